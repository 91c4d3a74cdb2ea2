// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"

#include <array>
#include <cmath>

namespace frictionbeam {

namespace {

/// Places in [0, 1] and weights of Gauss' rule with three points.
const std::array<std::pair<double, double>, 3> gauss_3 = {
    {{0.5 - std::sqrt(0.15), 5. / 18.}, {0.5, 4. / 9.}, {0.5 + std::sqrt(0.15), 5. / 18.}}};

} // namespace

double EventIntegrator::kinetic_energy() const {
  return velocity.dot(model.linear.mass() * velocity) / 2. +
         model.linear.kinetic_by_imposed(imposed_rates, velocity);
}

double EventIntegrator::stored_energy() const {
  double energy = unknowns.dot(model.linear.stiffness() * unknowns) / 2. +
                  model.linear.stored_by_imposed(imposed_factors, unknowns);
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (!states[i].is_closed())
      continue;
    if (contact.normal == EventContact::Normal::elastic)
      energy += force[i][0] * force[i][0] / (2. * contact.normal_stiffness);
    if (!contact.rigid_shear)
      energy += force[i].tail<2>().squaredNorm() / (2. * contact.shear_stiffness);
  }
  return energy;
}

void EventIntegrator::set_imposed(const double x, const double length) {
  const int n = motion.loads.factors.cols();
  imposed_factors.assign(n, 0.);
  imposed_rates.assign(n, 0.);
  imposed_accelerations.assign(n, 0.);
  for (int l = 0; l < n; ++l)
    if (model.linear.accelerates(l)) {
      imposed_factors[l] = value(motion.loads.factors.col(l), x);
      const Polynomial rate = derivative(motion.loads.factors.col(l));
      imposed_rates[l] = value(rate, x) / length;
      imposed_accelerations[l] = value(derivative(rate), x) / (length * length);
    }
}

double EventIntegrator::work_of_loads(const double x, const double length) const {
  const LinearPart &linear = model.linear;
  const LinearPart::Products &products = linear.imposed_products();
  const auto of_unknowns = [](const Eigen::MatrixXd &m, const Vector &forces) {
    return Polynomial(m.transpose() * forces);
  };
  double work = 0.;
  for (int l = 0; l < motion.loads.factors.cols(); ++l) {
    const Polynomial factor = motion.loads.factors.col(l), rate = derivative(factor);
    if (factor.isZero(0.))
      continue;
    if (!linear.accelerates(l)) {
      work += length * integral_of_product(factor, of_unknowns(motion.v, linear.forces(l)), x);
      continue;
    }
    // Of the reaction K u + C v + M a on the motion, whose forces on the unknowns do no work.
    work -= integral_of_product(rate, of_unknowns(motion.q, linear.forces(l)), x);
    const Polynomial v = of_unknowns(motion.v, linear.inertia(l));
    work -= integral_of_product(rate, derivative(v), x) / length;
    work -= integral_of_product(rate, of_unknowns(motion.v, linear.drag(l)), x);
    for (int k = 0; k < motion.loads.factors.cols(); ++k) {
      const Polynomial other = motion.loads.factors.col(k), other_rate = derivative(other);
      if (products.stiffness(k, l) == 0. && products.mass(k, l) == 0. &&
          products.damping(k, l) == 0.)
        continue;
      work += products.stiffness(k, l) * integral_of_product(rate, other, x) +
              products.damping(k, l) / length * integral_of_product(rate, other_rate, x) +
              products.mass(k, l) / (length * length) *
                  integral_of_product(rate, derivative(other_rate), x);
    }
  }
  return work;
}

double EventIntegrator::frictionless_wear(const unsigned int i, const double x) const {
  const Polynomial N = -TaylorMotion::row(motion.r[i], 0);
  const std::array<Polynomial, 2> rates = {derivative(TaylorMotion::row(motion.g[i], 1)),
                                           derivative(TaylorMotion::row(motion.g[i], 2))};
  if (rates[0].isZero(0.) && rates[1].isZero(0.))
    return 0.;
  const auto rate = [&](const double y) {
    return Eigen::Vector2d(value(rates[0], y), value(rates[1], y));
  };
  // Gauss' rule of order 6 on pieces; along a line it turns round where one component is zero.
  constexpr int n_pieces = 24;
  const bool on_a_line = rates[0].isZero(0.) || rates[1].isZero(0.);
  double wear = 0., before = 0.;
  for (int k = 1; k <= n_pieces; ++k) {
    const double after = x * k / n_pieces;
    double turn = after;
    if (on_a_line && rate(before).dot(rate(after)) < 0.)
      for (double a = before, b = after; b - a > 1e-16;) {
        turn = (a + b) / 2.;
        if (turn <= a || turn >= b)
          break;
        (rate(turn).dot(rate(after)) < 0. ? a : b) = turn;
      }
    for (const auto &[from, to] : {std::pair(before, turn), std::pair(turn, after)})
      for (const auto &[place, weight] : gauss_3) {
        const double y = from + (to - from) * place;
        wear += (to - from) * weight * value(N, y) * rate(y).norm();
      }
    before = after;
  }
  return wear;
}

double EventIntegrator::work_of_dampers(const double x, const double length) const {
  // Gauss' rule of order 6 on pieces: the motion is smooth
  constexpr int n_pieces = 24;
  const Eigen::MatrixXd &products = model.linear.imposed_products().damping;
  double work = 0.;
  for (int k = 0; k < n_pieces; ++k)
    for (const auto &[place, weight] : gauss_3) {
      const double y = x * (k + place) / n_pieces;
      const Vector now = TaylorMotion::at(motion.v, y);
      double power = now.dot(model.linear.damping() * now);
      Vector rates = Vector::Zero(products.cols());
      for (int l = 0; l < rates.size(); ++l)
        if (model.linear.accelerates(l)) {
          rates[l] = value(derivative(motion.loads.factors.col(l)), y) / length;
          power -= 2. * rates[l] * model.linear.drag(l).dot(now);
        }
      work += length * x / n_pieces * weight * (power + rates.dot(products * rates));
    }
  return work;
}

} // namespace frictionbeam
