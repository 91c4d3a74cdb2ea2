// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/algebra/dense_algebra.h"

#include <Eigen/Eigenvalues>

namespace frictionbeam {

LeastSquares::LeastSquares(const Eigen::MatrixXd &A) : factors(A) {}

LeastSquares::LeastSquares(const Eigen::MatrixXd &A, const double threshold) {
  factors.setThreshold(threshold);
  factors.compute(A);
}

Eigen::Index LeastSquares::rank() const { return factors.rank(); }

Eigen::VectorXd LeastSquares::solve(const Eigen::VectorXd &b) const { return factors.solve(b); }

Eigen::MatrixXd LeastSquares::pseudo_inverse() const { return factors.pseudoInverse(); }

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd &A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, B);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXi most_independent_columns(const Eigen::MatrixXd &A) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(A).colsPermutation().indices();
}

} // namespace frictionbeam
