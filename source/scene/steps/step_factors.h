// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// Factors of a scene's loads at the end of a step, as it declares them: the sum of what it names,
/// without the loads' histories. Preloads of hangers are always there.
std::vector<double> declared_factors(const Scene &scene, const LoadStep &step);

} // namespace frictionbeam
