// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/modal_damping.h"

#include "base/user_error.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace frictionbeam {

namespace {
constexpr int most_unknowns = 600;
constexpr double rigid = 1e-10; ///< of the largest eigenvalue
} // namespace

SparseMatrix modal_damping(const SparseMatrix &K, const SparseMatrix &M, const double ratio) {
  if (K.rows() > most_unknowns)
    throw UserError("'Modal damping' is for lines of at most " + std::to_string(most_unknowns) +
                    " unknowns, and this one has " + std::to_string(K.rows()) +
                    ". Use 'Mass damping' and 'Stiffness damping'.");
  for (int i = 0; i < M.rows(); ++i)
    if (!(M.coeff(i, i) > 0.))
      throw UserError(
          "'Modal damping' needs mass at every point that can move. Give points without "
          "mass a Mass, hold them, or use 'Mass damping' and 'Stiffness damping'.");
  if (K.rows() == 0) // all is held
    return K;
  const Eigen::MatrixXd mass(M);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(Eigen::MatrixXd(K), mass);
  const Vector &squares = modes.eigenvalues();
  const Eigen::MatrixXd shapes = mass * modes.eigenvectors();
  const double largest = squares.size() > 0 ? squares.maxCoeff() : 0.;
  Vector factors(squares.size());
  for (int i = 0; i < squares.size(); ++i)
    factors[i] = squares[i] > rigid * largest ? 2. * ratio * std::sqrt(squares[i]) : 0.;
  const Eigen::MatrixXd damping = shapes * factors.asDiagonal() * shapes.transpose();
  return damping.sparseView();
}

} // namespace frictionbeam
