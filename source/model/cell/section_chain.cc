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
/// Of what the first guess carries, where hardly anything is to be carried.
constexpr double of_guess = 1e-6;

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
 * missing of the motion. A rigid component has de = 0 in place of the first. Sections that answer
 * elastically are condensed, whose C_q does not change: few of a cell's flow.
 */
struct SectionChain::Linear {
  explicit Linear(const SectionChain &chain)
      : chain(chain), n(6 * chain.size()), right(Eigen::VectorXd::Zero(n + 6)) {}

  void set_right(const unsigned int q, const Vector6 &left_over) {
    for (int i = 0; i < 6; ++i)
      right[6 * q + i] = chain.scale[i] > 0. ? left_over[i] / chain.scale[i] : 0.;
  }

  void factorize(const std::vector<Matrix6> &tangent) {
    flowing.clear();
    Matrix6 by_beta = Matrix6::Zero();
    for (unsigned int q = 0; q < chain.size(); ++q)
      if (tangent[q] == chain.points[q].elastic)
        by_beta += chain.scaled[q].flexibility;
      else
        flowing.push_back(q);
    const int n_flowing = 6 * flowing.size();
    matrix.setZero(n_flowing + 6, n_flowing + 6);
    matrix.bottomRightCorner<6, 6>() = by_beta;
    for (std::size_t k = 0; k < flowing.size(); ++k) {
      const unsigned int q = flowing[k];
      matrix.block<6, 6>(6 * k, 6 * k) = chain.in_units(tangent[q]);
      matrix.block<6, 6>(6 * k, n_flowing) = -chain.scaled[q].b;
      matrix.block<6, 6>(n_flowing, 6 * k) = chain.points[q].length * chain.scaled[q].b.transpose();
    }
    factors.compute(matrix);
  }

  /// Changes of all strains and of beta.
  Eigen::VectorXd solve() const {
    const int n_flowing = 6 * flowing.size();
    Eigen::VectorXd condensed(n_flowing + 6);
    condensed.tail<6>() = right.tail<6>();
    std::size_t k = 0;
    for (unsigned int q = 0; q < chain.size(); ++q) {
      const auto left_over = right.segment<6>(6 * q);
      if (flows(q, k))
        condensed.segment<6>(6 * k++) = left_over;
      else
        condensed.tail<6>() -= chain.points[q].length *
                               (chain.scaled[q].b.transpose() * (chain.scaled[q].soft * left_over));
    }
    const Eigen::VectorXd of_flowing = factors.solve(condensed);
    Eigen::VectorXd change(n + 6);
    change.tail<6>() = of_flowing.tail<6>();
    k = 0;
    for (unsigned int q = 0; q < chain.size(); ++q)
      if (flows(q, k))
        change.segment<6>(6 * q) = of_flowing.segment<6>(6 * k++);
      else
        change.segment<6>(6 * q) =
            chain.scaled[q].soft * (chain.scaled[q].b * change.tail<6>() + right.segment<6>(6 * q));
    return change;
  }

  /// beta by the motion of the second end.
  Matrix6 by_motion() const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(6 * flowing.size() + 6, 6);
    unit.bottomRows<6>() = chain.beta_scale.asDiagonal();
    return chain.beta_scale.asDiagonal() * factors.solve(unit).bottomRows<6>();
  }

  const SectionChain &chain;
  const int n;
  Eigen::VectorXd right;

private:
  bool flows(const unsigned int q, const std::size_t k) const {
    return k < flowing.size() && flowing[k] == q;
  }
  std::vector<unsigned int> flowing; ///< points, ascending
  Eigen::MatrixXd matrix;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

SectionChain::SectionChain(std::vector<Point> list, const Eigen::Matrix<double, 6, 12> &G)
    : points(std::move(list)), G(G),
      scale(points.front().elastic.diagonal().cwiseMax(0.).cwiseSqrt()) {
  Vector6 flexibility = Vector6::Zero();
  for (const Point &point : points)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i)
        if (scale[i] > 0.)
          flexibility[j] += point.length * std::pow(point.b(i, j) / scale[i], 2);
  for (int j = 0; j < 6; ++j)
    beta_scale[j] = flexibility[j] > 0. ? 1. / std::sqrt(flexibility[j]) : 1.;
  for (const Point &point : points) {
    compliance.push_back(compliance_of(point.elastic));
    Scaled &own = scaled.emplace_back();
    own.soft = in_units(point.elastic).inverse();
    for (int i = 0; i < 6; ++i)
      if (scale[i] == 0.)
        own.soft(i, i) = 0.;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        own.b(i, j) = scale[i] > 0. ? point.b(i, j) * beta_scale[j] / scale[i] : 0.;
    own.flexibility = point.length * own.b.transpose() * own.soft * own.b;
  }
  Matrix6 by_beta = Matrix6::Zero();
  by_load.setZero();
  for (std::size_t q = 0; q < points.size(); ++q) {
    const Matrix6 bent = points[q].length * points[q].b.transpose() * compliance[q];
    by_beta += bent * points[q].b;
    by_load += bent * points[q].load_stress;
  }
  of_motion = by_beta.inverse();
  K = G.transpose() * of_motion * G;
}

SectionChain::Matrix6 SectionChain::in_units(const Matrix6 &stiffness) const {
  Matrix6 result = Matrix6::Identity();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (scale[i] > 0. && scale[j] > 0.)
        result(i, j) = stiffness(i, j) / (scale[i] * scale[j]) + (i == j ? least_stiffness : 0.);
  return result;
}

void SectionChain::solve_elastically(const Vector12 &motions, const std::vector<Vector6> &free,
                                     const Eigen::Vector3d &load, Solution &solution) const {
  Vector6 moved = G * motions - by_load * load;
  for (std::size_t q = 0; q < points.size(); ++q)
    moved -= points[q].length * points[q].b.transpose() * free[q];
  const Vector6 beta = of_motion * moved;
  solution.strain.resize(points.size());
  for (std::size_t q = 0; q < points.size(); ++q)
    solution.strain[q] = compliance[q] * (points[q].b * beta + points[q].load_stress * load);
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
  double size_of_stress = 0., size_of_motion = 0., least_stress = 0., least_motion = 0.;
  Linear linear(*this);
  solution.solved = solution.compatible = false;

  for (unsigned int q = 0; q < n_points; ++q)
    for (int i = 0; i < 6; ++i)
      if (scale[i] == 0.)
        strain[q][i] = 0.;
  const auto evaluate = [&]() {
    missing = moved;
    size_of_stress = least_stress;
    size_of_motion =
        std::max(least_motion, moved.cwiseProduct(beta_scale).lpNorm<Eigen::Infinity>());
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
                                     std::abs(strain[q][i]) * scale[i],
                                     std::abs(free[q][i]) * scale[i]}); // as if it were clamped
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

  if (!evaluate())
    return;
  least_stress = of_guess * size_of_stress;
  least_motion = of_guess * size_of_motion;
  for (unsigned int iteration = 0; iteration < most_iterations && !is_solved(solved_to);
       ++iteration) {
    linear.factorize(tangent);
    const Eigen::VectorXd change = linear.solve();
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
  solution.compatible =
      linear.right.tail<6>().lpNorm<Eigen::Infinity>() <= as_good_as_rounding * size_of_motion;
  if (!is_solved(as_good_as_rounding))
    return;
  linear.factorize(tangent);
  solution.forces = G.transpose() * beta;
  solution.stiffness = G.transpose() * linear.by_motion() * G;
  solution.solved = solution.stiffness.allFinite();
}

} // namespace frictionbeam
