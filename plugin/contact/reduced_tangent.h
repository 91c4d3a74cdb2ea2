// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/site_list.h>

#include <Eigen/LU>

namespace frictionbeam::contact {

/**
 * Solves (S + sum_i weight_i B_i^T D_i B_i) x = b for a body, whose S is dense, by factors of the
 * directions alone in which contacts give way.
 *
 * Unknowns y are the strains of each contact in place of three unknowns that no other contact has,
 * x = Z y, so that a contact adds D_i as it is, to Z^T S Z. Where it holds a direction, as all
 * three of a contact that sticks and the normal of one that slips, it adds nothing but a diagonal
 * entry d that is large beside S. These directions s are eliminated from the others f as if they
 * were not coupled among themselves, D_fs being the friction by the normal force:
 *
 *   F = S_ff + D_ff - D_fs d^-1 S_sf,
 *
 * and what that leaves out, some S_ss / d, is removed by iterative refinement, which multiplies the
 * error by it.
 */
class ReducedTangent {
public:
  /// @param unknowns of each contact, places in S
  ReducedTangent(const SparseMatrix &S, const SiteList &contacts,
                 const std::vector<std::vector<int>> &unknowns);

  /// @param stiffness D of each contact; @return false if a pivot vanishes
  bool factorize(const std::vector<Block> &stiffness);
  /// With the last factors. @return false if the refinement does not converge: no x then.
  bool solve(const Vector &right_hand_side, Vector &x) const;
  /// Directions that are factored at present.
  int n_free() const { return free.size(); }

private:
  struct Entry {
    int row, column;
    double value;
  };

  void choose_directions(const SiteList &contacts);
  void find_entries(const std::vector<Block> &stiffness);
  void divide();
  Eigen::MatrixXd matrix_of_free() const;
  /// The solution but for the refinement.
  Vector solve_roughly(const Vector &forces) const;

  const SiteList &contacts;
  const std::vector<std::vector<int>> unknowns;
  std::vector<std::array<int, 3>> directions; ///< of each contact, among y; -1 if it has none
  SparseMatrix Z;
  Eigen::MatrixXd S_of_y;
  Vector scale; ///< square roots of its diagonal, or 1

  // of the last factorization
  std::vector<Entry> entries;   ///< of the contacts, on y
  std::vector<int> free, stiff; ///< places in y
  std::vector<int> place;       ///< of each y among those of its kind
  std::vector<bool> is_stiff;
  Vector held;                 ///< d of the stiff directions
  std::vector<Entry> friction; ///< D_fs d^-1, by places among the free and the stiff ones
  Vector free_scale;           ///< that the factored matrix is multiplied by from both sides
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

} // namespace frictionbeam::contact
