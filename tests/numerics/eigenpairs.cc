// SPDX-License-Identifier: LGPL-2.1-or-later
// A chain of n masses between two walls has w_j^2 = 4 k/m sin^2(j pi / (2n + 2)). Few of many
// pairs, all of few, equal ones of two chains side by side, masses that vanish; Sylvester's count.
#include "../check.h"

#include "analysis/algebra/eigenpairs.h"

using namespace frictionbeam;

namespace {

constexpr double pi = 3.14159265358979323846, k = 400., m = 2.;

double exact(const unsigned int j, const unsigned int n) {
  const double sine = std::sin(j * pi / (2. * n + 2.));
  return 4. * k / m * sine * sine;
}

/// @p n_chains chains side by side that do not know of each other.
Eigen::SparseMatrix<double> stiffness(const int n, const int n_chains = 1) {
  Eigen::SparseMatrix<double> result(n * n_chains, n * n_chains);
  for (int c = 0; c < n_chains; ++c)
    for (int i = 0; i < n; ++i) {
      result.insert(c * n + i, c * n + i) = 2. * k;
      if (i > 0)
        result.insert(c * n + i, c * n + i - 1) = result.insert(c * n + i - 1, c * n + i) = -k;
    }
  return result;
}

Eigen::SparseMatrix<double> masses(const int n, const int without = 0) {
  Eigen::SparseMatrix<double> result(n, n);
  for (int i = without; i < n; ++i)
    result.insert(i, i) = m;
  return result;
}

std::vector<Eigenpair> lowest(const Eigen::SparseMatrix<double> &K,
                              const Eigen::SparseMatrix<double> &M, const unsigned int n) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(K);
  const std::vector<Eigenpair> pairs = lowest_eigenpairs(K, M, factors, n);
  for (const Eigenpair &pair : pairs) {
    const Vector left = K * pair.vector - pair.value * (M * pair.vector);
    CHECK_NEAR(left.norm() / (K * pair.vector).norm(), 0., 1e-8);
    CHECK_NEAR(pair.vector.lpNorm<Eigen::Infinity>(), 1., 1e-12);
  }
  return pairs;
}

} // namespace

int eigenpairs(int, char **) {
  for (const unsigned int n : {3u, 40u, 2000u}) { // all by the dense solver, the last by ARPACK
    const auto pairs = lowest(stiffness(n), masses(n), std::min(n, 8u));
    CHECK(pairs.size() == std::min(n, 8u));
    for (unsigned int j = 0; j < pairs.size(); ++j)
      CHECK_NEAR(pairs[j].value, exact(j + 1, n), 1e-8);
  }

  const auto twice = lowest(stiffness(600, 2), masses(1200), 6);
  CHECK(twice.size() == 6);
  for (unsigned int j = 0; j < twice.size(); ++j)
    CHECK_NEAR(twice[j].value, exact(j / 2 + 1, 600), 1e-8);

  // Without mass, an end is a spring: as many pairs as masses.
  CHECK(lowest(stiffness(5), masses(5, 2), 5).size() == 3);

  const Eigen::SparseMatrix<double> K = stiffness(50), M = masses(50);
  CHECK(count_eigenvalues_below(K, M, 0.) == 0);
  for (const unsigned int j : {1u, 7u, 50u}) {
    CHECK(count_eigenvalues_below(K, M, exact(j, 50) * (1. - 1e-9)) == j - 1);
    CHECK(count_eigenvalues_below(K, M, exact(j, 50) * (1. + 1e-9)) == j);
  }
  return check::report();
}
