// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/proximal_contacts.h"

#include "analysis/contact/proximal_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

/// Diagonal of the line's stiffness in the direction of one strain, per unit displacement.
double stiffness_along(const Contact &contact, const int strain, const SparseMatrix &stiffness,
                       const double otherwise) {
  double compliance = 0.;
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
    const double b = contact.length * contact.B_reduced(strain, j);
    const double k = stiffness.coeff(contact.unknowns[j], contact.unknowns[j]);
    if (b != 0. && k > 0.)
      compliance += b * b / k;
  }
  return compliance > 0. ? 1. / compliance : otherwise;
}

} // namespace

void ContactCheck::include(const ContactCheck &other) {
  natural_map = std::max(natural_map, other.natural_map);
  penetration = std::max(penetration, other.penetration);
  cone_violation = std::max(cone_violation, other.cone_violation);
  slip_angle = std::max(slip_angle, other.slip_angle);
  least_dissipation = std::min(least_dissipation, other.least_dissipation);
}

void ContactCheck::judge(const Point &point, const double largest) {
  const double P = point.P, rounding = point.rounding, rho_n = point.normal_scale,
               rho_t = point.shear_scale;
  const double *const T = point.T, *const slip = point.slip;
  const auto beyond = [](const double misfit, const double excused) {
    return std::max(0., std::abs(misfit) - excused);
  };
  const double normal = beyond(P - std::max(0., P - rho_n * point.gap), rho_n * rounding);
  double moved[2] = {T[0] + rho_t * slip[0], T[1] + rho_t * slip[1]};
  const double radius = point.friction * P, size = std::hypot(moved[0], moved[1]);
  if (size > radius)
    for (double &m : moved)
      m *= radius / size;
  const double shear = beyond(std::hypot(T[0] - moved[0], T[1] - moved[1]), rho_t * rounding);
  const double friction_force = std::hypot(T[0], T[1]), path = std::hypot(slip[0], slip[1]);
  // Its slip is no scale: rho_T times a slip may be 1e6 times the friction force.
  const double scale =
      std::max({std::hypot(P, friction_force), std::abs(rho_n * point.gap), 1e-12 * largest});
  if (scale > 0.)
    natural_map = std::max(natural_map, std::hypot(normal, shear) / scale);
  penetration = std::max(penetration, -point.gap);
  cone_violation =
      std::max(cone_violation, (friction_force - radius) / std::max(P, 1e-12 * largest));
  if (P > 0. && path > 1e4 * rounding &&
      std::min(friction_force, rho_t * path) > 1e-4 * std::max(scale, rho_t * path)) {
    const double cross = slip[0] * T[1] - slip[1] * T[0], dot = slip[0] * T[0] + slip[1] * T[1];
    slip_angle = std::max(slip_angle, std::abs(std::atan2(cross, dot)));
  }
}

ProximalContacts::ProximalContacts(const Contacts &contacts, const SparseMatrix &stiffness)
    : contacts(contacts), scales(contacts.size()), friction(contacts.size(), 0.) {
  centre.assign(contacts.size(), Contact::Strains::Zero());
  misfit = centre;
  double mean = 0.;
  int n = 0;
  for (int i = 0; i < stiffness.rows(); ++i)
    if (const double k = stiffness.coeff(i, i); k > 0.) {
      mean += k;
      ++n;
    }
  mean = n > 0 ? mean / n : 1e6;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    Scale &scale = scales[i];
    if (!is_exact(i))
      continue;
    const double share = contact.share();
    scale.normal_diagonal = stiffness_along(contact, 0, stiffness, mean) / share;
    scale.shear_diagonal = std::max(stiffness_along(contact, 1, stiffness, 0.),
                                    stiffness_along(contact, 2, stiffness, 0.)) /
                           share;
    if (scale.shear_diagonal == 0.)
      scale.shear_diagonal = scale.normal_diagonal;
  }
}

void ProximalContacts::begin(const ContactState &committed,
                             const ContactOverrides *const overrides) {
  take_all();
  friction_scale.assign(scales.size(), 1.);
  gap.resize(scales.size());
  for (unsigned int i = 0; i < scales.size(); ++i)
    gap[i] = contacts[i].law.closed_form().gap;
  if (overrides != nullptr) {
    friction_scale = overrides->friction_scale;
    gap = overrides->gap;
  }
  for (unsigned int i = 0; i < scales.size(); ++i)
    if (is_exact(i))
      friction[i] =
          friction_scale[i] * (committed.internal[contacts[i].state_offset +
                                                  contacts[i].law.closed_form().was_slipping] != 0.
                                   ? contacts[i].law.closed_form().dynamic_friction
                                   : contacts[i].law.closed_form().static_friction);
}

bool ProximalContacts::let_slipping_go(const ContactResponse &response) {
  bool changed = false;
  for (unsigned int i = 0; i < scales.size(); ++i)
    if (is_exact(i) && response.status[i] == ContactStatus::slip &&
        friction[i] > friction_scale[i] * contacts[i].law.closed_form().dynamic_friction) {
      friction[i] = friction_scale[i] * contacts[i].law.closed_form().dynamic_friction;
      changed = true;
    }
  return changed;
}

void ProximalContacts::evaluate(const ContactState &committed, const ContactIncrement &increment,
                                const LawTangent tangent, ContactResponse &response) {
  contacts.prepare(response);
  for (unsigned int i = 0; i < scales.size(); ++i) {
    if (is_exact(i))
      evaluate_exact(i, committed, response);
    else
      contacts.evaluate_law(i, committed, increment, tangent, response);
  }
}

void ProximalContacts::evaluate_exact(const unsigned int i, const ContactState &committed,
                                      ContactResponse &response) {
  const Contact &contact = contacts[i];
  const FrictionThreshold &law = contact.law.closed_form();
  const Contact::Strains &strain = response.state.strain[i];
  const double *const old_state = committed.internal.data() + contact.state_offset;
  double *const new_state = response.state.internal.data() + contact.state_offset;
  const ProximalAnswer answer =
      proximal_law(law,
                   {strain, contact.length, friction[i],
                    is_left_out[i] ? std::numeric_limits<double>::infinity() : gap[i],
                    stiffness_factor * scales[i].normal_diagonal,
                    stiffness_factor * scales[i].shear_diagonal, centre[i]},
                   ContactSlip::read(law, old_state));
  response.stress[i] = answer.stress;
  misfit[i] = answer.misfit;
  response.tangent[i] = answer.tangent;
  response.status[i] = answer.status;
  std::copy(old_state, old_state + contact.law.n_internal_variables(), new_state);
  answer.slip.write(law, new_state);
  response.state.touch[i] = answer.status == ContactStatus::open ? strain : committed.touch[i];
  response.state.dissipated[i] = committed.dissipated[i] + contact.weight * answer.dissipated;
}

Contact::Strains ProximalContacts::by_centre(const unsigned int i) const {
  Contact::Strains scale = Contact::Strains::Zero();
  if (is_exact(i)) {
    const double per_force = 1. / (contacts[i].length * stiffness_factor);
    scale[0] = per_force / scales[i].normal_diagonal;
    scale[1] = scale[2] = per_force / scales[i].shear_diagonal;
  }
  return scale;
}

bool ProximalContacts::gives_utmost(const unsigned int i, const ContactResponse &response,
                                    const Contact::Strains &rate) const {
  const double size = rate.head<3>().norm(), sliding = rate.segment<2>(1).norm();
  if (size == 0. || (response.status[i] == ContactStatus::open && rate[0] >= -1e-6 * size))
    return true;
  if (!is_exact(i) || std::abs(rate[0]) > 1e-6 * size)
    return false; // pressed on: the contact will resist more
  const auto T = response.stress[i].segment<2>(1);
  const double most = friction[i] * -response.stress[i][0];
  return most == 0. || T.dot(rate.segment<2>(1)) >= (1. - 1e-6) * most * sliding;
}

ContactCheck ProximalContacts::check(const ContactResponse &response, const ContactState &committed,
                                     const double rounding) const {
  ContactCheck result;
  double largest = 0.;
  for (const auto &stress : response.stress)
    largest = std::max(largest, stress.head<3>().norm());
  for (unsigned int i = 0; i < scales.size(); ++i) {
    if (!is_exact(i))
      continue;
    const Contact &contact = contacts[i];
    const Scale &scale = scales[i];
    const double l = contact.length;
    const Contact::Strains &strain = response.state.strain[i], &stress = response.stress[i];
    const double *const old_state = committed.internal.data() + contact.state_offset;
    const FrictionThreshold &law = contact.law.closed_form();
    const double P = -stress[0];
    result.judge({P,
                  {stress[1], stress[2]},
                  l * strain[0] + gap[i] + P * l / law.axial_rigidity,
                  {l * (strain[1] - old_state[law.slip_y] - stress[1] / law.shear_rigidity_y),
                   l * (strain[2] - old_state[law.slip_z] - stress[2] / law.shear_rigidity_z)},
                  friction[i],
                  scale.normal_diagonal,
                  scale.shear_diagonal,
                  rounding},
                 largest);
    result.least_dissipation =
        std::min(result.least_dissipation, response.state.dissipated[i] - committed.dissipated[i]);
  }
  return result;
}

} // namespace frictionbeam
