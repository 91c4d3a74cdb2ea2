// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * What the model that one can turn (model.js) is drawn from, as compact JSON: the pipes as stations
 * along them, supports and restraints with kind and direction, and for each step, instant and mode
 * the displacements, section forces, stresses and states of supports.
 *
 * Numbers at stations are differences from one station to the next in steps of 1/20000 of the
 * largest, SI units; those of supports, restraints and points have seven digits (instants of
 * transient steps five) in the units of the csv files. A long line is thinned to some 4000
 * stations, each with the largest value of those that it stands for; `left_out` says so.
 *
 * @param frames that the page shows: ends of steps, and cases
 * @param scale of displacements, to begin with
 */
std::string model_data(const Scene &scene, const Results &results,
                       const std::vector<const Frame *> &frames, const double scale);

} // namespace frictionbeam
