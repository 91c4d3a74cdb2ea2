// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/exact_method.h"

#include "analysis/time/time_integrator.h"

#include <limits>

namespace frictionbeam {

/**
 * Rigid contact and friction in a time step, as impulses on velocities, by the solver of static
 * contact (ExactMethod).
 *
 * A step whose displacements and velocities at its end hang together by q = base + reach v is a
 * static problem A q = b + H^T r in the displacements. What is rigid in a contact that takes part
 * (it was closed, or its gap, with half a step's motion, is) obeys Newton's law of impact and
 * Coulomb's law of friction on v at the end of the step, with a velocity of the ground there that
 * takes contacts along by the ground's own motion:
 *   0 <= u_N + e u_N(before) perp P_N >= 0,   |P_T| <= f P_N,  against u_T,
 * which is the law of a static contact with another gap and another position of its slip. Elements
 * of finite stiffness, normal forces of platens and contacts of nodes without mass keep their laws
 * on displacements. P is the
 * impulse, share times the step times r. Slip that reverses has come to rest within the step: it
 * goes on only beyond static friction.
 */
class ImpulseContacts {
public:
  explicit ImpulseContacts(const Model &model);

  /// The matrix A of the following steps.
  void set_matrix(const SparseMatrix &matrix);

  struct Relation {
    Vector base;         ///< of the unknowns
    double reach = 0.;   ///< [s]
    double share = 0.;   ///< of r that acts on average over the step
    double at_end = 0.5; ///< weight of the velocity at the end in the mean one over the step
  };
  /**
   * Solve. @param problem with matrix, right hand side, imposed motions, times
   * @param unknowns in: a first guess
   */
  EquilibriumResult solve(EquilibriumProblem &problem, const LineState &from,
                          const LoadCourse &loads, const Relation &relation, Vector &unknowns,
                          ContactResponse &response);

  /// What the solver keeps, and the last step; the matrix must have been set before reading.
  void transfer(Archive &archive) {
    if (solver)
      solver->transfer(archive);
    archive(step_begin, step_end, ground_rate, ground_rate_before);
  }

  /// Impulses of the rigid parts, H^T P, on the unknowns, of the last solution.
  Vector impulses() const;
  /// Take forces of the elastic parts at a state (the line's side of the equation of motion), times
  /// @p factor, from forces on the unknowns.
  void take_elastic_forces(const LineState &state, const double factor, Vector &forces) const;
  /// Forces of the rigid parts on the unknowns, likewise.
  Vector rigid_forces(const LineState &state) const;
  /// Mean forces of the last step, for the energy account.
  const std::vector<ContactWork> &work() const { return contact_work; }
  /// What their account leaves out: an impulse P takes P . (u0 + u1)/2, u the velocities before and
  /// after, whatever the scheme makes of the motion in between. Known after add_histories().
  const EnergyAccount &work_beyond_motion() const { return of_impulses; }
  /// Add the energy, wear and impulse of the step to the contacts' histories.
  void add_histories(const LineState &from, const double step, LineState &to);

private:
  struct Kind {
    bool is_exact = false, rigid_normal = false, rigid_shear = false;
    FrictionThreshold law{};
  };
  /// Rates of the contacts' strains by the motion g that is imposed, at the end of a step: with
  /// at_end, a, of the relation,
  ///   g1* = (g1 - g0)/h + (1 - a) (g1' - g0'),
  /// so that the mean a g1* + (1 - a) g0* of two steps is, but for O(h^2) that does not add up,
  /// what the ground moves by. (g1' itself would let a contact that stays closed creep away from
  /// it.) And before the step: of the one that ends where this one begins; after a jump, g0'.
  void set_ground_rates(const EquilibriumProblem &problem, const LineState &from,
                        const LoadCourse &loads, const double at_end);
  /// The laws of this step on displacements: gap -(H base)_N + reach e u_N^- and slip from
  /// (H base)_T, both with the ground's motion, of what is rigid and takes part (doc/dynamics.md,
  /// "Rigid contact on velocities").
  void set_laws(const EquilibriumProblem &problem, const LineState &from, const Relation &relation);
  /// Impulses and mean stresses over the step from the stresses r of a solution, which the means
  /// then replace. @param share of r that acts on average over the step
  void take_impulses(const LineState &from, const double share, const double step,
                     ContactResponse &response);
  /// Find what h (u0 + u1)/2 is beyond the motion of the step.
  void take_mean_velocities(const LineState &from, const double step, const LineState &to);
  /// Have contacts that slip against the direction of the step before, which have been at rest in
  /// between, overcome static friction first. @return whether there are any that did not
  bool test_reversals(const LineState &from, const Vector &imposed, const Vector &unknowns);
  /// Part of the stress that comes from rigid or from elastic parts.
  Contact::Strains part(const unsigned int i, const Contact::Strains &stress,
                        const bool rigid) const;

  const Model &model;
  std::vector<Kind> kinds;
  std::unique_ptr<ExactMethod> solver;
  double step_begin = std::numeric_limits<double>::quiet_NaN(), step_end = step_begin;
  std::vector<Contact::Strains> ground_rate, ground_rate_before;
  contact::Overrides overrides;
  ContactState shifted;
  std::vector<Contact::Strains> rigid_impulse; ///< of each contact, of the last solution
  std::vector<ContactWork> contact_work;
  bool motion_is_mean = true;           ///< of the last step: that by the mean of both velocities
  std::vector<Contact::Strains> beyond; ///< it, of h (u0 + u1)/2
  EnergyAccount of_impulses;            ///< their work there
};

} // namespace frictionbeam
