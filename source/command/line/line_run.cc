// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/line_run.h"

#include "base/interruption.h"
#include "base/unused_memory.h"
#include "results/combination/governing_cases.h"
#include "results/file/envelope_tables.h"
#include "results/frame/derived_cases.h"
#include "results/listing/hangers.h"
#include "results/quantity/wall_quantities.h"
#include "results/spectrum/modal_csv.h"
#include "results/spectrum/spectrum_response.h"
#include "results/stress/inner_pressure.h"
#include "results/stress/stresses.h"
#include "results/table/model_tables.h"
#include "results/text.h"

#include <algorithm>
#include <map>

namespace frictionbeam {

namespace {

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
    if (!scene.response.write_modes || scene.output.directory.empty())
      return spectrum_response(model, analysis, results);
    ModalCsv csv(scene, results, scene.output.directory);
    return spectrum_response(model, analysis, results,
                             [&](const unsigned int mode, const unsigned int direction,
                                 const Frame &frame) { csv.append(mode, direction, frame); });
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
    if (has_governing_cases(combination.kind)) // before there are more frames: the cases move then
      results.governing.push_back(governing_cases(combination, cases.ranges, results));
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

} // namespace

LineRun::LineRun(const Model &model, LoadSequence &sequence, Results &results)
    : model(model), scene(model.scene), sequence(sequence), results(results),
      collector(model, results,
                [this](const Frame &frame) {
                  if (!csv)
                    return;
                  Frame converted;
                  const Frame &shown = in_units(scene.units, frame, converted);
                  csv->append(shown);
                  if (scene.output.report)
                    kept_instants.add(frame);
                  if (vtu && vtu_frames.takes(frame))
                    vtu->append(shown);
                }),
      envelope(model, results), sections(model), vtu_frames(scene), kept_instants(scene, results),
      progress_line(scene) {
  output_timer.reset();
  if (scene.time.is_exact())
    sequence.watch([this](const MotionPiece &piece) {
      output_timer.start();
      collector.observe_piece(piece);
      envelope.observe_piece(piece);
      output_timer.stop();
    });
  if (!scene.output.directory.empty())
    open_files();
}

void LineRun::open_files() {
  checkpoint.emplace(model);
  std::optional<Archive> saved;
  if (scene.output.resume)
    saved = checkpoint->read();
  csv = std::make_unique<CsvWriter>(scene, results, scene.output.directory, saved.has_value());
  write_model_tables(model, results, scene.output.directory);
  if (scene.output.vtu)
    vtu = std::make_unique<VtuWriter>(results, scene.output.directory, scene.steps.size());
  if (scene.output.contact_problems)
    contact_problems = std::make_unique<ContactProblemWriter>(model, results, saved.has_value());
  if (saved)
    transfer(*saved);
}

LineRun::~LineRun() = default;

void LineRun::transfer(Archive &archive) {
  archive(sequence, collector, envelope, sections, *csv, kept_instants, modal_state);
  if (vtu)
    archive(*vtu, vtu_frames);
  if (contact_problems)
    archive(*contact_problems);
}

bool LineRun::run() {
  const dealii::Timer timer;
  const bool converged = sequence.run(
      [this](const Progress &progress, const LineState &state) { observe(progress, state); },
      [this](const Progress &progress, const LineState &state) {
        output_timer.start();
        sections.observe(state);
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
  if (progress.behind_jump) {
    collector.observe_behind_jump(state);
    envelope.observe_behind_jump(state, line_is_known);
    line_is_known = true;
    output_timer.stop();
    return;
  }
  if (progress.is_part) {
    collector.observe_part(state);
    output_timer.stop();
    return;
  }
  progress_line.show(progress);
  if (progress.n_increments == 0)
    vtu_frames.begin(state.time);
  collector.observe(progress.step, progress.increment, progress.n_increments, state);
  envelope.observe(progress.step, progress.increment, progress.n_increments, state, line_is_known);
  line_is_known = true;
  if (progress.increment == progress.n_increments && wants_modes_after(scene, progress.step))
    modal_state = state;
  if (scene.mesh.refine_hinges && progress.increment == progress.n_increments)
    for (const auto &cell : yielded_cells(model, state))
      if (std::count(results.yielded.begin(), results.yielded.end(), cell) == 0)
        results.yielded.push_back(cell);
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
  if (signal == 0 && !(checkpoint && checkpoint->is_due()))
    return;
  output_timer.start();
  if (checkpoint && !scene.takes_many_runs()) { // else there are many runs, which are not resumed
    {
      Archive archive;
      transfer(archive);
      checkpoint->write(archive);
    }
    give_back_unused_memory();
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
  results.hangers = evaluate_hangers(scene, results);
  add_envelope_remarks(scene, results);
  collector.finish(sequence.state());
  results.section_histories = sections.histories(sequence.state());
  if (csv)
    csv->finish();
  if (vtu) {
    for (const std::string &remark : vtu_frames.remarks())
      results.remarks.push_back(remark);
    vtu->append_modes();
    vtu->finish();
  }
}

} // namespace frictionbeam
