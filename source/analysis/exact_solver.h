// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/equilibrium.h>
#include <frictionbeam/analysis/line_factorization.h>

namespace frictionbeam {

/**
 * Exact contact: Signorini's condition and Coulomb's law without a stiffness to choose, by a
 * proximal-point iteration around semismooth Newton.
 *
 * Each outer step solves the line on proximal contacts (ProximalContacts) of stiffness c k_d around
 * the forces of the step before, by Newton's method with the unsymmetric tangent and a line search.
 * The stiffness grows tenfold from step to step; where Newton fails, it is lowered thirtyfold. The
 * iteration ends when the contact laws themselves, judged without the proximal term, hold: each
 * contact's natural-map residual on its own scale. Neither a small change from step to step nor the
 * convergence of an inner solve decides.
 */
class ExactSolver final : public EquilibriumSolver {
public:
  ExactSolver(const SolverSettings &settings, const Contacts &contacts, const ReducedSpace &space,
              const SparseMatrix &stiffness);

  void matrix_changed() override {}
  EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                          Vector &unknowns, ContactResponse &response) override;

private:
  /// Newton's method on the present proximal contacts.
  bool solve_inner(const EquilibriumProblem &problem, Residual &residual, Vector &unknowns,
                   ContactResponse &response, EquilibriumResult &result);

  /// Factor the tangent, with a small multiple of the diagonal where it is singular.
  bool factor(const EquilibriumProblem &problem, const Vector &forces,
              const ContactResponse &response, EquilibriumResult &result);
  /**
   * Whether the last iterate proves that there is no equilibrium: a motion without elastic forces,
   * along which every contact gives its utmost resistance or none, and the loads still do work.
   */
  bool slides_away(const EquilibriumProblem &problem, const Vector &forces,
                   const ContactResponse &response);

  const SolverSettings &settings;
  const Contacts &contacts;
  const ReducedSpace &space;
  ProximalContacts proximal;
  LineFactorization factors;
  SparseMatrix tangent;
  Vector diagonal; ///< of the line's stiffness with proximal contacts closed
  Vector last_forces;
  bool analyzed = false;
  double first_factor = 1e-3; ///< c that an increment begins with
};

} // namespace frictionbeam
