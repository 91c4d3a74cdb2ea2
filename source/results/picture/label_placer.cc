// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/label_placer.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
constexpr double bucket_size = 32.;
} // namespace

LabelPlacer::LabelPlacer(const double width, const double top, const double bottom)
    : width(width), top(top), bottom(bottom),
      n_columns(static_cast<unsigned int>(width / bucket_size) + 1),
      n_rows(static_cast<unsigned int>(bottom / bucket_size) + 1), taken(n_columns * n_rows) {}

std::vector<unsigned int> LabelPlacer::buckets(const Box &box) const {
  const auto index = [](const double coordinate, const unsigned int n) {
    return static_cast<unsigned int>(std::clamp(coordinate / bucket_size, 0., n - 1.));
  };
  std::vector<unsigned int> found;
  for (unsigned int row = index(box.top, n_rows); row <= index(box.bottom, n_rows); ++row)
    for (unsigned int column = index(box.left, n_columns); column <= index(box.right, n_columns);
         ++column)
      found.push_back(row * n_columns + column);
  return found;
}

void LabelPlacer::add(const Box &box) {
  for (const unsigned int bucket : buckets(box))
    taken[bucket].push_back(box);
}

void LabelPlacer::avoid(const double x, const double y, const double radius) {
  add({x - radius, y - radius, x + radius, y + radius});
}

void LabelPlacer::avoid_stroke(const double x0, const double y0, const double x1, const double y1) {
  const unsigned int n = static_cast<unsigned int>(std::hypot(x1 - x0, y1 - y0) / 4.) + 1;
  for (unsigned int i = 0; i <= n; ++i)
    avoid(x0 + (x1 - x0) * i / n, y0 + (y1 - y0) * i / n, 2.);
}

bool LabelPlacer::is_free(const Box &box) const {
  if (box.left < 2. || box.right > width - 2. || box.top < top || box.bottom > bottom)
    return false;
  for (const unsigned int bucket : buckets(box))
    for (const Box &other : taken[bucket])
      if (box.left < other.right && other.left < box.right && box.top < other.bottom &&
          other.top < box.bottom)
        return false;
  return true;
}

std::optional<LabelPlacer::Place> LabelPlacer::place(const std::string &text,
                                                     const double font_size, const double x,
                                                     const double y) {
  // bytes that continue a UTF-8 character take no room
  const auto n_characters =
      std::count_if(text.begin(), text.end(), [](const char c) { return (c & 0xc0) != 0x80; });
  const double length = 0.58 * font_size * n_characters + 2., height = 1.1 * font_size;
  for (const double distance : {9., 16., 26., 38.})
    for (const auto &[dx, dy] : {std::pair(1., 0.),
                                 {-1., 0.},
                                 {0., -1.},
                                 {0., 1.},
                                 {0.8, -0.8},
                                 {-0.8, -0.8},
                                 {0.8, 0.8},
                                 {-0.8, 0.8}}) {
      const double at = x + dx * distance;
      const double left = dx > 0. ? at : dx < 0. ? at - length : at - length / 2.;
      const double middle = y + dy * (distance + (dx == 0. ? height / 4. : 0.));
      const Box box{left, middle - height / 2., left + length, middle + height / 2.};
      if (is_free(box)) {
        add(box);
        return Place{at, middle + 0.35 * font_size, dx > 0. ? "start" : dx < 0. ? "end" : "middle"};
      }
    }
  return {};
}

} // namespace frictionbeam
