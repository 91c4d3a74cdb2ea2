// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/modal_damping.h"

#include "base/algebra/dense_algebra.h"
#include "base/user_error.h"

#include <cmath>

namespace frictionbeam {

namespace {
constexpr int most_unknowns = 600;
constexpr double rigid = 1e-10; ///< of the largest eigenvalue
} // namespace

Modes modes_to_damp(const SparseMatrix &K, const SparseMatrix &M) {
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
    return {};
  const SymmetricEigen modes = symmetric_eigen(Eigen::MatrixXd(K), Eigen::MatrixXd(M));
  const Vector &squares = modes.values;
  const double largest = squares.maxCoeff();
  Modes result{modes.vectors, Vector::Zero(squares.size())};
  for (int i = 0; i < squares.size(); ++i)
    if (squares[i] > rigid * largest)
      result.frequencies[i] = std::sqrt(squares[i]);
  return result;
}

SparseMatrix modal_damping(const SparseMatrix &K, const SparseMatrix &M, const double ratio) {
  const Modes modes = modes_to_damp(K, M);
  if (modes.frequencies.size() == 0)
    return K;
  const Eigen::MatrixXd shapes = Eigen::MatrixXd(M) * modes.shapes;
  const Eigen::MatrixXd damping =
      shapes * (2. * ratio * modes.frequencies).asDiagonal() * shapes.transpose();
  // Exactly symmetric, as what reads one half of it expects.
  return Eigen::MatrixXd((damping + damping.transpose()) / 2.).sparseView();
}

} // namespace frictionbeam
