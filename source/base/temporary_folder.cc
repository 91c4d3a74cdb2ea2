// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/temporary_folder.h"

#include <stdlib.h>

#include <filesystem>

namespace frictionbeam {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "frictionbeam-XXXXXX").string();
  if (!error && mkdtemp(name.data()) != nullptr)
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  if (!path.empty())
    std::filesystem::remove_all(path, error);
}

} // namespace frictionbeam
