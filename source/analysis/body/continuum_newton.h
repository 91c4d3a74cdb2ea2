// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "analysis/body/foundation_contacts.h"
#include "analysis/contact/free_body.h"
#include <frictionbeam/contact/attempts.h>

namespace frictionbeam {

struct ContinuumNewtonResult {
  bool converged = false;
  bool no_equilibrium = false; ///< proved: something slides or lifts off freely
  unsigned int iterations = 0;
  double residual = 0.; ///< relative to the largest force
  contact::Check check;
  std::string remark; ///< why not converged
};

/**
 * One increment of a body on its foundation: the two Newton's methods of contact::ExactSolver for a
 * body, in the order of contact::Attempts. What differs is the linear algebra: with a factorization
 * on one process an iteration costs two triangular solves and a dense system of the contacts;
 * unknowns are distributed among processes, and what is judged is judged by all of them.
 */
template <int dim>
class ContinuumNewton {
public:
  ContinuumNewton(const ContinuumBody<dim> &body, ContinuumSystem &system,
                  FoundationContacts &contacts);

  /**
   * @param forces of the loads, on unconstrained dofs
   * @param u in: first guess; out: solution, zero at held and hanging dofs
   * @param response of the contacts at the solution
   */
  ContinuumNewtonResult solve(const ContinuumVector &forces, const FoundationState &committed,
                              const LawIncrement &increment, ContinuumVector &u,
                              FoundationResponse &response);

  /// Displacements of the contact nodes in their own axes.
  std::vector<LocalVector> local(const ContinuumVector &u) const;
  /// Add the forces of tractions on the body.
  void add_forces(const std::vector<LocalVector> &stress, ContinuumVector &forces) const;

  /// What it learnt in increments before.
  void transfer(Archive &archive) { archive(attempts.first_factor, force_so_far, traction_so_far); }

  /// Newton's method on motions and tractions together.
  contact::Outcome solve_together(const unsigned int most_iterations, ContinuumVector &u,
                                  FoundationResponse &response, ContinuumNewtonResult &result);
  /// Newton's method on the contacts around a fixed centre.
  contact::Outcome solve_proximal(ContinuumVector &u, FoundationResponse &response,
                                  ContinuumNewtonResult &result);
  void take_forces_as_centre(const FoundationResponse &response) {
    contacts.centre = response.state.stress;
  }
  bool gives_up(const ContinuumNewtonResult &result) const;
  /// A random number, the same for all processes.
  double agreed(const double number) const;

private:
  /// The larger of a force or traction and what least_force leaves of the largest so far.
  static double or_least(const double largest, const double so_far);
  contact::Outcome solve_contacts(ContinuumVector &u, FoundationResponse &response,
                                  ContinuumNewtonResult &result);
  /**
   * Where these methods stall: solve the problem condensed to its contacts, contact::LocalProblem,
   * by contact::solve_local_contact(), for a start of one more attempt, the contacts' centre and u.
   * Weak springs at the contacts give a body that nothing else holds a flexibility; they have no
   * part in the attempt. Of bodies on one process with few contacts, exact ones without pressure.
   * @return whether there is one; if not, nothing is changed
   */
  bool find_condensed_start(ContinuumVector &u);
  /// Evaluate contacts and elastic forces at u.
  void evaluate(const ContinuumVector &u, FoundationResponse &response);
  /// Loads minus elastic forces, stiffness times u, plus forces of tractions.
  void residual(const std::vector<LocalVector> &stress, ContinuumVector &left) const;
  double energy(const ContinuumVector &forces) const;
  /// Of the residual with the centre for the contacts' tractions, and of what these miss the
  /// centre.
  double energy_together(const FoundationResponse &response, ContinuumVector &left) const;
  /// Largest contact force and traction.
  std::pair<double, double> largest(const std::vector<LocalVector> &stress) const;
  bool balanced(const ContinuumVector &u, const ContinuumVector &left,
                const FoundationResponse &response, ContinuumNewtonResult &result) const;
  contact::Check check(const FoundationResponse &response) const;
  /// Add to the tractions and their tangents what the centre as an unknown makes of them, and to
  /// @p step what the centre moves by itself.
  void eliminate_centre(FoundationResponse &response, std::vector<LocalVector> &step) const;
  /// Solve with the contacts' tangents for the motion that @p left asks for.
  bool find_direction(const std::vector<LocalMatrix> &tangent, const double shift,
                      const ContinuumVector &left, ContinuumVector &direction);
  /**
   * Whether an iterate proves that there is no equilibrium: a motion without elastic forces that
   * presses on no contact, along which every contact gives its utmost resistance or none, and the
   * loads still do work. Where FreeBody has an answer, it decides.
   */
  bool slides_away(const ContinuumVector &u, FoundationResponse &response);
  /// The same of one motion, that of the forces left. @param holds_stuck whether sticking contacts
  /// take no part in it
  bool moves_away(const FoundationResponse &response, const bool holds_stuck);
  bool all(const bool here) const;

  const ContinuumBody<dim> &body;
  ContinuumSystem &system;
  FoundationContacts &contacts;
  const SolverSettings &settings;
  FreeBody<dim> free_body;
  contact::Attempts<ContinuumNewton, FoundationContacts> attempts;
  ContinuumVector diagonal;

  // of the increment
  const ContinuumVector *loads = nullptr;
  const FoundationState *committed = nullptr;
  LawIncrement increment;
  double largest_load = 0.;
  bool is_proof_sought = false; ///< whether `pushed_away` is known
  std::optional<bool> pushed_away;
  // of all increments so far
  double force_so_far = 0., traction_so_far = 0.; ///< largest of loads and contacts [N, Pa]
  // as last evaluated
  ContinuumVector elastic; ///< stiffness times u
  std::vector<LocalVector> displacement;
  double largest_displacement = 0.;
};

} // namespace frictionbeam
