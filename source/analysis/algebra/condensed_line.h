// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/line_factorization.h"

#include <Eigen/Cholesky>

#include <deque>

namespace frictionbeam {

/**
 * The line condensed exactly onto the unknowns of the nodes that contacts touch.
 *
 * With kept unknowns c and inner ones i, K q = f becomes S q_c = f_c - K_ci K_ii^-1 f_i with
 * S = K_cc - K_ci K_ii^-1 K_ic, made once: what friction changes from iteration to iteration are
 * entries of S at the contacts, and a run of pipe between two supports costs no more than its two
 * ends. K_ii falls apart into the parts of the line between kept nodes, each factored by itself, so
 * that the cost is linear in the length (doc/theory.md, "Exact contact", condensation).
 */
class CondensedLine {
public:
  /// Keep the unknowns of all vertices that @p contacts touch.
  CondensedLine(const SparseMatrix &stiffness, const Contacts &contacts);

  /// S; its pattern contains the contacts' tangents.
  const SparseMatrix &matrix() const { return S; }
  int n_kept() const { return kept.size(); }
  /// Place of a kept unknown among those of S.
  int place(const int unknown) const { return place_of[unknown]; }

  /// f_c - K_ci K_ii^-1 f_i.
  Vector condense(const Vector &forces) const;
  /// All unknowns: q_c as given, q_i = K_ii^-1 (f_i - K_ic q_c).
  Vector expand(const Vector &kept_unknowns, const Vector &forces) const;

private:
  /// A connected part of the inner unknowns and the kept ones it borders on.
  struct Part {
    std::vector<int> inside, border; ///< unknowns; places among the kept
    bool in_one_run = false;         ///< inside are unknowns one after the other
    SparseMatrix to_border;          ///< K_ic
    Eigen::MatrixXd influence;       ///< K_ii^-1 K_ic
    Eigen::LDLT<Eigen::MatrixXd> dense;
    std::unique_ptr<LineFactorization> sparse;

    Vector inner(const Vector &all) const;
    Vector solve(const Vector &forces) const;
  };

  void find_parts(const SparseMatrix &stiffness);
  /// Factor K_ii of a part and add its share of S.
  void condense_part(const SparseMatrix &stiffness, Part &part,
                     std::vector<Eigen::Triplet<double>> &entries);

  std::vector<int> kept, place_of, place_inside;
  std::deque<Part> parts; ///< which never move: Eigen's LDLT is not whole before it has factored
  SparseMatrix S;
};

} // namespace frictionbeam
