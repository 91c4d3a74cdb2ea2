// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/condensation.h>

#include "block_factorization.h"
#include "part_cholesky.h"

#include <Eigen/Cholesky>

#include <unordered_map>

namespace frictionbeam::contact {

/// See condense_parts().
class CondensedParts final : public Condensation {
public:
  CondensedParts(const SparseMatrix &stiffness, const std::vector<int> &keep,
                 PartMemory *const memory = nullptr);

  Vector condense(const Vector &forces) const override;
  Vector expand(const Vector &kept_unknowns, const Vector &forces) const override;
  /// An inner unknown of each part that can move freely; the part is not condensed well then.
  const std::vector<int> &free_unknowns() const { return moves_freely; }

  /// What condenses a part: K_ii factored, and its influence. Parts whose matrices are the same
  /// numbers, as those of equal spans, have one.
  struct Factors {
    SparseMatrix to_border;    ///< K_ic
    Eigen::MatrixXd influence; ///< K_ii^-1 K_ic
    Eigen::LDLT<Eigen::MatrixXd> dense;
    std::unique_ptr<BlockFactorization> sparse; ///< of a line
    std::unique_ptr<PartCholesky> cholesky;     ///< of a body with a wide border
    int free = -1; ///< an inner unknown that moves freely, by its place in the part; -1: none

    Vector solve(const Vector &forces) const;
    /// K_ci K_ii^-1 f on its border.
    Vector condense(const Vector &forces) const;
    /// Factor K_ii. @return -K_ci K_ii^-1 K_ic
    Eigen::MatrixXd take(SparseMatrix &matrix);
    void take_dense(const SparseMatrix &matrix);
    void take_sparse(SparseMatrix &matrix);
  };

private:
  /// A connected part of the inner unknowns and the kept ones it borders on.
  struct Part {
    std::vector<int> inside, border; ///< unknowns; places among the kept
    bool in_one_run = false;         ///< inside are unknowns one after the other
    const Factors *factors = nullptr;

    Vector inner(const Vector &all) const;
  };
  /// Small parts that were condensed before.
  class KnownParts;

  void find_parts(const SparseMatrix &stiffness);
  /// Put zeros into S where it has entries.
  void make_places(const SparseMatrix &stiffness);
  /// Factor K_ii of a part, if none like it has been, and add its share of S.
  void condense_part(const SparseMatrix &stiffness, Part &part, KnownParts &known,
                     PartMemory *const memory);

  std::vector<int> place_inside, moves_freely;
  std::vector<Part> parts;
  std::vector<std::shared_ptr<const Factors>> factors; ///< parts point at them
};

class PartMemory {
public:
  struct Part {
    SparseMatrix matrix; ///< K_ii
    std::shared_ptr<const CondensedParts::Factors> factors;
    Eigen::MatrixXd share;
  };

  /// The part that began at this unknown, if it had these numbers; null otherwise.
  const Part *find(const int first, const SparseMatrix &matrix,
                   const SparseMatrix &to_border) const;
  void keep(const int first, Part part) { by_first[first] = std::move(part); }

private:
  std::unordered_map<int, Part> by_first;
};

} // namespace frictionbeam::contact
