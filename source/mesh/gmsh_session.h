// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// Keeps gmsh initialized, silent, and without the user's configuration.
class GmshSession {
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession &) = delete;
  GmshSession &operator=(const GmshSession &) = delete;
};

} // namespace frictionbeam
