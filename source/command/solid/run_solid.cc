// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/solid/run_solid.h"

#include "base/interruption.h"
#include "base/processes.h"
#include "base/user_error.h"
#include "mesh/solid/wall_layout.h"
#include "model/line_model.h"
#include "results/file/csv_writer.h"
#include "results/quantity/collector.h"
#include "results/quantity/shown_quantity.h"
#include "results/solid/solid_files.h"
#include "results/solid/solid_frame.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The scene as a body: the wall's materials, what is held and rubbed, and the steps.
Scene as_body(const Scene &scene, const Model &line, const PipeWall &wall) {
  ContinuumScene body;
  body.dimension = 3;
  for (const Pipe &pipe : scene.pipes) {
    const Material &material = scene.materials[pipe.material];
    body.materials.push_back({material.youngs_modulus, material.poissons_ratio});
  }
  for (const auto &sites : line.mesh.restraints)
    for (const Site &site : sites) {
      const WallRing &ring = wall.rings[wall.ring_at(site.vertex)];
      body.sections.push_back({ring.centre, ring.tangent, wall.outer,
                               scene.solid.anchors == SolidSettings::Anchors::breathing});
    }
  for (const WallPatch &patch : wall.patches) {
    const FrictionSupport &support = scene.supports[patch.support];
    ContinuumContact contact;
    contact.part = patch.part;
    contact.law = support.law;
    contact.parameters = support.parameters_of(patch.site);
    for (unsigned int i = 0; i < line.contacts.size(); ++i)
      if (line.contacts[i].support == patch.support && line.contacts[i].site == patch.site) {
        const LocalAxes &axes = line.contacts[i].axes; // x to the ground
        const Point3 centre = line.mesh.vertices[line.contacts[i].vertices[0]];
        const WallRing &ring = wall.rings[wall.ring_at(line.contacts[i].vertices[0])];
        contact.patch = ContinuumPatch{{{axes.x, axes.z, axes.y}},
                                       centre,
                                       ring.tangent,
                                       patch.outward,
                                       std::cos(patch_half_arc * (1. + 1e-6))};
      }
    body.contacts.push_back(contact);
  }
  for (const LoadStep &step : scene.steps) {
    ContinuumStep one;
    one.name = step.name;
    one.n_increments = step.n_increments;
    one.factors.assign(std::max<std::size_t>(1, scene.loads.size()), 0.);
    for (const auto &[load, factor] : step.loads)
      one.factors[load] += factor;
    body.steps.push_back(one);
  }
  Scene result = scene;
  result.continuum = body;
  result.continuum_settings.degree = scene.solid.degree;
  result.continuum_settings.linear_solver = ContinuumSettings::LinearSolver::direct; // thin cells
  return result;
}

/// @throws UserError where nothing holds the pipes, and for what is not done
void check_held(const Scene &scene) {
  using LinearSolver = ContinuumSettings::LinearSolver;
  const LinearSolver wish = scene.continuum_settings.linear_solver;
  if (wish == LinearSolver::amg || wish == LinearSolver::multigrid)
    throw UserError("Walls of pipes are factored.\n  read:    Continuum/Linear solver = " +
                    std::string(wish == LinearSolver::amg ? "amg" : "multigrid") +
                    "\n  "
                    "allowed: auto or direct with Model = solid\n  try:     to leave it out");
  if (n_processes() > 1)
    throw UserError("Walls of pipes are solved by one process.\n  read:    Model = solid under "
                    "mpirun\n  allowed: one process\n  try:     without mpirun");
  if (scene.restraints.empty())
    throw UserError("Nothing holds the solid pipe.\n  read:    no Support\n  allowed: anchors\n  "
                    "try:     an anchor at one end");
}

class SolidRun {
public:
  SolidRun(const Scene &scene, const LawLibrary &laws, Results &results)
      : scene(scene), results(results), line(scene, laws),
        wall(build_pipe_wall(scene, line.model().mesh)),
        body_scene(as_body(scene, line.model(), wall)), body(body_scene, wall.mesh),
        loads(scene, line.model().mesh, wall, body), collector(line.model(), results, {}) {
    results.cost.mesh_seconds = wall_clock.wall_time();
    body.distribute();
    std::vector<ContinuumVector> forces = loads.forces();
    if (forces.empty()) {
      forces.resize(1);
      body.reinit(forces[0]);
    }
    sequence = std::make_unique<ContinuumSequence<3>>(body, laws, std::move(forces));
    results.cost.setup_seconds = wall_clock.wall_time() - results.cost.mesh_seconds;
  }

  void run();

private:
  void read_states();
  void report(const bool converged);
  void add_quantities();
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
  std::unique_ptr<ContinuumSequence<3>> sequence;
  std::vector<WallFrame> frames;
};

void SolidRun::run() {
  const bool converged = sequence->run(nullptr, [&]() {
    const int signal = Utilities::MPI::max(interruption::received(), body.communicator);
    if (signal != 0)
      throw Interrupted(signal, "Interrupted in step " + sequence->reports().back().step + ".");
  });
  read_states();
  report(converged);
  add_quantities();
  write();
}

void SolidRun::read_states() {
  for (const ContinuumState &state : sequence->ends()) {
    WallFrame frame;
    frame.step = state.step;
    frame.rings = wall_state(wall, loads, body, state);
    results.frames.push_back(solid_frame(scene, line.model(), wall, loads, body,
                                         sequence->contacts(), state, frame.rings));
    frames.push_back(std::move(frame));
  }
}

void SolidRun::report(const bool converged) {
  results.units = scene.units;
  results.remarks = line.model().mesh.remarks;
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
}

void SolidRun::add_quantities() {
  for (const Quantity &quantity : scene.quantities) {
    const std::string &step = quantity.step.empty() ? scene.steps.back().name : quantity.step;
    const auto frame = std::find_if(results.frames.begin(), results.frames.end(),
                                    [&](const Frame &one) { return one.name == step; });
    if (frame == results.frames.end() || results.status != RunStatus::converged)
      results.remarks.push_back("Quantity " + quantity.name + " was not reached.");
    else
      results.quantities.push_back(shown(scene, quantity, collector.evaluate(quantity, *frame)));
  }
  if (frames.empty()) // the first step was not solved
    return;
  double ovality = 0., mises = 0.;
  for (const RingState &ring : frames.back().rings) {
    ovality = std::max(ovality, ring.ovality(2. * wall.outer));
    mises = std::max({mises, ring.largest_mises(0), ring.largest_mises(1)});
  }
  const double Pa = scene.units.factor("Pa");
  results.quantities.push_back({"largest_ovality", "-", "", ovality, {}, {}});
  results.quantities.push_back(
      {"largest_wall_stress", scene.units.name("Pa"), "", mises / Pa, {}, {}});
  results.quantities.back().in_si = Pa;
}

void SolidRun::write() {
  const std::string &folder = scene.output.directory;
  if (frames.empty())
    return;
  if (scene.output.vtu)
    write_wall_vtu(loads, body, sequence->ends(), folder);
  if (this_process(body.communicator) > 0)
    return;
  CsvWriter csv(scene, results, folder);
  for (const Frame &frame : results.frames) {
    Frame converted;
    csv.append(in_units(scene.units, frame, converted));
  }
  csv.finish();
  write_wall_csv(scene, wall, frames, folder);
  if (scene.output.report)
    results.sections.push_back(
        {"wall", "Wall of the pipes", wall_report(scene, wall, frames, folder)});
}

} // namespace

Results run_solid(const Scene &scene, const LawLibrary &laws) {
  Results results;
  check_held(scene);
  try {
    SolidRun(scene, laws, results).run();
  } catch (const UserError &error) {
    throw UserError(with_place(scene, error.what()));
  }
  return results;
}

} // namespace frictionbeam
