// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/picture/isometric.h"

#include "results/picture/marker.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

Pixel isometric(const Point3 &point) {
  return {(point[0] + point[1]) / std::sqrt(2.),
          (point[0] - point[1] - 2. * point[2]) / std::sqrt(6.)};
}

void IsometricView::include(const Point3 &point) {
  const Pixel at = isometric(point);
  low = {std::min(low.x, at.x), std::min(low.y, at.y)};
  high = {std::max(high.x, at.x), std::max(high.y, at.y)};
}

void IsometricView::fit(const double left, const double top, const double width,
                        const double most_height) {
  if (low.x > high.x) // nothing was included
    low = high = {0., 0.};
  const double across = high.x - low.x, down = high.y - low.y,
               needed = std::max(across / width, down / most_height);
  factor = needed > 0. ? 1. / needed : 1.;
  fitted = down * factor;
  origin = {left + (width - across * factor) / 2. - low.x * factor, top - low.y * factor};
}

Pixel IsometricView::place(const Point3 &point) const {
  const Pixel at = isometric(point);
  return {origin.x + at.x * factor, origin.y + at.y * factor};
}

std::string text_at(const double x, const double y, const std::string &text,
                    const std::string &attributes) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" " + attributes + ">" + escape_xml(text) +
         "</text>\n";
}

std::string stroke(const Pixel &from, const Pixel &to, const std::string &attributes) {
  return "<line x1=\"" + px(from.x) + "\" y1=\"" + px(from.y) + "\" x2=\"" + px(to.x) + "\" y2=\"" +
         px(to.y) + "\" " + attributes + "/>\n";
}

std::string svg_picture(const double width, const double height, const std::string &title,
                        const std::string &content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"" +
         escape_xml(title) + "\" viewBox=\"0 0 " + px(width) + " " + px(height) +
         "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"" +
         px(width) + "\" height=\"" + px(height) + "\" fill=\"#fff\"/>\n" +
         text_at(14., 22., title, "font-size=\"15\" font-weight=\"bold\"") + content + "</svg>\n";
}

} // namespace frictionbeam
