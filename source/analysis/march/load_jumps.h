// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/time/time_integrator.h"

namespace frictionbeam {

/**
 * Make @p state, at the end of a step or time step, fit to begin the next one where a load jumps:
 * its load rates are those before, empty if nothing is known of them. The factors are then those
 * after the jump, the integrator begins with the accelerations that belong to them, and where nodes
 * that loads move change their velocity by dv, the others do so by -M_uu^-1 M_ub dv, the impulse of
 * their inertia (doc/dynamics.md, "Corners and jumps").
 * @return what that impulse does to the account of energy
 */
EnergyAccount meet_jump(const Model &model, const LoadCourse &course, TimeIntegrator &integrator,
                        LineState &state);

/// Loads that clearly change the velocity of nodes with mass at an instant, from @p start on
/// and before @p end of a transient step. @param before rates at its start; empty: nothing is known
std::vector<unsigned int> loads_with_velocity_jumps(const Model &model, const LoadCourse &course,
                                                    std::vector<double> before, const double start,
                                                    const double end);

/**
 * A remark on each load whose imposed motion of points with mass jumps from @p start on and before
 * @p end of a transient step, with its largest jump; empty if none does.
 * @param before the loads' factors at its start, on the way there
 */
std::string jumps_of_motions(const Model &model, const LoadCourse &course,
                             const LoadCourse::Factors &before, const double start,
                             const double end, const std::string &step);

/**
 * What forbids that the factors of loads jump by @p jumps: a motion that one of them imposes on an
 * end of a dashpot, or of what is damped, whose force there would do infinite work.
 * @return a remark that names the load; empty if nothing forbids it
 */
std::string forbidden_by_damping(const Model &model, const LoadCourse::Factors &jumps);

/**
 * What forbids a time step from @p state to @p time: an imposed motion or ground that jumps into a
 * rigid contact, for which no finite force is an answer, or what damping forbids.
 * @return a remark that names the support; empty if nothing forbids it
 */
std::string forbidden_jump(const Model &model, const LoadCourse &course, const LineState &state,
                           const double time);

} // namespace frictionbeam
