// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * Say what of the pipes' routes is hardly meant (Scene::doubts):
 * - an end that misses another pipe by up to 2 mm, as rounding of dimensions makes it;
 * - straight runs that pass through one another where neither route has a point;
 * - a plain corner at which a route turns back onto itself;
 * - a bend whose radius is below that of its pipe.
 * Bends themselves are not looked at for what they meet.
 */
void doubt_routes(Scene &scene);

} // namespace frictionbeam
