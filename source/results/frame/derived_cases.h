// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/vibration/modal_analysis.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * What is made after the load sequence: modes and combinations of cases. All frames must have been
 * built with both sides of each node.
 */

/// Frequencies, shapes (largest displacement 1), participation and effective masses.
void add_modes(const Model &model, const ModalAnalysis &analysis, Results &results);

/// What a combination takes from a case: of a static step the same frame twice, of a transient step
/// the least and the largest value of each component over the step, of the spectrum, whose numbers
/// are sizes, these with either sign; so of combinations that give sizes.
struct CaseRange {
  const Frame *least, *largest;
};

/// Every number of a frame that can be combined, and a frame like this one with others.
Eigen::VectorXd numbers_of(const Frame &frame);
Frame with_numbers(Frame frame, const Eigen::VectorXd &numbers);

/// Takes from a frame what is a state's alone. @param is_amplitude as Frame::is_amplitude
void become_case(Frame &frame, const bool is_amplitude);

/// All numbers of a frame times -1.
Frame with_other_sign(const Frame &frame);

/// Make two frames the least and largest numbers of themselves and of a third one.
void widen(Frame &least, Frame &largest, const Frame &frame);

/// Between which each number of a case may be, its factor included.
struct NumberBounds {
  Eigen::VectorXd least, largest;
};
std::vector<NumberBounds> bounds_of(const Combination &combination,
                                    const std::vector<CaseRange> &cases);

/// What a combination comes to, its cases at any of their instants: of each component the value of
/// larger size, with its sign; of a maximum the largest, of a minimum the smallest. @p range, if
/// given: the least and the largest.
Frame combine(const Combination &combination, const std::vector<CaseRange> &cases,
              CombinationRange *const range = nullptr);

} // namespace frictionbeam
