// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

double Spectrum::at(const double frequency, const bool logarithmic) const {
  if (frequency <= curve.front().first)
    return curve.front().second;
  if (frequency >= curve.back().first)
    return curve.back().second;
  const auto after = std::upper_bound(
      curve.begin(), curve.end(), frequency,
      [](const double f, const std::pair<double, double> &point) { return f < point.first; });
  const auto [f0, a0] = *(after - 1);
  const auto [f1, a1] = *after;
  if (logarithmic && f0 > 0. && a0 > 0. && a1 > 0.)
    return a0 * std::pow(a1 / a0, std::log(frequency / f0) / std::log(f1 / f0));
  return a0 + (a1 - a0) * (frequency - f0) / (f1 - f0);
}

namespace parts {

namespace {

constexpr Word<bool> mass_matrices[] = {
    {"consistent", false, "of the elements, with rotary inertia"},
    {"lumped", true, "half the mass of each cell at either end, without rotary inertia"}};
constexpr Word<bool> modal_frictions[] = {
    {"as in the step", true, "a sticking support holds sideways too, a slipping one does not"},
    {"off", false, "none does"}};

using ModeSum = SpectrumSettings::Modes;
constexpr Word<ModeSum> mode_sums[] = {
    {"srss", ModeSum::srss, "square root of the sum of squares"},
    {"cqc", ModeSum::cqc,
     "complete quadratic combination, which sees that close modes act together"},
    {"absolute", ModeSum::absolute, "sum of absolute values"}};
using SpectrumSum = SpectrumSettings::Sum;
constexpr Word<SpectrumSum> spectrum_sums[] = {{"srss", SpectrumSum::srss},
                                               {"absolute", SpectrumSum::absolute}};
constexpr Word<bool> interpolations[] = {{"log-log", true}, {"linear", false}};

using CombinationKind = Combination::Kind;
constexpr Word<CombinationKind> combination_kinds[] = {
    {"sum", CombinationKind::sum,
     "with the cases' factors, those that are sizes (spectrum, range, srss, absolute) with either "
     "sign, so that they add to what has the larger size"},
    {"range", CombinationKind::range, "largest minus smallest"},
    {"envelope", CombinationKind::envelope, "that of largest size"},
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
  if (scene.spectra.empty())
    return;
  if (scene.modal.n_modes == 0)
    in.fail("Number", "a number of modes > 0 beside a Spectrum", "set Number = 10");
  if (in.given("Friction") && scene.modal.friction_holds)
    in.fail("Friction", "off beside a Spectrum: the method is linear", "set Friction = off");
  scene.modal.friction_holds = false;
}

void declare_spectrum(ParameterReader &in) {
  in.declare_text("Curve", "", "f a; f a; ...: frequency [Hz] and acceleration [m/s2], rising f",
                  "Acceleration of the supports as an oscillator of that frequency feels it.");
  in.declare_text("Directions", "x, y, z", "x, y, z, each with a factor [-] if not 1",
                  "In which the supports move so, each by itself.");
  in.declare_text("Supports", "", "names of supports and springs, separated by commas",
                  "The group that moves so; the others stand still. Empty: all move together.");
}

void parse_spectrum(const ParameterReader &in, const std::string &name, Scene &scene) {
  Spectrum spectrum;
  spectrum.name = name;
  const std::string form = "pairs 'frequency acceleration' separated by ';', frequencies rising";
  for (const std::string &pair : split(in.text("Curve"), ';')) {
    if (pair.empty())
      continue;
    const std::vector<std::string> words = split(pair, ' ');
    double f, a;
    if (words.size() != 2 || !to_number(words[0], f) || !to_number(words[1], a) || f < 0. ||
        a < 0. || (!spectrum.curve.empty() && f <= spectrum.curve.back().first))
      in.fail("Curve", form, "'1 2.5; 10 4; 33 1.5'", "'" + pair + "'");
    spectrum.curve.emplace_back(f, a * in.si("m/s2"));
  }
  if (spectrum.curve.empty())
    in.fail("Curve", form, "'1 2.5; 10 4; 33 1.5'");
  spectrum.factor = {{0., 0., 0.}};
  for (const std::string &item : in.list("Directions")) {
    const std::vector<std::string> words = split(item, ' ');
    double factor = 1.;
    const auto axis = std::string("xyz").find(words[0]);
    if (words[0].size() != 1 || axis == std::string::npos || words.size() > 2 ||
        (words.size() == 2 && !to_number(words[1], factor)))
      in.fail("Directions", "x, y, z, each with a factor if not 1", "'x, y, z 0.667'",
              "'" + item + "'");
    spectrum.factor[axis] = factor;
  }
  spectrum.supports = in.list("Supports");
  std::vector<std::string> known = names(scene.supports);
  for (const auto *list : {&scene.restraints})
    for (const Restraint &restraint : *list)
      known.push_back(restraint.name);
  for (const Spring &spring : scene.springs)
    known.push_back(spring.name);
  for (const std::string &support : spectrum.supports)
    in.find("Supports", support, known, "support");
  scene.spectra.push_back(spectrum);
}

void declare_response(ParameterReader &in) {
  in.declare_choice("Modes", ModeSum::srss, mode_sums, "How modes are combined.");
  in.declare_choice("Directions", SpectrumSum::srss, spectrum_sums, "How directions are combined.");
  in.declare_choice("Groups", SpectrumSum::absolute, spectrum_sums,
                    "How groups of supports are combined, in each mode and direction.");
  in.declare_choice("Interpolation", true, interpolations, "Of spectra.");
  in.declare_number("Damping", 0.05, "-", positive, 1., "Ratio to critical, of cqc.");
  in.declare_flag("Missing mass", false,
                  "Add the static response to what the modes leave out, at the acceleration of the "
                  "spectrum's last point.");
}

void parse_response(const ParameterReader &in, Scene &scene) {
  SpectrumSettings &s = scene.response;
  s.modes = in.choice("Modes", mode_sums);
  s.directions = in.choice("Directions", spectrum_sums);
  s.groups = in.choice("Groups", spectrum_sums);
  s.logarithmic = in.choice("Interpolation", interpolations);
  s.damping = in.number("Damping");
  s.missing_mass = in.flag("Missing mass");
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
    const std::vector<std::string> words = split(item, ' ');
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
