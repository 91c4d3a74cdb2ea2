// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/condensation.h>
#include <frictionbeam/contact/line_factorization.h>

#include "part_cholesky.h"

#include <Eigen/Cholesky>

#include <deque>

namespace frictionbeam::contact {

/// See condense_parts().
class CondensedParts final : public Condensation {
public:
  CondensedParts(const SparseMatrix &stiffness, const std::vector<int> &keep);

  Vector condense(const Vector &forces) const override;
  Vector expand(const Vector &kept_unknowns, const Vector &forces) const override;
  /// An inner unknown of each part that can move freely; the part is not condensed well then.
  const std::vector<int> &free_unknowns() const { return moves_freely; }

private:
  /// A connected part of the inner unknowns and the kept ones it borders on.
  struct Part {
    std::vector<int> inside, border; ///< unknowns; places among the kept
    bool in_one_run = false;         ///< inside are unknowns one after the other
    SparseMatrix to_border;          ///< K_ic
    Eigen::MatrixXd influence;       ///< K_ii^-1 K_ic
    Eigen::LDLT<Eigen::MatrixXd> dense;
    std::unique_ptr<LineFactorization> sparse; ///< of a line
    std::unique_ptr<PartCholesky> cholesky;    ///< of a body with a wide border

    Vector inner(const Vector &all) const;
    Vector solve(const Vector &forces) const;
    /// K_ci K_ii^-1 f on its border.
    Vector condense(const Vector &forces) const;
    /// @return an inner unknown of the part that moves freely; -1 if none does
    int take_dense(const SparseMatrix &matrix);
    int take_sparse(SparseMatrix &matrix);
  };

  void find_parts(const SparseMatrix &stiffness);
  /// Factor K_ii of a part and add its share of S.
  void condense_part(const SparseMatrix &stiffness, Part &part,
                     std::vector<Eigen::Triplet<double>> &entries);

  std::vector<int> place_inside, moves_freely;
  std::deque<Part> parts; ///< which never move: Eigen's LDLT is not whole before it has factored
};

} // namespace frictionbeam::contact
