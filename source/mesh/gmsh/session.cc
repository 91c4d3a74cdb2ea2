// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/session.h"

#include <gmsh.h>

namespace frictionbeam {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
}

GmshSession::~GmshSession() { gmsh::finalize(); }

} // namespace frictionbeam
