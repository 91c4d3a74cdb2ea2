// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// From which step each starts, drawn as a tree, as HTML; empty if each starts where the one before
/// it ended.
std::string step_tree(const Scene &scene);

} // namespace frictionbeam
