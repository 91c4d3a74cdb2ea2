// SPDX-License-Identifier: LGPL-2.1-or-later
#include "proximal_sites.h"

#include "proximal_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::contact {

namespace {

/// Diagonal of the stiffness in the direction of one strain, per unit displacement.
double stiffness_along(const Site &contact, const int strain, const Vector &diagonal,
                       const double otherwise) {
  double compliance = 0.;
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
    const double b = contact.length * contact.B(strain, j);
    const double k = diagonal[contact.unknowns[j]];
    if (b != 0. && k > 0.)
      compliance += b * b / k;
  }
  return compliance > 0. ? 1. / compliance : otherwise;
}

} // namespace

ProximalSites::ProximalSites(const SiteList &contacts, const Vector &diagonal)
    : contacts(contacts), scales(contacts.size()), stiffness(contacts.size()),
      friction(contacts.size(), 0.), patch_scale(contacts.size(), 1.) {
  centre.assign(contacts.size(), Strains::Zero());
  misfit = centre;
  double mean = 0.;
  int n = 0;
  for (const double k : diagonal)
    if (k > 0.) {
      mean += k;
      ++n;
    }
  mean = n > 0 ? mean / n : 1e6;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Site &contact = contacts[i];
    Scale &scale = scales[i];
    if (!is_exact(i))
      continue;
    const double share = contact.share();
    scale.normal_diagonal = stiffness_along(contact, 0, diagonal, mean) / share;
    scale.shear_diagonal = std::max(stiffness_along(contact, 1, diagonal, 0.),
                                    stiffness_along(contact, 2, diagonal, 0.)) /
                           share;
    if (scale.shear_diagonal == 0.)
      scale.shear_diagonal = scale.normal_diagonal;
    scale.by_centre.head<3>() << 1. / scale.normal_diagonal, 1. / scale.shear_diagonal,
        1. / scale.shear_diagonal;
    scale.by_centre /= contact.length;
  }
}

void ProximalSites::begin(const State &committed, const Overrides *const overrides) {
  take_all();
  factor_of_stiffness = 0.; // the host may have changed the laws' numbers
  friction_scale.assign(scales.size(), 1.);
  patch_scale = friction_scale;
  gap.resize(scales.size());
  for (unsigned int i = 0; i < scales.size(); ++i)
    gap[i] = contacts[i].law.closed_form().gap;
  if (overrides != nullptr) {
    friction_scale = overrides->friction_scale;
    gap = overrides->gap;
    if (!overrides->patch_scale.empty())
      patch_scale = overrides->patch_scale;
  }
  for (unsigned int i = 0; i < scales.size(); ++i)
    if (is_exact(i))
      friction[i] =
          friction_scale[i] * (committed.internal[contacts[i].state_offset +
                                                  contacts[i].law.closed_form().was_slipping] != 0.
                                   ? contacts[i].law.closed_form().dynamic_friction
                                   : contacts[i].law.closed_form().static_friction);
}

bool ProximalSites::let_slipping_go(const Response &response) {
  bool changed = false;
  for (unsigned int i = 0; i < scales.size(); ++i)
    if (is_exact(i) && response.status[i] == ContactStatus::slip &&
        friction[i] > friction_scale[i] * contacts[i].law.closed_form().dynamic_friction) {
      friction[i] = friction_scale[i] * contacts[i].law.closed_form().dynamic_friction;
      changed = true;
    }
  return changed;
}

bool ProximalSites::is_slide(const Vector &free_motion) const {
  constexpr double nothing = 1e-6; // of the motion
  const double size = free_motion.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < scales.size(); ++i) {
    const Strains d = contacts[i].length * contacts[i].strain_by_unknowns(free_motion);
    const double sliding = d.segment<2>(1).norm();
    const double resisted = is_exact(i) ? friction_coefficient(i) * sliding : 0.;
    // On the edge of what friction resists, d_N = mu |d_T|, if not in the plane itself.
    if (sliding > nothing * size && d[0] <= (1. + 1e-3) * resisted + nothing * size)
      return true;
  }
  return false;
}

void ProximalSites::save(WarmStart &memory) const {
  memory.stiffness_factor = stiffness_factor;
  memory.centre = centre;
  memory.friction = friction;
  memory.friction_scale = friction_scale;
  memory.gap = gap;
}

void ProximalSites::restore(const WarmStart &memory) {
  stiffness_factor = memory.stiffness_factor;
  centre = memory.centre;
  friction = memory.friction;
  friction_scale = memory.friction_scale;
  gap = memory.gap;
}

void ProximalSites::find_stiffness() {
  if (factor_of_stiffness == stiffness_factor)
    return;
  factor_of_stiffness = stiffness_factor;
  for (unsigned int i = 0; i < scales.size(); ++i)
    if (is_exact(i))
      stiffness[i] = {contacts[i].law.closed_form(), contacts[i].length,
                      stiffness_factor * scales[i].normal_diagonal,
                      stiffness_factor * scales[i].shear_diagonal};
}

void ProximalSites::evaluate(const State &committed, const Increment &increment,
                             const LawTangent tangent, Response &response) {
  contacts.prepare(response);
  find_stiffness();
  response.state.internal = committed.internal;
  for (unsigned int i = 0; i < scales.size(); ++i) {
    if (is_exact(i))
      evaluate_exact(i, committed, response);
    else
      contacts.evaluate_law(i, committed, increment, tangent, response);
  }
}

void ProximalSites::evaluate_exact(const unsigned int i, const State &committed,
                                   Response &response) {
  const Site &contact = contacts[i];
  const FrictionThreshold &law = contact.law.closed_form();
  const Strains &strain = response.state.strain[i];
  const double *const old_state = committed.internal.data() + contact.state_offset;
  double *const new_state = response.state.internal.data() + contact.state_offset;
  ProximalPoint point{strain,
                      contact.length,
                      friction[i],
                      is_left_out[i] ? std::numeric_limits<double>::infinity() : gap[i],
                      stiffness_factor * scales[i].normal_diagonal,
                      stiffness_factor * scales[i].shear_diagonal,
                      centre[i]};
  point.patch_scale = patch_scale[i];
  if (!branch.empty())
    point.branch = branch[i];
  const ProximalAnswer answer = answer_of(law, point, stiffness[i], Slip::read(law, old_state));
  response.stress[i] = answer.stress;
  misfit[i] = answer.misfit;
  response.tangent[i] = answer.tangent;
  response.status[i] = answer.status;
  answer.slip.write(law, new_state);
  response.state.touch[i] = answer.status == ContactStatus::open ? strain : committed.touch[i];
  response.state.dissipated[i] = committed.dissipated[i] + contact.weight * answer.dissipated;
}

bool ProximalSites::gives_utmost(const unsigned int i, const Response &response,
                                 const Strains &rate) const {
  const double size = rate.head<3>().norm(), sliding = rate.segment<2>(1).norm();
  if (size == 0. || (response.status[i] == ContactStatus::open && rate[0] >= -1e-6 * size))
    return true;
  if (!is_exact(i) || std::abs(rate[0]) > 1e-6 * size)
    return false; // pressed on: the contact will resist more
  const auto T = response.stress[i].segment<2>(1);
  const double most = friction[i] * -response.stress[i][0];
  return most == 0. || T.dot(rate.segment<2>(1)) >= (1. - 1e-6) * most * sliding;
}

Check::Point ProximalSites::point_of(const unsigned int i, const Strains &stress,
                                     const Strains &strain, const State &committed,
                                     const double rounding) const {
  const Site &contact = contacts[i];
  const FrictionThreshold &law = contact.law.closed_form();
  const double *const old_state = committed.internal.data() + contact.state_offset;
  const double l = contact.length, P = -stress[0];
  return {P,
          {stress[1], stress[2]},
          l * strain[0] + gap[i] + P * l / law.axial_rigidity,
          {l * (strain[1] - old_state[law.slip_y] - stress[1] / law.shear_rigidity_y),
           l * (strain[2] - old_state[law.slip_z] - stress[2] / law.shear_rigidity_z)},
          friction[i],
          scales[i].normal_diagonal,
          scales[i].shear_diagonal,
          rounding};
}

Check ProximalSites::check(const Response &response, const State &committed,
                           const double rounding) const {
  Check result;
  double largest = 0.;
  for (const auto &stress : response.stress)
    largest = std::max(largest, stress.head<3>().norm());
  for (unsigned int i = 0; i < scales.size(); ++i) {
    if (!is_exact(i))
      continue;
    result.judge(point_of(i, response.stress[i], response.state.strain[i], committed, rounding),
                 largest);
    result.least_dissipation =
        std::min(result.least_dissipation, response.state.dissipated[i] - committed.dissipated[i]);
  }
  return result;
}

} // namespace frictionbeam::contact
