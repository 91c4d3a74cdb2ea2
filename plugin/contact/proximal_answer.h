// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/proximal_law.h>
#include <frictionbeam/disc_projection.h>

#include <cmath>

namespace frictionbeam::contact {

/// Whether the branch is that of slip, and has a direction; @p trial and @p change become those of
/// the centre where the contact slides against its friction.
[[gnu::always_inline]] inline bool slides_on_branch(const ProximalPoint &point, double (&change)[2],
                                                    double (&trial)[2]) {
  if (*point.branch != ContactStatus::slip)
    return false;
  if (change[0] * point.centre[1] + change[1] * point.centre[2] < 0.)
#pragma GCC unroll 2
    for (int d = 0; d < 2; ++d) {
      change[d] = 0.;
      trial[d] = point.centre[1 + d];
    }
  return trial[0] != 0. || trial[1] != 0.;
}

/// Friction force and slip under the compression P, and their derivatives.
[[gnu::always_inline]] inline void add_friction(const FrictionThreshold &law,
                                                const ProximalPoint &point,
                                                const ProximalStiffness &stiffness, const Slip &old,
                                                const double P, ProximalAnswer &answer) {
  const double l = point.length, f = point.friction, radius = f * P;
  const double rigidity[2] = {law.shear_rigidity_y, law.shear_rigidity_z},
               old_slip[2] = {old.y, old.z};
  double *const slip[2] = {&answer.slip.y, &answer.slip.z};
  const double kappa[2] = {stiffness.kappa[1], stiffness.kappa[2]};
  double change[2], trial[2]; // by which the trial is off the centre
#pragma GCC unroll 2
  for (int d = 0; d < 2; ++d) {
    const double centre = point.centre[1 + d];
    change[d] = kappa[d] *
                (l * (point.strain[1 + d] - old_slip[d]) - centre * stiffness.flexibility[1 + d]);
    trial[d] = centre + change[d];
  }
  answer.slip.slips = point.branch ? slides_on_branch(point, change, trial)
                                   : length_of(trial[0], trial[1]) > radius;
  if (f == 0.) {
#pragma GCC unroll 2
    for (int d = 0; d < 2; ++d)
      *slip[d] = point.strain[1 + d];
  } else if (!answer.slip.slips) {
#pragma GCC unroll 2
    for (int d = 0; d < 2; ++d) {
      answer.stress[1 + d] = trial[d];
      answer.misfit[1 + d] = change[d];
      answer.tangent(1 + d, 1 + d) = kappa[d] * l;
      // the same slip but for rounding, so that the next increment begins without any
      *slip[d] = point.strain[1 + d] - trial[d] / rigidity[d];
    }
  } else {
    const DiscProjection on_disc(trial, kappa, radius);
#pragma GCC unroll 2
    for (int d = 0; d < 2; ++d) {
      answer.stress[1 + d] = on_disc.point[d];
      if (std::isfinite(on_disc.lambda)) { // radial rounding alone is left of T - T_c
        const double shrunk = on_disc.lambda * kappa[d];
        answer.misfit[1 + d] = (change[d] - shrunk * point.centre[1 + d]) / (1. + shrunk);
      }
      *slip[d] = point.strain[1 + d] - on_disc.point[d] / rigidity[d];
      answer.dissipated += on_disc.point[d] * (*slip[d] - old_slip[d]);
#pragma GCC unroll 2
      for (int e = 0; e < 2; ++e)
        answer.tangent(1 + d, 1 + e) = on_disc.by_trial[d][e] * kappa[e] * l;
      answer.tangent(1 + d, 0) = on_disc.by_radius[d] * -f * answer.tangent(0, 0);
    }
  }
  const bool free = f == 0.;
  answer.status = law.static_friction == 0.   ? ContactStatus::closed
                  : answer.slip.slips || free ? ContactStatus::slip
                                              : ContactStatus::stick;
  answer.slip.slips = answer.slip.slips && !free;
}

/// Moment about the normal, limited to what friction on a patch can hold.
[[gnu::always_inline]] inline void add_torsion(const FrictionThreshold &law,
                                               const ProximalPoint &point, const Slip &old,
                                               const double P, ProximalAnswer &answer) {
  const double lever = point.friction * point.patch_scale * law.patch_radius;
  const double moment = law.torsional_rigidity * (point.strain[3] - old.twist);
  const double limit = lever * P;
  if (law.patch_radius == 0. || std::abs(moment) <= limit) {
    answer.stress[3] = moment;
    answer.tangent(3, 3) = law.torsional_rigidity;
    return;
  }
  answer.stress[3] = std::copysign(limit, moment);
  answer.tangent(3, 0) = std::copysign(lever * answer.tangent(0, 0), -moment);
  answer.slip.twist = point.strain[3] - answer.stress[3] / law.torsional_rigidity;
  answer.dissipated += answer.stress[3] * (answer.slip.twist - old.twist);
}

/// proximal_law(), to be made part of where contact after contact is asked for its answer.
[[gnu::always_inline]] inline ProximalAnswer answer_of(const FrictionThreshold &law,
                                                       const ProximalPoint &point,
                                                       const ProximalStiffness &stiffness,
                                                       const Slip &old) {
  ProximalAnswer answer;
  answer.slip = old;
  answer.misfit.head<3>() = -point.centre.head<3>();
  double P = point.pressure.value_or(0.);
  if (point.pressure)
    answer.misfit[0] = 0.;
  else {
    const double kappa = stiffness.kappa[0],
                 change = kappa * (point.length * point.strain[0] + point.gap -
                                   point.centre[0] * stiffness.flexibility[0]);
    P = -(point.centre[0] + change);
    // A contact that just touches counts as closed: it may have to carry.
    if (point.branch ? *point.branch == ContactStatus::open : P < 0.) {
      answer.slip = {point.strain[1], point.strain[2], point.strain[3], false};
      answer.status = ContactStatus::open;
      return answer;
    }
    answer.misfit[0] = change;
    answer.tangent(0, 0) = kappa * point.length;
  }
  answer.stress[0] = -P;
  add_friction(law, point, stiffness, old, P, answer);
  add_torsion(law, point, old, P, answer);
  return answer;
}

} // namespace frictionbeam::contact
