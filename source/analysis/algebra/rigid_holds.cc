// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/rigid_holds.h"

#include <frictionbeam/contact/line_factorization.h>

#include <algorithm>

namespace frictionbeam {

namespace {
constexpr double rigid = 1e8; ///< times the line's own stiffness
} // namespace

std::vector<std::array<double, n_support_strains>>
rigid_holds(const SparseMatrix &A, const Contacts &contacts, const std::vector<HeldStrains> &held) {
  std::vector<std::array<double, n_support_strains>> result(contacts.size());
  const auto for_each_held = [&](const auto &function) {
    for (unsigned int i = 0; i < contacts.size(); ++i)
      for (unsigned int e = 0; e < n_support_strains; ++e)
        if (held[i][e] && contacts[i].B.row(e).norm() > 0.)
          function(contacts[i], Vector(contacts[i].B.row(e)), result[i][e]);
  };

  SparseMatrix with_holds = A;
  for_each_held([&](const Contact &contact, const Vector &b, double &own) {
    own = 0.;
    for (Eigen::Index r = 0; r < b.size(); ++r)
      for (Eigen::Index c = 0; c < b.size(); ++c)
        own += b[r] * b[c] * A.coeff(contact.unknowns[r], contact.unknowns[c]);
    own /= b.squaredNorm() * b.squaredNorm();
    for (Eigen::Index r = 0; r < b.size(); ++r)
      for (Eigen::Index c = 0; c < b.size(); ++c)
        add_to(with_holds, contact.unknowns[r], contact.unknowns[c], own * b[r] * b[c]);
  });
  contact::LineFactorization factors;
  factors.analyze(with_holds);
  const bool factored = factors.factorize(with_holds);
  const double largest = A.rows() > 0 ? A.diagonal().maxCoeff() : 1.;
  for_each_held([&](const Contact &contact, const Vector &b, double &stiffness) {
    const double least = largest / b.squaredNorm(), most = rigid * least;
    if (!factored) {
      stiffness = most;
      return;
    }
    Vector force = Vector::Zero(A.rows());
    for (Eigen::Index r = 0; r < b.size(); ++r)
      force[contact.unknowns[r]] = b[r];
    const Vector motion = factors.solve(force);
    double flexibility = 0.;
    for (Eigen::Index r = 0; r < b.size(); ++r)
      flexibility += b[r] * motion[contact.unknowns[r]];
    stiffness = std::clamp(rigid * (1. / flexibility - stiffness), least, most);
  });
  return result;
}

} // namespace frictionbeam
