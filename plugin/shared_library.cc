// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shared_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace frictionbeam {

void *open_shared_library(const std::string &file, const std::string &origin,
                          const std::string &how) {
  // A name without a slash would be searched among the system's libraries.
  void *const handle = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const std::string reason = dlerror();
    throw std::runtime_error(origin + " cannot be used: it does not open (" + reason +
                             "). Expected a shared library; give its path from the folder the "
                             "program runs in, and compile it with " +
                             how + " or 'g++ -std=c++17 -shared -fPIC'.");
  }
  return handle;
}

std::vector<std::string> shared_libraries_in(const std::string &folder) {
  std::vector<std::string> found;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".so")
      found.push_back(entry.path().string());
  std::sort(found.begin(), found.end()); // whatever the file system's order
  return found;
}

std::string folder_beside_library(const std::string &name) {
  Dl_info info;
  if (dladdr(reinterpret_cast<void *>(&folder_beside_library), &info) == 0)
    throw std::runtime_error("The folder of FrictionBeam's shared library cannot be found.");
  return (std::filesystem::absolute(info.dli_fname).parent_path() / name).string();
}

} // namespace frictionbeam
