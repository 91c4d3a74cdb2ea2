// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <array>
#include <functional>

namespace frictionbeam::accuracy {

/// Straight pipe beside a bend.
struct Tangent {
  /// What ends it: another bend, an anchor, the end of the line, or another pipe that goes on.
  enum class Until { bend, anchor, end, pipe } until = Until::end;
  double length = 0.; ///< [m]
};

/// A bend as the beams have it, and as its wall would be.
struct BendModel {
  unsigned int pipe = 0;   ///< in Scene::pipes
  unsigned int number = 0; ///< among the pipe's bends
  std::string name;        ///< as Solid/At has it
  double h = 0.;           ///< t R/r^2
  double r_over_t = 0.;
  double angle = 0.;               ///< [rad]
  double decay_length = 0.;        ///< r sqrt(r/t), in which its oval dies out [m]
  std::array<Tangent, 2> tangents; ///< before and behind it
  double tangent = 0.;             ///< the shorter one [diameters]
  /// Flexibility over that of a straight pipe: by the pipe's rule, and by moments in the bend's
  /// plane and across it of a solid wall (ratios_of_walls(); von Karman's excess over one scaled
  /// for h > 1).
  double by_rule = 1., in_plane = 1., across = 1.;
  double off = 0.; ///< part that the last two may be off
  std::array<Point3, 2> ends;
  /// What the line turns by pressure, as moments per flexibility and pressure: I times a curvature,
  /// E left out, for it is in both [m3]; and the part of it by which a wall turns more.
  Vector3 turn_by_pressure;
  double more_turn = 0.;
  double stiffening = 1.; ///< by pressure, in all three, which no solid part has
};

struct BendModels {
  std::vector<BendModel> judged;
  std::vector<std::string> unknown; ///< bends that no solid can stand for, and why
};

/// The bends of a scene's routes, in their order.
BendModels bend_models(const Scene &scene);

/// Which bends of a line beams answer for.
struct ModelOfPipes {
  double change = 0.;   ///< of a quantity, all bends being as flexible as their walls
  double left = 0.;     ///< what those that stay beams contribute
  double per_part = 0.; ///< change of a quantity by the part that the solids' flexibilities are off
  double of_joints = 0.;          ///< that part, as the joints of solids and beams leave it
  double r_over_t = 0.;           ///< largest of the bends that do not stay beams
  std::vector<std::string> solid; ///< these, as Solid/At has them
  std::string reason;
  std::vector<std::string> in_words; ///< a line for each bend
};

/// Solves a scene as beams. @param what it is, in words
using SolveAs = std::function<Results(const Scene &, const std::string &what)>;

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
