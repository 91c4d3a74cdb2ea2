// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/law_entries.h"

#include <frictionbeam/law_closed_form.h>

#include <algorithm>
#include <filesystem>

namespace frictionbeam {

const LawDescription &find_law(const ParameterReader &in, const LawLibrary &laws,
                               const LawKind kind, const std::string &otherwise) {
  const bool is_support = kind == LawKind::support;
  const std::vector<std::string> known = laws.names(kind),
                                 others =
                                     laws.names(is_support ? LawKind::section : LawKind::support);
  const std::string name = in.raw("Law", otherwise);
  if (std::count(others.begin(), others.end(), name) > 0)
    in.fail("Law",
            std::string("the name of a ") + (is_support ? "support" : "section") +
                " law: " + join(known) + "; '" + name + "' is a law of " +
                (is_support ? "beam sections" : "supports"),
            "'" + otherwise + "'", "'" + name + "'");
  return laws.find(known[in.find("Law", name, known, is_support ? "support law" : "section law")]);
}

std::vector<std::string> law_entries(const LawDescription &law) {
  std::vector<std::string> entries;
  for (int i = 0; i < law.n_parameters; ++i)
    entries.push_back(law.parameters[i].name);
  return entries;
}

void declare_parameters(ParameterReader &in, const LawDescription &law,
                        const std::vector<double> &defaults) {
  for (int i = 0; i < law.n_parameters; ++i) {
    const LawParameter &p = law.parameters[i];
    if (in.is_declared(p.name))
      in.fail("Law",
              "a law whose parameters have names of their own; '" + std::string(p.name) +
                  "' is an entry of this section whatever its law is",
              "another name for that parameter, in the source of law '" + std::string(law.name) +
                  "'",
              law.name);
    in.declare_number(p.name, defaults.empty() ? p.default_value : defaults[i], p.unit, p.minimum,
                      p.maximum, "Law " + std::string(law.name) + ": " + p.meaning + ".");
  }
}

void check_closed_form(const ParameterReader &in, const LawDescription &law,
                       const std::vector<double> &parameters) {
  const std::vector<std::string> faults = closed_form_faults(law, parameters);
  if (!faults.empty())
    in.fail("Law", "a law that does not contradict itself: " + faults.front(),
            "another law, or mend this one until frictionbeam-check-law says that it conforms");
}

void remark_on_units(const ParameterReader &in, const std::string &part, const LawDescription &law,
                     std::vector<std::string> &remarks) {
  for (int i = 0; i < law.n_parameters; ++i)
    if (const LawParameter &p = law.parameters[i]; in.given(p.name) && !in.converts(p.unit))
      remarks.push_back(part + ": its " + p.name + " is in " + p.unit +
                        " whatever the Units of the file are.");
}

void check_together(const ParameterReader &in, const LawDescription &law,
                    const std::vector<double> &parameters) {
  const auto fault = fault_of(law, parameters);
  if (!fault)
    return;
  std::vector<std::string> given;
  for (const std::string &entry : law_entries(law))
    if (in.given(entry))
      given.push_back(entry + " = " + in.text(entry));
  in.fail_section(join(given) + ", of law '" + law.name + "'", fault->allowed, fault->attempt);
}

void load_libraries(const ParameterReader &in, const std::string &entry, const std::string &what,
                    const std::function<void(const std::string &)> &load) {
  namespace fs = std::filesystem;
  for (const std::string &library : in.list(entry)) {
    const fs::path beside = fs::path(in.file().name()).parent_path() / library;
    const fs::path path = fs::exists(beside) ? beside : fs::path(library);
    if (!fs::exists(path))
      in.fail(entry,
              "shared libraries that exist, from the parameter file's folder or "
              "the working folder",
              "the path from " + fs::absolute(in.file().name()).parent_path().string(),
              "'" + library + "'");
    try {
      load(fs::absolute(path).string());
    } catch (const std::runtime_error &error) {
      in.fail(entry, "shared libraries that each export " + what, error.what(),
              "'" + library + "'");
    }
  }
}

void load_laws(const ParameterReader &in, LawLibrary &laws) {
  load_libraries(in, "Law libraries", "a law of this version",
                 [&](const std::string &path) { laws.load(path); });
}

} // namespace frictionbeam
