// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/solid/mixed_entries.h"

#include "scene/part/parts.h"

namespace frictionbeam {

std::vector<std::string> solid_places(const Scene &scene) {
  std::vector<std::string> places;
  for (const AskedPoint &asked : scene.asked_points)
    if (asked.entry == solid_at)
      places.push_back(asked.name);
  return places;
}

namespace parts {

void declare_mixed(ParameterReader &in) {
  in.declare_text(
      "At", "", "names of points separated by commas, or all bends",
      "Where the wall of a line's pipes is a solid between beams (a mixed model): the "
      "bends of these corners, straight pipe about other points. As much straight pipe "
      "on either side is solid too, Reach times r sqrt(r/t), in which a bend's oval dies out, "
      "as the next bend, anchor or end of the pipe leaves.");
  in.declare_number(
      "Reach", 2., "-", 2., 100.,
      "How many times r sqrt(r/t) of straight pipe are solid on either side of what "
      "At names. A cut after 1.2 leaves 1.4 % of the deflection of SSLX102, after 1.7 "
      "0.4 %, after 2.3 0.1 %; rests press the wall oval as well, and one within it "
      "does so on its patch.");
}

void parse_mixed(const ParameterReader &in, Scene &scene) {
  for (const std::string &point : in.list("At"))
    scene.asked_points.push_back({solid_at, point});
  scene.solid.reach = in.number("Reach");
  if (in.list("At").empty())
    return;
  if (scene.model == ModelKind::solid || scene.model == ModelKind::continuum)
    in.fail("At", "no At with Model = " + std::string(row_of(model_kinds, scene.model).word),
            "Model = line, whose pipes are solid there");
  if (scene.model == ModelKind::automatic)
    in.fail("At", "no At with Model = auto, which chooses what is solid", "Model = line");
}

void check_mixed(ParameterReader &in, const Scene &scene) {
  const auto refuse = [&](const bool is_so, const std::string &section, const std::string &entry,
                          const std::string &allowed, const std::string &hint) {
    if (!is_so)
      return;
    in.enter(section);
    in.fail(entry, allowed + " with Solid/At", hint + ", or no At in section Solid");
  };
  in.enter("Solid");
  const std::string at = in.text("At");
  in.enter("");
  if (const std::string kind = in.text("Scene"); kind != "line")
    in.fail_section("Solid/At = " + at + " with Scene = " + kind, "pipes with a Route",
                    "removing At in section Solid");
  refuse(scene.kinematics != Kinematics::linear, "", "Kinematics", "linear", "linear");
  refuse(!scene.mesh.file.empty(), "Mesh", "File", "routes", "pipes with a Route");
  refuse(scene.mesh.refine_hinges, "Mesh", "Refine hinges", "false", "false");
  refuse(scene.modal.n_modes > 0, "Modes", "Number", "no modes", "0");
  for (const Pipe &pipe : scene.pipes) {
    const Section &section = scene.sections[pipe.section];
    refuse(section.is_inelastic() && !pipe.rigid, "Section " + section.name, "Law",
           "elastic_section", "elastic_section");
  }
  for (const Load &load : scene.loads)
    refuse(load.kind == Load::Kind::wind, "Load " + load.name, "Kind", "all kinds but wind",
           "a line force");
  for (const LoadStep &step : scene.steps) {
    refuse(step.transient, "Step " + step.name, "Analysis", "static", "static");
    refuse(step.finds_limit, "Step " + step.name, "Find", "no limit load", "removing the entry");
  }
  in.enter("");
  for (const Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0.)
      in.fail_section("subsection Hanger " + hanger.name + ", without Cold load",
                      "hangers of a given Cold load with Solid/At, for springs are chosen by beams "
                      "alone",
                      "the Stiffness and Cold load that a run without At chose");
}

} // namespace parts
} // namespace frictionbeam
