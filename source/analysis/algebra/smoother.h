// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_operator.h"

namespace frictionbeam {

/**
 * Chebyshev iteration on D^-1 (K + B), D the diagonal of K with the contacts' blocks B added at
 * their nodes, over [largest/range, largest] of its eigenvalues (M. Adams, M. Brezina, J. Hu and
 * R. Tuminaro, J. Comput. Phys. 188 (2003) 593-610; Y. Saad, Iterative methods for sparse linear
 * systems, algorithm 12.1). Since B is in D as it is, the largest eigenvalue is at most that
 * without contacts, or 1: it is found once and serves all blocks.
 */
template <int dim>
class ChebyshevSmoother {
public:
  using Operator = ElasticOperator<dim, float>;
  using Vector = typename Operator::Vector;

  explicit ChebyshevSmoother(const Operator &stiffness);

  /// Take the blocks that the operator has now.
  void take_blocks();
  /// Improve @p x. @p is_zero whether it is zero
  void smooth(Vector &x, const Vector &b, const bool is_zero) const;

private:
  void divide(Vector &x) const; ///< x = D^-1 x
  void estimate_largest();

  const Operator &stiffness;
  Vector inverse; ///< of the diagonal of K
  double largest = 0.;
  std::vector<NodeBlock<dim>> node_inverses; ///< of D at contacts
  mutable Vector residual, direction;
};

} // namespace frictionbeam
