// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/section_chain.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using Vector6 = SectionChain::Vector6;
using Matrix6 = SectionChain::Matrix6;

constexpr unsigned int most_iterations = 100, most_searches = 40;
constexpr double most_overshoot = 0.5;
/// Of the elastic stiffness. Where all sections flow, nothing says which of them goes how far: with
/// so little more stiffness they share evenly.
constexpr double least_stiffness = 1e-8;
constexpr double solved_to = 1e-13, as_good_as_rounding = 1e-10; // relative

/// Of a section's stiffness, zero for its rigid components.
Matrix6 compliance_of(Matrix6 stiffness) {
  const Vector6 diagonal = stiffness.diagonal();
  const auto replace = [&](const double value) {
    for (int i = 0; i < 6; ++i)
      if (!(diagonal[i] > 0.)) {
        stiffness.row(i).setZero();
        stiffness.col(i).setZero();
        stiffness(i, i) = value;
      }
  };
  replace(1.);
  stiffness = stiffness.inverse().eval();
  replace(0.);
  return stiffness;
}

} // namespace

/**
 * Newton's equations in the changes of all strains and of beta, in units in which sections are of
 * stiffness 1:
 *   C_q de_q - b_q dbeta = b_q beta + sigma_load,q - sigma_q,   sum_q w_q b_q^T de_q = what is
 * missing of the motion. A rigid component has de = 0 in place of the first.
 */
struct SectionChain::Linear {
  explicit Linear(const SectionChain &chain)
      : chain(chain), n(6 * chain.size()), matrix(Eigen::MatrixXd::Zero(n + 6, n + 6)),
        right(Eigen::VectorXd::Zero(n + 6)) {}

  void set_right(const unsigned int q, const Vector6 &left_over) {
    for (int i = 0; i < 6; ++i)
      right[6 * q + i] = chain.scale[i] > 0. ? left_over[i] / chain.scale[i] : 0.;
  }
  void set(const unsigned int q, const Matrix6 &tangent) {
    const Point &point = chain.points[q];
    for (int i = 0; i < 6; ++i) {
      const int row = 6 * q + i;
      const double s = chain.scale[i];
      if (s == 0.) {
        matrix(row, row) = 1.;
        continue;
      }
      for (int j = 0; j < 6; ++j) {
        if (chain.scale[j] > 0.)
          matrix(row, 6 * q + j) =
              tangent(i, j) / (s * chain.scale[j]) + (i == j ? least_stiffness : 0.);
        const double b = point.b(i, j) * chain.beta_scale[j] / s;
        matrix(row, n + j) = -b;
        matrix(n + j, row) = point.length * b;
      }
    }
  }
  const SectionChain &chain;
  const int n;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

SectionChain::SectionChain(std::vector<Point> list, const Eigen::Matrix<double, 6, 12> &G,
                           const Matrix6 &elastic)
    : points(std::move(list)), G(G), scale(elastic.diagonal().cwiseMax(0.).cwiseSqrt()) {
  Vector6 flexibility = Vector6::Zero();
  for (const Point &point : points)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i)
        if (scale[i] > 0.)
          flexibility[j] += point.length * std::pow(point.b(i, j) / scale[i], 2);
  for (int j = 0; j < 6; ++j)
    beta_scale[j] = flexibility[j] > 0. ? 1. / std::sqrt(flexibility[j]) : 1.;
  compliance = compliance_of(elastic);
  Matrix6 by_beta = Matrix6::Zero();
  by_load.setZero();
  for (const Point &point : points) {
    by_beta += point.length * point.b.transpose() * compliance * point.b;
    by_load += point.length * point.b.transpose() * compliance * point.load_stress;
  }
  of_motion = by_beta.inverse();
  K = G.transpose() * of_motion * G;
}

void SectionChain::solve_elastically(const Vector12 &motions, const std::vector<Vector6> &free,
                                     const Eigen::Vector3d &load, Solution &solution) const {
  Vector6 moved = G * motions - by_load * load;
  for (std::size_t q = 0; q < points.size(); ++q)
    moved -= points[q].length * points[q].b.transpose() * free[q];
  const Vector6 beta = of_motion * moved;
  solution.strain.resize(points.size());
  for (std::size_t q = 0; q < points.size(); ++q)
    solution.strain[q] = compliance * (points[q].b * beta + points[q].load_stress * load);
  solution.forces = G.transpose() * beta;
  solution.stiffness = K;
  solution.solved = true;
}

SectionChain::Vector12 SectionChain::elastic_change(const Vector12 &motions,
                                                    const std::vector<Vector6> &free,
                                                    const Eigen::Vector3d &load) const {
  Vector6 moved = G * motions - by_load * load;
  for (std::size_t q = 0; q < points.size(); ++q)
    moved -= points[q].length * points[q].b.transpose() * free[q];
  return G.transpose() * of_motion * moved;
}

void SectionChain::solve(const Law &law, const Vector12 &motions, const std::vector<Vector6> &free,
                         const Eigen::Vector3d &load, Solution &solution) const {
  const unsigned int n_points = points.size();
  std::vector<Vector6> &strain = solution.strain;
  std::vector<Vector6> stress(n_points);
  std::vector<Matrix6> tangent(n_points);
  Vector6 beta = Vector6::Zero(), missing;
  const Vector6 moved = G * motions;
  double size_of_stress = 0., size_of_motion = 0.;
  Linear linear(*this);
  solution.solved = false;

  for (unsigned int q = 0; q < n_points; ++q)
    for (int i = 0; i < 6; ++i)
      if (scale[i] == 0.)
        strain[q][i] = 0.;
  const auto evaluate = [&]() {
    missing = moved;
    size_of_stress = 0.;
    size_of_motion = moved.cwiseProduct(beta_scale).lpNorm<Eigen::Infinity>();
    for (unsigned int q = 0; q < n_points; ++q) {
      const Point &point = points[q];
      if (!law(q, strain[q], stress[q], tangent[q]))
        return false;
      const Vector6 carried = point.b * beta + point.load_stress * load;
      for (int i = 0; i < 6; ++i) {
        if (scale[i] == 0.)
          stress[q][i] = carried[i];
        else
          size_of_stress = std::max({size_of_stress, std::abs(stress[q][i]) / scale[i],
                                     std::abs(strain[q][i]) * scale[i]});
        for (int j = 0; j < 6; ++j) {
          const double lever = point.length * point.b(i, j);
          missing[j] -= lever * (strain[q][i] + free[q][i]);
          size_of_motion =
              std::max(size_of_motion, std::abs(lever) * beta_scale[j] *
                                           (std::abs(strain[q][i]) + std::abs(free[q][i])));
        }
      }
      linear.set_right(q, carried - stress[q]);
    }
    for (int j = 0; j < 6; ++j)
      linear.right[linear.n + j] = missing[j] * beta_scale[j];
    return true;
  };
  // Of what the sections store and dissipate less the work of the load, which is least at the
  // solution among all strains of these motions: its slope along a direction.
  const auto slope = [&](const std::vector<Vector6> &direction) {
    double sum = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      for (int i = 0; i < 6; ++i)
        if (scale[i] > 0.)
          sum += points[q].length * direction[q][i] *
                 (stress[q][i] - points[q].load_stress.row(i).dot(load));
    return sum;
  };
  const auto is_solved = [&](const double to) {
    return linear.right.head(linear.n).lpNorm<Eigen::Infinity>() <= to * size_of_stress &&
           linear.right.tail<6>().lpNorm<Eigen::Infinity>() <= to * size_of_motion;
  };

  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
  const auto linearize = [&]() {
    for (unsigned int q = 0; q < n_points; ++q)
      linear.set(q, tangent[q]);
    factors.compute(linear.matrix);
  };
  if (!evaluate())
    return;
  for (unsigned int iteration = 0; iteration < most_iterations && !is_solved(solved_to);
       ++iteration) {
    linearize();
    const Eigen::VectorXd change = factors.solve(linear.right);
    if (!change.allFinite())
      return;
    const std::vector<Vector6> strain_before = strain;
    std::vector<Vector6> direction(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
      for (int i = 0; i < 6; ++i)
        direction[q][i] = scale[i] > 0. ? change[6 * q + i] / scale[i] : 0.;
    beta += beta_scale.cwiseProduct(change.tail<6>());
    const auto go = [&](const double length) {
      for (unsigned int q = 0; q < n_points; ++q)
        strain[q] = strain_before[q] + length * direction[q];
      return evaluate();
    };
    const double at_start = slope(direction);
    if (!go(1.))
      return;
    // Not beyond the least of it by more than a part of the way down; the first step is the one
    // that gives the sections the motion.
    const double allowed = most_overshoot * std::abs(at_start);
    double low = 0., high = 1., of_low = at_start, of_high = slope(direction);
    for (unsigned int k = 0;
         iteration > 0 && at_start < 0. && of_high > allowed && k < most_searches; ++k) {
      double length = low - of_low * (high - low) / (of_high - of_low);
      if (k % 2 == 1) // a plateau would hold the secant at one end
        length = std::sqrt(std::max(low, 1e-3 * high) * high);
      if (!go(length))
        return;
      const double here = slope(direction);
      if (std::abs(here) <= allowed)
        break;
      (here < 0. ? low : high) = length;
      (here < 0. ? of_low : of_high) = here;
      if (here < 0. && high - low < 1e-3 * high)
        break;
    }
  }
  if (!is_solved(as_good_as_rounding))
    return;
  // beta by the motions: the last rows answer to a unit of each.
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(linear.n + 6, 6);
  for (int j = 0; j < 6; ++j)
    unit(linear.n + j, j) = beta_scale[j];
  linearize();
  const Matrix6 by_motion = beta_scale.asDiagonal() * factors.solve(unit).bottomRows<6>();
  solution.forces = G.transpose() * beta;
  solution.stiffness = G.transpose() * by_motion * G;
  solution.solved = solution.stiffness.allFinite();
}

} // namespace frictionbeam
