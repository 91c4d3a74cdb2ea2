// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/contact.h"

namespace frictionbeam {

Contact::Strains Contact::strain(const Vector &all_dofs) const {
  Strains result = Strains::Zero();
  for (unsigned int i = 0; i < dofs.size(); ++i)
    result += all_dofs[dofs[i]] * B.col(i);
  return result;
}

} // namespace frictionbeam
