// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

class LoadSequence;

/**
 * Mesh, model, load sequence, modes, spectra, combinations and stresses of a scene. Rows of csv and
 * vtu files are written into Scene::output.directory, which exists, while it runs, and none if that
 * is empty; summary and report are left to the caller.
 */
Results solve_scene(const Scene &scene, const LawLibrary &laws);

/// The same of a model that is there, by a sequence that has not begun.
/// @param results with the remarks on mesh and model
void solve_sequence(const Model &model, LoadSequence &sequence, Results &results);

} // namespace frictionbeam
