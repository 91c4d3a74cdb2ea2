// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/eigenpairs.h"

#include "base/algebra/dense_algebra.h"
#include "base/user_error.h"

#include <deal.II/lac/arpack_solver.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <random>

namespace frictionbeam {

using namespace dealii;

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<Matrix>;

constexpr unsigned int most_unknowns_dense = 300;
constexpr double no_mass = 1e-14; ///< 1/w^2, relative to the largest

/// What deal.II's solvers want of a matrix.
struct Times {
  std::function<Vector(const Vector &)> apply;

  void vmult(dealii::Vector<double> &to, const dealii::Vector<double> &from) const {
    const Eigen::Map<const Vector> x(from.begin(), from.size());
    Eigen::Map<Vector>(to.begin(), to.size()) = apply(x);
  }
};

/// A largest entry of 1.
Vector scaled(const Vector &x) {
  int largest = 0;
  x.cwiseAbs().maxCoeff(&largest);
  return x / x[largest];
}

/// M x = mu K x with mu = 1/w^2: K is regular, M need not be.
std::vector<Eigenpair> solve_dense(const Matrix &K, const Matrix &M, const unsigned int n) {
  const SymmetricEigen eigen = symmetric_eigen(Eigen::MatrixXd(M), Eigen::MatrixXd(K));
  const Vector &mu = eigen.values;
  std::vector<Eigenpair> pairs;
  for (int i = mu.size() - 1; i >= 0 && pairs.size() < n; --i)
    if (mu[i] > no_mass * mu[mu.size() - 1])
      pairs.push_back({1. / mu[i], scaled(eigen.vectors.col(i))});
  return pairs;
}

} // namespace

std::vector<Eigenpair> arpack_eigenpairs(const Matrix &M,
                                         const std::function<Vector(const Vector &)> &inverse,
                                         const double shift, const unsigned int n,
                                         const unsigned int n_vectors) {
  const unsigned int size = M.rows();
  const Times mass{[&M](const Vector &x) { return Vector(M * x); }}, inverse_times{inverse};
  SolverControl control(1000, 1e-12, false, false);
  ArpackSolver solver(
      control, ArpackSolver::AdditionalData(n_vectors, ArpackSolver::largest_magnitude, true));
  solver.set_shift(shift);
  std::mt19937 random(1); // a symmetric vector would miss the modes that are not
  dealii::Vector<double> initial(size);
  for (double &x : initial)
    x = static_cast<double>(random()) / 4294967296. - 0.5;
  solver.set_initial_vector(initial);
  std::vector<std::complex<double>> values(n);
  std::vector<dealii::Vector<double>> vectors(n, dealii::Vector<double>(size));
  try {
    solver.solve(mass, mass, inverse_times, values, vectors, n);
  } catch (const ExceptionBase &) { // ARPACK's own word that it has not converged
    return {};
  }
  std::vector<Eigenpair> pairs;
  for (unsigned int i = 0; i < n; ++i)
    pairs.push_back({values[i].real(), Eigen::Map<const Vector>(vectors[i].begin(), size)});
  std::sort(pairs.begin(), pairs.end(),
            [](const Eigenpair &a, const Eigenpair &b) { return a.value < b.value; });
  return pairs;
}

unsigned int count_eigenvalues_below(const Matrix &K, const Matrix &M, const double value) {
  const Matrix pencil = K - value * M;
  const Factors factors(pencil);
  return (factors.vectorD().array() < 0.).count();
}

std::vector<Eigenpair> lowest_eigenpairs(const Matrix &K, const Matrix &M, const Factors &factors,
                                         const unsigned int n) {
  const unsigned int size = K.rows();
  if (size <= most_unknowns_dense || 4 * n >= size)
    return solve_dense(K, M, n);
  for (unsigned int n_vectors = std::max(2 * n + 2, 20u); n_vectors < size; n_vectors *= 2) {
    std::vector<Eigenpair> pairs = arpack_eigenpairs(
        M, [&factors](const Vector &x) { return Vector(factors.solve(x)); }, 0., n, n_vectors);
    if (pairs.empty() || count_eigenvalues_below(K, M, pairs.back().value * (1. - 1e-6)) >= n)
      continue;
    for (Eigenpair &pair : pairs)
      pair.vector = scaled(pair.vector);
    return pairs;
  }
  throw UserError("Time/Modes: ARPACK did not find all of the lowest " + std::to_string(n) +
                  " modes of a part of the line between its contacts. Ask for another number, or "
                  "set Modes to all.");
}

} // namespace frictionbeam
