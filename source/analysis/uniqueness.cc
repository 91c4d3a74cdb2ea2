// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/uniqueness.h>

#include <frictionbeam/analysis/line_factorization.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace frictionbeam {

namespace {

/// A hold of a contact, stiff beside the line but not so stiff that it could not be taken off
/// again.
Eigen::Vector3d hold(const ProximalContacts &proximal, const unsigned int i,
                     const ContactStatus status) {
  constexpr double stiff = 1e3;
  const Eigen::Vector2d diagonal = stiff * proximal.diagonal_stiffness(i);
  const double tangential = status == ContactStatus::stick ? diagonal[1] : 0.;
  return {status == ContactStatus::open ? 0. : diagonal[0], tangential, tangential};
}

} // namespace

std::vector<BeyondUniqueness> contacts_beyond_uniqueness(const Contacts &contacts,
                                                         const CondensedLine &line,
                                                         const ProximalContacts &proximal,
                                                         const std::vector<ContactStatus> &status) {
  std::vector<BeyondUniqueness> result;
  SparseMatrix held = line.matrix();
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!proximal.is_exact(i))
      return result; // what such a law holds is not known here
    const auto B = contacts[i].length * contacts[i].B_reduced.topRows<3>();
    const Eigen::MatrixXd block = B.transpose() * hold(proximal, i, status[i]).asDiagonal() * B;
    for (Eigen::Index a = 0; a < block.rows(); ++a)
      for (Eigen::Index b = 0; b < block.cols(); ++b)
        add_to(held, line.place(contacts[i].unknowns[a]), line.place(contacts[i].unknowns[b]),
               block(a, b));
  }
  LineFactorization factors;
  factors.analyze(held);
  if (!factors.factorize(held))
    return result;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const double friction = proximal.friction_coefficient(i);
    if (status[i] == ContactStatus::open || friction == 0.)
      continue;
    const auto B = contacts[i].length * contacts[i].B_reduced.topRows<3>();
    Eigen::Matrix3d compliance;
    for (int d = 0; d < 3; ++d) {
      Vector force = Vector::Zero(line.n_kept());
      for (Eigen::Index j = 0; j < B.cols(); ++j)
        force[line.place(contacts[i].unknowns[j])] = B(d, j);
      const Vector motion = factors.solve(force);
      compliance.col(d).setZero();
      for (Eigen::Index j = 0; j < B.cols(); ++j)
        compliance.col(d) += motion[line.place(contacts[i].unknowns[j])] * B.col(j);
    }
    Eigen::Matrix3d stiffness = compliance.inverse();
    stiffness -= Eigen::Matrix3d(hold(proximal, i, status[i]).asDiagonal());
    const Eigen::Matrix2d K_tt = stiffness.bottomRightCorner<2, 2>();
    const double coupling = stiffness.block<2, 1>(1, 0).norm();
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>((K_tt + K_tt.transpose()) / 2.)
            .eigenvalues()[0];
    // Below a millionth of the stiffness, coupling is rounding.
    if (coupling > 1e-6 * std::abs(least) && least > 0. && friction * coupling >= least)
      result.push_back({i, friction, least / coupling});
  }
  return result;
}

} // namespace frictionbeam
