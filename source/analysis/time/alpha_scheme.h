// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/linearized_solver.h"
#include "analysis/time/impulse_contacts.h"
#include "analysis/time/motion_products.h"

#include <frictionbeam/contact/line_factorization.h>

#include <limits>

namespace frictionbeam {

/**
 * The generalized-alpha family in the form of Arnold and Bruels (Multibody Syst. Dyn. 18 (2007)
 * 185-202): the equation of motion holds at the end of the step with the acceleration A, and
 *   (1 - alpha_m) a1 + alpha_m a0 = (1 - alpha_f) A1 + alpha_f A0,
 *   q1 = q0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),   v1 = v0 + h ((1 - gamma) a0 + gamma a1).
 * Newmark's method is alpha_m = alpha_f = 0, a = A.
 *
 * With `impulses`, rigid contacts act by impulses P outside of the accelerations (Bruels, Acary,
 * Cardona, CMAME 281 (2014) 131-161): M w = P, v1 gains w and q1 gains h (beta/gamma) w. (There it
 * is h/2, the same without numerical damping; with beta/gamma, q1 and v1 hang together as without
 * impact, and the step is one static contact problem.) With numerical damping (beta/gamma is not
 * 1/2) what presses on a support all the time would creep by that difference. So q1 gains
 *   h^2 (1/2 - beta/gamma) M^-1 d0 as well,   gamma d1 + (1 - gamma) d0 = P/h,
 * d the share of the contact forces in the accelerations, as if they had been in the equation of
 * motion. Without `impulses`, all contacts are friction elements of finite stiffness with their
 * return mapping. Either way elements of finite stiffness are followed to second order. All of it
 * stands in doc/dynamics.md, "The alpha schemes" and "Rigid contact on velocities".
 *
 * Of a line whose sections yield or creep or whose points turn by any angle, the cells' forces at
 * the end of the step stand in place of K q, and Newton's method solves the step
 * (alpha_nonlinear.cc). Rotations are then those of O. Bruels and A. Cardona (J. Comput. Nonlinear
 * Dyn. 5 (2010) 031002, doi:10.1115/1.4001370), in global axes: q1 - q0 of the formula above is the
 * rotation vector of the step, v the spin, A its derivative, and J A + w x J w stands for M A.
 */
class AlphaScheme final : public TimeIntegrator {
public:
  struct Parameters {
    double alpha_m = 0., alpha_f = 0., beta = 0.25, gamma = 0.5;
    bool impulses = false;
  };
  /// Rigid contacts act by impulses if Solver/Method is exact, as in statics.
  static Parameters newmark(const Scene &scene);
  /// Of Chung and Hulbert, by the spectral radius (J. Appl. Mech. 60 (1993) 371-375); of the rigid
  /// contacts as newmark.
  static Parameters generalized_alpha(const Scene &scene);
  static Parameters nonsmooth(const Scene &scene);

  AlphaScheme(const Model &model, const Parameters &parameters);

  std::string name() const override;
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &archive) override;
  std::string warning() const override;

private:
  /// A step on its way to its solution.
  struct Step {
    double h = 0.;                ///< its length [s]
    Vector motion, velocity;      ///< q1 and v1 but for a1
    Vector rest;                  ///< A1 but for ratio a1
    LoadCourse::Factors factors;  ///< of the loads at its end
    Vector forces_before, forces; ///< of loads, at its start and its end
    Vector stiff_before, momentum_before;
    Vector moved; ///< a1, with impulses that of the motion which they are part of

    // Of a nonlinear line:
    Vector begin;               ///< q0; of a line that turns without rotations, which begin at zero
    Vector imposed;             ///< motions of all degrees of freedom since its start
    Pose start, pose;           ///< at its start, and where it is
    LineCells::Balance balance; ///< there
    bool is_answered = false;   ///< whether it has been asked within this step
    Vector residual;            ///< but for the contacts
    SparseMatrix matrix;        ///< less its derivative
    double largest = 0.;        ///< force [N]
  };

  /// What a line whose points turn has beside another.
  void prepare_turning();
  void set_step(const double step);
  Vector contact_forces(const LineState &state) const;
  const SparseMatrix &mass_matrix() const;
  const SparseMatrix &damping() const { return turns ? mass_damping : model.linear.damping(); }
  /// Of motions that loads impose, and what Rayleigh's damping makes of them.
  void add_inertia(const LoadCourse &loads, const double time, const LoadCourse::Side side,
                   Vector &forces) const;
  /// M^-1 f, with nothing where there is no mass.
  Vector accelerations(Vector forces, const Pose &pose);
  /// Rates of rotations without inertia: the mean over the step, or nothing.
  void keep_inert(const Pose &pose, const Vector &mean, Vector &rates) const;
  Step begin(const LineState &from, const LoadCourse &loads, const double time);
  /// What residuals of the step are measured by [N].
  double size_of(const Step &step, const LineState &from) const;
  /// What the equation of motion leaves at the end of the step but for the contacts' forces.
  /// @param low what rounding took from the unknowns; may be empty
  Vector unbalanced(Step &step, const Vector &unknowns, const Vector &low);
  /// Find the motion and the contacts' forces at the end of the step.
  EquilibriumResult solve(EquilibriumProblem &problem, const Step &step, const LineState &from,
                          const LoadCourse &loads, LineState &to, ContactResponse &response);
  /// Of a nonlinear line: what its cells, their loads and its turning leave at a state, elastically
  /// from there.
  Vector forces_at(const LineState &state, const LoadCourse::Factors &factors) const;
  void evaluate(const LoadCourse &loads, const Vector &unknowns, const double time,
                Step &step) const;
  /// Solve for the change that the linearized line takes with its contacts.
  EquilibriumResult solve_linearized(const Step &step, const LineState &from,
                                     const LoadCourse &loads, const double time,
                                     const Vector &unknowns, Vector &change,
                                     ContactResponse &response);
  /// The residual with the forces and impulses of the contacts.
  Vector left_over(const Step &step, const ContactResponse &response) const;
  bool is_solved(const Step &step, const double time_of_laws, const ContactResponse &response,
                 EquilibriumResult &result) const;
  /// Add a change whose rotations are spins of the pose to the unknowns.
  void add_change(const Vector &change, const Step &step, Vector &unknowns) const;
  EquilibriumResult solve_nonlinear(Step &step, const LineState &from, const LoadCourse &loads,
                                    const double time, LineState &to, ContactResponse &response);
  EnergyAccount account_nonlinear(const Step &step, const LineState &from, const LoadCourse &loads,
                                  const LineState &to) const;
  EnergyAccount account_turning(const Step &step, const LineState &from, const LoadCourse &loads,
                                const LineState &to) const;
  /// Velocities and accelerations at the end of the step.
  void finish_motion(const Step &step, LineState &to);

  const Model &model;
  const Parameters p;
  const double ratio;         ///< (1 - alpha_m)/(1 - alpha_f)
  const bool turns;           ///< whether points turn by any angle
  std::vector<bool> has_mass; ///< or is a rotation of a line that turns (keep_inert())
  std::unique_ptr<EquilibriumSolver> return_mapping; ///< null with impulses
  ImpulseContacts contacts;
  LinearizedSolver linearized; ///< of nonlinear lines, without impulses
  contact::LineFactorization mass;
  SparseMatrix mass_damping;           ///< of a line that turns, but for its rotations
  std::vector<Vector> imposed_inertia; ///< of such a line: LineCells::inertia() by load, or empty
  SparseMatrix effective;              ///< K + gamma/(beta h) C + ratio/(beta h^2) M
  Vector diagonal;                     ///< of it
  double effective_step = 0.;
  /// What a state has besides, with impulses.
  struct Parts {
    double time = std::numeric_limits<double>::quiet_NaN(); ///< of the state
    Vector free;        ///< A without the rigid contacts' forces
    Vector by_contacts; ///< M^-1 P/h of the step that ended there
    Vector lasting;     ///< M^-1 d
    void transfer(Archive &archive) { archive(time, free, by_contacts, lasting); }
  };
  Parts at_start, at_end;          ///< of the last step
  KeptProduct stiff, momentum;     ///< K q and M v
  const Vector stiffness_diagonal; ///< of K
};

} // namespace frictionbeam
