// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_library.h>

#include "bridge/law_in_c.h"
#include "shared_library.h"

#include <dlfcn.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace frictionbeam {

namespace {

/// @param origin of the law, as a message begins: "The law library 'file'"
void check(const bool condition, const std::string &origin, const std::string &message) {
  if (!condition)
    throw std::runtime_error(origin + " cannot be used: " + message);
}

bool is_given(const char *text) { return text != nullptr && *text != '\0'; }

void check_description(const LawDescription &law, const std::string &origin) {
  check(law.interface_version >= oldest_law_interface_version &&
            law.interface_version <= law_interface_version,
        origin,
        "it was compiled for version " + std::to_string(law.interface_version) +
            " of the law interface, this program has version " +
            std::to_string(law_interface_version) + " and loads those from " +
            std::to_string(oldest_law_interface_version) +
            " on. Compile it again with the header frictionbeam/law.h of this program.");
  check(law.kind == LawKind::support || law.kind == LawKind::section, origin,
        "its kind is " + std::to_string(static_cast<int>(law.kind)) +
            ", expected 0 (support) or 1 (section). Set LawDescription::kind.");
  const int n_strains = law.kind == LawKind::support ? n_support_strains : n_section_strains;
  check(law.n_strains == n_strains, origin,
        "it has " + std::to_string(law.n_strains) + " strains, a law of its kind has " +
            std::to_string(n_strains) + ". Set LawDescription::n_strains.");
  check(law.n_internal_variables >= 0 && law.n_internal_variables <= 4000, origin,
        "it has " + std::to_string(law.n_internal_variables) +
            " internal variables, expected 0 to 4000. Set LawDescription::n_internal_variables.");
  check(law.law != nullptr, origin,
        "it has no law object. Let LawDescription::law point to a constant object.");
  check(law.n_parameters <= 1000, origin,
        "it announces " + std::to_string(law.n_parameters) +
            " parameters, expected 0 to 1000. Set LawDescription::n_parameters.");
  check(law.n_parameters == 0 || (law.n_parameters > 0 && law.parameters != nullptr), origin,
        "it announces " + std::to_string(law.n_parameters) +
            " parameters without a list. Set n_parameters and parameters together.");
}

void check_texts(const LawDescription &law, const std::string &origin) {
  for (int i = 0; i < law.n_parameters; ++i) {
    const LawParameter &p = law.parameters[i];
    const std::string which = is_given(p.name) ? "parameter '" + std::string(p.name) + "'"
                                               : "parameter number " + std::to_string(i);
    check(is_given(p.name) && is_given(p.unit) && is_given(p.meaning), origin,
          which + " lacks a name, a unit or a meaning. Give all three ('-' if it has no unit).");
    for (int j = 0; j < i; ++j)
      check(std::string(p.name) != law.parameters[j].name, origin,
            "it has two parameters called '" + std::string(p.name) +
                "'. Give each a name of its own.");
    check(std::isfinite(p.default_value), origin,
          "the default of " + which + " is not finite. Give a number within its bounds.");
    check(p.minimum <= p.default_value && p.default_value <= p.maximum, origin,
          "the default " + std::to_string(p.default_value) + " of " + which +
              " is outside its bounds " + std::to_string(p.minimum) + " to " +
              std::to_string(p.maximum) + ".");
  }
  check(is_given(law.reference), origin,
        "the law '" + std::string(law.name) +
            "' names no reference. Say where it is from in LawDescription::reference.");
}

/// A method that believes a closed form reads and writes where it says.
void check_closed_form(const LawDescription &law, const std::string &origin) {
  if (law.threshold == nullptr)
    return;
  check(law.kind == LawKind::support, origin,
        "it has a closed form, and is a law of sections. Set LawDescription::threshold to null.");
  const std::string faults = place_faults(law, closed_form_at_rest(law, default_parameters(law)));
  check(faults.empty(), origin,
        faults + ". Expected a place of its own within the internal variables for each: set "
                 "n_internal_variables, and the places in threshold().");
}

} // namespace

LawLibrary::LawLibrary() = default;

LawLibrary::~LawLibrary() {
  for (void *const handle : handles)
    dlclose(handle);
}

const LawDescription &LawLibrary::load(const std::string &file) {
  const std::string origin = "The law library '" + file + "'";
  void *const handle = open_shared_library(file, origin, "frictionbeam_add_law()");
  handles.push_back(handle);

  const std::string whence = "loaded from '" + file + "'";
  const auto *const law = static_cast<const LawDescription *>(dlsym(handle, "frictionbeam_law"));
  if (law != nullptr)
    return take(*law, origin, whence);
  void *const function = dlsym(handle, "frictionbeam_law_c");
  check(function != nullptr, origin,
        "it does not export the object 'frictionbeam_law'. Define it with extern \"C\", as "
        "plugin/law_skeleton.cc does, or the function 'frictionbeam_law_c' of frictionbeam/law_c.h "
        "in C or Fortran.");
  return take_law_in_c(function, origin, whence);
}

const LawDescription &LawLibrary::take_law_in_c(void *const function, const std::string &origin,
                                                const std::string &whence) {
  const frictionbeam_c_law *const law = reinterpret_cast<decltype(&frictionbeam_law_c)>(function)();
  const std::string faults = faults_of_law_in_c(law);
  check(faults.empty(), origin, faults);
  for (const std::unique_ptr<LawInC> &present : laws_in_c)
    if (present->is_of(*law))
      return take(present->description(), origin, whence);
  laws_in_c.push_back(std::make_unique<LawInC>(*law));
  return take(laws_in_c.back()->description(), origin, whence);
}

const LawDescription &LawLibrary::add(const LawDescription &law) {
  const std::string name = is_given(law.name) ? law.name : "";
  return take(law, "The law '" + name + "' that is linked in", "linked in");
}

const LawDescription &LawLibrary::take(const LawDescription &law, const std::string &origin,
                                       const std::string &whence) {
  check_description(law, origin);
  check(is_given(law.name), origin, "its law has no name. Set LawDescription::name.");
  const auto present = laws.find(law.name);
  if (present != laws.end() && present->second.law == &law)
    return law; // the same again
  check(present == laws.end(), origin,
        "its law is called '" + std::string(law.name) + "', as is the one already " +
            (present == laws.end() ? "" : present->second.whence) + ". Give it a name of its own.");
  check_texts(law, origin);
  check_closed_form(law, origin);
  laws[law.name] = {&law, whence};
  return law;
}

void LawLibrary::load_builtin() {
  for (const std::string &file : shared_libraries_in(builtin_directory()))
    load(file);
}

const LawDescription &LawLibrary::find(const std::string &name) const {
  const auto law = laws.find(name);
  if (law == laws.end()) {
    std::string known;
    for (const auto &entry : laws)
      known += (known.empty() ? "" : ", ") + entry.first;
    throw std::runtime_error("There is no law called '" + name + "'. Loaded are: " + known +
                             ". Load the shared library of another one: LawLibrary::load(), in a "
                             "parameter file the entry 'Law libraries'.");
  }
  return *law->second.law;
}

std::vector<std::string> LawLibrary::names(const LawKind kind) const {
  std::vector<std::string> result;
  for (const auto &[name, entry] : laws)
    if (entry.law->kind == kind)
      result.push_back(name);
  return result;
}

std::string LawLibrary::builtin_directory() { return folder_beside_library("frictionbeam-laws"); }

std::vector<double> default_parameters(const LawDescription &law) {
  std::vector<double> values(law.n_parameters);
  for (int i = 0; i < law.n_parameters; ++i)
    values[i] = law.parameters[i].default_value;
  return values;
}

std::vector<double> law_parameters(const LawDescription &law,
                                   const std::map<std::string, double> &values) {
  std::vector<double> result = default_parameters(law);
  for (const auto &[name, value] : values) {
    const unsigned int i = parameter_index(law, name);
    const LawParameter &parameter = law.parameters[i];
    if (!(value >= parameter.minimum && value <= parameter.maximum)) {
      std::ostringstream message;
      message << "\n  read:    " << value << " for '" << name << "' of the law '" << law.name
              << "'\n  allowed: from " << parameter.minimum << " to " << parameter.maximum << " ["
              << parameter.unit << "]\n  try:     " << parameter.default_value << "\n";
      throw std::runtime_error(message.str());
    }
    result[i] = value;
  }
  return result;
}

unsigned int parameter_index(const LawDescription &law, const std::string &name) {
  std::string known;
  for (int i = 0; i < law.n_parameters; ++i) {
    if (name == law.parameters[i].name)
      return i;
    known += (known.empty() ? "" : ", ") + std::string(law.parameters[i].name);
  }
  throw std::runtime_error("The law '" + std::string(law.name) + "' has no parameter '" + name +
                           "'. It has: " + known + ".");
}

} // namespace frictionbeam
