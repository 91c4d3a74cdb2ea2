// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/condensed_line.h"

#include <algorithm>

namespace frictionbeam {

namespace {
constexpr std::size_t largest_dense = 96;
}

CondensedLine::CondensedLine(const SparseMatrix &stiffness, const Contacts &contacts)
    : place_of(stiffness.rows(), -1), place_inside(stiffness.rows(), -1) {
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    kept.insert(kept.end(), contacts[i].unknowns.begin(), contacts[i].unknowns.end());
    kept.insert(kept.end(), contacts[i].vertex_unknowns.begin(), contacts[i].vertex_unknowns.end());
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (unsigned int k = 0; k < kept.size(); ++k)
    place_of[kept[k]] = k;

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

void CondensedLine::find_parts(const SparseMatrix &stiffness) {
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

void CondensedLine::condense_part(const SparseMatrix &stiffness, Part &part,
                                  std::vector<Eigen::Triplet<double>> &entries) {
  const std::size_t n = part.inside.size(), n_border = part.border.size();
  for (std::size_t i = 0; i < n; ++i)
    place_inside[part.inside[i]] = i;
  const bool is_dense = n <= largest_dense;
  Eigen::MatrixXd to_border = Eigen::MatrixXd::Zero(n, n_border), dense;
  if (is_dense)
    dense.setZero(n, n);
  std::vector<Eigen::Triplet<double>> inner;
  for (std::size_t i = 0; i < n; ++i)
    for (SparseMatrix::InnerIterator entry(stiffness, part.inside[i]); entry; ++entry)
      if (const int place = place_of[entry.col()]; place >= 0)
        to_border(i, std::lower_bound(part.border.begin(), part.border.end(), place) -
                         part.border.begin()) = entry.value();
      else if (is_dense)
        dense(i, place_inside[entry.col()]) = entry.value();
      else
        inner.emplace_back(i, place_inside[entry.col()], entry.value());
  part.in_one_run = part.inside.back() - part.inside.front() + 1 == static_cast<int>(n);
  part.to_border = to_border.sparseView();
  if (is_dense) {
    part.dense.compute(dense);
    if (n_border > 0)
      part.influence = part.dense.solve(to_border);
    else
      part.influence.resize(n, 0);
  } else {
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(inner.begin(), inner.end());
    part.sparse = std::make_unique<LineFactorization>();
    part.sparse->analyze(matrix);
    if (!part.sparse->factorize(matrix)) { // something turns freely between its ends
      for (std::size_t i = 0; i < n; ++i)
        matrix.coeffRef(i, i) *= 1. + 1e-9;
      part.sparse->factorize(matrix);
    }
    part.influence.resize(n, n_border);
    for (std::size_t b = 0; b < n_border; ++b)
      part.influence.col(b) = part.sparse->solve(to_border.col(b));
  }
  const Eigen::MatrixXd share = to_border.transpose() * part.influence;
  for (std::size_t a = 0; a < n_border; ++a)
    for (std::size_t b = 0; b < n_border; ++b)
      entries.emplace_back(part.border[a], part.border[b], -(share(a, b) + share(b, a)) / 2.);
}

Vector CondensedLine::Part::inner(const Vector &all) const {
  if (in_one_run)
    return all.segment(inside.front(), inside.size());
  Vector result(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    result[i] = all[inside[i]];
  return result;
}

Vector CondensedLine::Part::solve(const Vector &forces) const {
  return sparse ? sparse->solve(forces) : Vector(dense.solve(forces));
}

Vector CondensedLine::condense(const Vector &forces) const {
  Vector result(kept.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[k] = forces[kept[k]];
  for (const Part &part : parts) {
    const Vector share = part.influence.transpose() * part.inner(forces);
    for (std::size_t b = 0; b < part.border.size(); ++b)
      result[part.border[b]] -= share[b];
  }
  return result;
}

Vector CondensedLine::expand(const Vector &kept_unknowns, const Vector &forces) const {
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

} // namespace frictionbeam
