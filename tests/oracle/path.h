// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene.h"

/**
 * @file
 * The course of a pipe: straight runs, and circular arcs where corners are rounded.
 */
namespace oracle {

/// A straight run or an arc. It starts at `begin` in direction `tangent`; an arc turns towards
/// `inward`.
struct Curve {
  Vec begin = Vec::Zero(), tangent = Vec::UnitX(), inward = Vec::UnitY();
  double radius = 0.; ///< 0: straight
  double length = 0.;

  Vec at(double s) const;                            ///< point at the distance s from the beginning
  Vec direction(double s) const;                     ///< unit tangent there
  Vec axis() const { return tangent.cross(inward); } ///< about which an arc turns
  Curve part(double from, double to) const;
};

/// All curves of a pipe, one after the other.
struct Path {
  std::vector<Curve> curves;
  std::vector<double> start;                         ///< of each curve along the pipe
  std::vector<std::pair<std::string, double>> names; ///< corners; of a bend: its middle
  double length = 0.;

  explicit Path(const Pipe &pipe);
  std::size_t curve_at(double s) const;
  Vec at(double s) const;
};

} // namespace oracle
