// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/// A folder in the system's place for such, removed with all it holds at the end.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::string path; ///< empty if none can be made
};

} // namespace frictionbeam
