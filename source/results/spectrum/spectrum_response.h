// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/vibration/modal_analysis.h"
#include "results/results.h"

#include <functional>

namespace frictionbeam {

/// Takes what one mode does in one direction, with its sign where the motions of groups have one.
/// @param mode from 1 on; 0: the missing mass @param direction 0, 1, 2: x, y, z
using TakeModalResponse =
    std::function<void(const unsigned int mode, const unsigned int direction, const Frame &frame)>;

/**
 * The response to the scene's spectra, all numbers >= 0. In direction d, mode k and group g
 *   R_kdg = Gamma_kdg S_g(f_k) / w_k^2 R(phi_k),
 * Gamma = phi^T M r with r the motion of the line at rest when the group moves by a unit; without
 * groups the spectra are added with their signs, groups by their sizes or squares. Modes of one
 * frequency are one, with their signs. The periodic parts sqrt(1 - a_k^2) R_kd are combined over
 * modes (modal_combination.h), the rigid ones are added with their signs to the missing mass, the
 * static response to M (r - sum phi_k Gamma_k) at the spectrum's last acceleration; both are joined
 * by the square root of the sum of squares, and then the directions are (or, with
 * Response/First = directions, these first, in each mode and of the rigid part). Source: A. K.
 * Chopra, Dynamics of Structures, chapter 13; RG 1.92 rev. 3; see doc/dynamics.md.
 * @param results gets the excitation of each mode @param take may be empty
 */
Frame spectrum_response(const Model &model, const ModalAnalysis &analysis, Results &results,
                        const TakeModalResponse &take = {});

} // namespace frictionbeam
