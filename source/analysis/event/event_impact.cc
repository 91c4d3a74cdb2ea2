// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"

#include "base/algebra/dense_algebra.h"

#include <frictionbeam/contact/local_solver.h>

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr double rounding_of_rate = 1e-6; ///< of ground motions, of the fastest velocity
constexpr double no_jump = 1e-9;          ///< of the largest jump at that instant
constexpr double gap_rounding = 1e-12;
constexpr double rounding_of_bounce = 1e-6; ///< that has no height, of the fastest velocity
constexpr double at_the_same_time = 1e-9;   ///< of a step: impacts this close are one
constexpr double slowest_impact = 1e-10;    ///< with restitution, of the fastest velocity
/// Impacts that show a geometric law, how equal their ratios are, of what they are short of 1, and
/// how little time such a law may have left, of a step.
constexpr std::size_t impacts_of_a_law = 8;
constexpr double same_ratio = 0.05, shortest_rest = 1e-6;

} // namespace

double EventIntegrator::least_rate(const unsigned int i) const {
  if (!line.ground_moves)
    return at_rest * fastest;
  double noise = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    noise = std::max(noise, motion.loads.rounding_of_ground_rate(3 * i + d));
  return std::max(rounding_of_rate * fastest, noise);
}

void EventIntegrator::set_sliding(const unsigned int i, const Eigen::Vector2d &rate) {
  const bool slides = rate.norm() > least_rate(i);
  states[i].status = slides ? ContactStatus::slip : ContactStatus::stick;
  states[i].curved = false;
  if (slides) {
    states[i].direction = rate / rate.norm();
    states[i].at_limit = false;
  }
}

Vector EventIntegrator::ground_velocity(const double x, const double length) const {
  Vector result = Vector::Zero(3 * states.size());
  if (line.ground_moves)
    for (int c = 0; c < result.size(); ++c)
      result[c] = value(derivative(motion.loads.ground.col(c)), x) / length;
  return result;
}

Vector EventIntegrator::velocities(const std::vector<unsigned int> &contacts,
                                   const Vector &of_ground) const {
  Vector u(3 * contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    u.segment<3>(3 * k) =
        line.contacts[contacts[k]].displacement(velocity) + of_ground.segment<3>(3 * contacts[k]);
  return u;
}

Eigen::MatrixXd
EventIntegrator::response_to_impulses(const std::vector<unsigned int> &contacts) const {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(velocity.size(), 3 * contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    for (int d = 0; d < 3; ++d) {
      Vector unit = Vector::Zero(velocity.size());
      line.add_contact_force(contacts[k], -Eigen::Vector3d::Unit(d), unit);
      columns.col(3 * k + d) = line.accelerate(unit);
    }
  return columns;
}

void EventIntegrator::act(const std::vector<unsigned int> &contacts, const Vector &impulses,
                          const Eigen::MatrixXd &responses, const Vector &of_ground,
                          EnergyAccount &energy, LineState &to) {
  const double kinetic = kinetic_energy();
  const Vector before = velocities(contacts, of_ground);
  const Vector jump = responses * impulses;
  velocity += jump;
  for (unsigned int l = 0; l < imposed_rates.size(); ++l)
    if (model.linear.accelerates(l)) // what holds the moved nodes has its impulse too
      energy.external -= imposed_rates[l] * model.linear.inertia(l).dot(jump);
  const Vector mean = (before + velocities(contacts, of_ground)) / 2.;
  const double gained = kinetic_energy() - kinetic;
  energy.kinetic += gained;
  energy.turnover += std::abs(gained);
  energy.at_hand = std::max(energy.at_hand, kinetic_energy() + stored_energy());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const unsigned int j = contacts[k];
    const Eigen::Vector3d P = impulses.segment<3>(3 * k), way = mean.segment<3>(3 * k);
    const double by_friction = -P.tail<2>().dot(way.tail<2>());
    energy.external -= P.dot(of_ground.segment<3>(3 * j));
    energy.impact -= P[0] * way[0];
    energy.dissipated += by_friction;
    to.contacts.dissipated[j] += by_friction;
    to.contacts.impulse[j] += P[0];
    to.contacts.wear[j] += P[0] * way.tail<2>().norm();
  }
}

std::vector<unsigned int> EventIntegrator::closing_with(const unsigned int i, const double x,
                                                        const Vector &of_ground) const {
  std::vector<unsigned int> result;
  for (unsigned int j = 0; j < states.size(); ++j) {
    const EventContact &contact = line.contacts[j];
    if (states[j].is_closed() || contact.normal != EventContact::Normal::rigid || !contact.moves[0])
      continue;
    const double offset = states[j].offset,
                 gap = TaylorMotion::at(motion.g[j], x)[0] + contact.law.gap - offset,
                 speed = -velocities({j}, of_ground)[0],
                 rounding = gap_rounding * (contact.law.gap + std::abs(offset) +
                                            motion.g[j].row(0).lpNorm<Eigen::Infinity>());
    if (j == i || (speed > 0. && gap <= std::max(rounding, at_the_same_time * output_step * speed)))
      result.push_back(j);
  }
  return result;
}

bool EventIntegrator::returns_at_once(const unsigned int i, const double speed) const {
  return bounces[i].left == present && std::abs(speed) <= rounding_of_bounce * fastest;
}

double EventIntegrator::restitution(const unsigned int i, const double speed) {
  Bounces &past = bounces[i];
  if (speed <= slowest_impact * fastest || returns_at_once(i, speed))
    return 0.;
  past.time.push_back(present);
  past.speed.push_back(speed);
  const double e = line.contacts[i].contact->restitution;
  const std::size_t n = past.time.size();
  if (n < impacts_of_a_law)
    return e;
  const auto interval = [&](const std::size_t k) { return past.time[k + 1] - past.time[k]; };
  const double ratio = interval(n - 2) / interval(n - 3),
               speed_ratio = past.speed[n - 1] / past.speed[n - 2];
  bool is_geometric = ratio < 1. && speed_ratio < 1.;
  for (std::size_t k = 1; k + 1 < n && is_geometric; ++k)
    is_geometric = std::abs(interval(k) / interval(k - 1) - ratio) <= same_ratio * (1. - ratio) &&
                   std::abs(past.speed[k + 1] / past.speed[k] - speed_ratio) <=
                       same_ratio * (1. - speed_ratio);
  past.time.erase(past.time.begin());
  past.speed.erase(past.speed.begin());
  const double left = interval(n - 3) * ratio / (1. - ratio);
  return is_geometric && left <= shortest_rest * output_step ? 0. : e;
}

void EventIntegrator::strike(const std::vector<unsigned int> &contacts,
                             contact::LocalProblem problem, const Vector &of_ground,
                             EnergyAccount &energy, LineState &to) {
  constexpr double tolerance = 1e-12;
  const unsigned int n = contacts.size();
  const Eigen::MatrixXd columns = response_to_impulses(contacts);
  Eigen::MatrixXd W(3 * n, 3 * n); // Delassus operator
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int c = 0; c < 3 * n; ++c)
      W.block<3, 1>(3 * k, c) = line.contacts[contacts[k]].displacement(columns.col(c));
  W = ((W + W.transpose()) / 2.).eval();
  for (unsigned int k = 0; k < n; ++k)
    for (int d = 0; d < 3; ++d)
      if (!line.contacts[contacts[k]].moves[d]) { // such a direction takes no part
        W.row(3 * k + d).setZero();
        W.col(3 * k + d).setZero();
        W(3 * k + d, 3 * k + d) = 1.;
        problem.q[3 * k + d] = 0.;
      }
  Vector impulses = Vector::Zero(3 * n);
  if (n == 1 && problem.friction[0] == 0.)
    impulses[0] = std::max(0., -problem.q[0] / W(0, 0));
  else {
    problem.W = W.sparseView();
    impulses = contact::solve_local_contact(problem, tolerance).reactions;
  }
  act(contacts, impulses, columns, of_ground, energy, to);
}

/// An impact: the rigid contacts that take part, in the order of their rows in the problem.
struct EventIntegrator::Impact {
  std::vector<unsigned int> contacts;
  std::vector<bool> strikes; ///< they close now; the others were closed
  std::vector<bool> stays;   ///< it left at this instant, and is back within rounding
  contact::LocalProblem problem;
  double approach = 0.; ///< the fastest [m/s]
};

EventIntegrator::Impact EventIntegrator::impact_of(const std::vector<unsigned int> &striking,
                                                   const Vector &of_ground) {
  Impact impact;
  for (unsigned int j = 0; j < states.size(); ++j) {
    const bool strikes = std::find(striking.begin(), striking.end(), j) != striking.end();
    if (!strikes && !((states[j].is_closed() || is_idle_half(j)) &&
                      line.contacts[j].normal == EventContact::Normal::rigid))
      continue;
    impact.contacts.push_back(j);
    impact.strikes.push_back(strikes);
  }
  const unsigned int n = impact.contacts.size();
  const Vector u = velocities(impact.contacts, of_ground);
  fastest = std::max(fastest, u.lpNorm<Eigen::Infinity>());
  impact.stays.assign(n, false);
  impact.problem.q = u;
  impact.problem.friction.resize(n);
  for (unsigned int k = 0; k < n; ++k) {
    const unsigned int j = impact.contacts[k];
    const EventContact &contact = line.contacts[j];
    impact.problem.friction[k] = contact.rigid_shear ? contact.law.dynamic_friction : 0.;
    const double speed = -u[3 * k];
    impact.approach = std::max(impact.approach, speed);
    const double e = impact.strikes[k] ? restitution(j, speed) : contact.contact->restitution;
    impact.stays[k] = impact.strikes[k] && returns_at_once(j, speed);
    impact.problem.q[3 * k] -= e * std::max(speed, 0.); // 0 <= u_N + e u_N^- perp P_N >= 0
  }
  return impact;
}

void EventIntegrator::impact(const std::vector<unsigned int> &striking, const Vector &of_ground,
                             EnergyAccount &energy, LineState &to) {
  Impact impact = impact_of(striking, of_ground);
  if (impact.approach > at_rest * fastest)
    strike(impact.contacts, std::move(impact.problem), of_ground, energy, to);
  const Vector u = velocities(impact.contacts, of_ground);
  for (unsigned int k = 0; k < impact.contacts.size(); ++k) {
    const unsigned int j = impact.contacts[k];
    const EventContact &contact = line.contacts[j];
    if (!impact.stays[k] && u[3 * k] > std::max(at_rest * fastest, 1e-12 * impact.approach)) {
      states[j].status = ContactStatus::open;
      states[j].offset = displacement[j][0] + contact.law.gap;
      bounces[j].left = present;
      force[j].setZero();
      continue;
    }
    if (!states[j].is_closed())
      states[j].offset = displacement[j][0] + contact.law.gap;
    states[j].status = ContactStatus::closed;
    if (contact.has_friction && contact.rigid_shear)
      set_sliding(j, u.segment<2>(3 * k + 1));
    else if (contact.has_friction) {
      states[j].status = ContactStatus::stick;
      if (impact.strikes[k])
        states[j].plastic = displacement[j].tail<2>();
    }
  }
  if (std::count(impact.stays.begin(), impact.stays.end(), true) > 0)
    settle(of_ground, energy, to);
}

void EventIntegrator::meet_jump_of_ground(const LoadCourse &loads, EnergyAccount &energy,
                                          LineState &to) {
  const Vector jumps = loads.imposed_jumps(present - same_instant(present), present);
  if (jumps.size() == 0)
    return;
  const double least = no_jump * jumps.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (!states[i].is_closed())
      continue;
    const Eigen::Vector3d jump = contact.contact->length * contact.contact->strain(jumps).head<3>();
    if (contact.normal == EventContact::Normal::rigid && jump[0] > least) {
      states[i].status = ContactStatus::open;
      force[i].setZero();
    } else if (contact.rigid_shear && jump.tail<2>().norm() > least) {
      const double wear = -force[i][0] * jump.tail<2>().norm(),
                   work = contact.has_friction ? contact.law.dynamic_friction * wear : 0.;
      energy.external += work; // the ground's, against friction
      energy.dissipated += work;
      to.contacts.dissipated[i] += work;
      to.contacts.wear[i] += wear;
    }
  }
}

bool EventIntegrator::leaves_or_strikes() const {
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (states[i].is_closed() && contact.normal == EventContact::Normal::rigid &&
        contact.moves[0] &&
        std::abs(contact.displacement(velocity)[0]) > rounding_of_rate * fastest)
      return true;
  }
  return false;
}

bool EventIntegrator::meet_ground(const LoadCourse &loads, const double length,
                                  EnergyAccount &energy, LineState &to) {
  if (!line.ground_moves && !(begins && leaves_or_strikes()))
    return false;
  const std::vector<EventState> before = states;
  const Vector velocity_before = velocity;
  meet_jump_of_ground(loads, energy, to);
  const Vector of_ground = ground_velocity(0., length);
  set_imposed(0., length);
  if (at_rest_on_ground)
    settle(of_ground, energy, to);
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (!states[i].is_closed())
      continue;
    const Vector u = velocities({i}, of_ground);
    fastest = std::max(fastest, u.norm());
    const double least = least_rate(i);
    if (contact.normal == EventContact::Normal::rigid && contact.moves[0] && u[0] < -least)
      impact({i}, of_ground, energy, to);
    else if (contact.normal == EventContact::Normal::rigid && contact.moves[0] && u[0] > least) {
      states[i].status = ContactStatus::open;
      force[i].setZero();
    } else if (contact.has_friction && contact.rigid_shear)
      set_sliding(i, u.tail<2>());
  }
  bool changed = at_rest_on_ground || velocity != velocity_before;
  for (unsigned int i = 0; i < states.size(); ++i) {
    if (states[i].status != before[i].status) {
      to.events.push_back({present, i, states[i].status});
      to.contact_status[i] = states[i].status;
    }
    changed = changed || states[i].status != before[i].status ||
              states[i].direction != before[i].direction;
  }
  if (changed)
    motion.state_changed();
  return changed;
}

bool EventIntegrator::meet_imposed_jump(const double length, EnergyAccount &energy) {
  const LinearPart &linear = model.linear;
  const std::vector<double> before = imposed_rates;
  set_imposed(0., length);
  Vector jumps = Vector::Zero(imposed_rates.size()), impulse = Vector::Zero(velocity.size());
  for (unsigned int l = 0; l < before.size(); ++l) {
    const double jump = imposed_rates[l] - before[l];
    const double noise = motion.loads.rounding_of_factor_rate(l);
    if (std::abs(jump) <= std::max(noise, rounding_of_rate * std::max(std::abs(before[l]),
                                                                      std::abs(imposed_rates[l]))))
      continue;
    jumps[l] = jump;
    impulse += jump * linear.inertia(l);
  }
  if (jumps.isZero(0.))
    return false;
  const std::vector<double> after = imposed_rates;
  imposed_rates = before;
  const double kinetic = kinetic_energy();
  const Vector change = line.accelerate(impulse);
  velocity += change;
  imposed_rates = after;
  const Vector momentum = linear.imposed_products().mass * jumps;
  for (unsigned int l = 0; l < before.size(); ++l)
    if (linear.accelerates(l))
      energy.external +=
          (before[l] + after[l]) / 2. * (momentum[l] - linear.inertia(l).dot(change));
  const double gained = kinetic_energy() - kinetic;
  energy.kinetic += gained;
  energy.turnover += std::abs(gained);
  energy.at_hand = std::max(energy.at_hand, kinetic_energy() + stored_energy());
  return true;
}

void EventIntegrator::settle(const Vector &of_ground, EnergyAccount &energy, LineState &to) {
  std::vector<unsigned int> contacts;
  for (unsigned int i = 0; i < states.size(); ++i)
    if (states[i].is_closed())
      contacts.push_back(i);
  std::vector<int> held; // components
  for (unsigned int k = 0; k < contacts.size(); ++k) {
    const EventContact &contact = line.contacts[contacts[k]];
    const bool sticks = contact.has_friction && contact.rigid_shear &&
                        states[contacts[k]].status == ContactStatus::stick;
    for (int d = 0; d < 3; ++d)
      if (contact.moves[d] && (d == 0 ? contact.normal == EventContact::Normal::rigid : sticks))
        held.push_back(3 * k + d);
  }
  if (held.empty())
    return;
  const Eigen::MatrixXd columns = response_to_impulses(contacts);
  const Vector u = velocities(contacts, of_ground);
  Eigen::MatrixXd W(held.size(), held.size());
  Vector left(held.size());
  for (std::size_t a = 0; a < held.size(); ++a) {
    const EventContact &contact = line.contacts[contacts[held[a] / 3]];
    for (std::size_t b = 0; b < held.size(); ++b)
      W(a, b) = contact.displacement(columns.col(held[b]))[held[a] % 3];
    left[a] = -u[held[a]];
  }
  const Vector some = LeastSquares(W).solve(left);
  Vector impulses = Vector::Zero(3 * contacts.size());
  for (std::size_t a = 0; a < held.size(); ++a)
    impulses[held[a]] = some[a];
  act(contacts, impulses, columns, of_ground, energy, to);
}

} // namespace frictionbeam
