// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/modal.h"

#include <Eigen/Dense>

#include <vector>

namespace frictionbeam {

/**
 * @file
 * How the largest responses of modes, which do not come at the same time, are combined. Sources:
 * U.S. NRC Regulatory Guide 1.92, revision 1 (1976) and revision 3 (2012), "Combining modal
 * responses and spatial components in seismic response analysis"; A. Der Kiureghian, Earthquake
 * Engineering and Structural Dynamics 9 (1981) 419-435, doi:10.1002/eqe.4290090503.
 *
 * R_k is the response of mode k, f_k = w_k/(2 pi) its frequency, z the damping ratio:
 * - srss: R^2 = sum R_k^2
 * - absolute: R = sum |R_k|
 * - cqc: R^2 = sum rho_kj R_k R_j, with r = f_min/f_max of the two,
 *   rho = 8 z^2 (1+r) r^(3/2) / ((1-r^2)^2 + 4 z^2 r (1+r)^2)
 * - grouping (rev. 1, 1.2.1): from the lowest frequency on, modes with f <= 1.1 of the group's
 *   lowest one are a group; R^2 = sum over groups (sum |R_k|)^2
 * - ten percent (rev. 1, 1.2.2): R^2 = sum R_k^2 + 2 sum |R_i R_j| over pairs with f_j <= 1.1 f_i
 * - double sum (rev. 1, 1.2.3): R^2 = sum e_kj |R_k R_j|,
 *   e = 1/(1 + ((w'_k - w'_j)/(z'_k w_k + z'_j w_j))^2), w' = w sqrt(1-z^2), z' = z + 2/(t w)
 * - signed double sum (rev. 2 and 3): R^2 = sum e_kj R_k R_j
 *
 * Which part of a mode is rigid, in phase with the ground (rev. 3, with S_k the mode's spectral
 * acceleration, Z that of zero period):
 * - lindley-yow: a_k = Z/S_k, at most 1
 * - gupta: a_k = ln(f_k/f1)/ln(f2/f1), from 0 to 1
 */

/// rho and e above; of a mode with itself 1.
double cqc_correlation(const double one, const double other, const double damping);
double double_sum_correlation(const double one, const double other, const double damping,
                              const double duration);

/// R, number by number. @param frequencies rising [Hz]
Eigen::VectorXd combine_modes(const std::vector<Eigen::VectorXd> &responses,
                              const std::vector<double> &frequencies,
                              const SpectrumSettings &settings);

/// a_k: the periodic part of a response is sqrt(1 - a^2) of it.
double rigid_share(const SpectrumSettings &settings, const double frequency,
                   const double acceleration, const double at_zero_period);

} // namespace frictionbeam
