// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/statics.h"

namespace frictionbeam {

/**
 * Static increments of a line on which nothing but contact is nonlinear, on the unknowns that its
 * contacts touch: S q_c + H^T r = g, whose S and g by loads are made once, in extended precision,
 * since what condensing loses on a flexible line is not found again. The motions between contacts
 * are complete()'s. For many runs of one line.
 */
class CondensedLine {
public:
  explicit CondensedLine(const Model &model);

  /// Begin another run: the contacts' laws may have other numbers, nothing is remembered.
  void begin();

  /// As Statics::solve(), but of the unknowns those of contacts alone, also in @p from; of the
  /// displacements those that are imposed alone.
  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response);
  /// The motions of all unknowns, of the state at the end of an increment, as solve() left it.
  /// @return whether the forces on all of them balance, to the tolerance
  bool complete(LineState &state) const;

  /// Whether friction is so large that one contact by itself may have several states.
  bool may_jam() const { return solver->may_jam(); }
  void transfer(Archive &archive);

private:
  using Extended = std::vector<long double>;

  /// Kept unknowns in groups, no two of which have a row of S in common.
  std::vector<std::vector<int>> find_groups() const;
  void condense_stiffness();
  void condense_loads();
  /// Of the line under forces where the kept unknowns are as given: motions, to the last bit.
  Vector expand(const Vector &kept_motions, const Vector &forces, Vector &low) const;
  Vector kept_of(const Vector &unknowns) const;

  const Model &model;
  const SparseMatrix &K;
  const Vector diagonal; ///< of K
  std::unique_ptr<const contact::Condensation> line;
  std::vector<int> kept; ///< unknowns
  SparseMatrix S;        ///< rounded
  Extended values;       ///< of S
  std::vector<int> used; ///< places in S of what is not zero, row by row
  std::vector<int> first_used;
  /// Of what is always there and of each load: forces on kept unknowns, motions of the others.
  std::vector<Vector> forces, motions;
  std::vector<contact::Site> sites;
  std::unique_ptr<contact::ExactSolver> solver;
  contact::WarmStart fresh;
};

} // namespace frictionbeam
