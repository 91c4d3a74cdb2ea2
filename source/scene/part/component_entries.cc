// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_entries.h"
#include "scene/law_entries.h"
#include "scene/part/parts.h"

#include <algorithm>

namespace frictionbeam::parts {

namespace {

constexpr Word<TeeKind> tee_kinds[] = {
    {"welding tee", TeeKind::welding},       {"reinforced", TeeKind::reinforced},
    {"unreinforced", TeeKind::unreinforced}, {"extruded", TeeKind::extruded},
    {"welded-in", TeeKind::welded_in},       {"integrally reinforced", TeeKind::integral}};

/// Whether a hanger is constant, and what the list of reactions calls its springs.
struct HangerKind {
  const char *word;
  bool value;
  const char *meaning, *of_spring;
};
constexpr HangerKind hanger_kinds[] = {
    {"variable", false, "a spring", "spring hanger"},
    {"constant", true, "the same force wherever the pipe goes", "constant hanger"}};

/// "rigid" or a stiffness > 0.
double parse_stiffness(const ParameterReader &in, const std::string &entry,
                       const std::string &unit) {
  const std::string text = in.text(entry);
  double value;
  if (text == "rigid")
    return Joint::rigid;
  if (!to_number(text, value) || value <= 0.)
    in.fail(entry, "rigid, or a number > 0 [" + unit + "]", "rigid");
  return in.in_bounds(entry, value * in.si(unit), unit);
}

std::string parse_point_on(const ParameterReader &in, Scene &scene) {
  const std::string point = in.text("At");
  check_point(in, "At", point, scene);
  return point;
}

} // namespace

void declare_joint(ParameterReader &in) {
  in.declare_text("At", "", "name of a point", "Where the joint is; it has no length.");
  in.declare_text(
      "Pipe", "", "name of a pipe",
      "Which it belongs to: the joint is between the point and this pipe's run after it "
      "(before it, at the pipe's end). May be left out if there is only one.");
  in.declare_text("Axial", "rigid", "rigid, or a number > 0 [N/m]", "Stiffness along the pipe.");
  in.declare_text("Lateral", "rigid", "rigid, or a number > 0 [N/m]", "Stiffness across the pipe.");
  in.declare_text("Bending", "rigid", "rigid, or a number > 0 [N m/rad]",
                  "Stiffness about both axes across the pipe; small: a hinge.");
  in.declare_text("Torsion", "rigid", "rigid, or a number > 0 [N m/rad]",
                  "Stiffness about the pipe.");
  in.declare_number("Thrust area", 0., "m2", 0., 1e300,
                    "Of a bellows: pressure times this area pushes its two sides apart.");
}

void parse_joint(const ParameterReader &in, const std::string &name, Scene &scene) {
  Joint joint;
  joint.name = name;
  joint.kind = "joint";
  joint.point = parse_point_on(in, scene);
  joint.pipe = in.text("Pipe");
  if (joint.pipe.empty() && scene.pipes.size() == 1)
    joint.pipe = scene.pipes.front().name;
  in.find("Pipe", joint.pipe, names(scene.pipes), "pipe");
  joint.axial = parse_stiffness(in, "Axial", "N/m");
  joint.lateral = parse_stiffness(in, "Lateral", "N/m");
  joint.bending = parse_stiffness(in, "Bending", "N m/rad");
  joint.torsion = parse_stiffness(in, "Torsion", "N m/rad");
  joint.thrust_area = in.number("Thrust area");
  if (joint.thrust_area > 0. && joint.axial == Joint::rigid)
    in.fail("Thrust area", "a thrust area of a joint that yields along the pipe",
            "'Axial', the stiffness of the bellows");
  scene.joints.push_back(joint);
}

void declare_tee(ParameterReader &in) {
  in.declare_text("At", "", "name of a point", "Where the branch leaves the run.");
  in.declare_text("Branch", "", "name of a pipe", "The branch, which begins or ends there.");
  in.declare_choice("Kind", TeeKind::welding, tee_kinds,
                    "For the stress intensification factors of ASME B31.3, appendix D.");
  in.declare_number("Pad", 0., "m", 0., 1e300, "Thickness of a reinforced tee's pad.");
  in.declare_number("Crotch radius", 0., "m", 0., 1e300, "Of an extruded or welding tee.");
  in.declare_text("Flexibility", "rigid",
                  "rigid, code, or in-plane and out-of-plane stiffness "
                  "[N m/rad]",
                  "Of the branch's foot. rigid: as B31.3 has it; code: the springs of ASME III "
                  "NB-3686.5 for branch connections.");
}

namespace {

/// The springs of a branch's foot by ASME III NB-3686.5 [N m/rad]: theta = k M d/(E I_b), d the
/// branch's and D the run's outer diameter (doc/theory.md, "Joints").
void give_springs_of_code(const ParameterReader &in, const Tee &tee, const Scene &scene,
                          Joint &joint) {
  const auto of_point = std::find_if(scene.pipes.begin(), scene.pipes.end(), [&](const Pipe &p) {
    return p.name != tee.branch &&
           std::any_of(p.route.begin(), p.route.end(),
                       [&](const RoutePoint &r) { return r.name == tee.point; });
  });
  const Pipe &branch = scene.pipes[in.find("Branch", tee.branch, names(scene.pipes), "pipe")];
  const Section &b = scene.sections[branch.section];
  if (of_point == scene.pipes.end() || b.wall == 0. || scene.sections[of_point->section].wall == 0.)
    in.fail("Flexibility",
            "code where the run has a point of that name, and run and branch give "
            "'Outer diameter' and 'Wall'",
            "two numbers, or rigid");
  const Section &r = scene.sections[of_point->section];
  const double d = 2. * b.outer_radius, D = 2. * r.outer_radius;
  const double root = std::sqrt(r.wall / b.wall * d / D) * b.wall / r.wall;
  const double stiffness = scene.materials[branch.material].youngs_modulus * b.inertia / d;
  joint.out_of_plane = stiffness / (0.1 * std::pow(D / r.wall, 1.5) * root);
  joint.in_plane = stiffness / (0.2 * D / r.wall * root);
}

} // namespace

void parse_tee(const ParameterReader &in, const std::string &name, Scene &scene) {
  Tee tee;
  tee.name = name;
  tee.point = parse_point_on(in, scene);
  tee.branch = in.text("Branch");
  in.find("Branch", tee.branch, names(scene.pipes), "pipe");
  tee.kind = in.choice("Kind", tee_kinds);
  tee.pad = in.number("Pad");
  tee.crotch_radius = in.number("Crotch radius");
  scene.tees.push_back(tee);

  const std::string flexibility = in.text("Flexibility");
  if (flexibility == "rigid")
    return;
  Joint joint;
  joint.name = name;
  joint.kind = "tee";
  joint.point = tee.point;
  joint.pipe = tee.branch;
  if (flexibility == "code") {
    give_springs_of_code(in, tee, scene, joint);
  } else {
    const std::vector<double> values = in.numbers("Flexibility");
    if (values.size() != 2 || values[0] <= 0. || values[1] <= 0.)
      in.fail("Flexibility", "rigid, code, or two numbers > 0 [N m/rad]", "code");
    joint.in_plane = in.in_bounds("Flexibility", values[0] * in.si("N m/rad"), "N m/rad");
    joint.out_of_plane = in.in_bounds("Flexibility", values[1] * in.si("N m/rad"), "N m/rad");
  }
  scene.joints.push_back(joint);
}

void declare_hanger(ParameterReader &in) {
  in.declare_choice("Kind", false, hanger_kinds, "");
  in.declare_text("At", "", "names of points, separated by commas", "One such hanger at each.");
  in.declare_number("Stiffness", 0., "N/m", 0., 1e300,
                    "Of a variable hanger; 0, without Cold load: sized, for 'Variation'.");
  in.declare_number("Cold load", 0., "N", 0., 1e300,
                    "Its force before anything has moved; 0: sized, so that it carries the "
                    "weight when the line is hot.");
  in.declare_text("Item", "", "name of an item of Catalogue/Hangers, or by load",
                  "Whose stiffness and range of loads it has. by load: the first of the table that "
                  "carries hot and cold load with no more than 'Variation'; of constant hangers "
                  "(Catalogue/Constant hangers) the first that carries the load and has the "
                  "travel.");
  in.declare_text("Direction", "0 0 1", "x y z [-]",
                  "Of its force on the pipe, and of its stiffness: a hanger that pulls askew.");
  in.declare_number("Variation", 0.25, "-", positive, 1.,
                    "Largest change of load between hot and cold over the hot load: what it is "
                    "sized for, and a check.");
  in.declare_text("Weight step", "", "name of a step",
                  "With the weight that a sized hanger carries; empty: the first step.");
  in.declare_text("Hot step", "", "name of a step",
                  "With the travel that it must follow; empty: the second step, or the first if "
                  "there is only one.");
}

void parse_hanger(const ParameterReader &in, const std::string &name, Scene &scene) {
  Hanger hanger;
  hanger.name = name;
  hanger.points = points_at(in, scene);
  if (hanger.points.empty())
    in.fail("At", "at least one point", "the name of a point");
  const HangerKind &kind = *find_word(hanger_kinds, in.text("Kind"));
  hanger.constant = kind.value;
  hanger.stiffness = in.number("Stiffness");
  hanger.cold_load = in.number("Cold load");
  if (hanger.constant && hanger.stiffness > 0.)
    in.fail("Stiffness", "no stiffness of a constant hanger", "Kind = variable");
  if (hanger.stiffness > 0. && hanger.cold_load == 0.)
    in.fail("Cold load", "a load > 0 beside a stiffness, or neither for a sized hanger",
            "the cold load, or removing 'Stiffness'");
  parse_item_of_hanger(in, scene, hanger);
  if (!hanger.constant && hanger.cold_load > 0. && hanger.stiffness == 0.)
    in.fail("Stiffness", "a stiffness > 0 beside a Cold load, or neither for a sized hanger",
            "the stiffness; removing 'Cold load', which sizes both; or Kind = constant");
  hanger.largest_variation = in.number("Variation");
  hanger.weight_step = in.text("Weight step");
  hanger.hot_step = in.text("Hot step");
  for (unsigned int i = 0; i < hanger.points.size(); ++i) {
    Spring spring; // of a sized one, stiffness and preload follow
    spring.name = hanger.points.size() > 1 ? name + "." + std::to_string(i + 1) : name;
    spring.kind = kind.of_spring;
    spring.point = hanger.points[i];
    const Vector3 direction = parse_unit_vector(in, "Direction");
    for (unsigned int d = 0; d < 3; ++d)
      spring.directions[2][d] = direction[d];
    spring.stiffness[2] = hanger.stiffness;
    spring.preload = hanger.cold_load;
    hanger.springs.push_back(scene.springs.size());
    scene.springs.push_back(spring);
  }
  scene.hangers.push_back(hanger);
}

void check_hangers(const ParameterReader &in, Scene &scene) {
  const std::vector<std::string> steps = names(scene.steps);
  for (Hanger &hanger : scene.hangers) {
    for (std::string *step : {&hanger.weight_step, &hanger.hot_step}) {
      if (step->empty())
        *step = step == &hanger.weight_step ? steps.front()
                                            : steps[std::min<std::size_t>(1, steps.size() - 1)];
      if (std::count(steps.begin(), steps.end(), *step) == 0)
        in.fail_section("step '" + *step + "' of hanger " + hanger.name,
                        "a step of this file: " + join(steps), "one of these");
    }
  }
}

void add_preload(Scene &scene) {
  if (scene.hangers.empty())
    return;
  Load load;
  load.name = "of hangers";
  load.kind = Load::Kind::preload;
  scene.loads.push_back(load);
}

void declare_nozzle(ParameterReader &in) {
  in.declare_text("Support", "", "name of an anchor, restraint or spring",
                  "Whose forces are compared. Of one that stands at several points: name.1, ...");
  in.declare_text("Allowed", "", "fx fy fz [N] mx my mz [N m], none negative",
                  "Largest absolute values, global axes; 0: no limit.");
}

void parse_nozzle(const ParameterReader &in, const std::string &name, Scene &scene) {
  NozzleLimit nozzle;
  nozzle.name = name;
  nozzle.support = in.text("Support");
  std::vector<std::string> known = names(scene.restraints);
  for (const Spring &spring : scene.springs)
    known.push_back(spring.name);
  in.find("Support", nozzle.support.substr(0, nozzle.support.find('.')), known, "anchor");
  const std::vector<double> values = in.numbers("Allowed");
  if (values.size() != 6 || *std::min_element(values.begin(), values.end()) < 0. ||
      *std::max_element(values.begin(), values.end()) == 0.)
    in.fail("Allowed", "six numbers >= 0, at least one of them > 0",
            "'10000 10000 10000 8000 8000 8000'");
  for (unsigned int i = 0; i < 6; ++i)
    nozzle.allowed[i] =
        in.in_bounds("Allowed", values[i] * in.si(i < 3 ? "N" : "N m"), i < 3 ? "N" : "N m");
  scene.nozzles.push_back(nozzle);
}

void declare_stress(ParameterReader &in) {
  in.declare_text("Code", "none", "none, B31.3, or the name of a code in 'Code libraries'",
                  "By which stresses are judged.");
  in.declare_text(
      "Code libraries", "", "paths of .so files, separated by commas",
      "Shared libraries with stress codes of your own, from the parameter file's folder "
      "or the folder the program runs in.");
  in.declare_text("Sustained", "", "names of steps, separated by commas",
                  "With weight and pressure: SL against Sh.");
  in.declare_text("Expansion", "", "pairs 'step to step', separated by commas",
                  "Whose difference is a displacement stress range, such as 'weight to heat': SE "
                  "against SA.");
  in.declare_text("Occasional", "", "names of steps, separated by commas",
                  "With wind or earthquake as well: SL against 1.33 Sh.");
  in.declare_number("Cycles factor", 1., "-", positive, 1.2, "f of the allowable range SA.");
  in.declare_flag("Liberal", false, "SA = f (1.25 (Sc + Sh) - SL), with the sustained SL.");
  in.declare_number("Occasional factor", 1.33, "-", 1., 3., "Of Sh.");
}

namespace {

/// The codes of the program and of the user.
std::shared_ptr<const StressCodeLibrary> load_codes(const ParameterReader &in) {
  const auto codes = std::make_shared<StressCodeLibrary>();
  codes->load_builtin();
  load_libraries(in, "Code libraries", "a stress code of this version",
                 [&](const std::string &path) { codes->load(path); });
  return codes;
}

} // namespace

void parse_stress(const ParameterReader &in, Scene &scene) {
  StressSettings &stress = scene.stress;
  if (in.text("Code") != "none") {
    stress.code = in.text("Code");
    stress.codes = load_codes(in);
    std::vector<std::string> allowed = stress.codes->names();
    allowed.emplace_back("none");
    if (stress.codes->find(stress.code) == nullptr) {
      const std::string like = nearest(stress.code, allowed);
      in.fail("Code", join(allowed),
              like.empty() ? "the library that has it, in 'Code libraries'" : "'" + like + "'");
    }
  }
  const std::vector<std::string> known = case_names(scene);
  const auto find_case = [&](const std::string &entry, const std::string &name) {
    in.find(entry, name, known, "step");
    for (const Combination &one : scene.combinations)
      if (one.name == name &&
          (one.kind == Combination::Kind::maximum || one.kind == Combination::Kind::minimum))
        in.fail(entry, "no maximum or minimum, which has one side of the forces alone",
                "a combination of kind envelope", "'" + name + "'");
  };
  const auto steps = [&](const std::string &entry) {
    const std::vector<std::string> list = in.list(entry);
    for (const std::string &step : list)
      find_case(entry, step);
    return list;
  };
  stress.sustained = steps("Sustained");
  stress.occasional = steps("Occasional");
  for (const std::string &pair : in.list("Expansion")) {
    const std::vector<std::string> words = split_names(pair);
    if (words.size() != 3 || words[1] != "to")
      in.fail("Expansion", "pairs 'step to step', separated by commas", "'weight to heat'",
              "'" + pair + "'");
    find_case("Expansion", words[0]);
    find_case("Expansion", words[2]);
    stress.expansion.emplace_back(words[0], words[2]);
  }
  stress.cycles_factor = in.number("Cycles factor");
  stress.liberal = in.flag("Liberal");
  stress.occasional_factor = in.number("Occasional factor");
  if (stress.code.empty())
    return;
  if (stress.sustained.empty() && stress.occasional.empty() && stress.expansion.empty())
    in.fail("Sustained", "at least one of Sustained, Expansion, Occasional",
            "set Sustained = " + known.front());
  for (const Pipe &pipe : scene.pipes) {
    const Material &material = scene.materials[pipe.material];
    if (material.allowable_cold == 0. || material.allowable_hot == 0.)
      in.fail("Code", "materials with 'Allowable cold' and 'Allowable hot'",
              "these two entries in section 'Material " + material.name + "'");
    if (scene.sections[pipe.section].wall == 0.)
      in.fail("Code", "sections with 'Outer diameter' and 'Wall'",
              "these in section 'Section " + scene.sections[pipe.section].name + "'");
  }
}

} // namespace frictionbeam::parts
