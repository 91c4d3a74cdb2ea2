// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/run_line.h"
#include "command/support_remarks.h"

#include "analysis/sequence/load_sequence.h"
#include "base/interruption.h"
#include "mesh/build_line_mesh.h"
#include "model/line_model.h"
#include "model/mechanism.h"
#include "results/energy_judgement.h"
#include "results/file/checkpoint.h"
#include "results/file/contact_problem_writer.h"
#include "results/file/csv_writer.h"
#include "results/file/envelope_tables.h"
#include "results/file/vtu_writer.h"
#include "results/frame/derived_cases.h"
#include "results/frame/envelope.h"
#include "results/how_well_known.h"
#include "results/quantity/collector.h"
#include "results/quantity/wall_quantities.h"
#include "results/report/reduction_text.h"
#include "results/stress/stresses.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <set>

namespace frictionbeam {

namespace {

/// A line that is written over on a terminal; nothing in a log.
class ProgressLine {
public:
  explicit ProgressLine(const Scene &scene)
      : scene(scene), on_terminal(!scene.output.quiet && isatty(STDERR_FILENO)) {}
  ~ProgressLine() { clear(); }

  void clear() {
    if (shown)
      std::cerr << "\r\033[K";
    shown = false;
  }

  void show(const Progress &progress) {
    if (!on_terminal || progress.n_increments == 0)
      return;
    shown = true;
    std::cerr << "\r\033[K" << scene.steps[progress.step].name << ' ' << progress.increment << '/'
              << progress.n_increments << std::flush;
  }

private:
  const Scene &scene;
  const bool on_terminal;
  bool shown = false;
};

/// Whether the end of this step says which supports hold when the line vibrates.
bool wants_modes_after(const Scene &scene, const unsigned int step) {
  return scene.modal.n_modes > 0 &&
         (scene.modal.step.empty() ? !scene.steps[step].transient
                                   : scene.steps[step].name == scene.modal.step);
}

/// A case of a combination: over all instants where it has any.
CaseRange range_of(const Results &results, const Frame &end) {
  for (const CombinationRange &range : results.combination_ranges)
    if (range.step == end.step)
      return {&range.least, &range.largest};
  const StepEnvelope *const envelope = results.envelope_of(end.step);
  if (envelope != nullptr && envelope->least_frame)
    return {&*envelope->least_frame, &*envelope->largest_frame};
  return {&end, &end};
}

/// Modes, and the response to the spectra if there are any. @param state that the line vibrates
/// about
std::optional<Frame> vibrate(const Model &model, const LineState &state, Results &results) {
  const Scene &scene = model.scene;
  const ModalAnalysis analysis(model, state, scene.modal);
  add_modes(model, analysis, results);
  if (!scene.spectra.empty()) {
    results.remarks.push_back(
        "Friction is off in the modes and in the response to the spectra: a closed support holds "
        "along its normal only. The method is linear and cannot do otherwise; a transient step "
        "has friction.");
    return spectrum_response(model, analysis);
  }
  if (model.contacts.size() > 0)
    results.remarks.push_back(
        std::string("In the modes, closed supports hold along their normals") +
        (scene.modal.friction_holds ? ", and those that stick sideways too; slipping ones do not."
                                    : " only: friction is off."));
  return {};
}

/// The cases of a combination that were reached.
struct CombinedCases {
  std::vector<CaseRange> ranges;
  bool of_either_sign = false; ///< what comes out is a range
  std::string over_steps;      ///< names of those that are taken over a whole transient step
};

CombinedCases cases_of(const Combination &combination, const Results &results) {
  CombinedCases cases;
  cases.of_either_sign = combination.kind != Combination::Kind::sum;
  for (const auto &part : combination.cases)
    for (const Frame &end : results.frames)
      if (end.end_of_step && end.name == part.first) {
        cases.ranges.push_back(range_of(results, end));
        const CaseRange &range = cases.ranges.back();
        cases.of_either_sign = cases.of_either_sign || range.least != range.largest;
        if (results.envelope_of(end.step) != nullptr)
          cases.over_steps += (cases.over_steps.empty() ? "" : ", ") + part.first;
      }
  return cases;
}

/// Modes, spectra and combinations. Their frames count on from the scene's steps.
void add_derived_cases(const Model &model, const std::optional<LineState> &modal_state,
                       Collector &collector, Results &results) {
  const Scene &scene = model.scene;
  std::optional<Frame> response;
  if (modal_state)
    response = vibrate(model, *modal_state, results);
  unsigned int next = scene.steps.size();
  if (response) {
    response->step = next++;
    results.combination_ranges.push_back({response->step, with_other_sign(*response), *response});
    collector.observe_case(*response);
  }
  for (const Combination &combination : scene.combinations) {
    const CombinedCases cases = cases_of(combination, results);
    if (cases.ranges.size() != combination.cases.size())
      continue; // a transient step may have been left out
    CombinationRange range;
    range.step = next;
    Frame frame = combine(combination, cases.ranges, &range);
    frame.name = combination.name;
    frame.step = next++;
    collector.observe_case(frame);
    if (cases.of_either_sign)
      results.combination_ranges.push_back(range);
    if (cases.over_steps.empty())
      continue;
    results.remarks.push_back(
        "Combination " + combination.name + " takes of " + cases.over_steps +
        " the least and the largest value of each component over the step, at whatever instants: "
        "it is a bound. So are its stresses, the largest of all these values together.");
  }
}

void remark_on_laws(const Model &model, Results &results) {
  std::map<std::string, std::string> without_threshold;
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (const BoundLaw &law = model.contacts[i].law; !law.has_closed_form())
      without_threshold[law.name()] = law.closed_form_varies()
                                          ? " has a threshold that varies with more than its "
                                            "parameters: the exact method does not follow that, and"
                                          : " has no threshold in closed form: the exact method";
  if (model.scene.solver.is_exact())
    for (const auto &[law, what] : without_threshold)
      results.remarks.push_back("The law '" + law + "'" + what +
                                " evaluates it as it is, by Newton's method.");
}

/// Whether there are contacts, and none of them that the exact method could have judged.
bool no_contact_is_exact(const Model &model) {
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (model.contacts[i].law.has_closed_form())
      return false;
  return model.contacts.size() > 0;
}

/// Runs a sequence, and has all look on that gather results and write files while it goes.
class LineRun {
public:
  LineRun(const Model &model, LoadSequence &sequence, Results &results);

  /// From the beginning, or from the checkpoint. @return whether every step converged
  bool run();
  /// What the states that were seen give together: modes and combinations, stresses, quantities,
  /// files.
  void conclude(const bool converged);

private:
  void transfer(Archive &archive);
  void observe(const Progress &progress, const LineState &state);
  /// Between increments: write a checkpoint if it is time, and end if a signal came.
  void pause();
  bool needs_line(const Progress &progress, const double time);

  const Model &model;
  const Scene &scene;
  LoadSequence &sequence;
  Results &results;
  std::unique_ptr<CsvWriter> csv;
  std::unique_ptr<VtuWriter> vtu;
  std::unique_ptr<ContactProblemWriter> contact_problems;
  Collector collector;
  Envelope envelope;
  Checkpoint checkpoint;
  std::optional<LineState> modal_state; ///< at the end of the step that modes start from
  bool line_is_known = true;            ///< of a reduced line, not at every instant
  ProgressLine progress_line;
  dealii::Timer output_timer;
};

LineRun::LineRun(const Model &model, LoadSequence &sequence, Results &results)
    : model(model), scene(model.scene), sequence(sequence), results(results),
      collector(model, results,
                [this](const Frame &frame) {
                  const Frame shown = scene.units.is_si() ? frame : in_units(scene.units, frame);
                  csv->append(shown);
                  if (vtu)
                    vtu->append(shown);
                }),
      envelope(model, results), checkpoint(model), progress_line(scene) {
  output_timer.reset();
  std::optional<Archive> saved;
  if (scene.output.resume)
    saved = checkpoint.read();
  csv = std::make_unique<CsvWriter>(scene, results, scene.output.directory, saved.has_value());
  if (scene.output.vtu)
    vtu = std::make_unique<VtuWriter>(results, scene.output.directory);
  if (scene.output.contact_problems)
    contact_problems = std::make_unique<ContactProblemWriter>(model, results, saved.has_value());
  if (scene.time.is_exact())
    sequence.watch([this](const MotionPiece &piece) {
      output_timer.start();
      collector.observe_piece(piece);
      envelope.observe_piece(piece);
      output_timer.stop();
    });
  if (saved)
    transfer(*saved);
}

void LineRun::transfer(Archive &archive) {
  archive(sequence, collector, envelope, *csv, modal_state);
  if (vtu)
    archive(*vtu);
  if (contact_problems)
    archive(*contact_problems);
}

bool LineRun::run() {
  const dealii::Timer timer;
  const bool converged = sequence.run(
      [this](const Progress &progress, const LineState &state) { observe(progress, state); },
      [this](const Progress &progress, const LineState &state) {
        output_timer.start();
        if (contact_problems)
          contact_problems->observe(progress, state);
        output_timer.stop();
      },
      [this]() { pause(); },
      [this](const Progress &progress, const double time) { return needs_line(progress, time); });
  progress_line.clear();
  results.cost.solve_seconds = timer.wall_time() - output_timer.wall_time();
  return converged;
}

void LineRun::observe(const Progress &progress, const LineState &state) {
  output_timer.start();
  interruption::end_if_overdue();
  progress_line.show(progress);
  collector.observe(progress.step, progress.increment, progress.n_increments, state);
  envelope.observe(progress.step, progress.increment, progress.n_increments, state, line_is_known);
  line_is_known = true;
  if (progress.increment == progress.n_increments && wants_modes_after(scene, progress.step))
    modal_state = state;
  output_timer.stop();
}

bool LineRun::needs_line(const Progress &progress, const double time) {
  line_is_known =
      envelope.needs_line(progress.step) ||
      collector.needs_line(progress.step, progress.increment, progress.n_increments, time);
  return line_is_known;
}

void LineRun::pause() {
  const int signal = interruption::received();
  if (!checkpoint.is_due() && signal == 0)
    return;
  output_timer.start();
  if (!scene.takes_many_runs()) { // else there are many runs, which are not resumed
    Archive archive;
    transfer(archive);
    checkpoint.write(archive);
  }
  output_timer.stop();
  if (signal != 0)
    throw Interrupted(signal, "Interrupted at time " + rounded_number(sequence.state().time) +
                                  " s of step " + sequence.reports().back().step + ".");
}

void LineRun::conclude(const bool converged) {
  results.steps = sequence.reports();
  if (converged)
    add_derived_cases(model, modal_state, collector, results);
  std::map<std::pair<std::string, unsigned int>, double> pressures; // by step and pipe
  results.stresses = evaluate_stresses(
      scene, model.mesh, results, [&](const std::string &step, const unsigned int pipe) {
        const auto [known, is_new] = pressures.try_emplace({step, pipe}, 0.);
        if (is_new)
          known->second = pressure_in(scene, step, pipe);
        return known->second;
      });
  results.nozzles = evaluate_nozzles(scene, results);
  add_envelope_remarks(scene, results);
  collector.finish(sequence.state());
  csv->finish();
  if (vtu) {
    vtu->append_modes();
    vtu->finish();
  }
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
  for (const StepReport &step : results.steps)
    if (step.cycle && (step.cycle->number == step.cycle->of || &step == &results.steps.back()))
      results.remarks.push_back("Cycles to the end of step " + step.step + ": " +
                                step.cycle->words + ".");
}

} // namespace

Results solve_scene(const Scene &scene, const LawLibrary &laws) {
  const dealii::Timer wall;
  Results results;
  results.units = scene.units;
  dealii::Timer timer;
  LineMesh mesh = build_line_mesh(scene);
  results.remarks = mesh.remarks;
  results.cost.mesh_seconds = timer.wall_time();

  timer.restart();
  const LineModel line(scene, std::move(mesh), laws);
  const Model &model = line.model();
  if (!has_transient_step(scene))
    for (const std::string &warning : check_mechanisms(model))
      results.remarks.push_back(warning);
  remark_on_laws(model, results);
  add_remarks_on_model(model, results);
  LoadSequence sequence(model);
  results.cost.setup_seconds = timer.wall_time();

  LineRun run(model, sequence, results);
  const bool converged = run.run();
  run.conclude(converged);
  report_steps(scene, sequence, converged, results);
  results.certify(scene, !no_contact_is_exact(model));
  judge_energy(scene, results);
  results.known = how_well_known(scene, results);
  add_remarks_on_supports(model, results);
  if (scene.mesh.refine_hinges)
    results.yielded = yielded_cells(model, sequence.state());
  results.cost.unknowns = model.space.n_unknowns();
  results.cost.cells = model.discretization.pipe_cells().size();
  results.cost.contacts = model.contacts.size();
  results.cost.wall_seconds = wall.wall_time();
  return results;
}

} // namespace frictionbeam
