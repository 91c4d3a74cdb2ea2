// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"
#include <frictionbeam/law_library.h>

#include <iosfwd>

namespace frictionbeam {

/**
 * Read a parameter file into a scene, checked as far as it can be without a mesh.
 *
 * @param file path of the file
 * @param overrides `--set` options, "Section/Entry = value" or "Entry = value", applied in their
 *   order before anything is checked. If one changes anything but Mesh, Solver, Time, Output, the
 *   title, the monitors or the quantities, reference values given in the file are dropped, with a
 *   remark in Scene::remarks. References of generated scenes follow the parameters.
 * @param laws the laws that are known; those in the shared libraries that the file names are added
 * @throws UserError with the place in the file, the part, the entry, what was read, what is allowed
 *   and what to try.
 */
Scene read_scene(const std::string &file, const std::vector<std::string> &overrides,
                 LawLibrary &laws);

/// Write a parameter file with every entry there is, each with its unit, meaning and bounds: the
/// reference documentation.
void print_parameters(std::ostream &out, const LawLibrary &laws);

} // namespace frictionbeam
