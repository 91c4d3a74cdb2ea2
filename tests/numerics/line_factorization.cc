// SPDX-License-Identifier: LGPL-2.1-or-later
// A matrix whose pattern, but not whose values are symmetric is solved to rounding, one unknown or
// six a node, chains, rings and branches; a chain costs no fill, a ring not much; a vanishing pivot
// is said. Both factorizations, of single columns and of blocks of them. A matrix that is kept,
// with other values at some places, has the factors that it has as a whole, to the last bit.
#include "../../plugin/contact/block_factorization.h"
#include "../check.h"

#include <frictionbeam/contact/line_factorization.h>

#include <Eigen/LU>

#include <random>

using namespace frictionbeam;
using namespace frictionbeam::contact;

namespace {

using Edges = std::vector<std::pair<int, int>>; ///< pairs of nodes that are coupled

/// A chain of @p n nodes, closed to a ring or not.
Edges chain(const int n, const bool ring) {
  Edges edges;
  for (int i = 0; i + (ring ? 0 : 1) < n; ++i)
    edges.emplace_back(i, (i + 1) % n);
  return edges;
}

/// A tree of @p n nodes, most of them in a chain, and @p n_loops edges more.
Edges branched(const int n, const int n_loops) {
  std::minstd_rand random(n + n_loops);
  Edges edges;
  for (int i = 1; i < n; ++i)
    edges.emplace_back(random() % 4 == 0 ? random() % i : i - 1, i);
  for (int i = 0; i < n_loops; ++i)
    edges.emplace_back(random() % (n / 2), n / 2 + random() % (n / 2));
  return edges;
}

/// With friction's unsymmetric entries; each node has @p n_unknowns, all coupled.
SparseMatrix matrix_of(const Edges &edges, const int n_nodes, const int n_unknowns = 1) {
  std::minstd_rand random(n_nodes);
  std::uniform_real_distribution<double> number(-1., 1.);
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](const int a, const int b) {
    for (int i = 0; i < n_unknowns; ++i)
      for (int j = 0; j < n_unknowns; ++j)
        entries.emplace_back(n_unknowns * a + i, n_unknowns * b + j, number(random));
  };
  for (int a = 0; a < n_nodes; ++a) {
    couple(a, a);
    for (int i = 0; i < n_unknowns; ++i)
      entries.emplace_back(n_unknowns * a + i, n_unknowns * a + i, 4. * n_unknowns);
  }
  for (const auto &[a, b] : edges) {
    couple(a, b);
    couple(b, a);
  }
  SparseMatrix matrix(n_unknowns * n_nodes, n_unknowns * n_nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// @return numbers of L below its diagonal
template <typename Factors>
std::size_t solves(const SparseMatrix &matrix) {
  const Vector right = Vector::LinSpaced(matrix.rows(), 1., 2.);
  Factors factors;
  factors.analyze(matrix);
  const Vector exact = Eigen::MatrixXd(matrix).partialPivLu().solve(right);
  for (const double factor : {1., 2.}) { // again and again
    CHECK(factors.factorize(factor * matrix));
    CHECK_NEAR((factor * factors.solve(right) - exact).norm() / exact.norm(), 0., 1e-14);
  }
  return factors.n_nonzeros();
}

/// Whether a matrix that is kept is factored with its diagonal, and one in seven of its entries,
/// halved.
bool keeps(SparseMatrix matrix) {
  const Vector right = Vector::LinSpaced(matrix.rows(), 1., 2.);
  BlockFactorization of_kept, of_whole;
  std::vector<int> changing;
  for (int i = 0; i < matrix.rows(); ++i)
    for (int p = matrix.outerIndexPtr()[i]; p < matrix.outerIndexPtr()[i + 1]; ++p)
      if (p % 7 == 0 || matrix.innerIndexPtr()[p] == i)
        changing.push_back(p);
  of_kept.analyze(matrix);
  of_kept.keep(matrix, changing);
  of_whole.analyze(matrix);
  for (int k = 0; k < 2; ++k) { // again and again
    std::vector<double> changed;
    for (const int p : changing)
      changed.push_back(matrix.valuePtr()[p] /= 2.);
    if (!of_kept.factorize_changed(changed) || !of_whole.factorize(matrix) ||
        of_kept.solve(right) != of_whole.solve(right))
      return false;
  }
  return true;
}

template <typename Factors>
void factors() {
  for (const int n : {1, 2, 7, 200})
    solves<Factors>(matrix_of(chain(n, false), n));
  solves<Factors>(matrix_of(chain(200, true), 200));

  Factors factors;
  factors.analyze(matrix_of(chain(1000, false), 1000));
  CHECK(factors.n_nonzeros() == 999); // of L below its diagonal
  factors.analyze(matrix_of(chain(1000, true), 1000));
  CHECK(factors.n_nonzeros() < 3000);

  SparseMatrix singular = matrix_of(chain(5, false), 5);
  factors.analyze(singular);
  for (int i = 0; i < 5; ++i)
    for (SparseMatrix::InnerIterator entry(singular, i); entry; ++entry)
      entry.valueRef() = i == 0 ? 0. : entry.value();
  CHECK(!factors.factorize(singular));
  SparseMatrix small = matrix_of(chain(3, false), 3, 2); // x and y, y beside x
  factors.analyze(small);
  for (SparseMatrix::InnerIterator entry(small, 1); entry; ++entry)
    entry.valueRef() = small.coeff(0, entry.col());
  CHECK(!factors.factorize(small)); // the second of two equal rows
}

} // namespace

int line_factorization(int, char **) {
  factors<contact::LineFactorization>();
  factors<BlockFactorization>();
  for (const int n_loops : {0, 1, 9, 100})
    for (const int n_unknowns : {1, 3, 6, 9}) {
      const SparseMatrix matrix = matrix_of(branched(60, n_loops), 60, n_unknowns);
      CHECK(keeps(matrix));
      CHECK(solves<contact::LineFactorization>(matrix) == solves<BlockFactorization>(matrix));
    }
  return check::report();
}
