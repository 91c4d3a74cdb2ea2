// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/solid/solid_entries.h"
#include "scene/solid/mixed_entries.h"

#include "base/user_error.h"
#include "scene/part/parts.h"
#include "scene/solid/wall_refusal.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::parts {

namespace {

using Anchors = SolidSettings::Anchors;
constexpr Word<Anchors> anchor_kinds[] = {
    {"held", Anchors::held,
     "all displacements of the wall's section are zero, as of a pipe welded "
     "into something rigid"},
    {"breathing", Anchors::breathing,
     "all but along the radii, so that heat and pressure widen the section as elsewhere"}};

} // namespace

void declare_solid(ParameterReader &in) {
  in.declare_count("Degree", 2, 1, "Of the elements' polynomials, and of the wall's geometry.", 4);
  in.declare_count("Cells around", 32, 8, "The circumference.", 200);
  in.declare_count("Cells through", 1, 1, "The wall.", 20);
  in.declare_count("Cells per bend", 8, 1, "Along 90 degrees of a bend.", 200);
  in.declare_number("First cell", 0., "m", 0., 1e300,
                    "Length of a straight run's cells beside bends, supports, anchors and named "
                    "points; they grow from there. 0: sqrt(r t), the length in which local bending "
                    "of the wall dies out.");
  in.declare_number("Longest cell", 0., "m", 0., 1e300,
                    "Of a straight run; 0: two outer diameters.");
  in.declare_choice("Anchors", Anchors::held, anchor_kinds, "What they hold of their section.");
  in.declare_count("Most unknowns", 200000, 1,
                   "A wall of more would take very long, and is refused.", 100000000);
  in.declare_flag("Pressure stiffening", true,
                  "Whether pressure in the wall, which turns and moves with it, holds bends round "
                  "and bulges them, as it does at every instant's pressure; false: it is a load "
                  "and no more.");
  declare_mixed(in);
}

void parse_solid(const ParameterReader &in, Scene &scene) {
  SolidSettings &solid = scene.solid;
  solid.degree = in.count("Degree");
  solid.cells_around = in.count("Cells around");
  solid.cells_through = in.count("Cells through");
  solid.cells_per_bend = in.count("Cells per bend");
  solid.first_cell = in.number("First cell");
  solid.longest_cell = in.number("Longest cell");
  solid.anchors = in.choice("Anchors", anchor_kinds);
  solid.most_unknowns = in.count("Most unknowns");
  solid.pressure_stiffening = in.flag("Pressure stiffening");
  parse_mixed(in, scene);
}

namespace {

class SolidCheck {
public:
  SolidCheck(ParameterReader &in, const Scene &scene) : in(in), scene(scene) {}

  void all() {
    check_scene();
    check_settings();
    check_parts();
    check_pipes();
    check_supports();
    check_loads();
    check_steps();
    check_quantities();
  }

private:
  /// @throws UserError if it is so, about an entry of a section
  void refuse(const bool is_so, const std::string &section, const std::string &entry,
              const std::string &allowed, const std::string &hint) {
    if (!is_so)
      return;
    in.enter(section);
    in.fail(entry, allowed + " with Model = " + model(), hint + ", or Model = line");
  }
  std::string model() const { return row_of(model_kinds, scene.model).word; }
  /// @throws UserError if there are such parts
  template <typename Parts>
  void refuse_parts(const Parts &parts, const std::string &kind) {
    if (parts.empty())
      return;
    in.enter("");
    in.fail_section("subsection " + kind + " " + parts.front().name,
                    "no " + kind + " with Model = " + model() +
                        ": a solid pipe knows routes, anchors and other restraints, rests, guides, "
                        "stops, weight, temperature, pressure, line forces and forces at points",
                    "Model = line");
  }

  void check_scene();
  void check_settings();
  void check_parts();
  void check_pipes();
  void check_supports();
  /// What a patch of the wall can be pressed on.
  void check_patch(const FrictionSupport &support);
  void check_loads();
  void check_steps();
  void check_quantities();

  ParameterReader &in;
  const Scene &scene;
};

void SolidCheck::check_scene() {
  in.enter("");
  if (const std::string kind = in.text("Scene"); kind != "line")
    in.fail("Model", "line for Scene = " + kind + ", which is generated as beams alone,",
            "Model = line, or the parts of a scene of its own");
}

void SolidCheck::check_settings() {
  const std::array<bool, 6> all_motions{{true, true, true, true, true, true}};
  refuse(scene.kinematics != Kinematics::linear, "", "Kinematics", "linear", "linear");
  refuse(scene.free_motions != all_motions, "", "Free motions", "all six motions",
         "removing the entry");
  refuse(!scene.friction_multipliers.empty(), "", "Friction multipliers", "none",
         "a run for each coefficient");
  refuse(!scene.monitors.empty(), "", "Monitors", "none", "quantities at the ends of steps");
  refuse(!scene.mesh.file.empty(), "Mesh", "File", "routes", "pipes with a Route");
  in.enter("Mesh");
  for (const char *entry : {"Cell length", "Cells per bend", "Bends"})
    refuse(scene.model == ModelKind::solid && in.given(entry), "Mesh", entry,
           "cells by section Solid", "Longest cell and Cells per bend of section Solid");
  refuse(scene.mesh.refine_hinges, "Mesh", "Refine hinges", "false", "false");
  refuse(!scene.stress.code.empty(), "Stress", "Code", "no stress code", "removing section Stress");
  refuse(scene.modal.n_modes > 0, "Modes", "Number", "no modes", "0");
  refuse(scene.exact.has_value(), "Exact", "At", "no exact history", "removing section Exact");
  refuse(scene.output.contact_problems, "Output", "Write contact problems", "false", "false");
  refuse(scene.output.every_increment, "Output", "Every increment", "false", "false");
  refuse(!scene.solver.is_exact(), "Solver", "Method", "exact", "exact");
}

void SolidCheck::check_parts() {
  refuse_parts(scene.springs, "Spring or Hanger");
  refuse_parts(scene.hangers, "Hanger");
  refuse_parts(scene.masses, "Mass");
  refuse_parts(scene.joints, "Joint");
  refuse_parts(scene.tees, "Tee");
  refuse_parts(scene.nozzles, "Nozzle");
  refuse_parts(scene.spectra, "Spectrum");
  refuse_parts(scene.combinations, "Combination");
  if (!scene.initial.empty()) {
    in.enter("");
    in.fail_section("subsection Initial", "no Initial with Model = " + model(), "Model = line");
  }
}

void SolidCheck::check_pipes() {
  if (scene.pipes.empty()) {
    in.enter("");
    in.fail_section("no Pipe", "a pipe, whose wall is the solid", "a Pipe, or Model = line");
  }
  const Section &first = scene.sections[scene.pipes.front().section];
  for (const Pipe &pipe : scene.pipes) {
    const Section &section = scene.sections[pipe.section];
    const std::string heading = "Pipe " + pipe.name;
    double tightest = 0.; // bend
    for (const RoutePoint &point : pipe.route)
      if (point.bend_radius > 0.)
        tightest = tightest > 0. ? std::min(tightest, point.bend_radius) : point.bend_radius;
    if (const auto refusal = wall_refusal(scene, pipe, tightest))
      refuse(true, refusal->section, refusal->entry, refusal->allowed, refusal->hint);
    refuse(section.is_inelastic(), "Section " + section.name, "Law", "elastic_section",
           "elastic_section");
    refuse(section.outer_radius != first.outer_radius || section.wall != first.wall, heading,
           "Section", "the diameter and wall of the pipes before", "one Section for all pipes");
  }
}

void SolidCheck::check_supports() {
  for (const Restraint &restraint : scene.restraints)
    refuse(restraint.placement.continuous, "Support " + restraint.name, "Continuous", "false",
           "supports At points");
  for (const FrictionSupport &support : scene.supports)
    check_patch(support);
}

void SolidCheck::check_patch(const FrictionSupport &support) {
  const std::string heading = "Support " + part_name(support);
  const bool is_known = support.kind != "rod" && support.kind != "snubber";
  refuse(!is_known, heading, "Kind", "anchor, rest, guide, stop or friction", "rest");
  refuse(support.law != "coulomb", heading, "Law", "coulomb", "coulomb");
  for (const char *const rigidity : {"Axial rigidity", "Shear rigidity"}) {
    in.enter(heading);
    refuse(in.given(rigidity), heading, rigidity, "rigid contact", "removing the entry");
  }
  refuse(support.torsion, heading, "Torsion", "false", "false");
  refuse(support.normal_force > 0., heading, "Normal force", "ground that stands still",
         "removing the entry");
  refuse(!support.ground.empty(), heading, "Ground", "the ground", "removing the entry");
  refuse(support.ground_moves(), heading, "Ground motion", "ground that stands still",
         "removing the entry");
  refuse(support.placement.continuous, heading, "Continuous", "false", "supports Every so often");
}

void SolidCheck::check_loads() {
  for (const Load &load : scene.loads) {
    const std::string heading = "Load " + load.name;
    refuse(load.kind == Load::Kind::wind || load.kind == Load::Kind::displacement, heading, "Kind",
           "weight, temperature, pressure, force or line force", "another kind");
    refuse(load.follows, heading, "Follow", "false", "false");
    refuse(load.history.is_given(), heading, "History", "none", "factors of the steps");
    const bool everywhere = std::all_of(scene.pipes.begin(), scene.pipes.end(),
                                        [&](const Pipe &pipe) { return load.is_on(pipe.name); });
    refuse(load.kind == Load::Kind::pressure && !everywhere, heading, "Pipes",
           "all pipes: there is no cap inside of a pipe,", "leaving the entry out");
  }
}

void SolidCheck::check_steps() {
  for (std::size_t s = 0; s < scene.steps.size(); ++s) {
    const LoadStep &step = scene.steps[s];
    const std::string heading = "Step " + step.name;
    refuse(step.transient, heading, "Analysis", "static", "static");
    refuse(step.finds_limit, heading, "Find", "no limit load", "removing the entry");
    refuse(step.from && *step.from + 1 != s, heading, "From", "the step before",
           "a run of its own");
  }
}

void SolidCheck::check_quantities() {
  constexpr unsigned int n_numbers_of_patch = 7; // of a support: fn, ft1, ft2, gap, slips, work
  using Of = QuantityKind::Of;
  for (const Quantity &quantity : scene.quantities) {
    const QuantityKind &kind = quantity.kind();
    const bool is_of_patch = kind.of == Of::support && kind.component < n_numbers_of_patch,
               is_rate = kind.of == Of::directed &&
                         (kind.component == static_cast<unsigned int>(Directed::velocity) ||
                          kind.component == static_cast<unsigned int>(Directed::spin));
    const bool known =
        (kind.of == Of::motion || kind.of == Of::section || kind.of == Of::holder ||
         (kind.of == Of::directed && !is_rate) || is_of_patch || kind.of == Of::supports) &&
        quantity.over == Quantity::Over::end && !quantity.time;
    refuse(!known, "Quantities", quantity.name,
           "motions, section forces, forces of what holds, and fn, ft1, ft2, gap, slip1, slip2 and "
           "work of supports, at the ends of steps,",
           "'uz at <point>'");
  }
}

/// Two patches that face each other without a gap are a vice, and a collar has an area.
void remark_on_pairs(ParameterReader &in, Scene &scene) {
  const bool widens = std::any_of(scene.loads.begin(), scene.loads.end(), [](const Load &load) {
    return load.kind == Load::Kind::temperature || load.kind == Load::Kind::pressure;
  });
  for (const FrictionSupport &support : scene.supports) {
    const bool is_half = is_of_a_pair(support.kind) && support.normal.sign > 0.;
    if (!is_half) // or the other half, which says no more
      continue;
    if (support.normal.kind == Direction::Kind::along)
      scene.remarks.push_back("Support " + part_name(support) +
                              ": the collar of a solid pipe holds the rotation of its section as "
                              "well while it is pressed, which a beam's stop does not.");
    if (!widens || support.normal.kind == Direction::Kind::along)
      continue;
    in.enter("Support " + part_name(support));
    if (in.number("Gap") == 0.)
      scene.remarks.push_back("Support " + part_name(support) +
                              ": it has no Gap, so that its two patches squeeze the wall, which "
                              "heat and pressure widen; a beam knows nothing of that.");
  }
}

/// A line has no patches.
void remark_on_width(Scene &scene) {
  const auto wide = std::find_if(
      scene.supports.begin(), scene.supports.end(),
      [](const FrictionSupport &support) { return support.width > 0. && !support.on_edges; });
  if (wide != scene.supports.end())
    scene.remarks.push_back("Support " + part_name(*wide) +
                            ": its Width is that of a patch on a solid pipe, and a line does not "
                            "use it unless it stands on edges.");
}

} // namespace

void check_solid(ParameterReader &in, Scene &scene) {
  const bool is_mixed = !solid_places(scene).empty();
  if (is_mixed)
    check_mixed(in, scene);
  if (scene.is_solid()) {
    SolidCheck(in, scene).all();
    remark_on_pairs(in, scene);
  } else if (!is_mixed && scene.model != ModelKind::automatic)
    remark_on_width(scene);
}

} // namespace frictionbeam::parts
