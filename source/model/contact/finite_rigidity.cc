// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/finite_rigidity.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double times_the_line = 1e7;

/// Stiffness of the line, by its diagonal, against a unit of one of a contact's displacements
/// [N/m].
double stiffness_of_line(const Contact &contact, const int strain, const SparseMatrix &stiffness) {
  double compliance = 0.;
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
    const double b = contact.length * contact.B(strain, j),
                 k = stiffness.coeff(contact.unknowns[j], contact.unknowns[j]);
    if (b != 0. && k > 0.)
      compliance += b * b / k;
  }
  return compliance > 0. ? 1. / compliance : 0.;
}

/// Place of a parameter that is 0 for rigid; negative if the law has none.
int place_of_zero(const Contact &contact, const std::string &name) {
  const LawDescription &law = contact.law.description();
  for (int i = 0; i < law.n_parameters; ++i)
    if (law.parameters[i].name == name)
      return contact.law.parameters()[i] == 0. ? i : -1;
  return -1;
}

} // namespace

void make_rigid_contacts_finite(const SparseMatrix &stiffness, Contacts &contacts) {
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (contacts[i].law.closed_form().static_friction > 0.)
      return;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    if (!contact.law.has_closed_form())
      continue;
    const FrictionThreshold &law = contact.law.closed_form();
    std::vector<double> parameters = contact.law.parameters();
    const double length_over_share = contact.length * contact.length / contact.weight;
    const auto set = [&](const std::string &name, const double k) {
      if (const int place = place_of_zero(contact, name); place >= 0 && k > 0.)
        parameters[place] = times_the_line * k * length_over_share;
    };
    // A platen is free along its normal: what it carries does not depend on a stiffness.
    if (std::isinf(law.axial_rigidity) && contact.platen_force == 0.)
      set("Axial rigidity", stiffness_of_line(contact, 0, stiffness));
    if (std::isinf(law.shear_rigidity_y))
      set("Shear rigidity", std::max(stiffness_of_line(contact, 1, stiffness),
                                     stiffness_of_line(contact, 2, stiffness)));
    if (parameters != contact.law.parameters())
      contacts.set_parameters(i, parameters);
  }
}

} // namespace frictionbeam
