// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/finite_rigidity.h"

#include <frictionbeam/law_library.h>

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
    const double b = contact.length * contact.B_reduced(strain, j),
                 k = stiffness.coeff(contact.unknowns[j], contact.unknowns[j]);
    if (b != 0. && k > 0.)
      compliance += b * b / k;
  }
  return compliance > 0. ? 1. / compliance : 0.;
}

/// Place of a parameter that is 0 for rigid; negative if the law has none.
int place_of_zero(const Contact &contact, const std::string &name) {
  for (int i = 0; i < contact.law->n_parameters; ++i)
    if (contact.law->parameters[i].name == name)
      return (*contact.parameters)[i] == 0. ? i : -1;
  return -1;
}

} // namespace

bool is_rigid(const FrictionSupport &support, const LawDescription &law) {
  if (law.threshold == nullptr)
    return false;
  FrictionThreshold threshold{};
  law.threshold(support.parameters.data(), threshold);
  return std::isinf(threshold.axial_rigidity);
}

void make_rigid_contacts_finite(const SparseMatrix &stiffness, Contacts &contacts) {
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    FrictionThreshold law{};
    if (contacts[i].law->threshold != nullptr)
      contacts[i].law->threshold(contacts[i].parameters->data(), law);
    if (law.static_friction > 0.)
      return;
  }
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    if (contact.law->threshold == nullptr)
      continue;
    FrictionThreshold law{};
    contact.law->threshold(contact.parameters->data(), law);
    std::vector<double> parameters = *contact.parameters;
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
    if (parameters != *contact.parameters)
      contacts.set_parameters(i, parameters);
  }
}

} // namespace frictionbeam
