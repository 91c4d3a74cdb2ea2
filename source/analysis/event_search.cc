// SPDX-License-Identifier: LGPL-2.1-or-later
#include "event_integrator.h"

#include <cmath>

namespace frictionbeam {

namespace {

/// Sum of the sizes that a polynomial is the difference of, times rounding.
constexpr double eps = 1e-13;

double size(const Eigen::MatrixXd &m, const int row) { return m.row(row).cwiseAbs().maxCoeff(); }

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
  if (!state.is_closed()) {
    Polynomial gap = TaylorMotion::row(g, 0);
    gap[0] += contact.law.gap - state.offset;
    look(gap, eps * (contact.law.gap + std::abs(state.offset) + size(g, 0)), Kind::closing);
    return first;
  }
  const Polynomial N = -TaylorMotion::row(r, 0);
  const double largest_N = size(r, 0);
  if (contact.normal == EventContact::Normal::elastic)
    look(N, eps * contact.normal_stiffness * (contact.law.gap + size(g, 0)), Kind::opening);
  else if (contact.normal == EventContact::Normal::rigid && contact.moves[0])
    look(N, 100. * eps * largest_N, Kind::opening);
  if (!contact.has_friction)
    return first;

  if (state.status == ContactStatus::stick) {
    const double f = contact.law.static_friction;
    double rounding = 100. * eps * (f * largest_N + size(r, 1) + size(r, 2));
    if (!contact.rigid_shear)
      rounding += eps * contact.shear_stiffness *
                  (size(g, 1) + size(g, 2) + state.plastic.lpNorm<Eigen::Infinity>());
    const Polynomial T1 = TaylorMotion::row(r, 1), T2 = TaylorMotion::row(r, 2);
    const bool only_1 = size(r, 2) <= 1e-12 * size(r, 1), only_2 = size(r, 1) <= 1e-12 * size(r, 2);
    if (only_1 || only_2) {
      const Polynomial &T = only_1 ? T1 : T2;
      look(f * N - T, rounding, Kind::slipping);
      look(f * N + T, rounding, Kind::slipping);
    } else {
      const double scale = f * largest_N + size(r, 1) + size(r, 2);
      look(f * f * product(N, N) - product(T1, T1) - product(T2, T2), scale * rounding,
           Kind::slipping);
    }
  } else {
    Polynomial path =
        state.direction[0] * TaylorMotion::row(g, 1) + state.direction[1] * TaylorMotion::row(g, 2);
    const double largest = path.lpNorm<Eigen::Infinity>();
    if (!contact.rigid_shear)
      path -= contact.law.dynamic_friction / contact.shear_stiffness * N;
    look(derivative(path), eps * largest, Kind::sticking);
  }
  return first;
}

bool EventIntegrator::slips_along_a_curve() const {
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (states[i].status != ContactStatus::slip || !contact.has_friction)
      continue;
    const Eigen::Vector2d s = states[i].direction;
    const Polynomial g1 = TaylorMotion::row(motion.g[i], 1), g2 = TaylorMotion::row(motion.g[i], 2);
    const double along = derivative(s[0] * g1 + s[1] * g2).lpNorm<Eigen::Infinity>(),
                 across = derivative(s[0] * g2 - s[1] * g1).lpNorm<Eigen::Infinity>();
    if (across > 1e-9 * along &&
        across > 1e-12 * (g1.lpNorm<Eigen::Infinity>() + g2.lpNorm<Eigen::Infinity>()))
      return true;
  }
  return false;
}

bool EventIntegrator::events_accumulate(const double time, const double step) {
  const std::size_t most = 30 + 4 * states.size();
  recent.push_back(time);
  if (recent.size() > most)
    recent.erase(recent.begin());
  return recent.size() == most && recent.back() - recent.front() < 1e-4 * step;
}

} // namespace frictionbeam
