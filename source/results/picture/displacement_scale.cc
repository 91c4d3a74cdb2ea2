// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/displacement_scale.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double part_of_size = 0.08, part_of_distance = 0.7;
constexpr std::size_t n_places = 300; ///< of a frame that are compared with each other
constexpr double same_place = 1e-6;   ///< of the line's size: their distance is rounding
constexpr double no_motion = 1e-200;  ///< of the line's size: no factor would show it

/// 1, 2 or 5 times a power of ten, not above @p value.
double round_down(const double value) {
  const double power = std::pow(10., std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5. ? 5. : digit >= 2. ? 2. : 1.);
}

Vector3 way_of(const Station &station) {
  return Vector3({station.displacement[0], station.displacement[1], station.displacement[2]});
}

bool is_known(const Station &station) {
  return std::isfinite(way_of(station).norm()) && std::isfinite(station.position.norm());
}

/// The largest factor at which no two places have come too close, in a line of size @p size [m].
double factor_without_crossing(const Frame &frame, const double size) {
  std::vector<const Station *> places;
  const std::size_t every = frame.line.size() / n_places + 1;
  for (std::size_t i = 0; i < frame.line.size(); i += every)
    if (is_known(frame.line[i]))
      places.push_back(&frame.line[i]);
  double closing = 0.; // largest |u_a - u_b| / |x_a - x_b|
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double distance = places[a]->position.distance(places[b]->position);
      if (distance > same_place * size)
        closing = std::max(closing, (way_of(*places[a]) - way_of(*places[b])).norm() / distance);
    }
  return closing > 0. ? part_of_distance / closing : std::numeric_limits<double>::max();
}

} // namespace

double displacement_scale(const std::vector<const Frame *> &frames) {
  double largest = 0., factor = std::numeric_limits<double>::max();
  Point3 low(1e300, 1e300, 1e300), high(-1e300, -1e300, -1e300);
  for (const Frame *frame : frames) {
    if (frame->is_amplitude) // is no shape
      continue;
    for (const Station &station : frame->line)
      if (is_known(station)) {
        largest = std::max(largest, way_of(station).norm());
        for (unsigned int d = 0; d < 3; ++d) {
          low[d] = std::min(low[d], station.position[d]);
          high[d] = std::max(high[d], station.position[d]);
        }
      }
  }
  const double size = low.distance(high);
  for (const Frame *frame : frames)
    if (!frame->is_amplitude)
      factor = std::min(factor, factor_without_crossing(*frame, size));
  return size > 0. && largest > no_motion * size
             ? round_down(std::min(part_of_size * size / largest, std::max(factor, 1.)))
             : 1.;
}

} // namespace frictionbeam
