// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/coarse_multigrid.h"
#include "analysis/algebra/elastic_operator.h"

namespace frictionbeam {

/// Chebyshev's polynomial in D^-1 A, D being the diagonal, at contacts with the contact's tangent
/// (M. Adams, M. Brezina, J. Hu, R. Tuminaro, J. Comput. Phys. 188 (2003) 593-610).
class ChebyshevSmoother {
public:
  static constexpr unsigned int degree = 3; ///< products with A
  static constexpr double range = 15.;      ///< of eigenvalues that are smoothed

  ChebyshevSmoother(const ContinuumVector &inverse_diagonal, const double largest_eigenvalue)
      : inverse(inverse_diagonal), largest(largest_eigenvalue), step(inverse_diagonal),
        left(inverse_diagonal) {}

  void set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts);
  /// x += S (b - A x). @param from_zero whether x is zero
  void smooth(const StiffnessWithContacts &A, ContinuumVector &x, const ContinuumVector &b,
              const bool from_zero);

  /// Times D^-1 D_K at contacts, D_K being the diagonal without them (or, transposed, D_K D^-1):
  /// what a coarse correction is multiplied by, so that it is none where a contact holds.
  void scale_contacts(ContinuumVector &vector, const bool transposed) const;

private:
  void scale(ContinuumVector &vector) const;

  const ContinuumVector inverse;
  const double largest;
  std::vector<StiffnessWithContacts::Contact> blocks; ///< inverses
  ContinuumVector step, left;
};

/// One cycle of multigrid: smoothed on the body's own elements, then those of degree one.
class MultigridCycle {
public:
  MultigridCycle(const ContinuumBody<3> &body, const ElasticOperator &stiffness);

  /// @return whether the coarse multigrid was set up anew: it is kept while few contacts change
  bool set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts);
  void set_up_next() { is_set_up = false; }
  void vmult(ContinuumVector &x, const ContinuumVector &b) const;

private:
  using Contact = StiffnessWithContacts::Contact;

  /// What contacts add to the coarse stiffness, on the body's dofs.
  std::vector<Eigen::Matrix3d> coarse_tangents(const std::vector<Contact> &contacts) const;
  /// Whether they differ from those of the last set-up, for all processes.
  bool differ(const std::vector<Eigen::Matrix3d> &tangents,
              const std::vector<Contact> &contacts) const;

  const ContinuumBody<3> &body;
  const ElasticOperator &stiffness;
  const LinearElements linear;
  const std::unique_ptr<CoarseMultigrid> multigrid;
  std::unique_ptr<StiffnessWithContacts> definite;
  mutable std::unique_ptr<ChebyshevSmoother> smoother;
  bool is_set_up = false;
  std::vector<Eigen::Matrix3d> last_tangents; ///< that the coarse multigrid was set up with
  mutable ContinuumVector left, correction, coarse, coarse_left;
};

} // namespace frictionbeam
