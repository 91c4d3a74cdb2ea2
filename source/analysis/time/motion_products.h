// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

/// matrix vector. The columns of a row of the matrices of a line askew are mostly one run of
/// neighbours, which is gone through two entries at a time, and its indices need not be read.
void multiply(const SparseMatrix &matrix, const Vector &vector, Vector &product);

/// The product of one matrix with a vector that may be asked for again: with the vectors of the
/// last two it is at hand.
class KeptProduct {
public:
  explicit KeptProduct(const SparseMatrix &matrix) : matrix(matrix) {}

  const Vector &operator()(const Vector &vector) {
    for (const int i : {newest, 1 - newest})
      if (vectors[i].size() == vector.size() && vectors[i] == vector) {
        newest = i;
        return products[i];
      }
    newest = 1 - newest;
    vectors[newest] = vector;
    multiply(matrix, vector, products[newest]);
    return products[newest];
  }

private:
  const SparseMatrix &matrix;
  int newest = 0;
  Vector vectors[2], products[2];
};

/// Largest entry by size; 0 if there is none.
template <typename Expression>
double largest(const Expression &vector) {
  return vector.size() > 0 ? vector.template lpNorm<Eigen::Infinity>() : 0.;
}

/**
 * What the residual of a step is measured by: the forces. Momentum over a short step would be much
 * larger, and whatever friction does would drown in its tolerance; of it, as of all that is
 * @p rounded, counts what rounding errors are.
 * @param tolerance of residuals, relative
 */
inline double size_of_forces(const double forces, const double rounded, const double tolerance) {
  constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();
  return forces + std::min(1., rounding / tolerance) * rounded;
}

/// What a step begins with besides motions.
inline void take_over_contacts(const LineState &from, LineState &to) {
  to.contacts = from.contacts;
  to.contact_stress = from.contact_stress;
  to.contact_status = from.contact_status;
}

} // namespace frictionbeam
