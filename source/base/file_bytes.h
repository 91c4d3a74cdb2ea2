// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace frictionbeam {

/// All of a file that is no folder; nothing if there is none.
inline std::string file_bytes(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace frictionbeam
