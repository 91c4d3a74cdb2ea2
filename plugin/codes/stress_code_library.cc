// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/stress_code_library.h>

#include "../shared_library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace frictionbeam {

namespace {

bool has_text(const char *text) { return text != nullptr && *text != '\0'; }

} // namespace

StressCodeLibrary::~StressCodeLibrary() {
  for (void *const handle : handles)
    dlclose(handle);
}

const StressCodeDescription &StressCodeLibrary::load(const std::string &file) {
  const std::string origin = "The stress code library '" + file + "'";
  const auto require = [&](const bool condition, const std::string &message) {
    if (!condition)
      throw std::runtime_error(origin + " cannot be used: " + message);
  };
  void *const handle = open_shared_library(file, origin, "frictionbeam_add_stress_code()");
  handles.push_back(handle);
  const auto *const code =
      static_cast<const StressCodeDescription *>(dlsym(handle, "frictionbeam_stress_code"));
  require(code != nullptr, "it does not export the object 'frictionbeam_stress_code'. Define it "
                           "with extern \"C\", as plugin/codes/stress_skeleton.cc does.");
  require(code->interface_version == stress_code_interface_version,
          "it was compiled for version " + std::to_string(code->interface_version) +
              " of the interface of stress codes, this program has version " +
              std::to_string(stress_code_interface_version) +
              ". Compile it again with the header frictionbeam/stress_code.h of this program.");
  require(has_text(code->name), "its code has no name. Set StressCodeDescription::name.");
  require(has_text(code->edition), "its code '" + std::string(code->name) +
                                       "' does not say which edition it is. Set "
                                       "StressCodeDescription::edition.");
  require(code->code != nullptr,
          "it has no code object. Let StressCodeDescription::code point to a constant object.");
  const auto present = codes.find(code->name);
  require(present == codes.end() || present->second.code == code,
          "its code is called '" + std::string(code->name) + "', as is the one of '" +
              (present == codes.end() ? "" : present->second.file) +
              "'. Give it a name of its own.");
  codes[code->name] = {code, file};
  return *code;
}

void StressCodeLibrary::load_builtin() {
  for (const std::string &file : shared_libraries_in(builtin_directory()))
    load(file);
}

const StressCodeDescription *StressCodeLibrary::find(const std::string &name) const {
  const auto code = codes.find(name);
  return code == codes.end() ? nullptr : code->second.code;
}

std::vector<std::string> StressCodeLibrary::names() const {
  std::vector<std::string> result;
  for (const auto &entry : codes)
    result.push_back(entry.first);
  return result;
}

std::string StressCodeLibrary::builtin_directory() {
  return folder_beside_library("frictionbeam-codes");
}

} // namespace frictionbeam
