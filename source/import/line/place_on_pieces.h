// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/network.h"
#include "import/line/section_plan.h"

namespace frictionbeam::import {

/// Finds the place on a network's pieces that is nearest to a point.
class PlaceOnPieces {
public:
  PlaceOnPieces(const Network &network, const double tolerance)
      : network(network), tolerance(tolerance) {}

  struct Place {
    std::size_t piece = 0;
    Point3 position{};
    double distance = 0.;
    std::optional<unsigned int> node; ///< if it is one
    bool in_the_middle = false;       ///< of a bend
  };
  /// None if there is no piece.
  std::optional<Place> nearest(const Point3 &point) const;

  /// The nearest place of one piece.
  Place on(const std::size_t piece, const Point3 &point) const {
    return network.pieces[piece].radius > 0. ? on_arc(piece, point) : on_piece(piece, point);
  }

  /// How far from a piece's axis a support may be given: its outer diameter [m].
  double reach(const std::size_t piece, const SectionPlanner &sections) const;

private:
  Place on_piece(const std::size_t piece, const Point3 &point) const;
  Place on_arc(const std::size_t piece, const Point3 &point) const;

  const Network &network;
  const double tolerance;
};

} // namespace frictionbeam::import
