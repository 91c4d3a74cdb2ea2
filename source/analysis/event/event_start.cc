// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int most_iterations = 5000;
constexpr double tolerance = 1e-14;           ///< of the largest force
constexpr double good_enough = 1e-9;          ///< of it, where most_iterations do not get so far
constexpr double at_rest = 1e-12;             ///< of the fastest velocity so far
constexpr double no_acceleration = 1e-9;      ///< of the largest of the parts that it is the sum of
constexpr double well_below_the_limit = 1e-6; ///< friction that has been relieved

} // namespace

bool EventIntegrator::share_start(const unsigned int first, const LoadCourse &loads,
                                  const Vector &of_ground, LineState &to) {
  // Of all contacts that rest on rigid surfaces with friction.
  std::vector<bool> rests(states.size(), false);
  std::vector<EventState> trial = states;
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (!states[i].is_closed() || !contact.has_friction || !contact.rigid_shear)
      continue;
    const double speed = velocities({i}, of_ground).tail<2>().norm();
    rests[i] = i == first || states[i].status == ContactStatus::stick || speed <= at_rest * fastest;
    if (rests[i]) {
      trial[i].status = ContactStatus::slip;
      trial[i].curved = true;
    }
  }
  motion.state_changed();
  const double until_break = loads.next_break(present + same_instant(present)) - present;
  const TaylorMotion::Beginning begin = motion.begin(
      loads, present, std::min(output_step, until_break), unknowns, velocity, trial, force);
  motion.state_changed();

  const int n = begin.contacts.size();
  Vector tau = Vector::Zero(2 * n);
  const auto acceleration = [&](const int k) -> Eigen::Vector2d {
    return begin.free.segment<2>(3 * k) + begin.by_friction.middleRows<2>(3 * k) * tau;
  };
  const auto limit = [&](const int k) { // of one that begins to slip: dynamic friction
    const unsigned int i = begin.contacts[k];
    const FrictionThreshold &law = line.contacts[i].law;
    const double N = begin.free[3 * k + 2] + begin.by_friction.row(3 * k + 2).dot(tau);
    return std::max(0., N) * (rests[i] && states[i].status == ContactStatus::stick
                                  ? law.static_friction
                                  : law.dynamic_friction);
  };
  Vector step = Vector::Zero(n);
  for (int k = 0; k < n; ++k) {
    const Eigen::Matrix2d W = -begin.by_friction.block<2, 2>(3 * k, 2 * k);
    const double largest = (W + W.transpose()).norm() / 2.;
    step[k] = largest > 0. ? 1. / largest : 0.;
  }
  double change = 0.;
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration) {
    change = 0.;
    for (int k = 0; k < n; ++k) {
      const unsigned int i = begin.contacts[k];
      Eigen::Vector2d next;
      if (!line.contacts[i].rigid_shear)
        next = force[i].tail<2>();
      else if (!rests[i])
        next = limit(k) * states[i].direction;
      else {
        next = tau.segment<2>(2 * k) + step[k] * acceleration(k);
        if (const double most = limit(k), size = next.norm(); size > most)
          next *= most / size;
      }
      change = std::max(change, (next - tau.segment<2>(2 * k)).norm());
      tau.segment<2>(2 * k) = next;
    }
    if (change <= tolerance * tau.lpNorm<Eigen::Infinity>())
      break;
  }

  const auto slides = [&](const int k) {
    const double parts = begin.free.segment<2>(3 * k).norm() +
                         begin.by_friction.middleRows<2>(3 * k).norm() * tau.norm();
    return acceleration(k).norm() > no_acceleration * parts;
  };
  bool others_slide = false;
  for (int k = 0; k < n; ++k)
    others_slide =
        others_slide || (begin.contacts[k] != first && rests[begin.contacts[k]] && slides(k));
  for (int k = 0; k < n; ++k) {
    const unsigned int i = begin.contacts[k];
    if (!rests[i])
      continue;
    EventState &state = states[i];
    const Eigen::Vector2d friction = tau.segment<2>(2 * k);
    const bool is_relieved =
        others_slide && friction.norm() < (1. - well_below_the_limit) * limit(k);
    const ContactStatus before = state.status;
    state.status = slides(k) || (before == ContactStatus::slip && !is_relieved)
                       ? ContactStatus::slip
                       : ContactStatus::stick;
    state.curved = false;
    if (slides(k))
      state.direction = acceleration(k).normalized();
    if (state.status != before)
      to.events.push_back({present, i, state.status});
  }
  const bool is_shared = change <= good_enough * tau.lpNorm<Eigen::Infinity>();
  n_unshared += is_shared ? 0 : 1;
  return is_shared;
}

} // namespace frictionbeam
