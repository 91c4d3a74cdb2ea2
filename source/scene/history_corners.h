// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * Find the instants in [0, end] at which an expression may jump or bend, and put them into its
 * breaks: where a comparison in it changes, an argument of abs(), sign() or an argument of min() or
 * max() passes another one, floor(), ceil(), rint(), int() or the condition of an if() takes
 * another value. These conditions are looked at themselves, so that a pulse of a microsecond, t > 1
 * && t < 1.000001, is not missed: each alone changes once. They are sampled twice as densely until
 * no more changes appear, and each change is located to the last bit.
 */
void find_corners(TimeFunction &function, const double end);
/// In all histories and ground motions of a scene, for the time that its steps take.
void find_corners(Scene &scene);

} // namespace frictionbeam
