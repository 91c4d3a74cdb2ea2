// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <algorithm>

namespace frictionbeam {

namespace parts {

namespace {

constexpr Word<bool> mass_matrices[] = {
    {"consistent", false, "of the elements, with rotary inertia"},
    {"lumped", true, "half the mass of each cell at either end, without rotary inertia"}};
constexpr Word<bool> modal_frictions[] = {
    {"as in the step", true, "a sticking support holds sideways too, a slipping one does not"},
    {"off", false, "none does"}};

using CombinationKind = Combination::Kind;
constexpr Word<CombinationKind> combination_kinds[] = {
    {"sum", CombinationKind::sum,
     "with the cases' factors, those that are sizes (spectrum, range, srss, absolute) with either "
     "sign, so that they add to what has the larger size"},
    {"range", CombinationKind::range, "largest minus smallest"},
    {"envelope", CombinationKind::envelope, "that of largest size, with its sign"},
    {"maximum", CombinationKind::maximum, "the largest, whatever its sign"},
    {"minimum", CombinationKind::minimum, "the smallest, likewise"},
    {"srss", CombinationKind::srss, "square root of the sum of squares"},
    {"absolute", CombinationKind::absolute, "sum of absolute values"}};

} // namespace

void declare_modes(ParameterReader &in) {
  in.declare_count("Number", 0, 0, "Of modes, from the lowest frequency on; 0: none.", 10000);
  in.declare_choice("Mass", false, mass_matrices, "");
  in.declare_text(
      "Step", "", "name of a step",
      "Which supports hold is decided by the contacts at its end: an open one does not, "
      "a closed one holds along its normal. Empty: the last static step.");
  in.declare_choice("Friction", true, modal_frictions, "", "With a Spectrum it is off.");
}

void parse_modes(const ParameterReader &in, Scene &scene) {
  scene.modal.n_modes = in.count("Number");
  scene.modal.lumped = in.choice("Mass", mass_matrices);
  scene.modal.friction_holds = in.choice("Friction", modal_frictions);
  scene.modal.step = in.text("Step");
}

void check_modes(const ParameterReader &in, Scene &scene) {
  if (!scene.modal.step.empty())
    in.find("Step", scene.modal.step, names(scene.steps), "step");
  else if (scene.modal.n_modes > 0 && !scene.steps.empty() &&
           std::all_of(scene.steps.begin(), scene.steps.end(),
                       [](const LoadStep &step) { return step.transient; }))
    in.fail("Step", "the name of a step, where none is static: modes are those about its end",
            "set Step = " + scene.steps.front().name);
  if (scene.spectra.empty())
    return;
  if (scene.modal.n_modes == 0)
    in.fail("Number", "a number of modes > 0 beside a Spectrum", "set Number = 10");
  if (in.given("Friction") && scene.modal.friction_holds)
    in.fail("Friction", "off beside a Spectrum: the method is linear", "set Friction = off");
  scene.modal.friction_holds = false;
}

void declare_combination(ParameterReader &in) {
  in.declare_choice("Kind", CombinationKind::sum, combination_kinds,
                    "Of displacements, forces and reactions, component by component.");
  in.declare_text("Cases", "", "names of steps or combinations, each with a factor if not 1",
                  "What is combined, after the load sequence: 'hot, cold -1'. The result of the "
                  "spectra is called 'spectrum'. Of a transient step, the least and the largest "
                  "value of each component over the step count.");
}

void parse_combination(const ParameterReader &in, const std::string &name, Scene &scene) {
  Combination combination;
  combination.name = name;
  combination.kind = in.choice("Kind", combination_kinds);
  const std::vector<std::string> known = case_names(scene);
  for (const std::string &item : in.list("Cases")) {
    const std::vector<std::string> words = split_names(item);
    double factor = 1.;
    if (words.size() > 2 || (words.size() == 2 && !to_number(words[1], factor)))
      in.fail("Cases", "names of cases, each with a factor if not 1", "'hot, cold -1'",
              "'" + item + "'");
    in.find("Cases", words[0], known, "case");
    combination.cases.emplace_back(words[0], factor);
  }
  if (combination.cases.empty())
    in.fail("Cases", "at least one case", "'hot, cold -1'");
  if (std::count(known.begin(), known.end(), name) > 0)
    in.fail_section("'" + name + "'", "a name that no step or combination before has",
                    "another name");
  scene.combinations.push_back(combination);
}

std::vector<std::string> case_names(const Scene &scene) {
  std::vector<std::string> result = names(scene.steps);
  if (!scene.spectra.empty())
    result.emplace_back(spectrum_case);
  for (const Combination &combination : scene.combinations)
    result.push_back(combination.name);
  return result;
}

void check_output(ParameterReader &in, const Scene &scene) {
  in.enter("Output");
  for (const std::string &step : scene.output.steps)
    in.find("Steps", step, case_names(scene), "step or case");
}

} // namespace parts

} // namespace frictionbeam
