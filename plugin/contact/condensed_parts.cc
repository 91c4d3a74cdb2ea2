// SPDX-License-Identifier: LGPL-2.1-or-later
#include "condensed_parts.h"

#include <algorithm>
#include <string_view>

namespace frictionbeam::contact {

namespace {
constexpr std::size_t largest_dense = 96;
/// A pipe between supports has twelve unknowns at its border, a branched one some more.
constexpr std::size_t widest_of_lines = 48;
constexpr std::size_t most_known = 1000; ///< of some 5 kB
} // namespace

class CondensedParts::KnownParts {
public:
  struct Known {
    Eigen::MatrixXd matrix; ///< K_ii and K_ic
    Eigen::MatrixXd share;
    const Factors *factors;
  };

  /// The part with this matrix, or null.
  const Known *find(const Eigen::MatrixXd &matrix) const {
    const auto [begin, end] = by_hash.equal_range(hash(matrix));
    for (auto known = begin; known != end; ++known)
      if (is_same(known->second.matrix, matrix))
        return &known->second;
    return nullptr;
  }
  void add(Known known) {
    const std::size_t key = hash(known.matrix);
    if (by_hash.size() < most_known)
      by_hash.emplace(key, std::move(known));
  }

private:
  static bool is_same(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
  }
  static std::size_t hash(const Eigen::MatrixXd &matrix) {
    return std::hash<std::string_view>()(
        {reinterpret_cast<const char *>(matrix.data()), matrix.size() * sizeof(double)});
  }

  std::unordered_multimap<std::size_t, Known> by_hash;
};

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

namespace {
bool is_same(const SparseMatrix &a, const SparseMatrix &b) {
  const auto n = a.nonZeros();
  return a.rows() == b.rows() && a.cols() == b.cols() && n == b.nonZeros() &&
         std::equal(a.valuePtr(), a.valuePtr() + n, b.valuePtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + n, b.innerIndexPtr()) &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows(), b.outerIndexPtr());
}
} // namespace

const PartMemory::Part *PartMemory::find(const int first, const SparseMatrix &matrix,
                                         const SparseMatrix &to_border) const {
  const auto found = by_first.find(first);
  return found != by_first.end() && is_same(found->second.matrix, matrix) &&
                 is_same(found->second.factors->to_border, to_border)
             ? &found->second
             : nullptr;
}

std::shared_ptr<PartMemory> make_part_memory() { return std::make_shared<PartMemory>(); }

CondensedParts::CondensedParts(const SparseMatrix &stiffness, const std::vector<int> &keep,
                               PartMemory *const memory)
    : Condensation(stiffness.rows(), keep), place_inside(stiffness.rows(), -1) {
  find_parts(stiffness);
  make_places(stiffness);
  for (unsigned int k = 0; k < kept.size(); ++k)
    for (SparseMatrix::InnerIterator entry(stiffness, kept[k]); entry; ++entry)
      if (const int column = place_of[entry.col()]; column >= 0)
        add_to(S, k, column, entry.value());
  KnownParts known;
  for (Part &part : parts)
    condense_part(stiffness, part, known, memory);
}

void CondensedParts::make_places(const SparseMatrix &stiffness) {
  const int n = kept.size();
  std::vector<std::vector<int>> parts_of(n);
  for (unsigned int p = 0; p < parts.size(); ++p)
    for (const int place : parts[p].border)
      parts_of[place].push_back(p);
  std::vector<int> columns, row; // triplets would take three times as much memory as S
  S.resize(n, n);
  for (int k = 0; k < n; ++k) {
    row.clear();
    for (SparseMatrix::InnerIterator entry(stiffness, kept[k]); entry; ++entry)
      if (const int column = place_of[entry.col()]; column >= 0)
        row.push_back(column);
    for (const int p : parts_of[k])
      row.insert(row.end(), parts[p].border.begin(), parts[p].border.end());
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    columns.insert(columns.end(), row.begin(), row.end());
    S.outerIndexPtr()[k + 1] = columns.size();
  }
  S.resizeNonZeros(columns.size());
  std::copy(columns.begin(), columns.end(), S.innerIndexPtr());
  std::fill_n(S.valuePtr(), columns.size(), 0.);
}

void CondensedParts::find_parts(const SparseMatrix &stiffness) {
  std::vector<bool> reached(stiffness.rows(), false);
  std::vector<int> reached_from(kept.size(), -1); // the first unknown of the part that did last
  for (int first = 0; first < stiffness.rows(); ++first) {
    if (place_of[first] >= 0 || reached[first])
      continue;
    Part &part = parts.emplace_back();
    part.inside = {first};
    reached[first] = true;
    for (std::size_t i = 0; i < part.inside.size(); ++i)
      for (SparseMatrix::InnerIterator entry(stiffness, part.inside[i]); entry; ++entry)
        if (const int place = place_of[entry.col()]; place >= 0) {
          if (reached_from[place] != first)
            part.border.push_back(place);
          reached_from[place] = first;
        } else if (!reached[entry.col()]) {
          reached[entry.col()] = true;
          part.inside.push_back(entry.col());
        }
    std::sort(part.inside.begin(), part.inside.end());
    std::sort(part.border.begin(), part.border.end());
  }
}

void CondensedParts::Factors::take_dense(const SparseMatrix &matrix) {
  constexpr double nothing = 1e-13; // of the diagonal, as in PartCholesky
  dense.compute(Eigen::MatrixXd(matrix));
  if (to_border.cols() == 0)
    influence.resize(matrix.rows(), 0);
  else
    influence = dense.solve(Eigen::MatrixXd(to_border));
  Eigen::VectorXi at = Eigen::VectorXi::LinSpaced(matrix.rows(), 0, matrix.rows() - 1);
  for (Eigen::Index k = 0; k < at.size(); ++k)
    std::swap(at[k], at[dense.transpositionsP().coeff(k)]);
  for (Eigen::Index k = 0; k < at.size() && free < 0; ++k)
    if (!(dense.vectorD()[k] > nothing * matrix.coeff(at[k], at[k])))
      free = at[k];
}

void CondensedParts::Factors::take_sparse(SparseMatrix &matrix) {
  constexpr double suspicious = 1e-9; // of the largest entry of the diagonal
  sparse = std::make_unique<BlockFactorization>();
  sparse->analyze(matrix);
  const bool is_regular = sparse->factorize(matrix);
  if (!is_regular || sparse->least_pivot() < suspicious * matrix.diagonal().maxCoeff())
    if (const PartCholesky asked(matrix, to_border); !asked.ok() && free < 0)
      free = asked.vanishing();
  if (!is_regular) { // something turns freely between its ends
    for (int i = 0; i < matrix.rows(); ++i)
      matrix.coeffRef(i, i) *= 1. + 1e-9;
    sparse->factorize(matrix);
  }
  const Eigen::MatrixXd columns(to_border);
  influence.resize(to_border.rows(), to_border.cols());
  for (Eigen::Index b = 0; b < columns.cols(); ++b)
    influence.col(b) = sparse->solve(columns.col(b));
}

Eigen::MatrixXd CondensedParts::Factors::take(SparseMatrix &matrix) {
  const std::size_t n = to_border.rows(), n_border = to_border.cols();
  if (n > largest_dense && n_border >= widest_of_lines) {
    cholesky = std::make_unique<PartCholesky>(matrix, to_border);
    if (cholesky->ok())
      return cholesky->share();
    free = cholesky->vanishing();
    cholesky.reset();
  }
  if (n <= largest_dense)
    take_dense(matrix);
  else
    take_sparse(matrix);
  const Eigen::MatrixXd one_sided = to_border.transpose() * influence;
  return -(one_sided + one_sided.transpose()) / 2.;
}

void CondensedParts::condense_part(const SparseMatrix &stiffness, Part &part, KnownParts &known,
                                   PartMemory *const memory) {
  const std::size_t n = part.inside.size(), n_border = part.border.size();
  for (std::size_t i = 0; i < n; ++i)
    place_inside[part.inside[i]] = i;
  part.in_one_run = part.inside.back() - part.inside.front() + 1 == static_cast<int>(n);
  const auto each_entry = [&](const auto &row, const auto &inner, const auto &outwards) {
    for (std::size_t i = 0; i < n; ++i) {
      row(i);
      for (SparseMatrix::InnerIterator entry(stiffness, part.inside[i]); entry; ++entry)
        if (const int place = place_of[entry.col()]; place >= 0)
          outwards(i,
                   std::lower_bound(part.border.begin(), part.border.end(), place) -
                       part.border.begin(),
                   entry.value());
        else
          inner(i, place_inside[entry.col()], entry.value());
    }
  };
  const auto add_share = [&](const Eigen::MatrixXd &share) {
    for (std::size_t a = 0; a < n_border; ++a) {
      int p = S.outerIndexPtr()[part.border[a]];
      for (std::size_t b = 0; b < n_border; ++b) {
        while (S.innerIndexPtr()[p] < part.border[b])
          ++p;
        S.valuePtr()[p] += share(a, b);
      }
    }
    if (part.factors->free >= 0)
      moves_freely.push_back(part.inside[part.factors->free]);
  };

  Eigen::MatrixXd small;
  if (n <= largest_dense) {
    small.setZero(n, n + n_border);
    each_entry([](const int) {},
               [&](const int i, const int j, const double value) { small(i, j) = value; },
               [&](const int i, const int b, const double value) { small(i, n + b) = value; });
    if (const KnownParts::Known *const like = known.find(small)) {
      part.factors = like->factors;
      add_share(like->share);
      return;
    }
  }
  std::size_t n_entries = 0;
  for (const int unknown : part.inside)
    n_entries += stiffness.outerIndexPtr()[unknown + 1] - stiffness.outerIndexPtr()[unknown];
  auto own = std::make_shared<Factors>();
  SparseMatrix matrix(n, n);
  matrix.reserve(n_entries);
  own->to_border.resize(n, n_border);
  // Entries come in the order of rows and columns, since both are numbered in that of the unknowns.
  each_entry(
      [&](const int i) {
        matrix.startVec(i);
        own->to_border.startVec(i);
      },
      [&](const int i, const int j, const double value) { matrix.insertBack(i, j) = value; },
      [&](const int i, const int b, const double value) {
        own->to_border.insertBack(i, b) = value;
      });
  matrix.finalize();
  own->to_border.finalize();
  PartMemory *const kept_parts = n <= largest_dense ? nullptr : memory;
  if (kept_parts != nullptr)
    if (const PartMemory::Part *const same =
            kept_parts->find(part.inside.front(), matrix, own->to_border)) {
      factors.push_back(same->factors);
      part.factors = same->factors.get();
      add_share(same->share);
      return;
    }
  SparseMatrix as_it_was;
  if (kept_parts != nullptr)
    as_it_was = matrix;
  const Eigen::MatrixXd share = own->take(matrix);
  factors.push_back(own);
  part.factors = own.get();
  add_share(share);
  if (n <= largest_dense)
    known.add({std::move(small), share, own.get()});
  if (kept_parts != nullptr)
    kept_parts->keep(part.inside.front(), {std::move(as_it_was), std::move(own), share});
}

Vector CondensedParts::Part::inner(const Vector &all) const {
  if (in_one_run)
    return all.segment(inside.front(), inside.size());
  Vector result(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    result[i] = all[inside[i]];
  return result;
}

Vector CondensedParts::Factors::solve(const Vector &forces) const {
  return cholesky ? cholesky->solve(forces)
         : sparse ? sparse->solve(forces)
                  : Vector(dense.solve(forces));
}

Vector CondensedParts::Factors::condense(const Vector &forces) const {
  return cholesky ? Vector(-cholesky->condense(forces)) : Vector(influence.transpose() * forces);
}

Vector CondensedParts::condense(const Vector &forces) const {
  Vector result(kept.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[k] = forces[kept[k]];
  for (const Part &part : parts) {
    const Vector share = part.factors->condense(part.inner(forces));
    for (std::size_t b = 0; b < part.border.size(); ++b)
      result[part.border[b]] -= share[b];
  }
  return result;
}

Vector CondensedParts::expand(const Vector &kept_unknowns, const Vector &forces) const {
  const bool has_forces = !forces.isZero(0.);
  Vector result(place_of.size());
  for (unsigned int k = 0; k < kept.size(); ++k)
    result[kept[k]] = kept_unknowns[k];
  for (const Part &part : parts) {
    Vector border(part.border.size());
    for (std::size_t b = 0; b < part.border.size(); ++b)
      border[b] = kept_unknowns[part.border[b]];
    const Factors &of_part = *part.factors;
    const Vector motion = has_forces || of_part.cholesky
                              ? of_part.solve(part.inner(forces) - of_part.to_border * border)
                              : Vector(-(of_part.influence * border));
    if (part.in_one_run)
      result.segment(part.inside.front(), part.inside.size()) = motion;
    else
      for (std::size_t i = 0; i < part.inside.size(); ++i)
        result[part.inside[i]] = motion[i];
  }
  return result;
}

std::unique_ptr<Condensation> condense_parts(const SparseMatrix &stiffness,
                                             const std::vector<int> &keep,
                                             PartMemory *const memory) {
  return std::make_unique<CondensedParts>(stiffness, keep, memory);
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
