// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"
#include "base/number_text.h"

#include "analysis/contact/opposed_contacts.h"
#include "analysis/increment/time_step.h"
#include "base/interruption.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// So many pieces between two events get on by at least such a part of Time/Step: beyond that a
/// step takes minutes.
constexpr unsigned int most_pieces = 200000;
constexpr double least_progress = 0.1;
/// Where a curve's friction is not found, slip goes straight on for such a part of a step.
constexpr double part_straight_on = 1e-5;
/// Of its gaps, below which the clearance of a stop is none.
constexpr double no_clearance = 1e-12;

} // namespace

EventIntegrator::EventIntegrator(const Model &model, const PieceObserver &observer)
    : model(model), line(model), motion(line, 1e-9 * time_step(model)), fallback(model),
      piece_observer(observer), output_step(time_step(model)), partner(model.contacts.size(), -1) {
  for (const auto &[one, other] : contact::rigid_pairs(model.contacts)) {
    const double gap = line.contacts[one].law.gap, of_other = line.contacts[other].law.gap;
    if (std::abs(gap + of_other) > no_clearance * (std::abs(gap) + std::abs(of_other)))
      continue;
    partner[one] = other;
    partner[other] = one;
  }
}

std::string EventIntegrator::remark() const {
  std::string text = std::to_string(n_events) + " events";
  if (n_handed_over > 0)
    text += "; " + reason + ", first at " + rounded_number(first_handed_over, 6) +
            " s: handed over to moreau_jean " + std::to_string(n_handed_over) + " times, for " +
            rounded_number(time_handed_over) + " s in all";
  if (n_unshared > 0)
    text += "; contacts that begin to slip together did not find their friction, " +
            std::to_string(n_unshared) + " times";
  return text;
}

void EventIntegrator::start(LineState &state, const LoadCourse &loads) {
  state.acceleration = state.auxiliary = Vector::Zero(state.unknowns.size());
  read_states(state, loads);
  for (EventState &contact : states)
    contact.given = contact.offset;
  if (velocity.isZero(0.))
    find_limits();
  bounces.assign(states.size(), {});
  at_rest_on_ground = false;
  ground_may_jump = begins = true;
  imposed_rates = state.load_rates; // those before
}

void EventIntegrator::read_states(const LineState &state, const LoadCourse &loads) {
  present = state.time;
  unknowns = state.unknowns;
  velocity = state.velocity;
  states.assign(line.contacts.size(), EventState());
  displacement.resize(states.size());
  force.resize(states.size());
  const double after = 1e-6 * output_step;
  Vector ground = line.ground_displacement(loads.imposed(present)),
         ground_later =
             line.ground_moves ? line.ground_displacement(loads.imposed(present + after)) : ground;
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    EventState &now = states[i];
    const Eigen::Vector3d e = ground.segment<3>(3 * i);
    displacement[i] = contact.displacement(unknowns) + e;
    force[i] = contact.share * state.contact_stress[i].head<3>();
    const double gap = displacement[i][0] + contact.law.gap;
    now.status = state.contact_status[i];
    if (contact.normal == EventContact::Normal::platen && !now.is_closed())
      now.status = ContactStatus::stick;
    if (contact.normal == EventContact::Normal::elastic)
      now.status = gap < 0. ? ContactStatus::stick : ContactStatus::open;
    if (contact.normal == EventContact::Normal::rigid)
      now.offset = now.is_closed() ? gap : std::min(gap, 0.);
    if (now.is_closed() && !contact.has_friction)
      now.status = ContactStatus::closed;
    const double *const internal = state.contacts.internal.data() + contact.contact->state_offset;
    now.plastic << contact.contact->length * internal[contact.law.slip_y],
        contact.contact->length * internal[contact.law.slip_z];
    const Eigen::Vector3d own = contact.displacement(velocity),
                          of_ground = (ground_later.segment<3>(3 * i) - e) / after,
                          rate = own + of_ground;
    fastest = std::max({fastest, own.norm(), of_ground.norm()});
    if (now.is_closed() && contact.has_friction) {
      now.status = ContactStatus::stick;
      if (contact.rigid_shear)
        set_sliding(i, rate.tail<2>());
    }
  }
  motion.state_changed();
}

void EventIntegrator::release_idle_halves() {
  for (unsigned int i = 0; i < states.size(); ++i) {
    if (partner[i] <= static_cast<int>(i) || !states[i].is_closed() ||
        !states[partner[i]].is_closed())
      continue;
    const unsigned int idle = force[i][0] < force[partner[i]][0] ? partner[i] : i;
    states[idle].status = ContactStatus::open;
    states[idle].curved = states[idle].at_limit = false;
    states[idle].offset = displacement[idle][0] + line.contacts[idle].law.gap;
    force[idle].setZero();
    motion.state_changed();
  }
}

void EventIntegrator::find_limits() {
  for (unsigned int i = 0; i < states.size(); ++i) {
    const double most = line.contacts[i].law.static_friction * -force[i][0];
    states[i].at_limit = states[i].is_closed() && line.contacts[i].has_friction &&
                         force[i].tail<2>().norm() >= (1. - limit_of_statics) * most;
  }
}

double EventIntegrator::add_histories(const double x, const double length,
                                      ContactState &contacts) const {
  double dissipated = 0.;
  for (unsigned int i = 0; i < states.size(); ++i) {
    if (!states[i].is_closed())
      continue;
    const Polynomial N = -TaylorMotion::row(motion.r[i], 0);
    contacts.impulse[i] += length * integral_of_product(N, Polynomial::Ones(1), x);
    if (states[i].status == ContactStatus::closed)
      contacts.wear[i] += frictionless_wear(i, x);
    if (states[i].status != ContactStatus::slip)
      continue;
    const double wear = integral_of_product(N, slip_rate(i), x),
                 work = line.contacts[i].law.dynamic_friction * wear;
    contacts.wear[i] += wear;
    contacts.dissipated[i] += work;
    dissipated += work;
  }
  return dissipated;
}

void EventIntegrator::turn_slip(const double x, const double length) {
  for (unsigned int i = 0; i < states.size(); ++i) {
    EventState &state = states[i];
    if (state.status != ContactStatus::slip || !(state.curved || goes_straight_on))
      continue;
    if (!line.contacts[i].rigid_shear) {
      if (state.curved)
        state.direction = TaylorMotion::at(motion.s[i], x).normalized();
      continue;
    }
    Eigen::Vector2d rate;
    for (int d = 0; d < 2; ++d)
      rate[d] = value(derivative(TaylorMotion::row(motion.g[i], d + 1)), x) / length;
    if (rate.dot(state.direction) > 0.)
      state.direction = rate.normalized();
    if (state.curved && is_fast(rate.norm()))
      continue;
    state.curved = false;
    motion.state_changed();
  }
}

void EventIntegrator::go(const LoadCourse &loads, const double x, const double length,
                         LineState &to, EnergyAccount &energy) {
  if (piece_observer && present + x * length > present) { // it may be shorter than time resolves
    LineState within = to;
    const auto state_at = [&](const double time) -> const LineState & {
      write_within(loads, std::clamp((time - present) / length, 0., x), length, to.contacts,
                   within);
      return within;
    };
    piece_observer({present, present + x * length, state_at});
  }
  set_imposed(0., length);
  const double before = kinetic_energy(), stored_before = stored_energy();
  energy.external += work_of_loads(x, length);
  energy.dissipated += add_histories(x, length, to.contacts);
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    const Eigen::MatrixXd &g = motion.g[i], &r = motion.r[i];
    for (int d = 0; d < 3 && states[i].is_closed(); ++d)
      if (d == 0 && contact.normal == EventContact::Normal::platen)
        energy.external -=
            integral_of_product(TaylorMotion::row(r, 0), derivative(TaylorMotion::row(g, 0)), x);
      else if (line.ground_moves)
        energy.external += integral_of_product(TaylorMotion::row(r, d),
                                               derivative(motion.loads.ground.col(3 * i + d)), x);
    displacement[i] = TaylorMotion::at(g, x);
    force[i] = TaylorMotion::at(r, x);
  }
  if (line.damped)
    energy.damping += work_of_dampers(x, length);
  turn_slip(x, length);
  unknowns = TaylorMotion::at(motion.q, x);
  velocity = TaylorMotion::at(motion.v, x);
  for (const EventContact &contact : line.contacts)
    fastest = std::max(fastest, contact.displacement(velocity).lpNorm<Eigen::Infinity>());
  set_imposed(x, length);
  present += x * length;
  const double kinetic = kinetic_energy(), stored = stored_energy();
  energy.kinetic += kinetic - before;
  energy.stored += stored - stored_before;
  energy.at_hand = std::max(energy.at_hand, kinetic + stored);
  energy.turnover += std::abs(kinetic - before) + std::abs(stored - stored_before);
}

void EventIntegrator::change(const Event &event, const double x, const double length, LineState &to,
                             EnergyAccount &energy) {
  const unsigned int i = event.contact;
  const EventContact &contact = line.contacts[i];
  EventState &state = states[i];
  set_imposed(x, length);
  displacement[i] = TaylorMotion::at(motion.g[i], x);
  force[i] = TaylorMotion::at(motion.r[i], x);
  const auto rate = [&](const unsigned int j) {
    Eigen::Vector3d result;
    for (int d = 0; d < 3; ++d)
      result[d] = value(derivative(TaylorMotion::row(motion.g[j], d)), x) / length;
    return result;
  };
  std::vector<unsigned int> striking;
  const ContactStatus resting = contact.has_friction ? ContactStatus::stick : ContactStatus::closed;
  switch (event.kind) {
  case Kind::closing:
    if (contact.normal == EventContact::Normal::rigid) {
      const Vector of_ground = ground_velocity(x, length);
      striking = closing_with(i, x, of_ground);
      impact(striking, of_ground, energy, to);
    } else {
      state.status = resting;
      state.plastic = displacement[i].tail<2>();
      if (contact.has_friction && contact.rigid_shear)
        set_sliding(i, rate(i).tail<2>());
    }
    break;
  case Kind::opening:
    state.status = ContactStatus::open;
    force[i].setZero();
    if (partner[i] >= 0) // it touches, and may press from now on
      states[partner[i]].offset = displacement[partner[i]][0] + line.contacts[partner[i]].law.gap;
    break;
  case Kind::slipping:
    if (line.ground_moves && contact.rigid_shear) // not from what rounding has made of its velocity
      settle(ground_velocity(x, length), energy, to);
    begin_slip(i, direction_of_slip(i, rate(i).tail<2>()), to, energy);
    break;
  case Kind::dragged:
    begin_slip(i, drag(i), to, energy);
    break;
  default:
    state.status = ContactStatus::stick;
    state.curved = false;
    if (!contact.rigid_shear)
      state.plastic = displacement[i].tail<2>() - force[i].tail<2>() / contact.shear_stiffness;
    else if (rate(i).tail<2>().norm() > 1e-13 * fastest) // it came to rest along a curve
      settle(ground_velocity(x, length), energy, to);
  }
  for (const unsigned int j : striking)
    if (!states[j].is_closed()) // it bounces
      to.events.push_back({present, j, ContactStatus::closed});
    else if (j != i)
      to.events.push_back({present, j, states[j].status});
  to.events.push_back({present, i, state.status});
  motion.state_changed();
}

void EventIntegrator::meet(const Event &event, const LoadCourse &loads, const double x,
                           const double length, LineState &to, TimeStep &step) {
  change(event, x, length, to, step.energy);
  if ((event.kind == Kind::slipping || event.kind == Kind::dragged) &&
      line.contacts[event.contact].rigid_shear)
    step.handed_over =
        !share_start(event.contact, loads, ground_velocity(x, length), to) || step.handed_over;
  ++n_events;
}

double EventIntegrator::compute_motion(const LoadCourse &loads, const double longest) {
  motion_length = motion.compute(loads, present, longest, unknowns, velocity, states, force);
  goes_straight_on = motion_length == 0.;
  if (goes_straight_on) {
    for (EventState &state : states)
      state.curved = false;
    motion.state_changed();
    motion_length = motion.compute(loads, present, longest, unknowns, velocity, states, force);
  }
  return motion_length;
}

double EventIntegrator::next_motion(const LoadCourse &loads, const double longest, LineState &to,
                                    EnergyAccount &energy) {
  release_idle_halves();
  double length = compute_motion(loads, longest);
  if (ground_may_jump) {
    ground_may_jump = false;
    if (meet_imposed_jump(length, energy))
      length = compute_motion(loads, longest);
    if (meet_ground(loads, length, energy, to))
      length = compute_motion(loads, longest);
    begins = false;
  }
  while (!goes_straight_on && find_curves()) // one that turns may turn another
    length = compute_motion(loads, longest);
  return length;
}

EventIntegrator::Goal EventIntegrator::next_goal(const LoadCourse &loads, const double time) const {
  const double next_break = loads.next_break(present + same_instant(present));
  const bool breaks = next_break <= time + same_instant(time);
  return {breaks && next_break < time - same_instant(time) ? next_break : time, breaks};
}

TimeStep EventIntegrator::advance(const LineState &from, const LoadCourse &loads, const double time,
                                  LineState &to) {
  TimeStep step;
  step.result.converged = true;
  to = from;
  to.events.clear();
  for (unsigned int i = 0; begins && i < states.size(); ++i) // slide at once, or rest since statics
    if (states[i].is_closed() && line.contacts[i].has_friction && line.contacts[i].rigid_shear &&
        from.contact_status[i] != ContactStatus::open && from.contact_status[i] != states[i].status)
      to.events.push_back({present, i, states[i].status});
  bool changed = false;
  unsigned int n_pieces = 0;
  double progress = present;
  while (present < time && failure.empty()) {
    interruption::end_if_overdue();
    if (++n_pieces % most_pieces == 0) {
      if (present - progress < least_progress * output_step) {
        failure = "event: the motion gets on by " + rounded_number(present - progress) + " s in " +
                  std::to_string(most_pieces) +
                  " pieces without a change of state, since what is fastest takes no longer than "
                  "one of them. Lower a rigidity (of a support, of a short cell) or give more mass "
                  "there, make the support rigid, take another integrator, or a shorter Time/Step";
        break;
      }
      progress = present;
    }
    const Goal goal = next_goal(loads, time);
    const double longest = goal.time - present;
    const double length = next_motion(loads, longest, to, step.energy);
    n_unresolved = goes_straight_on ? n_unresolved + 1 : 0;
    const double valid =
        goes_straight_on ? std::min(1., part_straight_on * output_step / length) : 1.;
    ++step.result.iterations;
    const Event event = next_event();
    if (changed && event.x > 0.) { // the new state holds
      set_imposed(0., length);
      for (unsigned int i = 0; i < states.size(); ++i)
        force[i] = TaylorMotion::at(motion.r[i], 0.);
      break;
    }
    if (is_stuck(event))
      return hand_over_after(step, loads, time, to);
    const double x = std::min(event.x, valid);
    if (x > 0.) {
      if (!obeys_laws(x, length, step.result))
        break;
      const bool reaches = x == 1. && length == longest;
      go(loads, x, length, to, step.energy);
      n_at_once = 0;
      if (reaches) {
        present = goal.time;
        ground_may_jump = goal.breaks;
        at_rest_on_ground = false;
      }
    }
    if (event.x <= valid) {
      meet(event, loads, x, length, to, step);
      changed = true;
    }
  }
  if (!failure.empty()) {
    step.result.converged = false;
    step.result.remark = failure;
    return step;
  }
  write(loads, to);
  return step;
}

} // namespace frictionbeam
