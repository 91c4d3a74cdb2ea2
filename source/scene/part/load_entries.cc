// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/unit_constants.h"
#include "scene/part/parts.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <map>

namespace frictionbeam::parts {

namespace {

Load::AtPoint parse_force(const ParameterReader &in, const std::string &text, Scene &scene) {
  const std::vector<std::string> words = split(text, ' ');
  if (words.size() != 4 && words.size() != 7)
    in.fail("Forces", "point fx fy fz, or point fx fy fz mx my mz; more after ';'",
            "'P1 0 0 -1000'", "'" + text + "'");
  Load::AtPoint at;
  at.point = words[0];
  check_point(in, "Forces", at.point, scene);
  for (unsigned int i = 1; i < words.size(); ++i)
    if (!to_number(words[i], at.value[i - 1]))
      in.fail("Forces", "a point and numbers", "a number in place of '" + words[i] + "'",
              "'" + text + "'");
    else
      at.value[i - 1] = in.in_bounds("Forces", at.value[i - 1] * in.si(i <= 3 ? "N" : "N m"),
                                     i <= 3 ? "N" : "N m");
  return at;
}

Load::AtPoint parse_displacement(const ParameterReader &in, const std::string &text, Scene &scene) {
  const std::vector<std::string> words = split(text, ' ');
  const std::string form =
      "point, then ux, uy, uz, rx, ry or rz, each with a number; more after ';'";
  if (words.size() < 3 || words.size() % 2 == 0)
    in.fail("Displacements", form, "'P1 ux 0.01'", "'" + text + "'");
  Load::AtPoint at;
  at.point = words[0];
  check_point(in, "Displacements", at.point, scene);
  for (unsigned int i = 1; i < words.size(); i += 2) {
    const unsigned int motion = motion_index(words[i]);
    if (motion == 6 || at.given[motion] || !to_number(words[i + 1], at.value[motion]))
      in.fail("Displacements", form, "another text than '" + words[i] + " " + words[i + 1] + "'",
              "'" + text + "'");
    at.given[motion] = true;
    at.value[motion] =
        in.in_bounds("Displacements", at.value[motion] * (motion >= 3 ? degree : in.si("m")), "m");
  }
  return at;
}

void parse_weight(const ParameterReader &in, Scene &, Load &load) {
  load.vector = in.vector("Acceleration", "m/s2");
}

/// The inertia of what the ground carries along acts like a weight.
void parse_ground_acceleration(const ParameterReader &in, Scene &, Load &load) {
  if (!in.given("Acceleration"))
    in.fail("Acceleration", "the direction and scale of the ground's motion", "'1 0 0'");
  load.vector = -1. * in.vector("Acceleration", "m/s2");
}

void parse_seismic(const ParameterReader &in, Scene &scene, Load &load) {
  constexpr double g = standard_gravity;
  load.vector = g * in.vector("Seismic", "-");
  if (load.vector.norm() == 0.)
    in.fail("Seismic", "a vector that is not zero, in g", "'0.3 0 0.2'");
  constexpr double strongest = 5.; // g
  if (load.vector.norm() > strongest * g)
    scene.doubts.push_back("Load " + load.name + ": Seismic is " + to_text(load.vector.norm() / g) +
                           " g, more than any earthquake. Its unit is g, not m/s2.");
}

void parse_temperature(const ParameterReader &in, Scene &, Load &load) {
  if (!in.given("Temperature"))
    in.fail("Temperature", "the operating temperature [degC]", "set Temperature = 120");
  load.value = in.number("Temperature") - load.installation;
}

void parse_pressure(const ParameterReader &in, Scene &, Load &load) {
  load.value = in.number("Pressure");
}

void parse_wind(const ParameterReader &in, Scene &, Load &load) {
  load.vector = in.number("Shape factor") * in.vector("Wind", "Pa");
  if (load.vector.norm() == 0.)
    in.fail("Wind", "a vector that is not zero, the dynamic pressure", "'500 0 0'");
}

void parse_line_force(const ParameterReader &in, Scene &, Load &load) {
  load.vector = in.vector("Force per length", "N/m");
}

using ParseAtPoint = Load::AtPoint (*)(const ParameterReader &, const std::string &, Scene &);

void parse_points(const ParameterReader &in, const std::string &entry, const ParseAtPoint parse,
                  const std::string &example, Scene &scene, Load &load) {
  for (const std::string &text : split(in.text(entry), ';'))
    if (!text.empty())
      load.at.push_back(parse(in, text, scene));
  if (load.at.empty())
    in.fail(entry, "at least one point", example);
}

void parse_forces(const ParameterReader &in, Scene &scene, Load &load) {
  load.follows = in.flag("Follow");
  if (load.follows && scene.kinematics == Kinematics::linear)
    in.fail("Follow", "forces that follow their point with Kinematics = corotational",
            "set Kinematics = corotational, before the first subsection");
  parse_points(in, "Forces", &parse_force, "'P1 0 0 -1000'", scene, load);
}

void parse_displacements(const ParameterReader &in, Scene &scene, Load &load) {
  parse_points(in, "Displacements", &parse_displacement, "'P1 ux 0.01'", scene, load);
  std::map<std::string, std::array<bool, 6>> given;
  for (Load::AtPoint &at : load.at) {
    at.axes = parse_axes(in);
    std::array<bool, 6> &before = given[at.point];
    for (unsigned int c = 0; c < 6; ++c) {
      if (at.given[c] && before[c])
        in.fail("Displacements", "every motion of a point once",
                "removing one '" + motions[c] + "' of '" + at.point + "'");
      before[c] = before[c] || at.given[c];
    }
  }
}

/// A kind of load as the user calls it; two may be of one kind of the scene.
struct LoadWord {
  const char *word;
  Load::Kind value;
  const char *meaning;
  std::vector<std::string> entries; ///< that others do not have, beside those of the same
  void (*parse)(const ParameterReader &, Scene &, Load &);
};

const LoadWord load_kinds[] = {
    {"weight",
     Load::Kind::weight,
     "of pipes, contents and masses",
     {"Acceleration"},
     &parse_weight},
    {"temperature",
     Load::Kind::temperature,
     "of operation",
     {"Temperature", "Pipes"},
     &parse_temperature},
    {"pressure",
     Load::Kind::pressure,
     "inside, its thrust",
     {"Pressure", "Pipes"},
     &parse_pressure},
    {"force", Load::Kind::force, "at points", {"Forces", "Follow"}, &parse_forces},
    {"line force",
     Load::Kind::line_force,
     "per length of pipe",
     {"Pipes", "Force per length"},
     &parse_line_force},
    {"displacement",
     Load::Kind::displacement,
     "imposed at points",
     {"Displacements", "Axes"},
     &parse_displacements},
    {"ground acceleration",
     Load::Kind::weight,
     "of all supports together, motions are then relative to the ground",
     {"Acceleration"},
     &parse_ground_acceleration},
    {"seismic",
     Load::Kind::weight,
     "static forces of an earthquake, so many g on all that has mass",
     {"Seismic"},
     &parse_seismic},
    {"wind",
     Load::Kind::wind,
     "on the pipe's outer diameter, over its insulation",
     {"Wind", "Shape factor", "Pipes"},
     &parse_wind}};

/// Entries of one kind of load are refused for another.
void check_entries(const ParameterReader &in, const std::string &kind) {
  for (const LoadWord &of : load_kinds)
    for (const std::string &entry : of.entries) {
      std::vector<std::string> kinds;
      for (const LoadWord &one : load_kinds)
        if (std::count(one.entries.begin(), one.entries.end(), entry) > 0)
          kinds.emplace_back(one.word);
      if (in.given(entry) && std::count(kinds.begin(), kinds.end(), kind) == 0)
        in.fail(entry, "this entry with Kind = " + join(kinds), "set Kind = " + kinds[0],
                entry + " = " + in.text(entry) + " with Kind = " + kind);
    }
}

/// Whether a step has inertia.
constexpr Word<bool> analyses[] = {{"static", false}, {"transient", true}};

} // namespace

void declare_load(ParameterReader &in) {
  in.declare_choice("Kind", Load::Kind::weight, load_kinds, "");
  in.declare_text("Acceleration", "0 0 -9.81", "x y z [m/s2]",
                  "Of weight; of the ground for ground acceleration.");
  in.declare_text("Seismic", "0 0 0", "x y z [g], g = 9.80665 m/s2",
                  "Of seismic: the forces are mass times this.");
  in.declare_text("History", "", time_function_form,
                  "Factor on the load; 0 before a table's beginning, its last value after its "
                  "end. In a static step it multiplies the load, which goes evenly from its value "
                  "before the step to that of the step; what a static step does not name goes to "
                  "zero from the value that it had before. Empty: 1.");
  in.declare_choice("History time", TimeFunction::Clock::step, clocks,
                    "Where the time of History begins. step: with the step, or with the first of "
                    "the steps, all transient or all static, that follow each other and name the "
                    "load; run: with the run, of which a static step takes its Duration.");
  in.declare_number("Temperature", 20., "degC", -273.15, 1e300,
                    "Of operation; the pipe expands by its difference from 'Installation "
                    "temperature'.");
  in.declare_number("Pressure", 0., "Pa", -1e300, 1e300, "Inside, above the one outside.");
  in.declare_text(
      "Wind", "0 0 0", "x y z [Pa]",
      "Dynamic pressure of the wind, rho v^2/2, in its direction. A pipe feels the part "
      "across it: q C D |w| w, w that part of the unit vector, D the diameter over its "
      "insulation. It stays that of the pipe as built where displacements are large.");
  in.declare_number("Shape factor", 0.7, "-", 0., 10., "C of wind; 0.7 is usual for cylinders.");
  in.declare_text("Pipes", "", "names of pipes, separated by commas",
                  "Of temperature, pressure, line force and wind; empty: all.");
  in.declare_text("Forces", "", "point fx fy fz [N], or with mx my mz [N m]; more after ';'",
                  "Of force, in global axes.");
  in.declare_flag("Follow", false,
                  "Of force: it turns with its point, as the jet from a broken pipe does; with "
                  "Kinematics = corotational.");
  in.declare_text("Force per length", "0 0 0", "x y z [N/m]", "Of line force, in global axes.");
  in.declare_text(
      "Displacements", "",
      "point, then motions with values: ux uy uz [m], rx ry rz [degrees]; more after ';'",
      "Of displacement, along and about the axes, such as 'P ux 0.01 uz 0; Q ry 1.5'. Motions "
      "that are not named stay free.");
  declare_axes(in, "Of Displacements.");
}

void parse_load(const ParameterReader &in, const std::string &name,
                const double installation_temperature, Scene &scene) {
  const LoadWord &kind = *find_word(load_kinds, in.text("Kind"));
  check_entries(in, kind.word);
  Load load;
  load.name = name;
  load.kind = kind.value;
  load.installation = installation_temperature;
  load.pipes = in.list("Pipes");
  for (const std::string &pipe : load.pipes)
    in.find("Pipes", pipe, names(scene.pipes), "pipe");
  load.history = parse_time_function(in, "History", in.text("History"));
  load.history.clock = in.choice("History time", clocks);
  kind.parse(in, scene, load);
  scene.loads.push_back(load);
}

namespace {
constexpr Word<bool> searches[] = {
    {"nothing", false, "the step ends with all of its loads"},
    {"limit", true,
     "with the largest part of them that is carried by pipes which yield or, with Kinematics = "
     "corotational, by elastic ones that snap or buckle. Increments are motions along the path of "
     "equilibria, halved up to 'Max halvings' times near the limit; of pipes that yield with "
     "contacts or with a History, they are parts of the loads, halved as often. Quantities "
     "limit_factor and limit_bound say what it is"}};
}

void declare_step(ParameterReader &in) {
  in.declare_text(
      "Loads", "", "names of loads, separated by commas, each with a factor [-] if not 1",
      "All loads that act at the end of the step, such as 'weight, hot 0.5'. Loads of "
      "the step before that are not named go back to zero. Steps are taken in the order "
      "of the file.");
  in.declare_text("From", "", "name of an earlier step",
                  "The step starts from the state at the end of that one, as if those between had "
                  "not been; empty: of the step before it in the file.");
  in.declare_count("Increments", 1, 1, "Of a static step: how many pieces the change is cut into.");
  in.declare_choice("Analysis", false, analyses, "Without or with inertia.");
  in.declare_choice("Find", false, searches, "");
  in.declare_count(
      "Repeat", 1, 1,
      "How often the steps from 'Repeat from' to this one are taken in all, as cycles "
      "of loads. Those of the second cycle are called 'NAME (2)', and so on. Pipes that "
      "yield get a verdict: shakedown, alternating plasticity or ratchet.");
  in.declare_text("Repeat from", "", "name of a step", "Where the cycle begins; empty: this step.");
  in.declare_number("Duration", 1., "s", positive, 1e300,
                    "Of a static step, the time that laws and quantities see.");
  in.declare_number("Ramp", 0., "s", 0., 1e300,
                    "Of a transient step: time in which the loads reach their values; 0: at once.");
}

namespace {

/// Append the cycles after the first of the step that was read last.
void repeat_steps(const ParameterReader &in, Scene &scene) {
  constexpr unsigned int most_steps = 10000;
  const unsigned int n = in.count("Repeat"), last = scene.steps.size() - 1;
  if (n == 1 && in.given("Repeat from"))
    in.fail("Repeat from", "this entry with Repeat = 2 or more", "'set Repeat = 10'");
  if (n == 1)
    return;
  const unsigned int first = in.text("Repeat from").empty()
                                 ? last
                                 : in.find("Repeat from", in.text("Repeat from"),
                                           names(scene.steps), "step up to this one");
  if (n * (last + 1 - first) > most_steps)
    in.fail("Repeat", "at most " + std::to_string(most_steps) + " steps in all", "fewer cycles");
  const LoadStep &only = scene.steps[last];
  if (first == last && !only.transient &&
      std::none_of(only.loads.begin(), only.loads.end(),
                   [&](const auto &load) { return scene.loads[load.first].history.is_given(); }))
    in.fail("Repeat", "cycles in which loads change", "'Repeat from = NAME' of an earlier step",
            "a static step that repeats itself alone, without History");
  for (unsigned int s = first; s <= last; ++s) {
    LoadStep &step = scene.steps[s];
    if (step.cycle.number > 0)
      in.fail("Repeat from", "steps that are not repeated already", "a later step", step.name);
    if (step.finds_limit)
      in.fail("Repeat", "steps with Find = nothing", "a step of its own for the limit", step.name);
    if (s > first && is_branch(scene, s))
      in.fail("From", "steps of a cycle that follow each other; its first may start elsewhere",
              "leaving it out", step.name);
    step.cycle = {1, n, s == first, s == last};
  }
  for (unsigned int k = 2; k <= n; ++k)
    for (unsigned int s = first; s <= last; ++s) {
      LoadStep step = scene.steps[s];
      step.name += " (" + std::to_string(k) + ")";
      step.cycle.number = k;
      step.from.reset();
      scene.steps.push_back(step);
    }
}

} // namespace

void parse_step(const ParameterReader &in, const std::string &name, Scene &scene) {
  LoadStep step;
  step.name = name;
  for (const std::string &item : in.list("Loads")) {
    const std::vector<std::string> words = split(item, ' ');
    double factor = 1.;
    if (words.size() > 2 || (words.size() == 2 && !to_number(words[1], factor)))
      in.fail("Loads", "names of loads with factors, separated by commas", "'weight, hot 0.5'",
              "'" + item + "'");
    const unsigned int load = in.find("Loads", words[0], names(scene.loads), "load");
    for (const auto &present : step.loads)
      if (present.first == load)
        in.fail("Loads", "every load once", "one factor for '" + words[0] + "'");
    step.loads.emplace_back(load, factor);
  }
  if (const std::string from = in.text("From"); !from.empty())
    step.from =
        in.find("From", from, names(scene.steps), "step that stands before this one in the file");
  if (step.from && scene.steps[*step.from].cycle.number == 1) {
    const std::string last = scene.steps[*step.from].name + " (" +
                             std::to_string(scene.steps[*step.from].cycle.of) + ")";
    scene.remarks.push_back("Step " + name + " starts from the end of " +
                            scene.steps[*step.from].name +
                            " in its first cycle; the last one is called '" + last + "'.");
  }
  step.n_increments = in.count("Increments");
  step.transient = in.choice("Analysis", analyses);
  step.finds_limit = in.choice("Find", searches);
  step.duration = in.number("Duration");
  step.ramp = in.number("Ramp");
  if (step.transient && in.given("Increments"))
    in.fail("Increments", "Increments of static steps", "'Step' in section Time instead");
  if (step.finds_limit && step.transient)
    in.fail("Find", "nothing, for a transient step", "Analysis = static");
  if (!step.transient && in.given("Ramp"))
    in.fail("Ramp", "Ramp of transient steps; a static one changes evenly to its end",
            "Analysis = transient, or removing 'Ramp'");
  if (step.ramp > step.duration)
    in.fail("Ramp", "at most the step's Duration, " + to_text(step.duration) + " s",
            "a shorter ramp");
  scene.steps.push_back(step);
  repeat_steps(in, scene);
}

} // namespace frictionbeam::parts
