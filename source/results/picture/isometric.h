// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <string>

namespace frictionbeam {

/// A place in a picture [px], y downwards.
struct Pixel {
  double x = 0., y = 0.;
};

/// x to the lower right, y to the upper right, z up, lengths foreshortened by sqrt(2/3).
Pixel isometric(const Point3 &point);

/// Fits what it is shown into a picture.
class IsometricView {
public:
  void include(const Point3 &point);
  /// Scale what was included to a room of the picture [px], in the middle across and from its top.
  void fit(const double left, const double top, const double width, const double most_height);

  Pixel place(const Point3 &point) const;
  double scale() const { return factor; }  ///< [px/m], before foreshortening
  double height() const { return fitted; } ///< of what was included [px]

private:
  Pixel low{1e300, 1e300}, high{-1e300, -1e300}, origin;
  double factor = 1., fitted = 0.;
};

/// Elements of SVG. @p attributes are more of them, as text.
std::string text_at(const double x, const double y, const std::string &text,
                    const std::string &attributes = "");
std::string stroke(const Pixel &from, const Pixel &to, const std::string &attributes);
/// A whole picture with its title.
std::string svg_picture(const double width, const double height, const std::string &title,
                        const std::string &content);

} // namespace frictionbeam
