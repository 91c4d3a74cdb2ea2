// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/line_state.h>

namespace frictionbeam {

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
    products[newest].noalias() = matrix * vector;
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

/// What a step begins with besides motions.
inline void take_over_contacts(const LineState &from, LineState &to) {
  to.contacts = from.contacts;
  to.contact_stress = from.contact_stress;
  to.contact_status = from.contact_status;
  to.with_preload = from.with_preload;
}

} // namespace frictionbeam
