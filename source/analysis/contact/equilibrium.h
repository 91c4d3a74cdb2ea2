// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include <frictionbeam/contact/exact_solver.h>

#include <functional>
#include <memory>

namespace frictionbeam {

/// One nonlinear problem of a line: find q with  A q + contact forces(C q + imposed) = right hand
/// side.
struct EquilibriumProblem : contact::Problem {
  Vector imposed;  ///< on all degrees of freedom
  double end = 0.; ///< of a time step, the run's time, which laws may not see [s]
};

using EquilibriumResult = contact::Result;

/// A method for EquilibriumProblem. It may keep factors and states between increments.
class EquilibriumSolver {
public:
  virtual ~EquilibriumSolver() = default;

  /// To be called when the matrix of the following problems has changed.
  virtual void matrix_changed() = 0;

  /**
   * @param unknowns in: first guess; out: the solution, or the last iterate if not converged
   * @param response of the contacts at the solution
   */
  virtual EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                                  Vector &unknowns, ContactResponse &response) = 0;

  /// What it keeps from one problem to the next and the solutions depend on. Reading it, the
  /// factorizations that belong to it are made again.
  virtual void transfer(Archive &archive) = 0;

  /// Contacts of the last solution that may have other states for the same loads, as far as the
  /// method can see.
  virtual std::vector<contact::BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &) const {
    return {};
  }
};

/// Residual forces of a problem, the contacts evaluated on the way (contact::Balance).
class Residual : public contact::Balance {
public:
  /// Evaluates all contacts at displacements of all degrees of freedom.
  using Evaluate = std::function<void(const Vector &, const LawTangent, ContactResponse &)>;

  Residual(const EquilibriumProblem &problem, const Contacts &contacts, const ReducedSpace &space,
           Evaluate evaluate)
      : Balance(problem, contacts), problem(problem), space(space), evaluate(std::move(evaluate)) {}

  /// right_hand_side - A q - contact forces.
  Vector operator()(const Vector &unknowns, const LawTangent tangent, ContactResponse &response);

private:
  const EquilibriumProblem &problem;
  const ReducedSpace &space;
  const Evaluate evaluate;
  Vector dofs; ///< scratch
};

/**
 * Go along a direction until the residual, weighed by a positive diagonal so that forces and
 * moments become energies, decreases; where no length does that, a kink lies ahead, and the least
 * bad step crosses it. @return the weighed residual reached, squared.
 */
double search_line(Residual &residual, const Vector &direction, const Vector &diagonal,
                   Vector &unknowns, Vector &forces, ContactResponse &response);

} // namespace frictionbeam
