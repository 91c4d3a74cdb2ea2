// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// @file
/// Principal and equivalent stresses of walls (wall_stress.h) at the ends of steps, of pipes that
/// answer elastically and have a wall. Not of cases that are made of others, whose forces need not
/// belong to one instant.

/// The worst place of each step, as HTML; empty if there is none.
std::string wall_stress_section(const Scene &scene, const Results &results);

/// Write wall_stresses.csv, every station of every step, in the units of the results; none if there
/// are no such pipes, and of very long lines, which a remark says then, where the scene has neither
/// a stress code nor a quantity of a wall's stress.
void write_wall_stresses(const Scene &scene, Results &results, const std::string &folder);

} // namespace frictionbeam
