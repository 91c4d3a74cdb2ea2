// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "free_motion.h"
#include "increment_equations.h"
#include <frictionbeam/contact/attempts.h>

namespace frictionbeam::contact {

/**
 * Newton's methods for one increment of a condensed system on proximal contacts:
 * find x, the motion of the kept unknowns, with S x + H^T r = g and r = R(H x, centre).
 */
class Newton {
public:
  explicit Newton(IncrementEquations &equations)
      : equations(equations), settings(equations.settings), contacts(equations.contacts),
        S(equations.S), diagonal(equations.diagonal), proximal(equations.proximal) {}

  /// Other loads, which nothing is known of.
  void begin();

  /// Newton's method on the contacts around a fixed centre, with a line search.
  Outcome solve_proximal(Vector &x, Response &response, Result &result);

  /// One step of that, whose forces are then the centre. @return whether there is one
  bool approach(Vector &x, Response &response, Result &result);

  /**
   * Newton's method on motions and contact forces together, for the exact contact: the centre takes
   * part as an unknown. With r the forces, D the proximal tangent and C = D diag(by centre), the
   * linearised law is (I - C) dr = D H dx + R - r; C has the eigenvalue 1 where a rigid contact is
   * closed or sticks, so that I - (1 - epsilon) C takes its place, which is a stiffness of rho /
   * epsilon in the direction of Newton's step and leaves the solution alone. dr is eliminated
   * contact by contact. The line search is on the energy
   * (g - S x - H^T r)^2 / diag S + (R - r)^2 / (c k_d).
   * @param nothing_to_gain forces that x and the centre leave by rounding and are not worth a step
   * @param most_rise of that energy in a step: above 1, kinks are crossed that a step must else be
   * cut short for, and more iterations may cycle
   */
  Outcome solve_together(const unsigned int most_iterations, Vector &x, Response &response,
                         Result &result, const double nothing_to_gain = 0.,
                         const double most_rise = 1.);

  /// Whether solve_together() stalled at a solution of the contact laws because of rounding, which
  /// is too large beside the forces to be excused.
  bool rounding_bars() const { return is_barred; }
  void bar(const bool by_rounding) { is_barred = by_rounding; }
  std::string rounding_remark() const;

  /**
   * From here on a drag on all kept unknowns, this times diag S, holds what nothing else does; 0
   * takes it off. With a small one every problem has a solution.
   */
  void set_drag(const double factor);
  /// Whether the solution with drag proves that without it there is none: next to all of it strains
  /// nothing, every contact that resists it gives its utmost, and the loads do the work.
  bool drag_alone_holds(const Vector &x, const Response &response);

  /// Stresses of contacts that balance the loads on motions without strains, if there are.
  std::optional<std::vector<Strains>> balanced_forces() const;

  /// Of the kept unknowns, where an outcome is `slides_away`.
  const Vector &free_motion() const { return proof->motion; }
  /// Whether such an outcome is no proof: where loads and elasticity make the normal forces, those
  /// of an iterate are none of an equilibrium. The solution with drag decides.
  bool is_guess() const { return guesses; }
  /// It has decided otherwise: no more guesses of these loads.
  void refute() { may_guess = false; }

  void take_forces_as_centre(const Response &response) { proximal.centre = response.stress; }
  /// Whether no further attempt is worth its iterations.
  bool gives_up(const Result &result) const {
    return is_barred || result.iterations >= most_iterations;
  }
  double agreed(const double number) const { return number; } ///< of one process
  unsigned int most_iterations = 0;                           ///< of the present problem

private:
  /// A step of solve_proximal(); @p forces are those left. @return false if a pivot vanishes
  bool step_around_centre(Vector &x, Vector &forces, Response &response, Result &result);
  /// Add to the stresses and their tangents what the centre as an unknown makes of them, and to
  /// @p step what the centre moves by itself (doc/theory.md).
  void eliminate_centre(Response &response, std::vector<Strains> &step) const;
  /**
   * Whether an iterate proves that there is no equilibrium: a motion without elastic forces that
   * presses on no contact, along which every contact gives its utmost resistance or none, and the
   * loads still do work.
   */
  bool slides_away(const Vector &x, Response &response);
  /// Whether next to all of a motion of the kept unknowns is softer than 1e-13 of diag S: a soft
  /// line is not taken for a free body.
  bool strains_nothing(const Vector &x);
  /// Contacts only take off what loads do on a motion; where these do less than is left, a pose far
  /// off has rounding for its forces, or ground pushes what floats out of its way.
  bool loads_do(const double work, const Vector &motion) const;
  /// Whether all contacts give their utmost against a motion, which is kept as the proof or, if
  /// the response is not that of a solution, as a guess.
  bool is_resisted_in_vain(const Vector &motion, const Response &response, const bool is_solution);

  IncrementEquations &equations;
  const Settings &settings;
  const SiteList &contacts;
  const SparseMatrix &S;
  const Vector &diagonal;
  ProximalSites &proximal;

  // of the increment
  bool is_barred = false;
  std::optional<FreeMotionProof> proof; ///< for these loads, once they have been looked at
  bool guesses = false, may_guess = true;
};

} // namespace frictionbeam::contact
