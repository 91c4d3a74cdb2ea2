// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"
#include <frictionbeam/contact/line_factorization.h>

namespace frictionbeam {

/**
 * Solves by the return mapping of the friction elements, with either
 *  - elastic: the elastic stiffness kept, residual forces sent back until they vanish (what TEDEL
 *    did); one factorization for all increments;
 *  - newton: the consistent, unsymmetric tangent with a line search. Each increment starts with the
 *    elastic tangent, since contacts that rest exactly on the threshold make the consistent one
 *    singular at a reversal.
 * doc/theory.md, "Methods of return mapping".
 */
class ReturnMappingSolver final : public EquilibriumSolver {
public:
  ReturnMappingSolver(const SolverSettings &settings, const Contacts &contacts,
                      const ReducedSpace &space);

  void matrix_changed() override { elastic_is_current = elastic_is_known = false; }
  EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                          Vector &unknowns, ContactResponse &response) override;
  void transfer(Archive &archive) override;

private:
  bool factor_elastic(const EquilibriumProblem &problem, Residual &residual, const Vector &unknowns,
                      EquilibriumResult &result);
  /// One iteration, from the forces that are left. @return false if the tangent is singular
  bool improve(const EquilibriumProblem &problem, Residual &residual, Vector &forces,
               Vector &unknowns, ContactResponse &response, EquilibriumResult &result);

  const SolverSettings &settings;
  const bool newton;
  const Contacts &contacts;
  const ReducedSpace &space;
  contact::LineFactorization elastic, consistent;
  SparseMatrix tangent;
  Vector elastic_diagonal;
  decltype(ContactResponse::tangent) elastic_tangent; ///< of the contacts, that is factored
  bool analyzed = false, elastic_is_current = false, elastic_is_known = false;
};

} // namespace frictionbeam
