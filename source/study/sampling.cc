// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/sampling.h"

#include "base/process.h"
#include "base/user_error.h"

#include <dlfcn.h>

#include <filesystem>

namespace frictionbeam::study {

namespace {

constexpr const char *library_name = "frictionbeam_sampling.so";
constexpr const char *function_name = "frictionbeam_sampling";

/// Where the program's own libraries may be: in a build's tree, installed.
std::vector<std::filesystem::path> candidates() {
  const std::filesystem::path folder = std::filesystem::path(own_path()).parent_path();
  return {folder / ".." / "lib" / library_name, folder / FRICTIONBEAM_MODULES / library_name};
}

[[noreturn]] void fail(const std::string &reason) {
  throw UserError(
      "A study needs OpenTURNS, which makes its samples.\n  read:    " + reason +
      "\n  allowed: a program that was built where Debian's libopenturns-dev was "
      "installed\n  try:     ./run study CASE.prm, which installs it and builds what is "
      "missing; or apt-get install libopenturns-dev, and cmake and ninja again");
}

const Sampling &open_library() {
  for (const std::filesystem::path &path : candidates()) {
    if (!std::filesystem::exists(path))
      continue;
    void *const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
      fail(dlerror());
    using Function = const Sampling *(*)();
    const auto function = reinterpret_cast<Function>(dlsym(library, function_name));
    if (function == nullptr)
      fail(path.string() + " of another version of the program");
    return *function();
  }
  fail(std::string("no ") + library_name + " beside the program");
}

} // namespace

const Sampling &load_sampling() {
  static const Sampling &sampling = open_library();
  return sampling;
}

} // namespace frictionbeam::study
