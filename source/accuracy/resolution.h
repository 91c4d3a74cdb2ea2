// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::accuracy {

/**
 * The time step of the coarsest level [s]: a 64th of the shortest transient step, or so short that
 * straight lines between the ends of steps follow every history and motion of the ground to a tenth
 * of its range, so that no pulse is left out. Histories are looked at in 16,384 points of a step;
 * steps end at the corners of tables in any case.
 */
double longest_time_step(const Scene &scene);

/**
 * A contact that, between two instants, may have changed its state without being seen: one that has
 * kept it in two answers, the finer of which came nearer to the change than the two are apart.
 * @return what nearly happened, in plain words; empty if there is none
 */
std::string nearly_missed(const Results &coarse, const Results &fine);

/**
 * What of an answer depends on how it is cut into increments, and no difference from coarser ones
 * shows: slip of contacts, or flow of pipes, in no more than one increment of a step, in which it
 * was in coarser ones, too. Slip relative to the largest displacement, what has flowed to the
 * turnover of energy.
 */
double hidden_in_one_increment(const Scene &scene, const Results &results);

/// Likewise of cells: infinite where a pipe is solved as elastic that yields between their
/// sections.
double unseen_between_sections(const Scene &scene, const Results &results);

} // namespace frictionbeam::accuracy
