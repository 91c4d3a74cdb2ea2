// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <string>

namespace frictionbeam {

/// A coordinate of a picture, to a tenth of a pixel.
std::string px(const double value);

/// SVG marker of a status at (x, y) [px] with half width @p size: stick a disc, slip a diamond,
/// open a ring, closed a square, each in its colour. The tooltip may be empty.
std::string status_marker(const ContactStatus status, const double x, const double y,
                          const double size, const std::string &tooltip = "");

/// A status in a table's cell: its marker and its word.
std::string status_cell(const ContactStatus status);

/// SVG marker of a restraint or spring: a triangle that carries the point (x, y) [px].
std::string restraint_marker(const double x, const double y, const std::string &tooltip = "");

} // namespace frictionbeam
