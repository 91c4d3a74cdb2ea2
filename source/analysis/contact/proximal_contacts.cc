// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/proximal_contacts.h"

#include "analysis/contact/in_series.h"

#include <frictionbeam/disc_projection.h>

#include <algorithm>
#include <cmath>

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
                                const LawTangent tangent, ContactResponse &response) const {
  contacts.prepare(response);
  for (unsigned int i = 0; i < scales.size(); ++i) {
    if (is_exact(i))
      evaluate_exact(i, committed, tangent, response);
    else
      contacts.evaluate_law(i, committed, increment, tangent, response);
  }
}

void ProximalContacts::evaluate_exact(const unsigned int i, const ContactState &committed,
                                      const LawTangent tangent, ContactResponse &response) const {
  const Contact &contact = contacts[i];
  const Scale &scale = scales[i];
  const FrictionThreshold &law = contact.law.closed_form();
  const double l = contact.length, f = friction[i];
  const Contact::Strains &strain = response.state.strain[i];
  Contact::Strains &stress = response.stress[i];
  auto &D = response.tangent[i];
  const double *const old_state = committed.internal.data() + contact.state_offset;
  double *const new_state = response.state.internal.data() + contact.state_offset;
  std::copy(old_state, old_state + contact.law.n_internal_variables(), new_state);
  stress.setZero();
  if (tangent != LawTangent::none)
    D.setZero();
  response.state.dissipated[i] = committed.dissipated[i];
  response.state.touch[i] = committed.touch[i];

  const double rho_n = stiffness_factor * scale.normal_diagonal,
               rho_t = stiffness_factor * scale.shear_diagonal;
  const double kappa_n = in_series(law.axial_rigidity / l, rho_n);
  const double P = kappa_n * (-centre[i][0] / rho_n - (l * strain[0] + gap[i]));
  if (P < 0.) { // a contact that just touches counts as closed: it may have to carry
    new_state[law.slip_y] = strain[1];
    new_state[law.slip_z] = strain[2];
    new_state[law.twist] = strain[3];
    new_state[law.was_slipping] = 0.;
    response.state.touch[i] = strain;
    response.status[i] = ContactStatus::open;
    return;
  }
  stress[0] = -P;
  D(0, 0) = kappa_n * l;

  const double rigidity[2] = {law.shear_rigidity_y, law.shear_rigidity_z};
  const int place[2] = {law.slip_y, law.slip_z};
  double kappa[2], trial[2];
  for (int d = 0; d < 2; ++d) {
    kappa[d] = in_series(rigidity[d] / l, rho_t);
    trial[d] = kappa[d] * (l * (strain[1 + d] - old_state[place[d]]) + centre[i][1 + d] / rho_t);
  }
  const double radius = f * P;
  bool slips = std::hypot(trial[0], trial[1]) > radius;
  if (f == 0.) {
    for (int d = 0; d < 2; ++d)
      new_state[place[d]] = strain[1 + d];
    slips = true;
  } else if (!slips) {
    for (int d = 0; d < 2; ++d) {
      stress[1 + d] = trial[d];
      D(1 + d, 1 + d) = kappa[d] * l;
      // the same slip but for rounding, so that the next increment begins without any
      new_state[place[d]] = strain[1 + d] - trial[d] / rigidity[d];
    }
  } else {
    const DiscProjection on_disc(trial, kappa, radius);
    for (int d = 0; d < 2; ++d) {
      stress[1 + d] = on_disc.point[d];
      new_state[place[d]] = strain[1 + d] - on_disc.point[d] / rigidity[d];
      response.state.dissipated[i] +=
          contact.weight * on_disc.point[d] * (new_state[place[d]] - old_state[place[d]]);
      for (int e = 0; e < 2; ++e)
        D(1 + d, 1 + e) = on_disc.by_trial[d][e] * kappa[e] * l;
      D(1 + d, 0) = on_disc.by_radius[d] * -f * D(0, 0);
    }
  }
  new_state[law.was_slipping] = slips && f > 0. ? 1. : 0.;
  response.status[i] = law.static_friction == 0. ? ContactStatus::closed
                       : slips                   ? ContactStatus::slip
                                                 : ContactStatus::stick;

  const double moment = law.torsional_rigidity * (strain[3] - old_state[law.twist]);
  const double limit = radius * law.patch_radius;
  if (law.patch_radius == 0. || std::abs(moment) <= limit) {
    stress[3] = moment;
    D(3, 3) = law.torsional_rigidity;
  } else {
    stress[3] = std::copysign(limit, moment);
    D(3, 0) = std::copysign(f * law.patch_radius * D(0, 0), -moment);
    new_state[law.twist] = strain[3] - stress[3] / law.torsional_rigidity;
    response.state.dissipated[i] +=
        contact.weight * stress[3] * (new_state[law.twist] - old_state[law.twist]);
  }
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
