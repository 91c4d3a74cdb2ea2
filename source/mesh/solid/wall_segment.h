// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_path.h"

namespace frictionbeam {

/// A straight run or a bend of a pipe's axis, with axes of the section that go along it without
/// turning about it.
struct WallSegment {
  PipePath::Segment path;
  double start = 0.; ///< along the whole chain of pipes [m]
  unsigned int pipe = 0;
  Vector3 a, b; ///< unit, at the beginning; a x b is the tangent

  /// A direction of the section at the beginning, at @p s from there.
  Vector3 carried(const Vector3 &direction, const double s) const;
};

} // namespace frictionbeam
