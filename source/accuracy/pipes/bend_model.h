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
  double stiffening = 1.; ///< by a Stiffening pressure above that of the loads, of no solid part
};

struct BendModels {
  std::vector<BendModel> judged;
  std::vector<std::string> unknown; ///< bends that no solid can stand for, and why
};

/// Solves a scene as beams. @param what it is, in words
using SolveAs = std::function<Results(const Scene &, const std::string &what)>;

} // namespace frictionbeam::accuracy
