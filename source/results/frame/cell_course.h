// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line/pipe_element.h"

#include <utility>

namespace frictionbeam {

/**
 * Section forces along a cell by what acts on it: force F [N] and moment M [N m] on the section at
 * its start, force per length q [N/m] and moment per length mu [N], twelve numbers in axes that do
 * not turn along the cell. Along it F' = -q and M' = -t cross F + mu (doc/theory.md, "The pipe").
 */
using CellCourse = Eigen::Matrix<double, 12, 1>;

/// The course of force and moment on the section at the start and of a force per length.
CellCourse course_of(const Eigen::Matrix<double, 6, 1> &section, const Vector3 &line_force);

/// The course in balance with forces on a straight cell's ends, of inertia, M (a + alpha v), or of
/// a wall: q is their mean over the length, mu closes the moment at the other end.
/// @param ends forces and moments on both ends, those at the start first [N, N m]
/// @param axis from the start to the other end [m]
CellCourse course_in_balance(const PipeElement::Vector12 &ends, const Eigen::Vector3d &axis);

/// The same of an arc, whose start is where the deal.II cell begins.
CellCourse course_in_balance(const PipeElement::Vector12 &ends, const ArcBeam &arc);

/// Section force and moment at a distance from a straight cell's start.
std::pair<Vector3, Vector3> section_of_straight(const CellCourse &course, const Vector3 &along,
                                                const double distance);

/// Section force and moment (global axes) of an arc at @p psi.
std::pair<Vector3, Vector3> section_of_arc(const CellCourse &course, const ArcBeam &arc,
                                           const double psi);

/// Three numbers of a course: of F, M, q and mu at @p first = 0, 3, 6, 9.
Vector3 part_of(const CellCourse &course, const unsigned int first);

} // namespace frictionbeam
