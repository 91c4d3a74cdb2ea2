// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/pipes/bend_model.h"

namespace frictionbeam::accuracy {

/// The bends of a scene's routes, in their order.
BendModels bend_models(const Scene &scene);

/// Its shape, and how flexible it is by either model.
std::string in_words(const BendModel &bend);

/// Which bends of a line beams answer for.
struct ModelOfPipes {
  double change = 0.;   ///< of a quantity, all bends being as flexible as their walls
  double left = 0.;     ///< what those that stay beams contribute
  double per_part = 0.; ///< change of a quantity by the part that the solids' flexibilities are off
  double of_joints = 0.;          ///< that part, as the joints of solids and beams leave it
  double by_pressure = 0.;        ///< change of a quantity by what it would stiffen the solids
  double r_over_t = 0.;           ///< largest of the bends that do not stay beams
  std::vector<std::string> solid; ///< these, as Solid/At has them
  std::string reason;
  std::vector<std::string> in_words; ///< a line for each bend
};

/**
 * Solve the line with bends as flexible as their walls, by moments in their plane and across it, or
 * as much further from their rules as these may be off: all of them and, where that changes a
 * quantity by more than @p tolerance, each. Those that change most are to be solid, as few as leave
 * no more than that by the others together.
 * @param scene with bends as arcs @param beams its answer, with bends by their pipes' rules
 */
ModelOfPipes model_of_pipes(const Scene &scene, const Results &beams, const double tolerance,
                            const SolveAs &solve);

/// The scene with bends as arcs.
Scene with_arcs(Scene scene);

/// Why a scene cannot have solid parts; empty: it can.
std::string why_not_mixed(const Scene &scene);

} // namespace frictionbeam::accuracy
