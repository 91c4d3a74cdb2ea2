// SPDX-License-Identifier: LGPL-2.1-or-later
#include "condensed_parts.h"

#include <algorithm>

namespace frictionbeam::contact {

namespace {
constexpr std::size_t largest_dense = 96;
/// A pipe between supports has twelve unknowns at its border, a branched one some more.
constexpr std::size_t widest_of_lines = 48;
} // namespace

Condensation::Condensation(const int n_unknowns, const std::vector<int> &keep)
    : kept(keep), place_of(n_unknowns, -1) {
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (unsigned int k = 0; k < kept.size(); ++k)
    place_of[kept[k]] = k;
}

void Condensation::add_places(const std::vector<std::vector<int>> &blocks) {
  std::vector<Eigen::Triplet<double>> missing;
  for (const std::vector<int> &unknowns : blocks)
    for (const int i : unknowns)
      for (const int j : unknowns) {
        const int row = place_of[i],
                  column = place_of[j], *const begin = S.innerIndexPtr() + S.outerIndexPtr()[row],
                  *const end = S.innerIndexPtr() + S.outerIndexPtr()[row + 1];
        if (!std::binary_search(begin, end, column))
          missing.emplace_back(row, column, 0.);
      }
  if (missing.empty())
    return;
  SparseMatrix places(S.rows(), S.cols());
  places.setFromTriplets(missing.begin(), missing.end());
  S = (S + places).eval();
  S.makeCompressed();
}

CondensedParts::CondensedParts(const SparseMatrix &stiffness, const std::vector<int> &keep)
    : Condensation(stiffness.rows(), keep), place_inside(stiffness.rows(), -1) {
  find_parts(stiffness);
  std::vector<Eigen::Triplet<double>> entries;
  for (unsigned int k = 0; k < kept.size(); ++k)
    for (SparseMatrix::InnerIterator entry(stiffness, kept[k]); entry; ++entry)
      if (const int column = place_of[entry.col()]; column >= 0)
        entries.emplace_back(k, column, entry.value());
  for (Part &part : parts)
    condense_part(stiffness, part, entries);
  S.resize(kept.size(), kept.size());
  S.setFromTriplets(entries.begin(), entries.end());
}

void CondensedParts::find_parts(const SparseMatrix &stiffness) {
  std::vector<bool> reached(stiffness.rows(), false);
  for (int first = 0; first < stiffness.rows(); ++first) {
    if (place_of[first] >= 0 || reached[first])
      continue;
    Part &part = parts.emplace_back();
    part.inside = {first};
    reached[first] = true;
    for (std::size_t i = 0; i < part.inside.size(); ++i)
      for (SparseMatrix::InnerIterator entry(stiffness, part.inside[i]); entry; ++entry)
        if (place_of[entry.col()] >= 0)
          part.border.push_back(place_of[entry.col()]);
        else if (!reached[entry.col()]) {
          reached[entry.col()] = true;
          part.inside.push_back(entry.col());
        }
    std::sort(part.inside.begin(), part.inside.end());
    std::sort(part.border.begin(), part.border.end());
    part.border.erase(std::unique(part.border.begin(), part.border.end()), part.border.end());
  }
}

int CondensedParts::Part::take_dense(const SparseMatrix &matrix) {
  constexpr double nothing = 1e-13; // of the diagonal, as in PartCholesky
  dense.compute(Eigen::MatrixXd(matrix));
  if (border.empty())
    influence.resize(inside.size(), 0);
  else
    influence = dense.solve(Eigen::MatrixXd(to_border));
  Eigen::VectorXi at = Eigen::VectorXi::LinSpaced(matrix.rows(), 0, matrix.rows() - 1);
  for (Eigen::Index k = 0; k < at.size(); ++k)
    std::swap(at[k], at[dense.transpositionsP().coeff(k)]);
  for (Eigen::Index k = 0; k < at.size(); ++k)
    if (!(dense.vectorD()[k] > nothing * matrix.coeff(at[k], at[k])))
      return inside[at[k]];
  return -1;
}

int CondensedParts::Part::take_sparse(SparseMatrix &matrix) {
  constexpr double suspicious = 1e-9; // of the largest entry of the diagonal
  sparse = std::make_unique<LineFactorization>();
  sparse->analyze(matrix);
  int free = -1;
  const bool is_regular = sparse->factorize(matrix);
  if (!is_regular || sparse->least_pivot() < suspicious * matrix.diagonal().maxCoeff())
    if (const PartCholesky asked(matrix, to_border); !asked.ok())
      free = inside[asked.vanishing()];
  if (!is_regular) { // something turns freely between its ends
    for (int i = 0; i < matrix.rows(); ++i)
      matrix.coeffRef(i, i) *= 1. + 1e-9;
    sparse->factorize(matrix);
  }
  const Eigen::MatrixXd columns(to_border);
  influence.resize(inside.size(), border.size());
  for (std::size_t b = 0; b < border.size(); ++b)
    influence.col(b) = sparse->solve(columns.col(b));
  return free;
}

void CondensedParts::condense_part(const SparseMatrix &stiffness, Part &part,
                                   std::vector<Eigen::Triplet<double>> &entries) {
  const std::size_t n = part.inside.size(), n_border = part.border.size();
  for (std::size_t i = 0; i < n; ++i)
    place_inside[part.inside[i]] = i;
  std::vector<Eigen::Triplet<double>> inner, outwards;
  for (std::size_t i = 0; i < n; ++i)
    for (SparseMatrix::InnerIterator entry(stiffness, part.inside[i]); entry; ++entry)
      if (const int place = place_of[entry.col()]; place >= 0)
        outwards.emplace_back(i,
                              std::lower_bound(part.border.begin(), part.border.end(), place) -
                                  part.border.begin(),
                              entry.value());
      else
        inner.emplace_back(i, place_inside[entry.col()], entry.value());
  part.in_one_run = part.inside.back() - part.inside.front() + 1 == static_cast<int>(n);
  part.to_border.resize(n, n_border);
  part.to_border.setFromTriplets(outwards.begin(), outwards.end());
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(inner.begin(), inner.end());

  if (n > largest_dense && n_border >= widest_of_lines)
    part.cholesky = std::make_unique<PartCholesky>(matrix, part.to_border);
  int free = -1;
  if (part.cholesky && !part.cholesky->ok()) {
    free = part.inside[part.cholesky->vanishing()];
    part.cholesky.reset();
  }
  Eigen::MatrixXd share;
  if (part.cholesky)
    share = part.cholesky->share();
  else {
    const int found = n <= largest_dense ? part.take_dense(matrix) : part.take_sparse(matrix);
    free = free < 0 ? found : free;
    const Eigen::MatrixXd one_sided = part.to_border.transpose() * part.influence;
    share = -(one_sided + one_sided.transpose()) / 2.;
  }
  if (free >= 0)
    moves_freely.push_back(free);
  for (std::size_t a = 0; a < n_border; ++a)
    for (std::size_t b = 0; b < n_border; ++b)
      entries.emplace_back(part.border[a], part.border[b], share(a, b));
}

Vector CondensedParts::Part::inner(const Vector &all) const {
  if (in_one_run)
    return all.segment(inside.front(), inside.size());
  Vector result(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    result[i] = all[inside[i]];
  return result;
}

Vector CondensedParts::Part::solve(const Vector &forces) const {
  return cholesky ? cholesky->solve(forces)
         : sparse ? sparse->solve(forces)
                  : Vector(dense.solve(forces));
}

Vector CondensedParts::Part::condense(const Vector &forces) const {
  return cholesky ? Vector(-cholesky->condense(forces)) : Vector(influence.transpose() * forces);
}

Vector CondensedParts::condense(const Vector &forces) const {
  Vector result(kept.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[k] = forces[kept[k]];
  for (const Part &part : parts) {
    const Vector share = part.condense(part.inner(forces));
    for (std::size_t b = 0; b < part.border.size(); ++b)
      result[part.border[b]] -= share[b];
  }
  return result;
}

Vector CondensedParts::expand(const Vector &kept_unknowns, const Vector &forces) const {
  Vector result(place_of.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[kept[k]] = kept_unknowns[k];
  for (const Part &part : parts) {
    Vector border(part.border.size());
    for (std::size_t b = 0; b < part.border.size(); ++b)
      border[b] = kept_unknowns[part.border[b]];
    const Vector motion = part.solve(part.inner(forces) - part.to_border * border);
    if (part.in_one_run)
      result.segment(part.inside.front(), part.inside.size()) = motion;
    else
      for (std::size_t i = 0; i < part.inside.size(); ++i)
        result[part.inside[i]] = motion[i];
  }
  return result;
}

std::unique_ptr<Condensation> condense_parts(const SparseMatrix &stiffness,
                                             const std::vector<int> &keep) {
  return std::make_unique<CondensedParts>(stiffness, keep);
}

std::unique_ptr<Condensation> condense_bodies(const SparseMatrix &stiffness,
                                              const std::vector<int> &keep) {
  for (std::vector<int> all = keep;;) {
    auto result = std::make_unique<CondensedParts>(stiffness, all);
    if (result->free_unknowns().empty())
      return result;
    all.insert(all.end(), result->free_unknowns().begin(), result->free_unknowns().end());
  }
}

} // namespace frictionbeam::contact
