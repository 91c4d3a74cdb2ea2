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
    result += all_dofs[dofs[i]] * B.col(i);
  return result;
}

Contact::Strains Contact::strain_by_unknowns(const Vector &values,
                                             const std::vector<int> &places) const {
  Strains result = Strains::Zero();
  for (unsigned int j = 0; j < places.size(); ++j)
    result += values[places[j]] * B_reduced.col(j);
  return result;
}

void Contact::add_to(Vector &forces, const Strains &stress, const double factor,
                     const std::vector<int> &places) const {
  for (unsigned int j = 0; j < places.size(); ++j)
    forces[places[j]] += factor * weight * B_reduced.col(j).dot(stress);
}

} // namespace frictionbeam
