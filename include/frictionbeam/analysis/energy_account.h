// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/line_state.h>

namespace frictionbeam {

/**
 * Where the work of the loads went in static increments, each term by the trapezoid: the mean of a
 * force before and after times the motion. With both ends in equilibrium the terms balance to
 * rounding, so that what is left over measures the solution and not the size of the increment.
 */
struct EnergyAccount {
  double external = 0.; ///< work of loads (thermal ones included) and of imposed motions [J]
  double stored = 0.;   ///< in the line, its springs and the elastic part of friction elements [J]
  double dissipated = 0.; ///< by friction [J]
  double gaps = 0.; ///< of normal forces along gaps that open or close within an increment [J]
  /// Friction work that the trapezoid misses, 1/2 dT . dslip, as sizes: a measure of the
  /// increments.
  double missed_friction = 0.; ///< [J]
  double turnover = 0.;        ///< sum of the sizes of all terms [J]

  /// |external - stored - dissipated - gaps| / turnover.
  double imbalance() const;
  EnergyAccount &operator+=(const EnergyAccount &other);
};

/**
 * Account of one increment.
 * @param loads forces on the unknowns before and after
 */
EnergyAccount account_increment(const Model &model, const LineState &before, const LineState &after,
                                const Vector &loads_before, const Vector &loads_after);

} // namespace frictionbeam
