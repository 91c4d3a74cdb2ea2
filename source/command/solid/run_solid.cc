// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/solid/run_solid.h"
#include "command/solid/wall_scene.h"

#include "analysis/substructure/free_pressed_wall.h"
#include "base/interruption.h"
#include "base/processes.h"
#include "base/user_error.h"
#include "mesh/solid/held_points.h"
#include "mesh/solid/wall_layout.h"
#include "model/line_model.h"
#include "model/mechanism.h"
#include "results/file/body_vtu.h"
#include "results/file/checkpoint.h"
#include "results/file/csv_writer.h"
#include "results/quantity/collector.h"
#include "results/quantity/shown_quantity.h"
#include "results/solid/solid_files.h"
#include "results/solid/solid_frame.h"
#include "results/solid/wall_doubts.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

class SolidRun {
public:
  /// @param halved layers to cut in two
  SolidRun(const Scene &scene, const LawLibrary &laws, const std::vector<double> &halved,
           Results &results)
      : scene(scene), results(results), line(scene, laws),
        wall(with_held_points(build_pipe_wall(scene, line.model().mesh, halved))),
        body_scene(scene_of_wall(scene, line.model(), wall)), body(body_scene, wall.mesh),
        loads(scene, line.model().mesh, wall, body), collector(line.model(), results, {}),
        checkpoint(body) {
    results.cost.mesh_seconds = wall_clock.wall_time();
    results.remarks = line.model().mesh.remarks;
    for (const std::string &warning : check_mechanisms(line.model()))
      results.remarks.push_back(warning);
    body.distribute();
    tie_sections(tied_sections(scene, line.model(), wall), body);
    check_patches(scene, wall, body);
    std::vector<ContinuumVector> forces = loads.forces();
    if (forces.empty()) {
      forces.resize(1);
      body.reinit(forces[0]);
    }
    sequence = std::make_unique<ContinuumSequence<3>>(body, laws, std::move(forces), stiffening());
    results.cost.setup_seconds = wall_clock.wall_time() - results.cost.mesh_seconds;
  }

  void run();
  /// What the mesh leaves.
  WallErrors errors() const;

private:
  /// By the pressure of the loads, if there is any and it is wanted.
  Stiffening stiffening();
  /// After an increment: write a checkpoint if it is time, and end if a signal came.
  void pause();
  void read_states();
  void report(const bool converged);
  void add_quantities();
  /// Stresses of the wall above what its material says that it yields at.
  void doubt_stresses();
  void write();

  const Scene &scene;
  Results &results;
  const Timer wall_clock;
  const LineModel line;
  const PipeWall wall;
  const Scene body_scene;
  ContinuumBody<3> body;
  const WallLoads loads;
  const Collector collector; ///< of the quantities, in the words of a line
  Checkpoint checkpoint;
  std::unique_ptr<const PressureStiffness> pressure_stiffness;
  std::unique_ptr<ContinuumSequence<3>> sequence;
  std::vector<WallFrame> frames;
  double support_imbalance = 0.; ///< largest of all frames
};

Stiffening SolidRun::stiffening() {
  const bool has_pressure =
      std::any_of(scene.loads.begin(), scene.loads.end(),
                  [](const Load &load) { return load.kind == Load::Kind::pressure; });
  if (!scene.solid.pressure_stiffening || !has_pressure)
    return {};
  pressure_stiffness = std::make_unique<const PressureStiffness>(
      PressureStiffness{wall, body, free_pressed_wall(body_scene, wall)});
  return {[this](const AddMatrix &add) { pressure_stiffness->assemble(add); },
          [this](const std::vector<double> &factors) { return loads.pressure(factors); },
          pressure_stiffness->times_free_field()};
}

void SolidRun::run() {
  if (scene.output.resume)
    if (std::optional<Archive> saved = checkpoint.read())
      sequence->transfer(*saved);
  const bool converged = sequence->run(nullptr, [&]() { pause(); });
  read_states();
  report(converged);
  add_quantities();
  doubt_stresses();
  write();
}

void SolidRun::pause() {
  const int signal = interruption::received();
  if ((signal != 0 || checkpoint.is_due()) && !scene.takes_many_runs()) {
    Archive archive;
    sequence->transfer(archive);
    checkpoint.write(archive);
  }
  if (signal != 0)
    throw Interrupted(signal, "Interrupted at time " + rounded_number(sequence->time()) +
                                  " of step " + sequence->reports().back().step + ".");
}

WallErrors SolidRun::errors() const {
  std::vector<bool> is_pushed(wall.rings.size());
  for (unsigned int r = 0; r < is_pushed.size(); ++r)
    is_pushed[r] = loads.is_loaded(r);
  for (const std::vector<Site> &sites : line.model().mesh.restraints)
    for (const Site &site : sites)
      is_pushed[wall.ring_at(site.vertex)] = true;
  return wall_errors(wall, loads, body, sequence->ends(), is_pushed);
}

void SolidRun::read_states() {
  for (const ContinuumState &state : sequence->ends()) {
    WallFrame frame;
    frame.step = state.step;
    frame.rings = wall_state(wall, loads, body, state, pressure_stiffness.get());
    results.frames.push_back(solid_frame(scene, line.model(), wall, loads, body,
                                         sequence->contacts(), state, frame.rings));
    support_imbalance =
        std::max(support_imbalance, imbalance_of_supports(loads.resultant(state.factors), results,
                                                          results.frames.back(), wall, body, state,
                                                          force_of_rounding(body_scene, wall)));
    frames.push_back(std::move(frame));
  }
}

void SolidRun::report(const bool converged) {
  results.units = scene.units;
  results.known = how_well_known_of_wall(scene);
  results.steps = sequence->reports();
  results.status = converged                                   ? RunStatus::converged
                   : sequence->reports().back().no_equilibrium ? RunStatus::no_equilibrium
                                                               : RunStatus::failed;
  results.method = "exact: rigid contact and Coulomb friction by a semismooth Newton method; wall "
                   "of hexahedra of degree " +
                   std::to_string(scene.solid.degree) + ", " + std::to_string(wall.around) +
                   " around, " + std::to_string(wall.n_layers()) + " along";
  results.cost.solve_seconds =
      wall_clock.wall_time() - results.cost.mesh_seconds - results.cost.setup_seconds;
  results.cost.unknowns = body.dof_handler.n_dofs();
  results.cost.cells = body.triangulation->n_global_active_cells();
  results.cost.contacts =
      Utilities::MPI::sum(static_cast<unsigned int>(body.nodes.size()), body.communicator);
  for (const StepReport &step : results.steps) {
    results.cost.iterations += step.iterations;
    results.cost.factorizations += step.factorizations;
    results.cost.steps += step.increments;
  }
  results.certify(scene, true);
  results.certificate.push_back({"support_balance", "-",
                                 "sum of loads and of forces of anchors and supports, and of their "
                                 "moments, of the largest of them",
                                 support_imbalance});
}

void SolidRun::add_quantities() {
  for (const Quantity &quantity : scene.quantities) {
    const std::string &step = quantity.step.empty() ? scene.steps.back().name : quantity.step;
    const auto frame = std::find_if(results.frames.begin(), results.frames.end(),
                                    [&](const Frame &one) { return one.name == step; });
    const bool is_reached =
        std::any_of(results.steps.begin(), results.steps.end(), [&](const StepReport &report) {
          return report.step == step && report.converged;
        });
    if (frame == results.frames.end() || !is_reached)
      results.remarks.push_back("Quantity " + quantity.name + " was not reached.");
    else
      results.quantities.push_back(shown(scene, quantity, collector.evaluate(quantity, *frame)));
  }
  if (frames.empty()) // the first step was not solved
    return;
  double ovality = 0., mises = 0.;
  for (const WallFrame &frame : frames)
    for (const RingState &ring : frame.rings) {
      ovality = std::max(ovality, ring.ovality(2. * wall.outer));
      mises = std::max({mises, ring.largest_mises(0), ring.largest_mises(1)});
    }
  const double Pa = scene.units.factor("Pa");
  results.quantities.push_back({"largest_ovality", "-", "", ovality, {}, {}});
  results.quantities.push_back(
      {"largest_wall_stress", scene.units.name("Pa"), "", mises / Pa, {}, {}});
  results.quantities.back().in_si = Pa;
}

void SolidRun::doubt_stresses() {
  for (const std::string &text :
       {doubt_of_stresses(scene, wall, frames), doubt_of_bore(scene, wall, frames)})
    if (!text.empty())
      results.doubts.push_back(text);
}

void SolidRun::write() {
  const std::string &folder = scene.output.directory;
  if (frames.empty())
    return;
  if (scene.output.vtu)
    write_body_vtu<3>(
        body, sequence->ends(), "solid",
        [&](const ContinuumState &state) { return stress_of_wall(loads, body, state.factors); },
        folder);
  if (this_process(body.communicator) > 0)
    return;
  CsvWriter csv(scene, results, folder);
  for (const Frame &frame : results.frames) {
    Frame converted;
    csv.append(in_units(scene.units, frame, converted));
  }
  csv.finish();
  write_wall_csv(scene, wall, frames, folder);
  if (!scene.output.report)
    return;
  RingNames names;
  for (const auto &[name, vertex] : line.model().mesh.points)
    names[wall.ring_at(vertex)].push_back(name);
  results.sections.push_back(
      {"wall", "Wall of the pipes", wall_report(scene, wall, frames, names, "wall", folder)});
}

} // namespace

Results run_solid(const Scene &scene, const LawLibrary &laws, WallMesh *const mesh) {
  Results results;
  check_can_be_solid(scene);
  try {
    SolidRun run(scene, laws, mesh != nullptr ? mesh->halved : std::vector<double>{}, results);
    run.run();
    if (mesh != nullptr)
      mesh->left = run.errors();
  } catch (const UserError &error) {
    throw UserError(with_place(scene, error.what()));
  }
  return results;
}

std::string check_solid(const Scene &scene, const Model &line) {
  check_can_be_solid(scene);
  const PipeWall wall = build_pipe_wall(scene, line.mesh);
  const Scene body_scene = scene_of_wall(scene, line, wall);
  ContinuumBody<3> body(body_scene, wall.mesh);
  body.distribute();
  tie_sections(tied_sections(scene, line, wall), body);
  check_patches(scene, wall, body);
  return std::to_string(wall.n_layers()) + " layers of " +
         std::to_string(wall.around * wall.through) + " cells of degree " +
         std::to_string(scene.solid.degree) + ", " + std::to_string(body.dof_handler.n_dofs()) +
         " unknowns, " + std::to_string(body.nodes.size()) + " contact nodes in " +
         std::to_string(wall.patches.size()) + " patches";
}

} // namespace frictionbeam
