// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/vibration/modal_analysis.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * What is made after the load sequence: modes, the response to spectra, combinations of cases.
 * All frames must have been built with both sides of each node.
 */

/// Frequencies, shapes (largest displacement 1), participation and effective masses.
void add_modes(const Model &model, const ModalAnalysis &analysis, Results &results);

/**
 * The response to the scene's spectra, all numbers >= 0:
 *   R_kd = |sum over groups| (Gamma_kdg S_g(f_k) / w_k^2) R(phi_k),
 * combined over modes k (of one frequency: as one, with their signs), then over directions d, as
 * Scene::response says. Gamma = phi^T M r with r the motion of the line at rest when the group
 * moves by a unit. The missing mass is the static response to M (r - sum phi_k Gamma_k) at the
 * spectrum's last acceleration, joined to the modes by the square root of the sum of squares.
 * Source: A. K. Chopra, Dynamics of Structures, chapter 13; CQC: A. Der Kiureghian, Earthquake
 * Engineering and Structural Dynamics 9 (1981) 419-435, doi:10.1002/eqe.4290090503. See
 * doc/theory.md, "Modes and spectra".
 */
Frame spectrum_response(const Model &model, const ModalAnalysis &analysis);

/// What a combination takes from a case: of a static step the same frame twice, of a transient step
/// the least and the largest value of each component over the step, of the spectrum, whose numbers
/// are sizes, these with either sign; so of combinations that give sizes.
struct CaseRange {
  const Frame *least, *largest;
};

/// Every number of a frame that can be combined, and a frame like this one with others.
Eigen::VectorXd numbers_of(const Frame &frame);
Frame with_numbers(Frame frame, const Eigen::VectorXd &numbers);

/// All numbers of a frame times -1.
Frame with_other_sign(const Frame &frame);

/// Make two frames the least and largest numbers of themselves and of a third one.
void widen(Frame &least, Frame &largest, const Frame &frame);

/// What a combination comes to, its cases at any of their instants: of each component the value of
/// larger size, with its sign. @p range, if given: the least and the largest.
Frame combine(const Combination &combination, const std::vector<CaseRange> &cases,
              CombinationRange *const range = nullptr);

} // namespace frictionbeam
