// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include "scene/law_entries.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::parts {

const std::vector<std::string> motions = {"ux", "uy", "uz", "rx", "ry", "rz"};

namespace {

/// What a kind of support is made of.
enum class Form {
  restraint, ///< motions held exactly
  pair,      ///< friction elements from either side, or a restraint without gap and friction
  element    ///< one friction element
};
struct SupportKind {
  const char *word;
  Form value;
  const char *meaning;
  bool slides = false; ///< with friction, unless its coefficient is given
  const char *law = "coulomb";
};
constexpr SupportKind kinds[] = {
    {"anchor", Form::restraint, "all six motions held"},
    {"restraint", Form::restraint, "those in Fixed"},
    {"guide", Form::pair, "no motion sideways (horizontal, across the pipe, or along Normal)"},
    {"line stop", Form::pair, "none along the pipe, or along Normal"},
    {"stop", Form::pair, "none along Normal, either way"},
    {"rest", Form::element, "stands under the pipe, lifts off, slides with friction", true},
    {"rod", Form::element,
     "carries the pipe along Normal without friction, goes slack when it rises"},
    {"friction", Form::element, "as rest, with any normal", true},
    {"snubber", Form::element,
     "nothing in static steps, holds along Normal in vibrations, by the law of that name", true,
     "snubber"}};

/// Of an entry that may not have been checked yet.
const SupportKind &kind_of(const std::string &word) {
  const auto row = find_word(kinds, word);
  return row == std::end(kinds) ? *find_word(kinds, "rest") : *row;
}

/// Friction coefficients in use for sliding pairs; a design takes its supplier's.
constexpr double no_pad = -1.;
constexpr Word<double> pads[] = {{"none", no_pad},   {"steel", 0.3},    {"ptfe", 0.1},
                                 {"graphite", 0.15}, {"concrete", 0.5}, {"roller", 0.03}};

using Rotations = FrictionSupport::Rotations;
constexpr Word<Rotations> rotations[] = {
    {"none", Rotations::none}, {"averaged", Rotations::averaged}, {"pipe", Rotations::pipe}};

const std::vector<std::string> element_entries = {
    "Law",          "Normal", "Length",      "Rotations",     "Torsion",
    "Normal force", "Ground", "Restitution", "Ground motion", "Ground motion time"};

const std::string rigidity = "Axial rigidity"; // of coulomb; without it, rigid

bool is_restraint(const std::string &kind) { return kind_of(kind).value == Form::restraint; }
bool is_pair(const std::string &kind) { return kind_of(kind).value == Form::pair; }

double friction_of(const std::string &pad, const double otherwise) {
  const auto row = find_word(pads, pad);
  return row == std::end(pads) || row->value == no_pad ? otherwise : row->value;
}

std::string default_law(const std::string &kind) { return kind_of(kind).law; }

} // namespace

unsigned int motion_index(const std::string &name) {
  return std::find(motions.begin(), motions.end(), name) - motions.begin();
}

std::array<bool, 6> parse_motions(const ParameterReader &in, const std::string &entry) {
  std::array<bool, 6> result{};
  for (const std::string &name : in.list(entry)) {
    const unsigned int i = motion_index(name);
    if (i == 6)
      in.fail(entry, "motions out of " + join(motions) + ", separated by commas",
              "one of these in place of '" + name + "'");
    if (result[i])
      in.fail(entry, "each motion once",
              "leaving the second " + name + " out, or what it was meant for");
    result[i] = true;
  }
  return result;
}

void declare_support(ParameterReader &in, const LawLibrary &laws) {
  const std::string kind = in.raw("Kind", "rest");
  in.declare_choice("Kind", Form::element, kinds, ""); // the first such: rest
  declare_placement(in);
  in.declare_text(
      "Fixed", kind == "restraint" ? "ux, uy, uz" : "ux, uy, uz, rx, ry, rz",
      "motions out of ux, uy, uz, rx, ry, rz",
      "Of anchor and restraint, along and about the axes. Not given: ux, uy, uz of a restraint.");
  declare_axes(in, "Of Fixed.");
  in.declare_text("Law", default_law(kind), join(laws.names(LawKind::support)),
                  "Of the friction element. Its parameters are entries of the support.");
  in.declare_text(
      "Normal", "0 0 1", "x y z [-], along, or across",
      "Direction from the ground into the pipe, of rest and friction; of a rod, that of its pull "
      "on the pipe; of guide and stop, that which is held, either way. Along the pipe or across it "
      "(horizontal), as guide and line stop are unless it is given. With Ground, and not given: "
      "from that point to the support.");
  in.declare_number("Length", 1., "m", positive, 1e300,
                    "Of the friction element. Rigidity over length is stiffness; with Rotations it "
                    "is the lever arm as well. Not given, it is 1 m in all units, and with Ground "
                    "the distance to that point.");
  in.declare_choice(
      "Rotations", Rotations::none, rotations,
      "Rotations of the pipe in the shear strain: none; averaged over the element "
      "(moment T l/2 on the pipe); the pipe's own (T l: contact at its surface, with "
      "Length its radius). Averaged, unless it is given, with Ground and Kinematics = "
      "linear: nothing else carries the couple T l between two pipes.");
  in.declare_flag("Torsion", false, "Torsional stiffness about the normal, from the law.");
  in.declare_number("Normal force", 0., "N", 0., 1e300,
                    "Of a platen that is pressed onto the pipe; 0: the ground stands still.");
  in.declare_number("Capacity", 0., "N", 0., 1e300,
                    "Largest force that the support is made for, which the report checks, at each "
                    "place; 0: not said.");
  in.declare_text("Ground", "", "name of a point of another pipe",
                  "What the support stands on; empty: the ground. What of the way there is across "
                  "the normal, is a rigid arm of that pipe.");
  in.declare_number("Width", 0., "m", 0., 1e300,
                    "Along the pipe, of the patch that a support of a solid pipe is pressed on, "
                    "over 30 degrees of its circumference; 0: an outer diameter. Of a line, "
                    "the distance between the edges that it stands on, if it does.");
  declare_edges(in);
  in.declare_number("Restitution", 0., "-", 0., 1.,
                    "Newton's coefficient of an impact on a rigid contact, in transient steps: "
                    "relative velocity after over the one before.");
  in.declare_text("Ground motion", "", "x; y; z, each " + std::string(time_function_form),
                  "Displacement of the ground in global axes [m]: a belt, one support's motion in "
                  "an earthquake, a gap that changes. Empty: it stands still.");
  in.declare_choice("Ground motion time", TimeFunction::Clock::step, clocks,
                    "Where the time of Ground motion begins. step: with the step, or with the "
                    "first of the steps, all transient or all static, that follow each other; run: "
                    "with the run.");
  in.declare_choice(
      "Pad", no_pad, pads,
      "What steel slides on, which gives 'Friction coefficient' a default: steel 0.3, "
      "ptfe 0.1, graphite 0.15, concrete 0.5, roller 0.03. Guides and stops have none unless "
      "one of the two is given.");
  const LawDescription &law = find_law(in, laws, LawKind::support, default_law(kind));
  std::vector<double> defaults;
  for (int i = 0; i < law.n_parameters; ++i) {
    const LawParameter &p = law.parameters[i];
    defaults.push_back(
        std::string(p.name) == "Friction coefficient"
            ? friction_of(in.raw("Pad", "none"), kind_of(kind).slides ? p.default_value : 0.)
            : p.default_value);
  }
  declare_parameters(in, law, defaults);
}

namespace {

/// Unit normal of rest and friction supports; zero for one that stands on a point, the way to which
/// is its normal unless another one is given.
Direction parse_normal(const ParameterReader &in) {
  Direction direction;
  if (!in.text("Ground").empty() && !in.given("Normal") && in.text("Kind") != "rod")
    return direction;
  const std::string text = in.text("Normal");
  if (text == "along" || text == "across") {
    direction.kind = text == "along" ? Direction::Kind::along : Direction::Kind::across;
    return direction;
  }
  direction.vector = parse_unit_vector(in, "Normal");
  return direction;
}

void refuse(const ParameterReader &in, const std::vector<std::string> &entries,
            const std::string &kind, const std::string &where_allowed) {
  for (const std::string &entry : entries)
    if (in.given(entry))
      in.fail(entry, where_allowed, "removing '" + entry + "', or another Kind than " + kind,
              entry + " = " + in.text(entry) + " with Kind = " + kind);
}

Restraint parse_restraint(const ParameterReader &in, const std::string &name,
                          const Placement &placement, const std::vector<std::string> &law_entries) {
  const std::string kind = in.text("Kind");
  refuse(in, element_entries, kind,
         "a friction element's entries for guide, line stop, rest and "
         "friction");
  refuse(in, law_entries, kind, "a law's entries for guide, line stop, rest and friction");
  refuse(in, {"Pad"}, kind, "a pad under rest, guide, stop and friction");
  refuse(in, {"Width", "Stands on"}, kind, "that of rest, guide, stop and friction");
  Restraint restraint;
  restraint.name = name;
  restraint.kind = kind;
  restraint.placement = placement;
  restraint.fixed = parse_motions(in, "Fixed");
  restraint.axes = parse_axes(in);
  restraint.capacity = in.number("Capacity");
  if (std::count(restraint.fixed.begin(), restraint.fixed.end(), true) == 0)
    in.fail("Fixed", "at least one of " + join(motions), "'ux, uy, uz'");
  return restraint;
}

/// Entries that are there for the friction elements of other kinds only.
void refuse_entries_of_others(const ParameterReader &in, const LawDescription &law) {
  const std::string kind = in.text("Kind");
  refuse(in, {"Fixed", "Axes"}, kind, "Fixed and its Axes for anchor and restraint");
  if (is_pair(kind) || kind == "rod")
    refuse(in, {"Normal force"}, kind, "Normal force for rest and friction");
  if (kind == "rod") {
    refuse(in, {"Pad"}, kind, "Pad for what slides on it");
    if (in.given("Friction coefficient") && in.number("Friction coefficient") > 0.)
      in.fail("Friction coefficient", "0 with Kind = rod, which swings with the pipe",
              "Kind = friction, with the same Normal");
  }
  if (kind == "snubber") {
    refuse(in, {"Length", "Rotations", "Torsion", "Normal force", "Restitution", "Pad"}, kind,
           "a friction element's entries for guide, stop, rest, rod and friction");
    if (law.name != default_law(kind))
      in.fail("Law", "the law 'snubber' with Kind = snubber",
              "Kind = friction, which takes any law");
  }
}

/// What a support stands on: the ground, which may move, or a point of another pipe.
void parse_ground(const ParameterReader &in, Scene &scene, FrictionSupport &support) {
  support.ground = in.text("Ground");
  const bool on_pipe = !support.ground.empty();
  if (on_pipe && !in.given("Length"))
    support.length = 0.;
  if (on_pipe) {
    check_point(in, "Ground", support.ground, scene);
    const bool may_turn = scene.kinematics == Kinematics::linear; // large ones know none
    if (!in.given("Rotations") && may_turn)
      support.rotations = Rotations::averaged;
    if (support.rotations == Rotations::none && support.kind != "rod" && support.kind != "snubber")
      scene.remarks.push_back("Support " + support.name +
                              ": with Rotations = none the couple of its friction T, T times the "
                              "distance to Ground, is on neither pipe, so that moments are not in "
                              "balance: try " +
                              (may_turn ? "averaged or pipe." : "Kinematics = linear."));
    const auto &points = support.placement.points;
    if (std::count(points.begin(), points.end(), support.ground) > 0)
      in.fail("Ground", "another point than those of At", "a point of another pipe");
    if (support.normal_force > 0.)
      in.fail("Normal force", "either a platen with a normal force or a ground that is a pipe",
              "removing 'Ground' or 'Normal force'");
  }
  const std::string motion = in.text("Ground motion");
  if (motion.empty())
    return;
  const std::vector<std::string> courses = split(motion, ';');
  if (courses.size() != 3)
    in.fail("Ground motion", "three courses in time, x; y; z", "'0.1*t; 0; 0'");
  for (unsigned int d = 0; d < 3; ++d) {
    TimeFunction &one = support.ground_motion[d];
    one = parse_time_function(in, "Ground motion", courses[d], in.si("m"));
    one.clock = in.choice("Ground motion time", clocks);
  }
  if (on_pipe)
    in.fail("Ground motion", "either a ground that moves or one that is a pipe",
            "removing 'Ground'");
}

/// A stiffness is a rigidity over a length, and one metre is a strange length in other units.
void remark_on_length(const ParameterReader &in, const LawDescription &law,
                      const FrictionSupport &support, Scene &scene) {
  const std::string rigid = "rigidity"; // the last word, which a Shear rigidity ratio has not
  bool has_stiffness = false;
  for (int i = 0; i < law.n_parameters; ++i) {
    const std::string parameter = law.parameters[i].name;
    const auto at = parameter.rfind(rigid);
    has_stiffness =
        has_stiffness || (at != std::string::npos && at + rigid.size() == parameter.size() &&
                          support.parameters[i] > 0.);
  }
  if (has_stiffness && !in.given("Length") && in.text("Ground").empty() && !scene.units.is_si())
    scene.remarks.push_back("Support " + support.name + ": its Length is not given and is 1 m, " +
                            to_text(1. / scene.units.factor("m")) + " " + scene.units.name("m") +
                            ". Its stiffness is the rigidity over that.");
}

/// Impacts have a restitution on rigid contacts only: a stiffness gives back what it stores.
void remark_on_restitution(const ParameterReader &in, const LawDescription &law,
                           const FrictionSupport &support, Scene &scene) {
  const std::vector<std::string> entries = law_entries(law);
  const bool is_rigid = support.normal_force == 0. &&
                        std::count(entries.begin(), entries.end(), rigidity) > 0 &&
                        in.number(rigidity) == 0.;
  if (support.restitution > 0. && !is_rigid)
    scene.remarks.push_back("Support " + support.name +
                            ": its Restitution is not used, for it is not rigid along its normal: "
                            "leave " +
                            (support.normal_force > 0. ? "Normal force" : rigidity) + " out.");
}

/// A support on a friction element (doc/theory.md), but for its normal.
FrictionSupport parse_friction_support(const ParameterReader &in, const std::string &name,
                                       const Placement &placement, const LawDescription &law,
                                       Scene &scene) {
  FrictionSupport support;
  support.name = name;
  support.kind = in.text("Kind");
  support.placement = placement;
  support.law = law.name;
  for (const std::string &entry : law_entries(law))
    support.parameters.push_back(in.number(entry));
  check_together(in, law, support.parameters);
  check_closed_form(in, law, support.parameters);
  remark_on_units(in, "Support " + name, law, scene.remarks);
  support.length = in.number("Length");
  remark_on_length(in, law, support, scene);
  support.rotations = in.choice("Rotations", rotations);
  support.torsion = in.flag("Torsion");
  support.normal_force = in.number("Normal force");
  support.restitution = in.number("Restitution");
  support.capacity = in.number("Capacity");
  support.width = in.number("Width");
  remark_on_restitution(in, law, support, scene);
  parse_ground(in, scene, support);
  parse_edges(in, scene, support);
  return support;
}

/// Whether a guide or stop has no gap, no friction and no stiffness of its own: it holds exactly.
bool holds_exactly(const ParameterReader &in, const LawDescription &law,
                   const FrictionSupport &support) {
  bool exact = law.name == std::string("coulomb") && support.ground.empty() &&
               !in.given("Length") && !in.flag("Torsion") && !support.ground_moves() &&
               !in.given("Restitution") && !support.on_edges;
  const std::vector<std::string> entries = law_entries(law);
  for (unsigned int i = 0; i < entries.size(); ++i)
    if (entries[i] == "Gap" || entries[i] == "Friction coefficient")
      exact = exact && support.parameters[i] == 0.;
    else
      exact = exact && !in.given(entries[i]);
  return exact;
}

/// The two halves of a guide or stop, on either side of the pipe.
void add_pair(FrictionSupport support, Scene &scene) {
  const std::string name = support.name;
  support.name = name + plus_half;
  scene.supports.push_back(support);
  support.name = name + minus_half;
  support.normal.sign = -1.;
  scene.supports.push_back(support);
}

} // namespace

void parse_support(const ParameterReader &in, const LawLibrary &laws, const std::string &name,
                   Scene &scene) {
  const std::string kind = in.text("Kind");
  const Placement placement = parse_placement(in, scene);
  const LawDescription &law = laws.find(in.text("Law"));
  if (is_restraint(kind)) {
    scene.restraints.push_back(parse_restraint(in, name, placement, law_entries(law)));
    return;
  }
  refuse_entries_of_others(in, law);
  FrictionSupport support = parse_friction_support(in, name, placement, law, scene);
  if ((kind == "guide" || kind == "line stop") && !in.given("Normal"))
    support.normal.kind = kind == "guide" ? Direction::Kind::across : Direction::Kind::along;
  else
    support.normal = parse_normal(in);
  if (!is_pair(kind))
    scene.supports.push_back(support);
  else if (!holds_exactly(in, law, support))
    add_pair(support, scene);
  else {
    Restraint restraint;
    restraint.name = name;
    restraint.kind = kind;
    restraint.placement = placement;
    restraint.translations.push_back(support.normal);
    restraint.capacity = support.capacity;
    scene.restraints.push_back(restraint);
    if (in.given("Width"))
      scene.remarks.push_back("Support " + name + ": its Width is not used, for a " + kind +
                              " without gap and friction holds the motion of the section as a "
                              "plane, and has no patch.");
  }
}

} // namespace frictionbeam::parts
