// SPDX-License-Identifier: LGPL-2.1-or-later
// A matrix whose pattern, but not whose values are symmetric is solved to rounding; a chain costs
// no fill, a ring not much; a vanishing pivot is said.
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

} // namespace

int main() {
  for (const int n : {1, 2, 7, 200})
    solves(chain(n, false));
  solves(chain(200, true));

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
