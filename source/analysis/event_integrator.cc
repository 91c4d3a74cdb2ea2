// SPDX-License-Identifier: LGPL-2.1-or-later
#include "event_integrator.h"

#include <frictionbeam/analysis/interruption.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int steps_handed_over = 40;

} // namespace

EventIntegrator::EventIntegrator(const Model &model)
    : model(model), line(model), motion(line), fallback(model), output_step(time_step(model)) {}

std::string EventIntegrator::remark() const {
  std::string text = std::to_string(n_events) + " events";
  if (n_handed_over > 0)
    text += "; " + reason + ", first at " + std::to_string(first_handed_over) +
            " s: handed over to moreau_jean " + std::to_string(n_handed_over) + " times, for " +
            std::to_string(time_handed_over) + " s in all";
  return text;
}

void EventIntegrator::start(LineState &state, const LoadCourse &loads) {
  state.acceleration = state.auxiliary = Vector::Zero(state.unknowns.size());
  read_states(state, loads);
  at_rest_on_ground = false;
  ground_may_jump = true;
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

void EventIntegrator::go(const double x, const double length, LineState &to,
                         EnergyAccount &energy) {
  set_imposed(0., length);
  const double before = kinetic_energy(), stored_before = stored_energy();
  energy.external += work_of_loads(x, length);
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    const Eigen::MatrixXd &g = motion.g[i], &r = motion.r[i];
    if (states[i].is_closed()) {
      for (int d = 0; d < 3; ++d) {
        if (d == 0 && contact.normal == EventContact::Normal::platen)
          energy.external -=
              integral_of_product(TaylorMotion::row(r, 0), derivative(TaylorMotion::row(g, 0)), x);
        else if (line.ground_moves)
          energy.external += integral_of_product(TaylorMotion::row(r, d),
                                                 derivative(motion.ground.col(3 * i + d)), x);
      }
      const Polynomial N = -TaylorMotion::row(r, 0);
      to.contacts.impulse[i] += length * integral_of_product(N, Polynomial::Ones(1), x);
      if (states[i].status == ContactStatus::slip) {
        const Eigen::Vector2d s = states[i].direction;
        Polynomial path = s[0] * TaylorMotion::row(g, 1) + s[1] * TaylorMotion::row(g, 2);
        if (!contact.rigid_shear)
          path -= contact.law.dynamic_friction / contact.shear_stiffness * N;
        const double wear = integral_of_product(N, derivative(path), x);
        to.contacts.wear[i] += wear;
        to.contacts.dissipated[i] += contact.law.dynamic_friction * wear;
        energy.dissipated += contact.law.dynamic_friction * wear;
      }
    }
    displacement[i] = TaylorMotion::at(g, x);
    force[i] = TaylorMotion::at(r, x);
  }
  if (line.damped)
    energy.damping += work_of_dampers(x, length);
  unknowns = TaylorMotion::at(motion.q, x);
  velocity = TaylorMotion::at(motion.v, x);
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
  const ContactStatus resting = contact.has_friction ? ContactStatus::stick : ContactStatus::closed;
  switch (event.kind) {
  case Kind::closing:
    if (contact.normal == EventContact::Normal::rigid)
      impact(i, ground_velocity(x, length), energy, to);
    else {
      state.status = resting;
      state.plastic = displacement[i].tail<2>();
      if (contact.has_friction && contact.rigid_shear)
        set_sliding(i, rate(i).tail<2>());
    }
    break;
  case Kind::opening:
    state.status = ContactStatus::open;
    force[i].setZero();
    break;
  case Kind::slipping: {
    const Eigen::Vector2d T = force[i].tail<2>(), u = rate(i).tail<2>();
    const double f = contact.law.dynamic_friction, N = -force[i][0];
    const bool has_force = T.norm() > 1e-9 * contact.law.static_friction * std::abs(N) && N > 0.;
    state.direction = has_force       ? T / T.norm()
                      : u.norm() > 0. ? u / u.norm()
                                      : Eigen::Vector2d(1., 0.);
    const double stored = stored_energy();
    force[i].tail<2>() = f * N * state.direction;
    energy.stored += stored_energy() - stored;
    energy.dissipated += stored - stored_energy(); // where the dynamic coefficient is lower
    to.contacts.dissipated[i] += stored - stored_energy();
    state.status = ContactStatus::slip;
    break;
  }
  default:
    state.status = ContactStatus::stick;
    if (!contact.rigid_shear)
      state.plastic = displacement[i].tail<2>() - force[i].tail<2>() / contact.shear_stiffness;
  }
  if (event.kind == Kind::closing && !state.is_closed()) // it bounces
    to.events.push_back({present, i, ContactStatus::closed});
  to.events.push_back({present, i, state.status});
  motion.state_changed();
}

TimeStep EventIntegrator::advance(const LineState &from, const LoadCourse &loads, const double time,
                                  LineState &to) {
  TimeStep step;
  step.result.converged = true;
  to = from;
  to.events.clear();
  bool changed = false;
  unsigned int at_once = 0;
  while (present < time) {
    interruption::end_if_overdue();
    const double next_break = loads.next_break(present),
                 longest = std::min(time, next_break) - present;
    double length = motion.compute(loads, present, longest, unknowns, velocity, states);
    if (ground_may_jump) {
      ground_may_jump = false;
      if (meet_ground(length, step.energy, to))
        length = motion.compute(loads, present, longest, unknowns, velocity, states);
    }
    ++step.result.iterations;
    const Event event = next_event();
    if (changed && event.x > 0.)
      break; // the new state holds
    const bool curved = slips_along_a_curve();
    const bool busy =
        event.x <= 1. && (++at_once, events_accumulate(present + event.x * length, output_step));
    if (curved || busy || at_once > 20 + 10 * states.size()) {
      reason = curved ? "slip along a curve" : "events accumulate";
      write(loads, to);
      LineState middle = to;
      TimeStep rest = hand_over(middle, loads, time, to);
      rest.energy += step.energy;
      rest.result.iterations += step.result.iterations;
      return rest;
    }
    const double x = std::min(event.x, 1.);
    if (x > 0.) {
      const bool reaches = x == 1. && length == longest;
      const double goal = present + longest;
      go(x, length, to, step.energy);
      if (reaches) {
        present = goal;
        ground_may_jump = goal == next_break;
        at_rest_on_ground = false;
      }
    }
    if (event.x <= 1.) {
      change(event, x, length, to, step.energy);
      ++n_events;
      changed = true;
    }
  }
  write(loads, to);
  return step;
}

TimeStep EventIntegrator::hand_over(const LineState &from, const LoadCourse &loads,
                                    const double time, LineState &to) {
  if (n_handed_over == 0)
    first_handed_over = from.time;
  ++n_handed_over;
  time_handed_over += time - from.time;
  recent.clear();
  TimeStep all;
  LineState now = from;
  fallback.start(now, loads);
  for (unsigned int k = 1; k <= steps_handed_over; ++k) {
    const double goal =
        k == steps_handed_over ? time : from.time + (time - from.time) * k / steps_handed_over;
    if (goal <= now.time)
      continue;
    const std::vector<ContactEvent> events = now.events;
    TimeStep step = fallback.advance(now, loads, goal, to);
    all.result = step.result;
    if (!step.result.converged)
      return all;
    to.events.insert(to.events.begin(), events.begin(), events.end());
    all.energy += step.energy;
    now = to;
  }
  read_states(to, loads);
  ground_may_jump = true;
  at_rest_on_ground = loads.next_break(from.time) > time;
  return all;
}

} // namespace frictionbeam
