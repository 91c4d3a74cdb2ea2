// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/sequence/load_sequence.h"

#include "analysis/contact/undetermined_forces.h"
#include "analysis/increment/follow_resolution.h"
#include "analysis/reduction/transient_reduction.h"
#include "model/cell/line_cells.h"
#include "model/line_model.h"
#include "scene/steps/step_factors.h"
#include "scene/steps/step_tree.h"

#include "analysis/increment/time_step.h"
#include "analysis/time/step_helpers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
/// Whether a step that leads to this one is transient.
bool has_moved_before(const Scene &scene, const unsigned int step) {
  for (auto before = step_before(scene, step); before; before = step_before(scene, *before))
    if (scene.steps[*before].transient)
      return true;
  return false;
}

/// Of the line as it is built: no load acts, but preloads do of which no limit is to be a part.
std::vector<double> factors_at_start(const Scene &scene) {
  if (!scene.steps.empty() && scene.steps[0].finds_limit)
    return declared_factors(scene, LoadStep());
  return std::vector<double>(scene.loads.size(), 0.);
}
} // namespace

LoadSequence::LoadSequence(const Model &model)
    : model(model), own_statics(make_statics(model)), statics(*own_statics), course(model),
      declared(factors_at_start(model.scene)), path(model), cycles(model) {}

LoadSequence::LoadSequence(const Model &model, Statics &statics)
    : model(model), statics(statics), course(model), declared(factors_at_start(model.scene)),
      path(model), cycles(model) {}

LoadSequence::~LoadSequence() = default;

LoadSequence::Factors LoadSequence::target_of(const LoadStep &step) const {
  return declared_factors(model.scene, step);
}

std::string LoadSequence::integrator_name() const {
  return march ? march->integrator_name() : reduction ? reduction->integrator_name() : "";
}

void LoadSequence::initialize() {
  check_time_steps(model);
  const unsigned int n = model.space.n_unknowns();
  current.unknowns = Vector::Zero(n);
  if (has_transient_step(model.scene) || !model.scene.initial.empty())
    current.velocity = current.acceleration = current.auxiliary = current.unknowns;
  current.load_factors = declared;
  current.turns = model.cells.at_rest().turns;
  current.sections = model.cells.pipe_sections().at_rest();
  set_initial_motion(true);
  const Vector imposed = course.imposed(0.);
  const auto expand = [&]() {
    model.space.expand(current.unknowns, current.dofs);
    current.dofs += imposed;
  };
  expand();
  current.contacts = model.contacts.initial_state(current.dofs);
  check_initial_gaps();
  model.contacts.place_platens(current.unknowns);
  expand();
  model.contacts.evaluate(current.dofs, current.contacts, {}, LawTangent::none, response);
  model.contacts.press_platens(response);
  commit(declared, 0.);
  press_at_start();
}

void LoadSequence::commit(const Factors &factors, const double time) {
  response.state.wear = current.contacts.wear;
  response.state.impulse = current.contacts.impulse;
  const std::vector<ContactStatus> before = current.contact_status;
  current.time = time;
  declared = factors;
  current.load_factors = course.factors_at(time, side);
  commit_contacts(response, before, current);
}

bool LoadSequence::run(const Observer &observer, const Observer &each, const Pause &pause,
                       const NeedsLine &needs_line) {
  each_increment = each;
  part_observer = observer;
  between_increments = pause;
  observer_needs_line = needs_line;
  if (!resolution)
    resolution = std::make_unique<FollowResolution>(model);
  if (!is_resumed) {
    initialize();
    observer({0, 0, 0}, current);
    if (each_increment)
      each_increment({0, 0, 0}, current);
  }
  for (; position.step < model.scene.steps.size(); ++position.step) {
    const LoadStep &declared_step = model.scene.steps[position.step];
    if (!is_resumed) {
      StepReport report;
      report.step = declared_step.name;
      step_reports.push_back(report);
      if (is_branch(model.scene, position.step)) {
        go_back_to(*declared_step.from);
        observer({position.step, 0, 0}, current);
        if (each_increment)
          each_increment({position.step, 0, 0}, current);
      }
      position.from = declared;
      position.start = current.time;
      position.next = 0;
      path.begin(1. / declared_step.n_increments, model.cells.pipe_sections().any());
      cycles.step_begins(declared_step, current);
      resolution->begin_step();
    }
    const Factors target = target_of(declared_step);
    course.begin_step(position.step, position.from, target, position.start,
                      declared_step.transient ? declared_step.ramp : declared_step.duration);
    if (declared_step.transient && !is_resumed && position.step > 0 &&
        !model.scene.initial.empty() && !has_moved_before(model.scene, position.step)) {
      set_initial_motion(false);
      current.events.clear();
      observer({position.step, 0, 0}, current); // its velocity has changed
    }
    const bool reduced = is_resumed
                             ? reduction && reduction->is_within_step()
                             : model.scene.time.reduction.modes != ReductionSettings::Modes::all;
    step_reports.back().converged = !declared_step.transient ? run_static(target, observer)
                                    : reduced                ? run_reduced(target, observer)
                                                             : run_transient(target, observer);
    if (!step_reports.back().converged)
      return false;
    step_reports.back().cycle = cycles.step_ends(declared_step, current);
    factors_at_ends.push_back(current.load_factors);
    if (judges && model.scene.solver.is_exact())
      if (std::vector<unsigned int> found =
              contacts_with_undetermined_forces(model.contacts, current);
          !found.empty()) {
        step_reports.back().undetermined_forces = std::move(found);
        step_reports.back().undetermined_within = false;
      }
    if (is_returned_to(model.scene, position.step)) {
      Archive archive;
      transfer_state(archive);
      kept[position.step] = archive.bytes();
    }
  }
  return true;
}

void LoadSequence::transfer_state(Archive &archive) {
  archive(declared, current, force_so_far, in_equilibrium, statics, cycles, *resolution);
}

void LoadSequence::go_back_to(const unsigned int step) {
  const double time = current.time;
  Archive archive(kept.at(step));
  transfer_state(archive);
  current.time = time;
  current.events.clear();
  if (march)
    march = std::make_unique<TimeMarch>(model, piece_observer);
}

void LoadSequence::transfer(Archive &archive) {
  bool has_moved = march != nullptr, has_reduced = reduction != nullptr;
  if (!resolution)
    resolution = std::make_unique<FollowResolution>(model);
  transfer_state(archive);
  std::vector<std::pair<unsigned int, std::string>> ends(kept.begin(), kept.end());
  archive(position, path, step_reports, ends, factors_at_ends, has_moved, has_reduced);
  kept = {ends.begin(), ends.end()};
  if (archive.reads() && has_moved)
    march = std::make_unique<TimeMarch>(model, piece_observer);
  if (has_moved)
    archive(*march);
  if (archive.reads() && has_reduced)
    reduction = std::make_unique<TransientReduction>(model, piece_observer);
  if (has_reduced)
    reduction->transfer(
        {position.step, position.from, target_of(model.scene.steps[position.step]), position.start},
        archive);
  if (archive.reads())
    is_resumed = true;
}

bool LoadSequence::run_transient(const Factors &target, const Observer &observer) {
  if (!march)
    march = std::make_unique<TimeMarch>(model, piece_observer);
  const bool resumed = is_resumed;
  is_resumed = in_equilibrium = false;
  const bool done = march->run(
      {position.step, position.from, target, position.start}, course, current, step_reports.back(),
      {observer, each_increment, between_increments, resolution.get()}, resumed);
  declared = course.declared(current.time);
  return done;
}

bool LoadSequence::run_reduced(const Factors &target, const Observer &observer) {
  if (!reduction)
    reduction = std::make_unique<TransientReduction>(model, piece_observer);
  StepReport &report = step_reports.back();
  const TransientStep start{position.step, position.from, target, position.start};
  const bool resumed = is_resumed;
  if (!resumed) {
    report.reduction.emplace();
    if (!reduction->prepare(start, current, *report.reduction))
      return run_transient(target, observer);
  }
  is_resumed = in_equilibrium = false;
  const bool done = reduction->run(start, course, current, report,
                                   {observer, observer_needs_line, between_increments}, resumed);
  declared = course.declared(current.time);
  return done;
}

} // namespace frictionbeam
