// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"

namespace frictionbeam {

/// Geometry of a straight run or a bend of a pipe in the coordinates s along the axis [m], angle
/// from a to b [rad] and distance from the axis [m].
class WallManifold final : public dealii::ChartManifold<3, 3, 3> {
public:
  explicit WallManifold(const WallSegment &segment);

  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override;
  dealii::Point<3> pull_back(const dealii::Point<3> &place) const override;
  dealii::Point<3> push_forward(const dealii::Point<3> &chart) const override;

private:
  const WallSegment segment;
};

} // namespace frictionbeam
