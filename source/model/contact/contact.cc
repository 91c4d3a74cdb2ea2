// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/contact.h"

namespace frictionbeam {

double Contact::temperature(const std::vector<double> &load_factors) const {
  double result = installation_temperature;
  for (const auto &[load, rise] : heating)
    result += load_factors[load] * rise;
  return result;
}

Contact::Strains Contact::strain(const Vector &all_dofs) const {
  Strains result = Strains::Zero();
  for (unsigned int i = 0; i < dofs.size(); ++i)
    result += all_dofs[dofs[i]] * B_dofs.col(i);
  return result;
}

} // namespace frictionbeam
