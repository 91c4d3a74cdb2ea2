// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/pieces.h"

namespace frictionbeam::import {

/**
 * Corner and radius of a bend from @p a to @p b: CENTRE-POINT is where the tangents meet. It is
 * moved so that both tangents are equally long, by no more than their difference, and
 * R = T/tan(theta/2), T the tangent's length, theta the angle by which the bend turns.
 * @throws UserError where the points make no bend
 */
void give_bend(const PcfFile &file, const PcfComponent &component, const Point3 &a, const Point3 &b,
               const double tolerance, Piece &piece, Notes &notes);

/// Look at what comes into bends: by a CENTRE-POINT that is the arc's centre straight pipes would
/// come in across.
/// @throws UserError in that case
void check_tangents(const PcfFile &file, const PcfLine &line, const Network &network,
                    const double tolerance, Notes &notes);

/// Whether @p point is further from the line through @p a and @p b than @p tolerance.
bool is_off_line(const Point3 &point, const Point3 &a, const Point3 &b, const double tolerance);

/// "(1.2, 0, 3.4) m".
std::string text_of_place(const Point3 &point);

} // namespace frictionbeam::import
