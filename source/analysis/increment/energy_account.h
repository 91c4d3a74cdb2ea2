// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"

namespace frictionbeam {

/**
 * Where the work of the loads went, each term by the trapezoid: the mean of a force before and
 * after times the motion. In statics, with both ends in equilibrium, the terms balance to rounding,
 * so that what is left over measures the solution and not the size of the increment. In dynamics
 * what is left over is what the integrator itself loses (or gains, if it is negative).
 */
struct EnergyAccount {
  double external = 0.; ///< work of loads (thermal ones included) and of imposed motions [J]
  double stored = 0.;   ///< in the line, its springs and the elastic part of friction elements [J]
  double dissipated = 0.; ///< by friction [J]
  double inelastic = 0.;  ///< dissipated by pipes that yield or creep [J]
  double gaps = 0.;    ///< of normal forces along gaps that open or close within an increment [J]
  double kinetic = 0.; ///< of the motion [J]
  double damping = 0.; ///< lost in viscous damping [J]
  double impact = 0.;  ///< lost in impacts on rigid contacts [J]
  /// Friction work that the trapezoid misses, 1/2 dT . dslip, as sizes: a measure of the
  /// increments.
  double missed_friction = 0.; ///< [J]
  double turnover = 0.;        ///< sum of the sizes of all terms [J]
  double at_hand = 0.; ///< dynamics: largest kinetic and stored energy of the line at one time [J]
  double least_scale = 0.; ///< what imbalance() is relative to at least: rounding of it all [J]

  /// Work that went nowhere: external less all the others [J].
  double left_over() const;
  /// What a time step came by of itself: less is left over than impacts and gaps account for.
  double gained() const { return -(left_over() + impact + gaps); }
  /// |left_over| / turnover, in dynamics / at_hand.
  double imbalance() const;
  EnergyAccount &operator+=(const EnergyAccount &other);
};

/**
 * Account of one increment.
 * @param loads forces on the unknowns before and after
 */
EnergyAccount account_increment(const Model &model, const LineState &before, const LineState &after,
                                const Vector &loads_before, const Vector &loads_after);

/**
 * Account of any cells from one state to the next, without contacts: forces at both ends in the
 * mean.
 * @param factors_before of the loads, after any jump
 * @param imposed change of motions of all degrees of freedom that loads impose
 */
EnergyAccount account_cells(const Model &model, const LineState &before, const LineState &after,
                            const std::vector<double> &factors_before, const Vector &imposed);

/**
 * Work of friction in a static increment [J], from the internal variables and forces at its ends:
 * that where slip begins and that at its end, in the mean. A contact that slips throughout, opens
 * or closes has the trapezoid of its account; one that sticks first slips at the limit only, which
 * the trapezoid misses. For laws with a closed form.
 */
double friction_work(const Contact &contact, unsigned int i, const LineState &before,
                     const LineState &after);

/// What one increment did to the contacts: the mean force over it.
struct ContactWork {
  Contact::Strains mean_stress;
  /// Rigidities of the elastic part [N, N, N, N m2]; infinity: rigid.
  Contact::Strains rigidity;
};

/// K q and M v at both ends of a time step.
struct MotionProducts {
  const Vector &stiff_before, &stiff_after, &momentum_before, &momentum_after;
};

/**
 * Account of a time step.
 * @param work of contacts solved with impulses; contacts beyond its end, or all if it is empty, are
 * taken by the trapezoid of the stresses at both ends.
 */
EnergyAccount account_motion(const Model &model, const LineState &before, const LineState &after,
                             const MotionProducts &products, const Vector &loads_before,
                             const Vector &loads_after, const std::vector<ContactWork> &work);

/**
 * What motions that loads impose add to the share of the unknowns: the mixed and quadratic terms of
 * the energies and of damping, and as work the same and what inertia takes.
 * @param h time from before to after; of no meaning in statics
 */
EnergyAccount account_imposed(const Model &model, const LineState &before, const LineState &after,
                              const double h);

/// The contacts' share of either.
EnergyAccount account_contacts(const Model &model, const LineState &before, const LineState &after,
                               const std::vector<ContactWork> &work);

} // namespace frictionbeam
