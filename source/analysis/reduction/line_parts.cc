// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/reduction/line_parts.h"

#include "analysis/time/mass_factorization.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using Triplet = Eigen::Triplet<double>;

constexpr double least_pivot = 1e-15;      ///< relative; below, a part can move freely
constexpr unsigned int most_at_once = 100; ///< parts of which all modes are found at once

/// Entries that rounding made do not couple what they stand between.
bool couples(const double entry, const double diagonal, const double other_diagonal) {
  return std::abs(entry) > 1e-14 * std::sqrt(std::abs(diagonal * other_diagonal));
}

unsigned int rank(const PartOfLine &part) { return part.has_mass ? part.inside.size() : 0; }

} // namespace

Vector PartOfLine::inner(const Vector &unknowns) const {
  Vector result(inside.size());
  for (unsigned int i = 0; i < inside.size(); ++i)
    result[i] = unknowns[inside[i]];
  return result;
}

LineParts::LineParts(const Model &model) {
  check_dashpots_have_mass(model, "Time/Modes");
  keep(model);
  find_parts(model);
  for (PartOfLine &part : list)
    fill(model, part);
}

void LineParts::keep(const Model &model) {
  const SparseMatrix &K = model.linear.stiffness(), &M = model.linear.mass();
  const Vector stiffness = K.diagonal(), mass = M.diagonal();
  std::vector<bool> is_kept(K.rows(), false);
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    for (const int unknown : model.contacts[i].unknowns)
      is_kept[unknown] = true;
    for (const int unknown : model.contacts[i].vertex_unknowns)
      is_kept[unknown] = true;
  }
  const std::vector<bool> of_contacts = is_kept;
  for (int row = 0; row < K.rows(); ++row)
    if (!of_contacts[row] && !(mass[row] > 0.))
      for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry)
        if (mass[entry.col()] > 0. &&
            couples(entry.value(), stiffness[row], stiffness[entry.col()]))
          is_kept[entry.col()] = true;
  place_of_kept.assign(K.rows(), -1);
  for (int unknown = 0; unknown < K.rows(); ++unknown)
    if (is_kept[unknown]) {
      place_of_kept[unknown] = kept_unknowns.size();
      kept_unknowns.push_back(unknown);
    }
}

void LineParts::find_parts(const Model &model) {
  const std::vector<const SparseMatrix *> matrices = {
      &model.linear.stiffness(), &model.linear.mass(), &model.linear.damping()};
  std::vector<Vector> diagonals;
  for (const SparseMatrix *const matrix : matrices)
    diagonals.push_back(matrix->diagonal());
  homes.assign(place_of_kept.size(), {-1, -1});
  for (unsigned int first = 0; first < homes.size(); ++first) {
    if (place_of_kept[first] >= 0 || homes[first].first >= 0)
      continue;
    PartOfLine part;
    const auto take = [&](const int unknown) {
      homes[unknown] = {static_cast<int>(list.size()), 0};
      part.inside.push_back(unknown);
    };
    take(first);
    for (std::size_t i = 0; i < part.inside.size(); ++i) {
      const int row = part.inside[i];
      for (unsigned int m = 0; m < matrices.size(); ++m) {
        if (matrices[m]->nonZeros() == 0)
          continue;
        for (SparseMatrix::InnerIterator entry(*matrices[m], row); entry; ++entry) {
          const int column = entry.col();
          if (!couples(entry.value(), diagonals[m][row], diagonals[m][column]))
            continue;
          if (place_of_kept[column] >= 0)
            part.border.push_back(place_of_kept[column]);
          else if (homes[column].first < 0)
            take(column);
        }
      }
    }
    std::sort(part.inside.begin(), part.inside.end());
    std::sort(part.border.begin(), part.border.end());
    part.border.erase(std::unique(part.border.begin(), part.border.end()), part.border.end());
    for (unsigned int i = 0; i < part.inside.size(); ++i)
      homes[part.inside[i]].second = i;
    list.push_back(std::move(part));
  }
}

void LineParts::fill(const Model &model, PartOfLine &part) {
  const unsigned int n = part.inside.size(), n_border = part.border.size();
  const int number = homes[part.inside.front()].first;
  const auto take = [&](const SparseMatrix &from, Eigen::SparseMatrix<double> &inner,
                        Eigen::MatrixXd &border) {
    inner.resize(n, n);
    border.setZero(n, n_border);
    if (from.nonZeros() == 0)
      return;
    std::vector<Triplet> entries;
    for (unsigned int i = 0; i < n; ++i)
      for (SparseMatrix::InnerIterator entry(from, part.inside[i]); entry; ++entry)
        if (const int place = place_of_kept[entry.col()]; place >= 0) {
          const auto column = std::lower_bound(part.border.begin(), part.border.end(), place);
          if (column != part.border.end() && *column == place)
            border(i, column - part.border.begin()) = entry.value();
        } else if (homes[entry.col()].first == number && entry.value() != 0.)
          entries.emplace_back(i, homes[entry.col()].second, entry.value());
    inner.setFromTriplets(entries.begin(), entries.end());
  };
  take(model.linear.stiffness(), part.K, part.K_border);
  take(model.linear.mass(), part.M, part.M_border);
  take(model.linear.damping(), part.C, part.C_border);
  part.has_mass = part.M.diagonal().maxCoeff() > 0.;
  part.has_all_modes = !part.has_mass;

  part.factors = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(part.K);
  const Vector diagonal = part.K.diagonal();
  if (part.factors->info() != Eigen::Success || !(diagonal.minCoeff() > 0.) ||
      !((part.factors->vectorD().array() / (part.factors->permutationP() * diagonal).array().eval())
            .minCoeff() > least_pivot))
    throw UserError("Time/Modes: a part of the line can move freely while the nodes of the "
                    "contacts are held, so that it has no static shapes. Hold it, or set Modes to "
                    "all.");
  part.constraint_modes =
      n_border > 0 ? Eigen::MatrixXd(-part.factors->solve(part.K_border)) : Eigen::MatrixXd(n, 0);
}

unsigned int LineParts::n_modes() const {
  unsigned int n = 0;
  for (const PartOfLine &part : list)
    n += part.has_all_modes ? part.modes.size() : rank(part);
  return n;
}

void LineParts::find_more_modes(PartOfLine &part) {
  const unsigned int had = part.modes.size(), all = rank(part),
                     wanted = all <= most_at_once ? all : std::min(2 * had + 4, all);
  part.modes = lowest_eigenpairs(part.K, part.M, *part.factors, wanted);
  part.has_all_modes = part.modes.size() < wanted || wanted == all;
}

void LineParts::find_modes(PartOfLine &part, const double eigenvalue) {
  while (!part.has_all_modes && (part.modes.empty() || part.modes.back().value <= eigenvalue))
    find_more_modes(part);
}

void LineParts::transfer(Archive &archive) {
  for (PartOfLine &part : list)
    archive(part.modes, part.has_all_modes);
}

LineParts::Choice LineParts::below(const double eigenvalue) {
  Choice choice;
  for (PartOfLine &part : list) {
    find_modes(part, eigenvalue);
    unsigned int n = 0;
    while (n < part.modes.size() && part.modes[n].value <= eigenvalue)
      choice.highest = std::max(choice.highest, part.modes[n++].value);
    if (n < part.modes.size() && (choice.next == 0. || part.modes[n].value < choice.next))
      choice.next = part.modes[n].value;
    choice.n_of_part.push_back(n);
    choice.n += n;
  }
  return choice;
}

LineParts::Choice LineParts::lowest(const unsigned int n) {
  // The n-th lowest of those known is an upper bound; with all below it known, it is the value.
  for (PartOfLine &part : list)
    find_modes(part, 0.);
  double bound = 0.;
  for (;;) {
    std::vector<double> values;
    bool any_left = false;
    for (const PartOfLine &part : list) {
      for (const Eigenpair &mode : part.modes)
        values.push_back(mode.value);
      any_left = any_left || !part.has_all_modes;
    }
    std::sort(values.begin(), values.end());
    if (values.size() < n && any_left) {
      for (PartOfLine &part : list)
        if (!part.has_all_modes)
          find_more_modes(part);
      continue;
    }
    const double before = bound;
    bound = n == 0 || values.empty() ? 0. : values[std::min<std::size_t>(n, values.size()) - 1];
    if (bound == before)
      break;
    for (PartOfLine &part : list)
      find_modes(part, bound);
  }
  Choice choice = below(bound);
  for (unsigned int p = list.size(); choice.n > n && p > 0; --p) { // of equal ones, the first
    unsigned int &taken = choice.n_of_part[p - 1];
    while (choice.n > n && taken > 0 && list[p - 1].modes[taken - 1].value >= bound) {
      --taken;
      --choice.n;
      choice.next = bound;
    }
  }
  return choice;
}

} // namespace frictionbeam
