// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"
#include "model/line_pose.h"
#include "model/model.h"
#include <frictionbeam/contact/condensation.h>
#include <frictionbeam/contact/line_factorization.h>

#include <functional>
#include <memory>
#include <optional>

namespace frictionbeam {

/// Symmetric part of a matrix of symmetric pattern.
SparseMatrix symmetric_part(const SparseMatrix &matrix);

/**
 * Solves for the change x of a line whose stiffness is linearized at a pose: matrix x + forces of
 * the contacts at the pose's displacements plus x = right hand side. Contacts by the method of
 * Solver/Method, which then takes the symmetric part of the matrix; without contacts, and where all
 * are open and nothing leads, by the matrix itself.
 */
class LinearizedSolver {
public:
  explicit LinearizedSolver(const Model &model) : model(model) {}

  /// Make the contacts' method for a matrix that comes again and again, and keep it: that of an
  /// elastic line, with which increments begin.
  void keep(const SparseMatrix &matrix);
  /// What the method that is kept remembers.
  void transfer(Archive &archive);

  EquilibriumResult solve(EquilibriumProblem &problem, const ContactState &committed,
                          Vector &change, ContactResponse &response);
  /// An unknown whose change is given, in place of the size of the loads: by a spring of any
  /// stiffness, without which the matrix may be singular or not definite, and which is left without
  /// force.
  struct Lead {
    int unknown;
    double change, whole;   ///< of the unknown: now, and in all iterations
    double stiffness;       ///< of the spring
    const Vector &forces;   ///< on the unknowns, of one more of the loads
    double loads_by_change; ///< as expected
    bool by_work = false;   ///< changes are those of f . x, not of the unknown; without contacts
    double more = 0.;       ///< of the loads, what it takes
  };
  /**
   * Solves for the change x and the size m of further loads f: matrix x + forces of the contacts =
   * right hand side + m f, with x of the lead's unknown given. One matrix, with the spring, serves
   * all sizes: without contacts x is linear in m, and two solutions are enough (J. L. Batoz, G.
   * Dhatt, IJNME 14 (1979) 1262-1267, doi:10.1002/nme.1620140811); with contacts it is so piece by
   * piece, and the root is found by secants.
   *
   * Led by the work f . x, pipes that yield make a convex potential least under a linear condition,
   * whose multiplier m is: it has a solution up to collapse and beyond.
   */
  EquilibriumResult solve_led(EquilibriumProblem &problem, Lead &lead,
                              const ContactState &committed, Vector &change,
                              ContactResponse &response);
  /// The matrix's own solution; false if it is singular.
  bool solve_without_contacts(const SparseMatrix &matrix, const Vector &right_hand_side,
                              Vector &change);
  /// The same with the factors of the last matrix.
  Vector solve_again(const Vector &right_hand_side) const {
    return factorization.solve(right_hand_side);
  }

private:
  /// Of the lead's unknown on a line with contacts, by a method made for the matrix with the
  /// spring: how much further it goes than it is to, under loads of a size.
  using Overshoot = std::function<std::optional<double>(const double more)>;
  /// The size where that is below @p allowed; nothing where none is found.
  static std::optional<double> find_load(const Overshoot &overshoot, const Lead &lead,
                                         const double allowed);
  /// Of factors of the matrix with the spring. @return false where there is no solution
  bool solve_by_work(Lead &lead, const Vector &of_loads, Vector &change) const;
  EquilibriumResult solve_led_freely(const SparseMatrix &matrix, const Vector &right_hand_side,
                                     Lead &lead, Vector &change);

  /// Where all contacts are open, by the matrix itself; nothing is changed where one then would not
  /// be, or it is singular.
  void correct_freely(const EquilibriumProblem &problem, const ContactState &committed,
                      Vector &change, ContactResponse &response);

  /// For a matrix, with all that it has factored and remembers.
  struct Method {
    SparseMatrix matrix, symmetric;
    std::unique_ptr<EquilibriumSolver> solver;
  };

  const Model &model;
  contact::LineFactorization factorization;
  bool analyzed = false;
  std::optional<Method> kept;
  std::shared_ptr<contact::PartMemory> parts = contact::make_part_memory();
};

/// One more iteration of Newton's method around the contacts, unless @p most have been made: solves
/// the line linearized at its pose and adds to @p result what that took.
/// @return whether it was solved; if not, the result's remark says why
bool iterate(const unsigned int most, const std::function<EquilibriumResult()> &solve_linearized,
             EquilibriumResult &result);

/// A pose whose motions have other last digits: what rounding makes of them. Turns have the digits
/// of 1. Cells take their lengths from displacements, which keep their digits.
/// @param of_places whether displacements have those of places, as on the way of a time step
Pose with_other_digits(const Model &model, const Pose &pose, const bool of_places);

/// Largest entry of a diagonal by size; 0 where all is held.
double largest_diagonal(const SparseMatrix &matrix);

/// Whether residual forces of a pose count as zero: below the tolerance times the largest force,
/// below the rounding error of the stiffness times the motion, up to 1e-8 of the largest force, or
/// below what rounding of the pose makes of the line's forces.
/// @param stiffness largest_diagonal() of the line's
/// @param measure of that; asked if nothing else excuses the residual
/// @param scale [N] of what goes without forces: free strains that the line follows, the momentum
/// in free flight. What rounding may excuse is a part of it where it is larger than all forces
bool is_balanced(const Model &model, const double stiffness, const double size,
                 const double largest, const Pose &pose, const std::function<double()> &measure,
                 const double scale);

/// Largest force of the contacts on the line.
double largest_contact_force(const Contacts &contacts, const ContactResponse &response);

/// Take over rotations of all degrees of freedom among the unknowns.
void set_rotations(const Model &model, const Vector &dofs, Vector &unknowns);

/// Take over a pose: displacements, turns, and rotations among the unknowns.
void set_pose(const Model &model, const Pose &pose, LineState &state);

} // namespace frictionbeam
