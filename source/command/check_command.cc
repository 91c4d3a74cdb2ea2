// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/check_command.h"
#include "command/solid/mixed_walls.h"
#include "command/solid/run_solid.h"

#include "analysis/sequence/load_sequence.h"
#include "base/user_error.h"
#include "model/line_model.h"
#include "model/mechanism.h"
#include "results/file/output_file.h"
#include "results/frame/frame_builder.h"
#include "results/picture/line_picture.h"
#include "results/stress/stresses.h"
#include "results/support/support_states.h"
#include "results/text.h"
#include "scene/read_scene.h"

#include <algorithm>
#include <iostream>
#include <map>

namespace frictionbeam {

namespace {

std::string plural(const std::size_t n, const std::string &what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// A number in the units of the file.
struct InUnits {
  const UnitSystem &units;
  std::string operator()(const double value, const std::string &si_unit) const {
    return rounded_number(value / units.factor(si_unit), 5) + " " + units.name(si_unit);
  }
};

/// How much more flexible than a straight pipe a bend is, in words: by the code's factor, or by the
/// law of its section, which may find it itself.
std::string flexibility_of_bend(const Scene &scene, const Discretization &discretization,
                                const unsigned int pipe, const double radius) {
  const Section &section = scene.sections[scene.pipes[pipe].section];
  const Material &material = scene.materials[scene.pipes[pipe].material];
  if (!section.is_inelastic())
    return rounded_number(bend_flexibility(scene.pipes[pipe], section, material, radius), 4);
  double factor = 1.;
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const Profile &profile = discretization.profiles()[discretization.pipe_cell(i)->material_id()];
    if (discretization.pipe_cells()[i].pipe == pipe && profile.bend.radius == radius)
      factor = std::max(factor, profile.material.youngs_modulus * section.inertia / profile.EI);
  }
  return rounded_number(factor, 4) + " while elastic, as the law " + section.law + " has it";
}

void list_pipes(const Scene &scene, const LineMesh &mesh, const Discretization &discretization) {
  const InUnits in_units{scene.units};
  double total = 0.;
  for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
    const Pipe &pipe = scene.pipes[p];
    const Section &section = scene.sections[pipe.section];
    const MeshedPipe &meshed = mesh.pipes[p];
    total += meshed.s.back();
    std::map<double, unsigned int> bends; // radius: number
    for (const RoutePoint &point : pipe.route)
      if (point.bend_radius > 0.)
        ++bends[point.bend_radius];
    std::cout << "Pipe " << pipe.name << ": " << in_units(meshed.s.back(), "m") << " long, section "
              << section.name;
    if (section.wall > 0.)
      std::cout << " (" << in_units(2. * section.outer_radius, "m") << " x "
                << in_units(section.wall, "m") << ")";
    if (pipe.end_section)
      std::cout << " to " << scene.sections[*pipe.end_section].name;
    std::cout << ", material " << scene.materials[pipe.material].name << ", "
              << plural(meshed.bend_radius.size(), "cell") << (pipe.rigid ? ", rigid" : "") << '\n';
    for (const auto &[radius, n] : bends)
      std::cout << "  " << plural(n, "bend") << " of radius " << in_units(radius, "m")
                << ", flexibility factor " << flexibility_of_bend(scene, discretization, p, radius)
                << '\n';
  }
  double mass = 0.;
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const PipeCell &cell = discretization.pipe_cells()[i];
    const auto &s = mesh.pipes[cell.pipe].s;
    mass += (s[cell.position + 1] - s[cell.position]) *
            discretization.profiles()[discretization.pipe_cell(i)->material_id()].mass;
  }
  for (const PointMass &point_mass : scene.masses)
    mass += point_mass.points.size() * point_mass.mass;
  std::cout << "Altogether " << in_units(total, "m") << " of pipe, mass " << in_units(mass, "kg")
            << '\n';
}

void list_supports(const Scene &scene, const LineMesh &mesh) {
  std::map<std::string, unsigned int> count;
  for (unsigned int i = 0; i < scene.supports.size(); ++i)
    count[scene.supports[i].kind] += n_places(mesh.supports[i]);
  for (unsigned int i = 0; i < scene.restraints.size(); ++i)
    count[scene.restraints[i].kind] += mesh.restraints[i].size();
  for (const Spring &spring : scene.springs)
    ++count[spring.kind];
  for (const Joint &joint : scene.joints)
    ++count[joint.kind + " with flexibility"];
  std::cout << "Supports: ";
  std::string text;
  for (const auto &[kind, n] : count)
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
  std::cout << (text.empty() ? "none" : text) << '\n';
  for (const FrictionSupport &support : scene.supports)
    std::cout << "  " << support.name << ": " << support.kind << ", law " << support.law << '\n';
}

void list_steps(const Scene &scene) {
  for (const LoadStep &step : scene.steps) {
    std::string loads;
    for (const auto &[load, factor] : step.loads)
      loads += (loads.empty() ? "" : ", ") + scene.loads[load].name +
               (factor == 1. ? "" : " x " + rounded_number(factor));
    std::cout << "Step " << step.name
              << (step.from ? " from the end of " + scene.steps[*step.from].name : "") << ": "
              << (loads.empty() ? "no loads" : loads) << ", "
              << (step.transient ? "transient, " + rounded_number(step.duration) + " s"
                                 : plural(step.n_increments, "increment"))
              << '\n';
  }
  if (scene.modal.n_modes > 0)
    std::cout << "Modes: " << scene.modal.n_modes << ", "
              << (scene.modal.lumped ? "lumped" : "consistent") << " mass\n";
  for (const Spectrum &spectrum : scene.spectra)
    std::cout << "Spectrum " << spectrum.name << ": "
              << (spectrum.record == nullptr
                      ? plural(spectrum.curve.size(), "point")
                      : "of a record with " + plural(spectrum.record->time.size(), "instant"))
              << '\n';
  for (const Combination &combination : scene.combinations)
    std::cout << "Combination " << combination.name << ": "
              << plural(combination.cases.size(), "case") << '\n';
  if (!scene.stress.code.empty())
    std::cout << "Stresses: " << scene.stress.code << '\n';
}

} // namespace

namespace {

/// Draw the line as built: nothing has moved, supports stand as they would touch.
void draw_as_built(const Model &model) {
  const Scene &scene = model.scene;
  prepare_output_folder(scene.output.directory);
  FrameBuilder builder(model);
  LineState state;
  state.dofs = Vector::Zero(model.space.n_dofs());
  state.unknowns = Vector::Zero(model.space.n_unknowns());
  state.contacts = model.contacts.initial_state(state.dofs);
  state.contact_stress.assign(model.contacts.size(), Contact::Strains::Zero());
  state.contact_status.assign(model.contacts.size(), ContactStatus::closed);
  state.load_factors.assign(scene.loads.size(), 0.);
  const Pose at_rest = model.cells.at_rest();
  state.turns = at_rest.turns;
  state.sections = *at_rest.sections;
  Results results;
  results.units = scene.units;
  results.supports = support_infos(model);
  results.restraints = builder.restraint_infos();
  Frame frame = builder.make(state);
  frame.name = "as built";
  const std::string picture = scene.output.directory + "/model.svg";
  if (!frame.line.empty()) {
    write_file(picture, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
                            draw_line(scene, results, frame, 1.));
    std::cout << "The line is drawn in " << picture << ". Nothing was solved.\n";
  }
}

void check(const RunOptions &options, const LawLibrary &laws, const Scene &scene) {
  const LineModel line(scene, laws);
  const Model &model = line.model();

  std::cout << options.parameter_file << (scene.title.empty() ? std::string() : ": " + scene.title)
            << '\n';
  list_pipes(scene, model.mesh, model.discretization);
  list_supports(scene, model.mesh);
  list_steps(scene);
  std::cout << "Quantities: " << scene.quantities.size() << '\n'
            << "Unknowns: " << model.space.n_unknowns() << ", contacts: " << model.contacts.size()
            << '\n';
  if (scene.is_solid())
    std::cout << "Wall: " << check_solid(scene, model) << '\n';
  for (const std::string &text : MixedWalls(scene, model.mesh).in_words())
    std::cout << text << '\n';
  for (const std::vector<std::string> *const remarks :
       {&scene.doubts, &scene.remarks, &model.mesh.remarks})
    for (const std::string &remark : *remarks)
      std::cout << "Note: " << remark << '\n';
  for (const std::string &warning : check_mechanisms(model))
    std::cout << "Note: " << warning << '\n';
  if (!scene.stress.code.empty())
    if (const std::string places =
            check_stress_code(scene, model.mesh, FrameBuilder(model, true).stations());
        !places.empty())
      std::cout << "Note: " << places << '\n';
  draw_as_built(model);
  if (options.strict && !scene.doubts.empty())
    throw UserError("With --strict, a note of what is hardly meant is an error: " +
                    scene.doubts.front());
}

} // namespace

int check_case_file(const RunOptions &options) {
  LawLibrary laws;
  laws.load_builtin();
  Scene scene = read_scene(options.parameter_file, options.overrides, laws);
  scene.output.directory =
      options.output_directory.empty() ? "output/" + scene.name : options.output_directory;
  try {
    check(options, laws, scene);
  } catch (const UserError &error) {
    throw UserError(with_place(scene, error.what()));
  }
  return 0;
}

} // namespace frictionbeam
