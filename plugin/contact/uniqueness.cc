// SPDX-License-Identifier: LGPL-2.1-or-later
#include "uniqueness.h"

#include <frictionbeam/contact/line_factorization.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>

namespace frictionbeam::contact {

namespace {

/// A hold of a contact, stiff beside the line but not so stiff that it could not be taken off
/// again.
Eigen::Vector3d hold(const ProximalSites &proximal, const unsigned int i,
                     const ContactStatus status) {
  constexpr double stiff = 1e3;
  const Eigen::Vector2d diagonal = stiff * proximal.diagonal_stiffness(i);
  const double tangential = status == ContactStatus::stick ? diagonal[1] : 0.;
  return {status == ContactStatus::open ? 0. : diagonal[0], tangential, tangential};
}

/**
 * Least K_tt/|K_tn| of all directions t in the plane of a contact, K its stiffness along t and n;
 * couplings below a millionth are rounding. Where the line is held in some direction, the contact
 * moves in a plane or on a line of its three directions only: t are those without a normal part,
 * and n stands for the motion across them that lifts off by one, whatever it does sideways.
 * @param compliance of the contact, @param hold that is in it besides the line
 */
double least_ratio(const Eigen::Matrix3d &compliance, const Eigen::Vector3d &hold) {
  constexpr double degree = 3.14159265358979323846 / 180., infinity = 1e300;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen((compliance + compliance.transpose()) /
                                                             2.);
  const Eigen::Vector3d &values = eigen.eigenvalues(); // ascending
  int n_free = 0;
  for (int i = 0; i < 3; ++i)
    n_free += values[i] > 1e-13 * values[2] ? 1 : 0;
  const Eigen::MatrixXd free = eigen.eigenvectors().rightCols(n_free);
  Eigen::MatrixXd stiffness = values.tail(n_free).cwiseInverse().asDiagonal();
  stiffness -= free.transpose() * hold.asDiagonal() * free;
  // How each free direction lifts off; what of them is orthogonal to that is sliding.
  const Eigen::VectorXd lifts = free.row(0).transpose();
  if (n_free < 2 || lifts.squaredNorm() < 1e-18)
    return infinity;
  const Eigen::MatrixXd slides = Eigen::HouseholderQR<Eigen::MatrixXd>(lifts).householderQ() *
                                 Eigen::MatrixXd::Identity(n_free, n_free).rightCols(n_free - 1);
  const Eigen::VectorXd normal = lifts / lifts.squaredNorm();
  const Eigen::MatrixXd K_tt = slides.transpose() * stiffness * slides;
  const Eigen::VectorXd K_tn = slides.transpose() * stiffness * normal;
  double least = infinity;
  for (int angle = 0; angle < (n_free == 3 ? 180 : 1); ++angle) {
    const Eigen::Vector2d way(std::cos(angle * degree), std::sin(angle * degree));
    const Eigen::VectorXd t = way.head(n_free - 1);
    const double along = t.dot(K_tt * t), coupling = std::abs(K_tn.dot(t));
    if (along > 0. && coupling > 1e-6 * along)
      least = std::min(least, along / coupling);
  }
  return least;
}

/// The condensed stiffness with all contacts held as they are.
SparseMatrix hold_all(const SiteList &contacts, const Condensation &line,
                      const ProximalSites &proximal, const std::vector<ContactStatus> &status) {
  SparseMatrix held = line.matrix();
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const auto B = contacts[i].length * contacts[i].B.topRows<3>();
    const Eigen::MatrixXd block = B.transpose() * hold(proximal, i, status[i]).asDiagonal() * B;
    for (Eigen::Index a = 0; a < block.rows(); ++a)
      for (Eigen::Index b = 0; b < block.cols(); ++b)
        add_to(held, line.place(contacts[i].unknowns[a]), line.place(contacts[i].unknowns[b]),
               block(a, b));
  }
  return held;
}

/// Displacements of a contact by unit forces there [m/N].
Eigen::Matrix3d compliance_at(const Site &contact, const Condensation &line,
                              const LineFactorization &factors) {
  const auto B = contact.length * contact.B.topRows<3>();
  Eigen::Matrix3d compliance;
  for (int d = 0; d < 3; ++d) {
    Vector force = Vector::Zero(line.n_kept());
    for (Eigen::Index j = 0; j < B.cols(); ++j)
      force[line.place(contact.unknowns[j])] = B(d, j);
    const Vector motion = factors.solve(force);
    compliance.col(d).setZero();
    for (Eigen::Index j = 0; j < B.cols(); ++j)
      compliance.col(d) += motion[line.place(contact.unknowns[j])] * B.col(j);
  }
  return compliance;
}

} // namespace

std::vector<BeyondUniqueness> contacts_beyond_uniqueness(const SiteList &contacts,
                                                         const Condensation &line,
                                                         const ProximalSites &proximal,
                                                         const std::vector<ContactStatus> &status) {
  std::vector<BeyondUniqueness> result;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!proximal.is_exact(i))
      return result; // what such a law holds is not known here
  const SparseMatrix held = hold_all(contacts, line, proximal, status);
  LineFactorization factors;
  factors.analyze(held);
  if (!factors.factorize(held))
    return result;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const double friction = proximal.friction_coefficient(i);
    if (status[i] == ContactStatus::open || friction == 0.)
      continue;
    const double limit =
        least_ratio(compliance_at(contacts[i], line, factors), hold(proximal, i, status[i]));
    if (friction >= limit)
      result.push_back({i, friction, limit});
  }
  return result;
}

} // namespace frictionbeam::contact
