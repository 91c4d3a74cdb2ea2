// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/line_factorization.h>
#include <frictionbeam/analysis/line_state.h>

namespace frictionbeam {

/// One nonlinear problem: find q with  A q + contact forces(C q + imposed) = right_hand_side.
struct EquilibriumProblem {
  const SparseMatrix &matrix;
  Vector right_hand_side;
  Vector imposed;  ///< on all degrees of freedom
  double time = 0., time_increment = 0.;
};

struct EquilibriumResult {
  bool converged = false;
  unsigned int iterations = 0, factorizations = 0;
  double residual = 0.; ///< relative to the largest force
  std::string remark;   ///< why not
};

/**
 * Solves an EquilibriumProblem by the return mapping of the friction elements, with either
 *  - elastic: the elastic stiffness kept, residual forces sent back until they vanish (what TEDEL
 *    did); one factorization for all increments;
 *  - newton: the consistent, unsymmetric tangent with a line search. Each increment starts with the
 *    elastic tangent, since contacts that rest exactly on the threshold make the consistent one
 *    singular at a reversal.
 * Converged means that the largest residual is below the tolerance times the largest force, or below
 * the rounding error of the forces themselves where that is larger.
 *
 * The place for further methods is a class beside this one with the same call.
 */
class EquilibriumSolver {
public:
  EquilibriumSolver(const SolverSettings &settings, const Contacts &contacts,
                    const ReducedSpace &space);

  /// To be called when the matrix of the following problems has changed.
  void matrix_changed() { elastic_is_current = false; }

  /**
   * @param unknowns in: first guess; out: the solution, or the last iterate if not converged
   * @param response of the contacts at the solution
   */
  EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                          Vector &unknowns, ContactResponse &response);

private:
  /// Residual forces at the unknowns, the contacts evaluated on the way.
  Vector residual(const EquilibriumProblem &problem, const ContactState &committed,
                  const Vector &unknowns, const LawTangent tangent, ContactResponse &response);
  double tolerance(const EquilibriumProblem &problem, const Vector &unknowns,
                   const ContactResponse &response) const;
  bool factor_elastic(const EquilibriumProblem &problem, const ContactState &committed,
                      const Vector &unknowns, EquilibriumResult &result);
  bool factor_consistent(const EquilibriumProblem &problem, const ContactResponse &response,
                         EquilibriumResult &result);
  void search_line(const EquilibriumProblem &problem, const ContactState &committed,
                   const Vector &direction, Vector &unknowns, Vector &forces,
                   ContactResponse &response);

  const SolverSettings &settings;
  const Contacts &contacts;
  const ReducedSpace &space;
  LineFactorization elastic, consistent;
  SparseMatrix tangent;
  Vector elastic_diagonal; ///< scales residuals of forces and moments to displacements
  bool analyzed = false, elastic_is_current = false;
  mutable double largest_force = 0.;
};

} // namespace frictionbeam
