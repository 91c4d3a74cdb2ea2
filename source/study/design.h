// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/variables.h"

namespace frictionbeam::study {

/// The runs of a study, as points of the unit cube of its variables' probabilities.
/// @throws UserError if there are more than can be run
Points make_design(const StudySettings &settings, const Variables &variables,
                   const Sampling &sampling);

/// A change of one variable on a way of Morris' design.
struct MorrisStep {
  std::size_t before, after; ///< runs
  std::size_t variable;
};

/// How far each variable goes in Morris' design: between the ends of its grid.
std::vector<double> morris_ranges(const Variables &variables);

/// All of them, of a design that make_design() has made.
std::vector<MorrisStep> morris_steps(const Points &design);

} // namespace frictionbeam::study
