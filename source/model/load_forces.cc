// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/load_forces.h"

namespace frictionbeam {

Vector load_forces(const Model &model, const std::vector<double> &factors) {
  Vector result = model.contacts.platen_forces();
  for (unsigned int l = 0; l < factors.size(); ++l)
    if (factors[l] != 0.)
      result += factors[l] * model.linear.forces(l);
  return result;
}

} // namespace frictionbeam
