// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/run_line.h"
#include "command/line/line_run.h"
#include "command/line/support_remarks.h"
#include "command/solid/mixed_walls.h"

#include "mesh/build_line_mesh.h"
#include "model/line_model.h"
#include "model/mechanism.h"
#include "results/doubt/doubts.h"
#include "results/energy_judgement.h"
#include "results/frame/frame_builder.h"
#include "results/frame/frame_choice.h"
#include "results/how_well_known.h"
#include "results/quantity/wall_quantities.h"
#include "results/report/reduction_text.h"
#include "results/stress/stresses.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace frictionbeam {

namespace {

/// Whether there are contacts, and none of them that the exact method could have judged.
bool no_contact_is_exact(const Model &model) {
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (model.contacts[i].law.has_closed_form())
      return false;
  return model.contacts.size() > 0;
}

/// What a step that looked for its limit has found, in a sentence.
std::string limit_in_words(const Scene &scene, const std::string &step, const LimitLoad &limit,
                           const std::vector<double> &factors) {
  constexpr int digits = 6;
  if (limit.reached >= 1. && !std::isfinite(limit.bound))
    return "Step " + step +
           " carries all of its loads: limit_factor is 1, which is not the limit itself. Larger "
           "loads would find it.";
  std::string loads;
  for (unsigned int l = 0; l < factors.size(); ++l)
    if (factors[l] != 0.)
      loads += (loads.empty() ? "" : ", ") + scene.loads[l].name + " " +
               rounded_number(factors[l], digits);
  return "Step " + step + " ends at its limit, " + rounded_number(limit.reached, digits) +
         " of the way to its loads (" + (loads.empty() ? "none acts" : loads) + ")" +
         (std::isfinite(limit.bound) ? "; no more than " + rounded_number(limit.bound, digits) +
                                           " by the bound of its last motion"
                                     : "") +
         "; " + limit.mechanism + ".";
}

/// How far the line has moved where a step ends: in large displacements a limit may be that of a
/// pose far away.
std::string motion_in_words(const Scene &scene, const Results &results, const unsigned int step) {
  if (scene.kinematics == Kinematics::linear)
    return "";
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && frame.step == step)
      return " The line has moved by up to " +
             rounded_number(largest_motion(frame) / scene.units.factor("m"), 3) + " " +
             scene.units.name("m") + " there.";
  return "";
}

/// How the steps were solved, and at what cost.
void report_steps(const Scene &scene, const LoadSequence &sequence, const bool converged,
                  Results &results) {
  results.status = converged                                  ? RunStatus::converged
                   : sequence.reports().back().no_equilibrium ? RunStatus::no_equilibrium
                                                              : RunStatus::failed;
  const SolverMethodRow &method = scene.solver.row();
  results.method = std::string(method.word) + ": " + method.in_words;
  results.integrator = sequence.integrator_name();
  if (!results.integrator.empty())
    results.method += "; transient steps by " + results.integrator;
  for (const StepReport &step : results.steps) {
    results.cost.iterations += step.iterations;
    results.cost.factorizations += step.factorizations;
    results.cost.back_substitutions += step.back_substitutions;
    results.cost.steps += step.increments;
  }
  remark_on_gains(results);
  for (const StepReport &step : results.steps)
    if (step.reduction)
      results.remarks.push_back(describe_reduction(step.step, *step.reduction));
  std::set<std::string> warnings;
  for (const StepReport &step : results.steps)
    if (!step.warning.empty() && warnings.insert(step.warning).second)
      results.remarks.push_back(step.warning);
  for (unsigned int s = 0; s < results.steps.size(); ++s)
    if (const StepReport &step = results.steps[s]; step.limit && step.converged)
      results.remarks.push_back(
          limit_in_words(scene, step.step, *step.limit, sequence.factors_at_end(s)) +
          motion_in_words(scene, results, s));
  for (const StepReport &step : results.steps)
    if (step.cycle && (step.cycle->number == step.cycle->of || &step == &results.steps.back()))
      results.remarks.push_back("Cycles to the end of step " + step.step + ": " +
                                step.cycle->words + ".");
}

} // namespace

void solve_sequence(const Model &model, LoadSequence &sequence, Results &results) {
  const Scene &scene = model.scene;
  results.units = scene.units;
  remark_on_laws(model, results);
  add_remarks_on_model(model, results);
  if (!scene.stress.code.empty())
    if (const std::string places =
            check_stress_code(scene, model.mesh, FrameBuilder(model, true).stations());
        !places.empty())
      results.remarks.push_back(places);
  LineRun run(model, sequence, results);
  const bool converged = run.run();
  run.conclude(converged);
  report_steps(scene, sequence, converged, results);
  results.certify(scene, !no_contact_is_exact(model));
  judge_energy(scene, results);
  results.known = how_well_known(scene, results);
  add_remarks_on_supports(model, results);
  add_doubts(model, results);
  results.cost.unknowns = model.space.n_unknowns();
  results.cost.cells = model.discretization.pipe_cells().size();
  results.cost.contacts = model.contacts.size();
}

Results solve_scene(const Scene &scene, const LawLibrary &laws) {
  const dealii::Timer wall;
  Results results;
  dealii::Timer timer;
  LineMesh mesh = build_line_mesh(scene);
  results.remarks = mesh.remarks;
  results.cost.mesh_seconds = timer.wall_time();

  timer.restart();
  MixedWalls walls(scene, mesh);
  for (const std::string &text : walls.in_words())
    results.remarks.push_back(text);
  LineModel line(scene, std::move(mesh), laws, walls.superelements());
  for (const std::string &warning : check_mechanisms(line.model()))
    results.remarks.push_back(warning);
  LoadSequence sequence(line.model());
  results.cost.setup_seconds = timer.wall_time();
  solve_sequence(line.model(), sequence, results);
  walls.report(sequence, results);
  results.cost.wall_seconds = wall.wall_time();
  return results;
}

} // namespace frictionbeam
