// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace frictionbeam {

/// Finds places for the labels of a picture where they cover neither each other nor what is drawn.
class LabelPlacer {
public:
  struct Place {
    double x = 0., y = 0.; ///< of the text's baseline [px], y downwards
    std::string anchor;    ///< SVG's text-anchor
  };

  /// Labels stay within @p width and from @p top to @p bottom [px].
  LabelPlacer(const double width, const double top, const double bottom);

  /// Keep the labels off a square of side 2 @p radius about a point.
  void avoid(const double x, const double y, const double radius);

  /// Keep the labels off the stroke between two points.
  void avoid_stroke(const double x0, const double y0, const double x1, const double y1);

  /// A place for @p text near a point, kept off from then on; nothing if there is none.
  std::optional<Place> place(const std::string &text, const double font_size, const double x,
                             const double y);

private:
  struct Box {
    double left, top, right, bottom;
  };

  bool is_free(const Box &box) const;
  std::vector<unsigned int> buckets(const Box &box) const;
  void add(const Box &box);

  double width, top, bottom;
  unsigned int n_columns, n_rows;
  std::vector<std::vector<Box>> taken; ///< by squares of the picture
};

} // namespace frictionbeam
