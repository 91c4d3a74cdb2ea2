// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"

#include <optional>

namespace frictionbeam {

/// Forces in a line under which it buckles.
struct Buckling {
  double ratio = 0.;       ///< of them to those at which it begins to
  double compression = 0.; ///< largest where it bends most [N]
  Station begin, end;      ///< where that is
};

/**
 * Linear buckling of a line about a state in small displacements: the least factor c > 0 of all its
 * axial forces N at which K + c G(N) + K_c is no longer positive definite, if it is below 1/@p
 * least. K is the stiffness of pipes, springs and joints. K_c is that of the supports which touch,
 * of a stop that holds both ways of one half: along their normals; across, of those that stick, and
 * of those that have slid by s, T/s across their way, for a deflection that has grown with the
 * slide met that share of the friction T. G is that of straight cells, cut into eight with the
 * compression of each, their inner unknowns condensed, and of others as one. How many eigenvalues
 * are negative is counted from the signs of a factorization, those of clamped cells added (Wittrick
 * and Williams 1971), which is exact for the cells' matrices; shear and joints are left out of G.
 *
 * @param touching largest gap of a support that does [m]
 */
std::optional<Buckling> buckling_of(const Model &model, const Frame &frame, const double least,
                                    const double touching);

} // namespace frictionbeam
