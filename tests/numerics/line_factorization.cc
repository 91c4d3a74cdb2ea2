// SPDX-License-Identifier: LGPL-2.1-or-later
// A matrix whose pattern, but not whose values are symmetric is solved to rounding; a chain costs
// no fill, a ring not much; a vanishing pivot is said. Where leading rows stay as they were, their
// factors are kept, and the solution is the same to the last bit.
#include "../check.h"

#include <frictionbeam/contact/line_factorization.h>

#include <Eigen/LU>

#include <random>

using namespace frictionbeam;
using namespace frictionbeam::contact;

namespace {

/// A chain of @p n unknowns, closed to a ring or not, with friction's unsymmetric entries.
SparseMatrix chain(const int n, const bool ring) {
  std::minstd_rand random(n);
  std::uniform_real_distribution<double> number(-1., 1.);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    entries.emplace_back(i, i, 4. + number(random));
  for (int i = 0; i + (ring ? 0 : 1) < n; ++i) {
    entries.emplace_back(i, (i + 1) % n, number(random));
    entries.emplace_back((i + 1) % n, i, number(random));
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void solves(const SparseMatrix &matrix) {
  const Vector right = Vector::LinSpaced(matrix.rows(), 1., 2.);
  contact::LineFactorization factors;
  factors.analyze(matrix);
  CHECK(factors.factorize(matrix));
  const Vector exact = Eigen::MatrixXd(matrix).partialPivLu().solve(right);
  CHECK_NEAR((factors.solve(right) - exact).norm() / exact.norm(), 0., 1e-14);
}

/// Entries behind @p n_unchanged rows are changed, and the factors made of all or of these alone.
void keeps_rows(SparseMatrix matrix, const int n_unchanged) {
  const Vector right = Vector::LinSpaced(matrix.rows(), 1., 2.);
  contact::LineFactorization kept, whole;
  kept.analyze(matrix);
  CHECK(kept.factorize(matrix));
  for (int i = n_unchanged; i < matrix.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(matrix, i); entry; ++entry)
      if (entry.col() >= n_unchanged)
        entry.valueRef() *= 1.5;
  CHECK(kept.factorize(matrix, n_unchanged));
  whole.analyze(matrix);
  CHECK(whole.factorize(matrix));
  CHECK(kept.solve(right) == whole.solve(right));
}

} // namespace

int main() {
  for (const int n : {1, 2, 7, 200})
    solves(chain(n, false));
  solves(chain(200, true));
  for (const int n_unchanged : {0, 1, 77, 199, 200})
    for (const bool ring : {false, true})
      keeps_rows(chain(200, ring), n_unchanged);

  contact::LineFactorization factors;
  factors.analyze(chain(1000, false));
  CHECK(factors.n_nonzeros() == 999); // of L below its diagonal
  factors.analyze(chain(1000, true));
  CHECK(factors.n_nonzeros() < 3000);

  SparseMatrix singular = chain(5, false);
  factors.analyze(singular);
  for (int i = 0; i < 5; ++i)
    for (SparseMatrix::InnerIterator entry(singular, i); entry; ++entry)
      entry.valueRef() = i == 0 ? 0. : entry.value();
  CHECK(!factors.factorize(singular));
  return check::report();
}
