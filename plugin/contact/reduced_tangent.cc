// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reduced_tangent.h"

#include <Eigen/QR>

#include <cmath>

namespace frictionbeam::contact {

namespace {
constexpr double stiff_beside_body = 1e3; ///< times S: what is eliminated first
}

ReducedTangent::ReducedTangent(const SparseMatrix &S, const SiteList &contacts,
                               const std::vector<std::vector<int>> &unknowns)
    : contacts(contacts), unknowns(unknowns), Z(S.rows(), S.rows()) {
  choose_directions(contacts);
  const auto times_Z = [&](const Eigen::MatrixXd &matrix) {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(matrix.rows(), matrix.cols());
    for (int k = 0; k < Z.rows(); ++k)
      for (SparseMatrix::InnerIterator entry(Z, k); entry; ++entry)
        product.col(entry.col()) += entry.value() * matrix.col(k);
    return product;
  };
  S_of_y = times_Z(times_Z(Eigen::MatrixXd(S)).transpose());
  scale = S_of_y.diagonal().cwiseAbs().cwiseSqrt();
  for (double &s : scale)
    s = s > 0. ? s : 1.;
}

void ReducedTangent::choose_directions(const SiteList &contacts) {
  std::vector<int> n_contacts(Z.rows(), 0);
  for (const std::vector<int> &list : unknowns)
    for (const int unknown : list)
      ++n_contacts[unknown];
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<bool> is_replaced(Z.rows(), false);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    std::array<int, 3> &of_contact = directions.emplace_back(std::array<int, 3>{-1, -1, -1});
    const auto B = contacts[i].B.topRows<3>();
    std::vector<int> own, others;
    for (unsigned int k = 0; k < unknowns[i].size(); ++k)
      (n_contacts[unknowns[i][k]] == 1 ? own : others).push_back(k);
    if (own.size() < 3 || !contacts[i].B.row(3).isZero(0.))
      continue;
    Eigen::MatrixXd of_own(3, own.size());
    for (unsigned int k = 0; k < own.size(); ++k)
      of_own.col(k) = B.col(own[k]);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivots(of_own);
    pivots.setThreshold(1e-3);
    if (pivots.rank() < 3)
      continue;
    const auto &order = pivots.colsPermutation().indices();
    Eigen::Matrix3d replaced;
    for (int d = 0; d < 3; ++d) {
      of_contact[d] = unknowns[i][own[order[d]]];
      is_replaced[of_contact[d]] = true;
      replaced.col(d) = B.col(own[order[d]]);
    }
    for (unsigned int k = 3; k < own.size(); ++k)
      others.push_back(own[order[k]]);
    const Eigen::Matrix3d inverse = replaced.inverse();
    for (int row = 0; row < 3; ++row) {
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(of_contact[row], of_contact[d], inverse(row, d));
      for (const int k : others)
        entries.emplace_back(of_contact[row], unknowns[i][k], -inverse.row(row).dot(B.col(k)));
    }
  }
  for (int j = 0; j < Z.rows(); ++j)
    if (!is_replaced[j])
      entries.emplace_back(j, j, 1.);
  Z.setFromTriplets(entries.begin(), entries.end());
}

void ReducedTangent::find_entries(const std::vector<Block> &stiffness) {
  entries.clear();
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const double weight = contacts[i].weight;
    if (directions[i][0] >= 0) {
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          if (stiffness[i](a, b) != 0.)
            entries.push_back({directions[i][a], directions[i][b], weight * stiffness[i](a, b)});
      continue;
    }
    const auto &B = contacts[i].B;
    const Eigen::MatrixXd block = weight * B.transpose() * stiffness[i] * B;
    for (Eigen::Index a = 0; a < block.rows(); ++a)
      for (Eigen::Index b = 0; b < block.cols(); ++b)
        entries.push_back({unknowns[i][a], unknowns[i][b], block(a, b)});
  }
}

void ReducedTangent::divide() {
  const int n = S_of_y.rows();
  Vector diagonal = Vector::Zero(n);
  is_stiff.assign(n, true);
  for (const Entry &entry : entries)
    if (entry.row == entry.column)
      diagonal[entry.row] += entry.value;
    else
      is_stiff[entry.row] = false;
  free.clear();
  stiff.clear();
  place.resize(n);
  std::vector<double> pivots;
  for (int j = 0; j < n; ++j) {
    is_stiff[j] = is_stiff[j] && diagonal[j] > stiff_beside_body * scale[j] * scale[j];
    std::vector<int> &list = is_stiff[j] ? stiff : free;
    place[j] = list.size();
    list.push_back(j);
    if (is_stiff[j])
      pivots.push_back(diagonal[j] + S_of_y(j, j));
  }
  held = Eigen::Map<const Vector>(pivots.data(), pivots.size());
  friction.clear();
  for (const Entry &entry : entries)
    if (!is_stiff[entry.row] && is_stiff[entry.column])
      friction.push_back(
          {place[entry.row], place[entry.column], entry.value / held[place[entry.column]]});
}

Eigen::MatrixXd ReducedTangent::matrix_of_free() const {
  const int n = free.size();
  Eigen::MatrixXd F(n, n);
  for (int b = 0; b < n; ++b) {
    const double *const column = S_of_y.col(free[b]).data();
    for (int a = 0; a < n; ++a)
      F(a, b) = column[free[a]];
    for (const Entry &entry : friction)
      F(entry.row, b) -= entry.value * column[stiff[entry.column]];
  }
  for (const Entry &entry : entries)
    if (!is_stiff[entry.row] && !is_stiff[entry.column])
      F(place[entry.row], place[entry.column]) += entry.value;
  return F;
}

bool ReducedTangent::factorize(const std::vector<Block> &stiffness) {
  constexpr double vanishes = 1e-15;
  find_entries(stiffness);
  divide();
  Eigen::MatrixXd F = matrix_of_free();
  free_scale = F.diagonal().cwiseAbs();
  for (double &s : free_scale)
    s = s > 0. ? 1. / std::sqrt(s) : 1.;
  F = free_scale.asDiagonal() * F * free_scale.asDiagonal();
  factors.compute(F);
  return free.empty() || factors.matrixLU().diagonal().cwiseAbs().minCoeff() > vanishes;
}

Vector ReducedTangent::solve_roughly(const Vector &forces) const {
  Vector y(forces.size()), of_free(free.size()), of_stiff(stiff.size());
  for (std::size_t k = 0; k < stiff.size(); ++k)
    of_stiff[k] = forces[stiff[k]];
  for (std::size_t k = 0; k < free.size(); ++k)
    of_free[k] = forces[free[k]];
  for (const Entry &entry : friction)
    of_free[entry.row] -= entry.value * of_stiff[entry.column];
  if (!free.empty())
    of_free = free_scale.cwiseProduct(Vector(factors.solve(free_scale.cwiseProduct(of_free))));
  y.setZero();
  Vector by_free = Vector::Zero(y.size());
  for (std::size_t k = 0; k < free.size(); ++k) {
    y[free[k]] = of_free[k];
    by_free += of_free[k] * S_of_y.col(free[k]);
  }
  for (std::size_t k = 0; k < stiff.size(); ++k)
    y[stiff[k]] = (of_stiff[k] - by_free[stiff[k]]) / held[k];
  return y;
}

bool ReducedTangent::solve(const Vector &right_hand_side, Vector &x) const {
  constexpr double nothing_left = 1e-14, little_left = 1e-10, rounding = 1e-13, gained = 0.1;
  constexpr int most_refinements = 10;
  Vector left = Z.transpose() * right_hand_side, y = Vector::Zero(left.size());
  const double at_first = left.cwiseQuotient(scale).lpNorm<Eigen::Infinity>();
  double size = at_first;
  for (int k = 0; k < most_refinements && size > nothing_left * at_first; ++k) {
    const Vector correction = solve_roughly(left);
    y += correction;
    left.noalias() -= S_of_y * correction;
    for (const Entry &entry : entries)
      left[entry.row] -= entry.value * correction[entry.column];
    const double before = size;
    size = left.cwiseQuotient(scale).lpNorm<Eigen::Infinity>();
    if (!(size < gained * before))
      break;
  }
  // What rounding leaves may be more where the body moves far as a whole.
  const double far = y.cwiseProduct(scale).lpNorm<Eigen::Infinity>();
  if (!(size <= std::max(little_left * at_first, rounding * far)))
    return false;
  x = Z * y;
  return true;
}

} // namespace frictionbeam::contact
