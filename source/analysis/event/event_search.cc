// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Slip that is slower than this, of the fastest velocity so far, and stops within such a part of a
/// step, goes straight on: its direction has no power series where it stops. What is at rest
/// starts.
constexpr double slowest = 1e-8, shortest_stop = 1e-4, starting = 1e-13;

/// Sum of the sizes that a polynomial is the difference of, times rounding.
constexpr double eps = 1e-13;
/// Part of the ground's motion by which a contact that sticks may miss it.
constexpr double follows = 1e-6;

double size(const Eigen::MatrixXd &m, const int row) { return m.row(row).cwiseAbs().maxCoeff(); }
/// Of all components: each is made of the global ones, and has the rounding of the largest.
double size(const Eigen::MatrixXd &m) { return m.cwiseAbs().maxCoeff(); }

} // namespace

EventIntegrator::Event EventIntegrator::next_event() const {
  Event first;
  for (unsigned int i = 0; i < states.size(); ++i)
    if (const Event event = next_event(i); event.x < first.x)
      first = event;
  return first;
}

EventIntegrator::Event EventIntegrator::next_event(const unsigned int i) const {
  const EventContact &contact = line.contacts[i];
  const EventState &state = states[i];
  const Eigen::MatrixXd &g = motion.g[i], &r = motion.r[i];
  Event first;
  const auto look = [&](const Polynomial &p, const double rounding, const Kind kind) {
    if (const double x = first_root(p, rounding); x < first.x)
      first = {x, i, kind};
  };
  if (is_idle_half(i))
    return first;
  if (!state.is_closed()) {
    Polynomial gap = TaylorMotion::row(g, 0);
    gap[0] += contact.law.gap - state.offset;
    look(gap, eps * (contact.law.gap + std::abs(state.offset) + size(g)), Kind::closing);
    return first;
  }
  const Polynomial N = -TaylorMotion::row(r, 0);
  const double largest_N = size(r, 0);
  if (contact.normal == EventContact::Normal::elastic)
    look(N, eps * contact.normal_stiffness * (contact.law.gap + size(g)), Kind::opening);
  else if (contact.normal == EventContact::Normal::rigid && contact.moves[0])
    look(N, 100. * eps * largest_N, Kind::opening);
  if (!contact.has_friction)
    return first;

  if (state.status == ContactStatus::stick) {
    if (contact.rigid_shear && drag(i) != Eigen::Vector2d::Zero())
      return {0., i, Kind::dragged};
    const Event slip = next_slip(i);
    return slip.x < first.x ? slip : first;
  }
  Polynomial rate = slip_rate(i);
  if (state.began == present)
    rate[0] = 0.; // not the rounding that is left of it
  look(rate,
       std::abs(state.direction[0]) * noise_of_rate(i, 1) +
           std::abs(state.direction[1]) * noise_of_rate(i, 2),
       Kind::sticking);
  return first;
}

EventIntegrator::Event EventIntegrator::next_slip(const unsigned int i) const {
  const EventContact &contact = line.contacts[i];
  const EventState &state = states[i];
  const Eigen::MatrixXd &g = motion.g[i], &r = motion.r[i];
  const double f = contact.law.static_friction, largest_N = size(r, 0);
  double rounding = 100. * eps * (f * largest_N + size(r, 1) + size(r, 2));
  if (!contact.rigid_shear)
    rounding += eps * contact.shear_stiffness *
                (size(g, 1) + size(g, 2) + state.plastic.lpNorm<Eigen::Infinity>());
  if (state.at_limit)
    rounding = std::max(rounding, limit_of_statics * f * largest_N);
  const Polynomial N = -TaylorMotion::row(r, 0), T1 = TaylorMotion::row(r, 1),
                   T2 = TaylorMotion::row(r, 2);
  const bool only_1 = size(r, 2) <= no_component * size(r, 1),
             only_2 = size(r, 1) <= no_component * size(r, 2);
  Event first;
  const auto look = [&](const Polynomial &p, const double noise) {
    if (const double x = first_root(p, noise); x < first.x)
      first = {x, i, Kind::slipping};
  };
  if (only_1 || only_2) {
    const Polynomial &T = only_1 ? T1 : T2;
    look(f * N - T, rounding);
    look(f * N + T, rounding);
  } else {
    const double scale = f * largest_N + size(r, 1) + size(r, 2);
    look(f * f * product(N, N) - product(T1, T1) - product(T2, T2), scale * rounding);
  }
  return first;
}

double EventIntegrator::noise_of_rate(const unsigned int i, const int d) const {
  if (!line.ground_moves)
    return eps * size(motion.g[i], d);
  return motion_length * (eps * fastest + motion.loads.rounding_of_ground_rate(3 * i + d));
}

Eigen::Vector2d EventIntegrator::drag(const unsigned int i) const {
  const EventContact &contact = line.contacts[i];
  const Eigen::MatrixXd &g = motion.g[i];
  const bool follows_all = contact.moves[1] && contact.moves[2] && !motion.is_overdetermined();
  if (!line.ground_moves || follows_all)
    return Eigen::Vector2d::Zero();
  double noise = 0.;
  if (motion.is_overdetermined())
    noise = eps * motion_length * motion_length *
            contact.displacement(acceleration_by_contacts(0.)).lpNorm<Eigen::Infinity>();
  Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(2, g.cols());
  for (int d = 1; d < 3; ++d)
    for (Eigen::Index k = 1; k < motion.loads.ground.rows(); ++k) {
      double least = noise_of_rate(i, d) / k;
      if (contact.moves[d]) { // by the line, and it follows but where the ground cannot be followed
        const double of_ground = motion.loads.ground.row(k).lpNorm<Eigen::Infinity>();
        if (k == 1 || of_ground == 0. || !motion.is_overdetermined())
          continue;
        least = std::max({least, noise, follows * of_ground});
      }
      if (std::abs(g(d, k)) > least)
        rates(d - 1, k) = k * g(d, k);
    }
  const double largest = rates.rightCols(rates.cols() - 2).colwise().norm().maxCoeff();
  for (Eigen::Index k = 2; k < rates.cols(); ++k) // it is at rest
    if (rates.col(k).norm() > no_component * largest)
      return rates.col(k).normalized();
  return rates.col(1).norm() > 0. ? Eigen::Vector2d(rates.col(1).normalized())
                                  : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

Polynomial EventIntegrator::slip_rate(const unsigned int i) const {
  const EventContact &contact = line.contacts[i];
  const Eigen::MatrixXd &g = motion.g[i], &s = motion.s[i];
  Polynomial rate;
  if (s.cols() == 0) {
    const Eigen::Vector2d d = states[i].direction;
    rate = derivative(d[0] * TaylorMotion::row(g, 1) + d[1] * TaylorMotion::row(g, 2));
  } else
    rate = product(TaylorMotion::row(s, 0), derivative(TaylorMotion::row(g, 1))) +
           product(TaylorMotion::row(s, 1), derivative(TaylorMotion::row(g, 2)));
  if (contact.rigid_shear)
    return rate;
  const Polynomial released = derivative(contact.law.dynamic_friction / contact.shear_stiffness *
                                         TaylorMotion::row(motion.r[i], 0));
  rate.head(released.size()) += released;
  return rate;
}

bool EventIntegrator::find_curves() {
  bool found = false;
  for (unsigned int i = 0; i < states.size(); ++i) {
    EventState &state = states[i];
    if (state.status != ContactStatus::slip || !line.contacts[i].has_friction || state.curved)
      continue;
    const Eigen::Vector2d s = state.direction;
    const Polynomial g1 = TaylorMotion::row(motion.g[i], 1), g2 = TaylorMotion::row(motion.g[i], 2);
    const double along = derivative(s[0] * g1 + s[1] * g2).lpNorm<Eigen::Infinity>(),
                 across = derivative(s[0] * g2 - s[1] * g1).lpNorm<Eigen::Infinity>();
    if (across <= 1e-9 * along || across <= std::max(noise_of_rate(i, 1), noise_of_rate(i, 2)) ||
        across <= no_component * (g1.lpNorm<Eigen::Infinity>() + g2.lpNorm<Eigen::Infinity>()) ||
        stops(i))
      continue;
    state.curved = found = true;
  }
  if (found)
    motion.state_changed();
  return found;
}

bool EventIntegrator::stops(const unsigned int i) const {
  const double rate = std::hypot(motion.g[i](1, 1), motion.g[i](2, 1)) / motion_length;
  const double at_rest = std::max(starting * fastest * motion_length,
                                  std::max(noise_of_rate(i, 1), noise_of_rate(i, 2)));
  if (!line.contacts[i].rigid_shear || is_fast(rate) || rate * motion_length <= at_rest)
    return false;
  const double end = first_root(slip_rate(i), 0.);
  return end <= 1. && end * motion_length <= shortest_stop * output_step;
}

bool EventIntegrator::is_fast(const double rate) const { return rate > slowest * fastest; }

} // namespace frictionbeam
