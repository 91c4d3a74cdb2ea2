// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/proximal_contacts.h"
#include "analysis/contact/uniqueness.h"
#include "model/line_state.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace frictionbeam {

/// One nonlinear problem: find q with  A q + contact forces(C q + imposed) = right_hand_side.
struct EquilibriumProblem {
  const SparseMatrix &matrix;
  Vector right_hand_side;
  Vector imposed; ///< on all degrees of freedom
  ContactIncrement increment;
  const ContactOverrides *overrides = nullptr; ///< of exact contacts
  double largest_force = 0.; ///< to measure residuals by, beside those of the problem itself
  /// right_hand_side - matrix (unknowns + low), where the caller knows it in a cheaper way. Of the
  /// right hand side nothing but its size is then asked.
  std::function<Vector(const Vector &unknowns, const Vector &low)> unbalanced = {};
  /// Largest force of the load sequence so far, beside which rounding is rounding even where all
  /// loads are taken off.
  double force_so_far = 0.;
  unsigned int most_iterations = std::numeric_limits<unsigned int>::max(); ///< give up after
  /// Forces of exact contacts to begin from, where the caller knows better than the method. A
  /// matrix that is not positive definite has several solutions: the nearest is the one meant.
  const std::vector<Contact::Strains> *forces_before = nullptr;
};

struct EquilibriumResult {
  bool converged = false;
  unsigned int iterations = 0, factorizations = 0;
  unsigned int back_substitutions = 0; ///< with a matrix of the whole line
  double residual = 0.;                ///< relative to the largest force
  std::optional<ContactCheck> check;   ///< of methods that solve exact contact laws
  bool no_equilibrium = false;         ///< proved: something slides or lifts off freely
  bool rounding_bars = false;          ///< not converged, and no smaller increment would
  std::string remark;                  ///< why not converged
};

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
  virtual std::vector<BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &) const {
    return {};
  }
};

/// f - K q without the contacts' forces, in extended precision, where q = unknowns + low.
Vector unbalanced_forces(const EquilibriumProblem &problem, const Vector &unknowns,
                         const Vector &low);

/// Why an increment ends whose forces rounding keeps from vanishing, in words without a full stop.
/// @param left what is unbalanced [N] @param largest force of the problem [N]
std::string too_much_rounding(const double left, const double largest);

/**
 * Residual forces of a problem, and when they count as zero: below the tolerance times the largest
 * force, or below the rounding error of the forces themselves where that is larger, but never above
 * 1e-8 of the largest force, of the sequence so far.
 */
class Residual {
public:
  /// Evaluates all contacts at displacements of all degrees of freedom.
  using Evaluate = std::function<void(const Vector &, const LawTangent, ContactResponse &)>;

  Residual(const EquilibriumProblem &problem, const Contacts &contacts, const ReducedSpace &space,
           Evaluate evaluate);

  /// right_hand_side - A q - contact forces, the contacts evaluated on the way.
  Vector operator()(const Vector &unknowns, const LawTangent tangent, ContactResponse &response);

  /// The same at the stresses that the response has.
  /// @param low what rounding took from the unknowns; may be empty.
  Vector with_stress(const Vector &unknowns, const Vector &low,
                     const ContactResponse &response) const;

  double largest_force(const ContactResponse &response) const;
  /// @param diagonal of the tangent, for the rounding error of A q
  double tolerance(const double relative, const Vector &diagonal, const Vector &unknowns,
                   const ContactResponse &response) const;
  /// Of A q, by the same diagonal.
  static double rounding(const Vector &diagonal, const Vector &unknowns);

private:
  const EquilibriumProblem &problem;
  const Contacts &contacts;
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
