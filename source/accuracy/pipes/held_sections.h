// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::accuracy {

/// All that held sections do, or only how a ring gives way.
enum class HeldAs { sections, rings };

/**
 * What guides, stops and anchors hold of a solid pipe's sections, as imposed motions of the line:
 * first order in what it has there, M, Q and N, at the end of each step. By a thin wall whose
 * motions go with cos theta (r its mean radius, B = 1.285/sqrt(r t) the rate at which its local
 * bending dies out; doc/solid.md, "Held sections"):
 * - A bent section changes its shape, so that its mean is nu r^2/2 M/(E I) off the line; a guide
 *   without gap holds the mean.
 * - The force R of a guide bends the ring that it acts on, whose mean moves by
 *   R sqrt(r/t) (1 - 1.6 t/r) 0.051/(E t), and turns the pipe behind it by nu r^2/2 R/(E I).
 * - An anchor that holds the radius, too (Solid/Anchors = held), is as if nu^2/B of the pipe did
 *   not bend, and what the wall would widen by, e by heat and pressure, moves what is beyond it by
 *   nu (e - nu N/(E A))/B along the pipe.
 * - The wall at an anchor does not shear over 0.3 t, or 0.7 t if it holds the radius (measured).
 * Straight pipes only; anchors at ends of pipes; no place where a
 * support with friction or a gap stands, too.
 * @param beams results of the scene
 */
Scene with_held_sections(Scene scene, const Results &beams, const HeldAs as);

/**
 * The answer of beams whose quantities are changed by what the sections of a solid pipe do at named
 * points of straight pipes that nothing holds, by the same thin wall: the mean of a bent section is
 * off the line and turned by nu r^2/2 times its curvature and shear, and moved as a guide's ring is
 * by a force on it; at a free end four times as far, as a long cylinder bends at its edge.
 */
Results with_sections_at_points(const Scene &scene, Results beams);

} // namespace frictionbeam::accuracy
