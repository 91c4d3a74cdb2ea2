// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/network.h"
#include "import/pcf/pcf_component.h"

namespace frictionbeam::import {

/**
 * Corner and radius of a bend from @p a to @p b: CENTRE-POINT is where the tangents meet. It is
 * moved so that both tangents are equally long, by no more than their difference, and
 * R = T/tan(theta/2), T the tangent's length, theta the angle by which the bend turns.
 * @throws UserError where the points make no bend
 */
void give_bend(const PcfFile &file, const PcfComponent &component, const Point3 &a, const Point3 &b,
               const double tolerance, Piece &piece, Notes &notes);

/// Make a bend of @p piece from @p a to @p b around a corner that is equally far from both.
void give_corner(Piece &piece, const Point3 &a, const Point3 &corner, const Point3 &b);

/// Cut a bend from @p a to @p b at a place on its arc; the first part ends there, the second one
/// begins there. Nodes are left to the caller.
std::pair<Piece, Piece> cut_bend(const Piece &bend, const Point3 &a, const Point3 &place,
                                 const Point3 &b);

/**
 * Whether a bend turns back: by a CENTRE-POINT in the middle between its ends, where the tangents
 * of no other bend meet, or by its ANGLE if something comes in square to the line of its ends.
 */
bool turns_back(const PcfLine &line, const PcfComponent &component, const double tolerance);

/**
 * Where the arc of a bend of 180 degrees is farthest from its ends: on from what comes in.
 * @throws UserError where nothing does
 */
Point3 top_of_return(const PcfFile &file, const PcfLine &line, const PcfComponent &component,
                     const double tolerance);

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
