// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/linearized_solver.h"
#include "analysis/time/impulse_contacts.h"

namespace frictionbeam {

/**
 * The midpoint rule for any cells, conserving momentum:
 *   M (v1 - v0) = h F - a h M (v0 + v1)/2 + P,   x1 - x0 = h (v0 + v1)/2,
 * with the forces F on the pose halfway made from the mean of the cells' forces at both ends (J. C.
 * Simo, N. Tarnow, M. Doblare, IJNME 38 (1995) 1431-1473, doi:10.1002/nme.1620380903). F has no
 * resultant, so that linear and angular momentum are exact, and its work is the change of the
 * stored energy and what viscous forces take. a is Mass damping. Motions that loads impose have the
 * velocities of their histories, with which their masses go into M (v1 - v0). Of linear cells this
 * is moreau_jean with theta = 1/2, and the contacts are that method's.
 *
 * A step is solved by Newton's method with the contacts solved on the linearized line
 * (doc/dynamics.md, "Large displacements").
 */
class NonlinearMotion final : public TimeIntegrator {
public:
  explicit NonlinearMotion(const Model &model);

  std::string name() const override;
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &) override {} // every step begins anew

private:
  /// A step on its way to its solution.
  struct Step {
    Pose from, half, to;
    Vector moved;                ///< unknowns, turns as Cayley vectors
    Vector change;               ///< the same of all degrees of freedom
    Vector imposed;              ///< change that is imposed
    std::vector<double> factors; ///< mean ones of the loads
    std::vector<double> factors_at_end;
    Vector velocity;           ///< of all degrees of freedom, at the start
    Vector imposed_velocity;   ///< mean of the imposed ones
    Vector imposed_impulse;    ///< what these take from the unknowns
    double start = 0., h = 0.; ///< [s]
    LineCells::Balance balance;
    bool is_answered = false; ///< whether it has been asked within this step
    Vector residual;          ///< but for the contacts at the end
    SparseMatrix matrix;      ///< less its derivative by `moved`
    double stiffness = 0.;    ///< largest on the diagonal of that which was factored last [N/m]
    double largest = 0.;      ///< force [N]
    double momentum = 0.;     ///< at its beginning, over half the step [N]

    /// What goes without forces [N], in free flight or along free strains.
    double without_force() const { return std::max(momentum, 2. * balance.free); }
  };
  enum class Matrix { none, tangent };
  /// @param matrix none: that of the step stays as it is
  void evaluate(const LineState &state, const Matrix matrix, Step &step) const;
  /// What the last digit of the places makes of the residual, or of the largest force [N].
  double digits_of(const Step &step) const;
  /// What rounding of the pose at its end makes of the residual.
  double rounding_of(const Step &step) const;
  EquilibriumResult solve_linearized(const LineState &state, const LoadCourse &loads,
                                     const double time, Step &step, Vector &change,
                                     ContactResponse &response);
  /// The residual with the forces and impulses of the contacts.
  Vector unbalanced(const Step &step, const ContactResponse &response) const;
  /// Whether that, @p left, counts as zero; its size goes into the result.
  bool is_solved(const Step &step, const Vector &left, const ContactResponse &response,
                 EquilibriumResult &result) const;
  /// Go a part of the change of a line that yields if its whole goes too far (search_slope()).
  /// @return whether by all of it
  bool search(const LineState &state, Step &step, const Vector &change,
              const ContactResponse &response) const;
  EquilibriumResult solve(const LineState &state, const LoadCourse &loads, const double time,
                          Step &step, ContactResponse &response);
  /// What the step is given: motions and loads from @p from to the time of @p
  /// to, whose rates are set.
  Step begin(const LineState &from, const LoadCourse &loads, const LineState &to) const;
  /// The step's account but for the contacts.
  void account(const Step &step, const Vector &velocity_after, EnergyAccount &account) const;
  void finish(const LineState &state, Step &step, ContactResponse &response, LineState &to,
              TimeStep &report);

  const Model &model;
  const std::vector<bool> has_mass;
  const bool is_smooth; ///< neither contacts nor sections that yield
  ImpulseContacts contacts;
  LinearizedSolver linearized;
  std::vector<Vector> inertia; ///< LineCells::inertia() of each load that has any
  /// After how many iterations the last step had to have other factors; 0: not at all.
  unsigned int factored_again = 0;
};

} // namespace frictionbeam
