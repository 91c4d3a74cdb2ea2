// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Largest value of a pipe's sections, and where.
struct WorstSection {
  double value = 0.;
  double s = 0.;    ///< along the pipe [m]
  std::string step; ///< in which it grew most; of a utilization, at whose end it was met
};

/// How far a pipe yielded and crept.
struct PipeYield {
  unsigned int pipe = 0;
  WorstSection plastic, creep, utilization;
  double dissipated = 0.;    ///< to the end of the run, or where most has flowed [J]
  unsigned int n_hinges = 0; ///< then
};

/// A stretch of pipe whose sections are hinges, one beside the other.
struct Hinge {
  double from = 0., to = 0.; ///< along the pipe [m]
  SectionState worst;
  std::string since;  ///< the step at whose end it was one first
  bool flows = false; ///< in the last step
};

/// Ends of steps of which sections are known.
std::vector<const Frame *> frames_of_sections(const Results &results);

/// Name of a frame that is of no one step.
inline constexpr char over_all_steps[] = "all steps";

/// Of these, each section where it has flowed most by, the last such: the end of the run, unless
/// steps went back to others.
Frame most_flowed(const std::vector<const Frame *> &frames);

/// Pipes that could yield or creep, at the ends of steps.
std::vector<PipeYield> yield_of_pipes(const Results &results);

/// Where most has flowed among these frames of sections, in the order of the pipes.
std::vector<Hinge> hinges_of(const std::vector<const Frame *> &frames);

} // namespace frictionbeam
