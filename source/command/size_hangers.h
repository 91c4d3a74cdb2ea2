// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/**
 * The scene with the loads and stiffnesses of the hangers that it leaves open. The hot load W is
 * what a rigid support at the hanger carries in its weight step. With W as a constant force, the
 * line is taken to the hot step, where the hanger has travelled by u. A variable hanger then gets
 * the stiffness k = 0.98 variation W/|u|, at most W/25 mm, and the cold load W + k u, so that it
 * carries W when the line is hot; one with an item of the catalogue has the item's stiffness. What
 * was chosen is said in Scene::remarks.
 * @throws UserError if a hanger would have to push down, the line is not in equilibrium without, or
 * no item of the catalogue fits.
 */
Scene with_sized_hangers(Scene scene, const LawLibrary &laws);

} // namespace frictionbeam
