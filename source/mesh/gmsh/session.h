// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/user_error.h"

#include <string>

namespace frictionbeam {

/// Keeps gmsh initialized, silent, and without the user's configuration.
class GmshSession {
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession &) = delete;
  GmshSession &operator=(const GmshSession &) = delete;
};

/// Do what gmsh may find impossible. @throws UserError then
template <typename Task>
auto by_gmsh(const std::string &file, const Task &task) {
  try {
    return task();
  } catch (const std::string &reason) { // what gmsh throws
    throw UserError(file.empty() ? "gmsh cannot mesh what the parameter file describes: " + reason
                                 : "Mesh/File: gmsh cannot read or mesh '" + file + "': " + reason +
                                       ". Open the file in gmsh to see what is wrong.");
  }
}

} // namespace frictionbeam
