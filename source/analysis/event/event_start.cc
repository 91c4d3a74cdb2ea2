// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int most_start_iterations = 5000;
constexpr double tolerance = 1e-14;      ///< of the largest force
constexpr double good_enough = 1e-9;     ///< of it, where most_start_iterations do not get so far
constexpr double no_acceleration = 1e-9; ///< of the largest of the parts that it is the sum of
constexpr double well_below_the_limit = 1e-6; ///< friction that has been relieved

} // namespace

/// The accelerations at which contacts begin to slip, by the friction of all of them: Coulomb's law
/// for them, tau = proj_{f N}(tau + rho u') (doc/dynamics.md, "From event to event").
struct EventIntegrator::SharedStart {
  TaylorMotion::Beginning begin;
  std::vector<double> coefficient; ///< by which they begin to slip
  Vector tau;                      ///< friction, 2 rows a contact [N]

  Eigen::Vector2d friction(const int k) const { return tau.segment<2>(2 * k); }
  Eigen::Vector2d acceleration(const int k) const {
    return begin.free.segment<2>(3 * k) + begin.by_friction.middleRows<2>(3 * k) * tau;
  }
  double normal_force(const int k) const {
    return std::max(0., begin.free[3 * k + 2] + begin.by_friction.row(3 * k + 2).dot(tau));
  }
  double limit(const int k) const { return normal_force(k) * coefficient[k]; }
  /// Of projected gradients: one over the size of the contact's acceleration by its own friction.
  double step_length(const int k) const {
    const Eigen::Matrix2d W = -begin.by_friction.block<2, 2>(3 * k, 2 * k);
    const double largest = (W + W.transpose()).norm() / 2.;
    return largest > 0. ? 1. / largest : 0.;
  }
  /// Whether the acceleration is more than rounding leaves of the parts that it is the sum of.
  bool slides(const int k) const {
    const double parts = begin.free.segment<2>(3 * k).norm() +
                         begin.by_friction.middleRows<2>(3 * k).norm() * tau.norm();
    return acceleration(k).norm() > no_acceleration * parts;
  }
  /**
   * Solve contact by contact, again and again until no friction changes.
   * @param next says a contact's friction by that of the others
   * @return whether it was found
   */
  template <typename Next>
  bool solve(const Next &next) {
    double change = 0.;
    for (unsigned int iteration = 0; iteration < most_start_iterations; ++iteration) {
      change = 0.;
      for (int k = 0; 2 * k < tau.size(); ++k) {
        const Eigen::Vector2d changed = next(k);
        change = std::max(change, (changed - friction(k)).norm());
        tau.segment<2>(2 * k) = changed;
      }
      if (change <= tolerance * tau.lpNorm<Eigen::Infinity>())
        break;
    }
    return change <= good_enough * tau.lpNorm<Eigen::Infinity>();
  }
};

Eigen::Vector2d EventIntegrator::direction_of_slip(const unsigned int i,
                                                   const Eigen::Vector2d &rate) const {
  constexpr double no_force = 1e-9; // of the limit
  const Eigen::Vector2d T = force[i].tail<2>();
  const double N = -force[i][0], limit = line.contacts[i].law.static_friction * std::abs(N);
  const bool has_force = T.norm() > no_force * limit && N > 0.;
  return has_force          ? Eigen::Vector2d(T / T.norm())
         : rate.norm() > 0. ? Eigen::Vector2d(rate / rate.norm())
                            : Eigen::Vector2d(1., 0.);
}

void EventIntegrator::begin_slip(const unsigned int i, const Eigen::Vector2d &direction,
                                 LineState &to, EnergyAccount &energy) {
  EventState &state = states[i];
  const double stored = stored_energy();
  force[i].tail<2>() = -line.contacts[i].law.dynamic_friction * force[i][0] * direction;
  energy.stored += stored_energy() - stored;
  energy.dissipated += stored - stored_energy(); // where the dynamic coefficient is lower
  to.contacts.dissipated[i] += stored - stored_energy();
  state.direction = direction;
  state.status = ContactStatus::slip;
  state.curved = state.at_limit = false;
  if (line.contacts[i].rigid_shear)
    state.began = present;
}

std::vector<bool> EventIntegrator::resting_with(const unsigned int first,
                                                const Vector &of_ground) const {
  std::vector<bool> rests(states.size(), false);
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (!states[i].is_closed() || !contact.has_friction || !contact.rigid_shear)
      continue;
    const double speed = velocities({i}, of_ground).tail<2>().norm();
    rests[i] = i == first || states[i].status == ContactStatus::stick || speed <= at_rest * fastest;
  }
  return rests;
}

EventIntegrator::SharedStart EventIntegrator::start_of(const std::vector<bool> &rests,
                                                       const LoadCourse &loads) {
  std::vector<EventState> trial = states;
  for (unsigned int i = 0; i < states.size(); ++i)
    if (rests[i]) {
      trial[i].status = ContactStatus::slip;
      trial[i].curved = true;
    }
  motion.state_changed();
  const double until_break = loads.next_break(present + same_instant(present)) - present;
  SharedStart start;
  start.begin = motion.begin(loads, present, std::min(output_step, until_break), unknowns, velocity,
                             trial, force);
  motion.state_changed();
  for (const unsigned int i : start.begin.contacts) {
    const FrictionThreshold &law = line.contacts[i].law;
    start.coefficient.push_back(rests[i] && states[i].status == ContactStatus::stick
                                    ? law.static_friction
                                    : law.dynamic_friction);
  }
  start.tau = Vector::Zero(2 * start.begin.contacts.size());
  return start;
}

void EventIntegrator::take_start(const SharedStart &start, const unsigned int first,
                                 const std::vector<bool> &rests, LineState &to) {
  const std::vector<unsigned int> &contacts = start.begin.contacts;
  bool others_slide = false;
  for (unsigned int k = 0; k < contacts.size(); ++k)
    others_slide = others_slide || (contacts[k] != first && rests[contacts[k]] && start.slides(k));
  for (unsigned int k = 0; k < contacts.size(); ++k) {
    const unsigned int i = contacts[k];
    if (!rests[i])
      continue;
    EventState &state = states[i];
    const bool is_relieved =
        others_slide && start.friction(k).norm() < (1. - well_below_the_limit) * start.limit(k);
    const ContactStatus before = state.status;
    const bool slips = start.slides(k) || (before == ContactStatus::slip && !is_relieved);
    state.status = slips ? ContactStatus::slip : ContactStatus::stick;
    state.curved = false;
    if (start.slides(k))
      state.direction = start.acceleration(k).normalized();
    if (slips && before == ContactStatus::stick)
      state.began = present;
    if (state.status != before)
      to.events.push_back({present, i, state.status});
  }
}

bool EventIntegrator::share_start(const unsigned int first, const LoadCourse &loads,
                                  const Vector &of_ground, LineState &to) {
  const std::vector<bool> rests = resting_with(first, of_ground);
  SharedStart start = start_of(rests, loads);
  std::vector<double> step;
  for (unsigned int k = 0; k < start.begin.contacts.size(); ++k)
    step.push_back(start.step_length(k));
  const bool is_found = start.solve([&](const int k) -> Eigen::Vector2d {
    const unsigned int i = start.begin.contacts[k];
    if (!line.contacts[i].rigid_shear)
      return force[i].tail<2>();
    if (!rests[i])
      return start.limit(k) * states[i].direction;
    const double most = start.limit(k);
    if (step[k] == 0.) // no friction moves it
      return most * (start.slides(k) ? start.acceleration(k).normalized() : states[i].direction);
    const Eigen::Vector2d next = start.friction(k) + step[k] * start.acceleration(k);
    const double size = next.norm();
    return size > most ? Eigen::Vector2d(next * (most / size)) : next;
  });
  take_start(start, first, rests, to);
  n_unshared += is_found ? 0 : 1;
  return is_found;
}

} // namespace frictionbeam
