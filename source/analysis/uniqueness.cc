// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/uniqueness.h>

#include <frictionbeam/analysis/line_factorization.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>

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

/// Least t.K_tt t/|K_tn.t| of all directions t, to a degree; couplings below a millionth are
/// rounding.
double least_ratio(const Eigen::Matrix2d &K_tt, const Eigen::Vector2d &K_tn) {
  constexpr double degree = 3.14159265358979323846 / 180.;
  double least = std::numeric_limits<double>::infinity();
  for (int angle = 0; angle < 180; ++angle) {
    const Eigen::Vector2d t(std::cos(angle * degree), std::sin(angle * degree));
    const double stiffness = t.dot(K_tt * t), coupling = std::abs(K_tn.dot(t));
    if (stiffness > 0. && coupling > 1e-6 * stiffness)
      least = std::min(least, stiffness / coupling);
  }
  return least;
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
    const double limit =
        least_ratio(stiffness.bottomRightCorner<2, 2>(), stiffness.block<2, 1>(1, 0));
    if (friction >= limit)
      result.push_back({i, friction, limit});
  }
  return result;
}

} // namespace frictionbeam
