// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/unused/unused_entries.h"

#include "scene/unused/unused_row.h"

#include <map>
#include <set>

namespace frictionbeam {

namespace {

using namespace unused;

/// The reasons of the rows, in the order of the file.
void remark_on(const Rows &rows, const Place &at, Scene &scene) {
  const std::string kind = at.heading.substr(0, at.heading.find(' '));
  std::set<std::string> said;
  for (const Row &row : rows) {
    if (row.kind != kind)
      continue;
    const std::string why = row.why_not(at);
    if (why.empty())
      continue;
    if (row.entries.empty()) {
      scene.remarks.push_back("Section " + kind + " is not used " + why + ".");
      return;
    }
    for (const std::string &entry : row.entries)
      if (at.in.given(entry) && said.insert(entry).second)
        scene.remarks.push_back((kind.empty() ? "" : at.heading + ": its ") + entry +
                                " is not used " + why + ".");
  }
}

/// What is asked of a part besides: entries that are there, and do nothing by themselves.
void remark_on_part(const Place &at, Scene &scene) {
  const std::string kind = at.heading.substr(0, at.heading.find(' '));
  if (kind == "Support" && at.is_on("Torsion") && at.raw("Law", "coulomb") == "coulomb" &&
      at.number("Torsional rigidity") == 0.)
    scene.remarks.push_back(at.heading + ": its Torsion does nothing without a Torsional rigidity"
                                         " > 0 [N m2], whose default is 0.");
  if (kind == "Section" && at.number("Insulation") != 0. && at.number("Insulation density") == 0.)
    scene.remarks.push_back(at.heading +
                            ": its Insulation has no weight without an Insulation density.");
  constexpr double widest = 20.; // that anybody has built [m]
  const double diameter = at.number("Outer diameter") * at.in.si("m");
  if (kind == "Section" && diameter > widest)
    scene.remarks.push_back(at.heading + ": its Outer diameter is " + to_text(diameter) +
                            " m. Entries are in m where Units does not say otherwise.");
}

/// Entries of Time that belong to other integrators than the one that is taken.
void remark_on_integrator(ParameterReader &in, Scene &scene) {
  in.enter("Time");
  const IntegratorRow &taken = scene.time.row();
  std::map<std::string, std::vector<std::string>> users; // of each entry that is not of this one
  for (const IntegratorRow &row : integrators)
    for (const char *const entry : row.entries)
      if (entry != nullptr && in.given(entry) &&
          std::none_of(taken.entries.begin(), taken.entries.end(), [&](const char *const own) {
            return own != nullptr && std::string(own) == entry;
          }))
        users[entry].push_back(row.word);
  for (const auto &[entry, words] : users)
    scene.remarks.push_back("Time/" + entry + " is of " + join(words) +
                            " and is not used with Integrator = " + taken.word + ".");
  for (const LoadStep &step : scene.steps)
    if (step.transient && !scene.time.is_exact() && scene.time.step > step.duration)
      scene.remarks.push_back("Time/Step is longer than step " + step.name +
                              ", all of which is one time step.");
  const bool maps_back =
      taken.value == Integrator::newmark || taken.value == Integrator::generalized_alpha;
  if (!maps_back || scene.solver.is_exact())
    return;
  for (const FrictionSupport &support : scene.supports)
    if (support.restitution > 0.)
      scene.remarks.push_back("Support " + support.name +
                              ": its Restitution is not used with Integrator = " + taken.word +
                              " and Solver/Method = " + scene.solver.row().word +
                              ", which know no impulses; Method = exact does.");
}

} // namespace

void remark_on_unused(ParameterReader &in, Scene &scene) {
  for (const ParameterFile::Section &section : in.file().sections()) {
    in.enter(section.heading);
    const Place at{in, scene, section.heading};
    remark_on(rows_of_parts(), at, scene);
    remark_on(rows_of_settings(), at, scene);
    remark_on_part(at, scene);
  }
  if (std::any_of(scene.steps.begin(), scene.steps.end(),
                  [](const LoadStep &step) { return step.transient; }))
    remark_on_integrator(in, scene);
}

} // namespace frictionbeam
