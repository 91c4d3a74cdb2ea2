// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Every support and restraint with its largest force over all steps and judged cases and the step
/// of it, the largest first, as HTML.
std::string restraint_summary(const Results &results);

/// Displacements and rotations of the named points on pipes, a tab for each of at most six frames.
std::string displacement_tables(const Results &results, const std::vector<const Frame *> &frames);

/// Largest force of each support over all steps and judged cases [N]; they come in the order of
/// Results::supports, then Results::restraints.
std::vector<double> largest_forces(const Results &results);

/// Add a run to a study over multipliers of friction: its largest_forces(), and how much nozzles
/// and stresses use of what is allowed.
void include_in_study(const double multiplier, const Results &run, FrictionStudy &study);

/// The tables of such a study, as HTML.
std::string friction_study_section(const Results &results);

/// Write friction_study.csv and friction_study_ratios.csv, if there is one.
void write_friction_study(const Results &results, const std::string &folder);

} // namespace frictionbeam
