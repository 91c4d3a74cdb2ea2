// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

namespace frictionbeam {

/// Say which entries the file gives and the scene does not use, and why (Scene::remarks): none may
/// be ignored without a word. `tests/entries` tries all of them.
void remark_on_unused(ParameterReader &in, Scene &scene);

} // namespace frictionbeam
