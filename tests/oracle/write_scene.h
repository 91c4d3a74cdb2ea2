// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene.h"

#include <map>

namespace oracle {

/// The scene as a parameter file in its units; tables of materials go into files beside it, by
/// their names.
std::string parameter_file(const Scene &scene, std::map<std::string, std::string> &tables);

/// Steps, 'spectrum' and combinations.
std::vector<std::string> cases_of(const Scene &scene);

/// Of the motion of a point in a case, where the scene has quantities.
std::string quantity_name(const std::string &point, const std::string &name,
                          const std::string &motion);

/// Write parameter file and tables. @param comment lines on top, without '#'.
void write_scene(const Scene &scene, const std::string &file, const std::string &comment);

} // namespace oracle
