// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/envelope/envelope.h"
#include "results/envelope/envelope_tools.h"

#include "results/frame/derived_cases.h"

#include "model/cell/line_cells.h"
#include "results/stress/inner_pressure.h"
#include "results/stress/stresses.h"
#include "results/support/support_states.h"
#include "results/text.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frictionbeam {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether a combination has this step among its cases.
bool is_combined(const Scene &scene, const std::string &step) {
  for (const Combination &combination : scene.combinations)
    for (const auto &part : combination.cases)
      if (part.first == step)
        return true;
  return false;
}

bool has_stresses(const Scene &scene, const std::string &step) {
  const StressSettings &stress = scene.stress;
  return !stress.code.empty() &&
         (std::count(stress.sustained.begin(), stress.sustained.end(), step) > 0 ||
          std::count(stress.occasional.begin(), stress.occasional.end(), step) > 0 ||
          std::any_of(stress.expansion.begin(), stress.expansion.end(),
                      [&](const auto &range) { return range.second == step; }));
}

/// What every station of a cell has met already.
SectionForces::Bounds met_by_all(const StepEnvelope &envelope, const unsigned int first,
                                 const unsigned int n) {
  SectionForces::Bounds result;
  result.low.fill(-infinity);
  result.high.fill(infinity);
  for (unsigned int i = first; i < first + n; ++i)
    for (unsigned int c = 0; c < 6; ++c) {
      result.low[c] = std::max(result.low[c], envelope.least[6 * i + c]);
      result.high[c] = std::min(result.high[c], envelope.largest[6 * i + c]);
    }
  return result;
}

} // namespace

Envelope::Envelope(const Model &model, Results &results) : model(model), results(results) {}

Envelope::~Envelope() = default;

bool Envelope::needs_line(const unsigned int step) const {
  const std::string &name = model.scene.steps[step].name;
  return has_stresses(model.scene, name) || is_combined(model.scene, name);
}

void Envelope::transfer(Archive &archive) {
  archive(results.stations, results.envelopes, previous_status, previous_impulse, sizes_met);
  if (archive.reads() && !results.envelopes.empty())
    prepare(results.envelopes.back().step);
}

void Envelope::observe(const unsigned int step, const unsigned int increment,
                       const unsigned int n_increments, const LineState &state,
                       const bool line_is_known) {
  const auto &steps = model.scene.steps;
  const bool is_start = n_increments == 0, is_end = !is_start && increment == n_increments;
  if (!is_start && steps[step].transient)
    include(state, line_is_known);
  const unsigned int next = is_start ? step : step + 1;
  if ((is_start || (is_end && next < steps.size() && !is_branch(model.scene, next))) &&
      steps[next].transient) {
    begin(next, state);
    include(state, true);
  }
}

void Envelope::observe_behind_jump(const LineState &state, const bool line_is_known) {
  const std::vector<ContactStatus> before = std::exchange(previous_status, state.contact_status);
  include(state, line_is_known);
  previous_status = before;
}

void Envelope::begin(const unsigned int step, const LineState &state) {
  if (!results.envelopes.empty() && results.envelopes.back().step == step)
    results.envelopes.pop_back(); // the step begins with another state than the one before ended
  results.envelopes.emplace_back();
  StepEnvelope &envelope = results.envelopes.back();
  envelope.step = step;
  envelope.start = state.time;
  prepare(step);
  if (results.stations.empty())
    for (const Station &station : tools->line)
      results.stations.push_back({station.pipe, station.s});
  const std::size_t n = tools->line.size();
  envelope.supports.resize(results.supports.size());
  envelope.restraints.resize(results.restraints.size());
  envelope.points.resize(results.points.size());
  envelope.least.assign(6 * n, infinity);
  envelope.largest.assign(6 * n, -infinity);
  envelope.least_at.assign(6 * n, 0.);
  envelope.largest_at.assign(6 * n, 0.);
  envelope.nozzles.resize(tools->nozzles.size());
  for (StressEnvelope &stress : envelope.stresses) {
    stress.stress.assign(n, -1.);
    stress.time.assign(n, 0.);
    stress.force.assign(6 * n, 0.);
  }
  previous_status = state.contact_status;
  previous_impulse = state.contacts.impulse;
  sizes_met.fill(0.);
}

void Envelope::prepare(const unsigned int step) {
  if (!tools)
    tools = std::make_unique<EnvelopeTools>(model, results);
  SectionForces::Bounds nothing;
  nothing.low.fill(infinity);
  nothing.high.fill(-infinity);
  if (tools->section_forces)
    tools->known.assign(tools->section_forces->n_cells(), nothing);
  tools->kinds.resize(0);
  stresses.reset();
  const std::string &name = model.scene.steps[step].name;
  tools->is_part = is_combined(model.scene, name);
  if (!has_stresses(model.scene, name))
    return;
  stresses = std::make_unique<EnvelopeStresses>();
  const StressEvaluation evaluation(model.scene, model.mesh, results);
  const StressSettings &settings = model.scene.stress;
  std::vector<StressEnvelope> envelopes;
  const auto add = [&](const std::string &from, const Frame *const before) {
    EnvelopeStresses::Case one;
    std::vector<double> pressure(model.scene.pipes.size(), 0.);
    for (unsigned int pipe = 0; pipe < pressure.size() && before == nullptr; ++pipe)
      pressure[pipe] = pressure_in(model.scene, name, pipe);
    for (unsigned int i = 0; i < tools->line.size(); ++i) {
      const Station &station = tools->line[i];
      const StressPoint point = evaluation.point(station);
      one.formulas.push_back(before ? evaluation.code.expansion_range(point)
                                    : evaluation.code.sustained(point));
      one.axes.push_back(evaluation.axes(station, pressure[station.pipe]));
      one.before.push_back(before ? before->line[i].force : Motion{});
    }
    stresses->cases.push_back(std::move(one));
    envelopes.push_back({from, {}, {}});
  };
  if (std::count(settings.sustained.begin(), settings.sustained.end(), name) +
          std::count(settings.occasional.begin(), settings.occasional.end(), name) >
      0)
    add("", nullptr);
  for (const auto &[from, to] : settings.expansion)
    if (to == name)
      if (const Frame *const before = evaluation.frame_of(from))
        add(from, before);
  if (results.envelopes.back().stresses.empty()) // else those of a checkpoint
    results.envelopes.back().stresses = std::move(envelopes);
}

bool Envelope::strikes(const LineState &state, const unsigned int support) const {
  const auto strikes_at = [&](const unsigned int i) {
    const auto closes = [&](const ContactEvent &event) {
      return event.contact == i && event.status != ContactStatus::open;
    };
    return tools->rigid[i] && previous_status[i] == ContactStatus::open &&
           (state.contact_status[i] != ContactStatus::open ||
            std::any_of(state.events.begin(), state.events.end(), closes));
  };
  const std::vector<unsigned int> &contacts = model.contacts.places()[support];
  return std::any_of(contacts.begin(), contacts.end(), strikes_at);
}

double Envelope::previous_impulse_of(const unsigned int support) const {
  double sum = 0.;
  for (const unsigned int contact : model.contacts.places()[support])
    sum += previous_impulse[contact];
  return sum;
}

bool Envelope::is_impulse(const LineState &state, const unsigned int i) const {
  return !model.scene.time.is_exact() && strikes(state, i);
}

void Envelope::include(const LineState &state, const bool line_is_known) {
  StepEnvelope &envelope = results.envelopes.back();
  envelope.end = state.time;
  ++envelope.n_instants;
  if (line_is_known) {
    ++envelope.n_line_instants;
    include_line(state);
    include_displacements(state);
  } else
    include_reactions(state.time, tools->builder.reactions(state));
  include_supports(state);
  previous_status = state.contact_status;
  previous_impulse = state.contacts.impulse;
}

void Envelope::include_supports(const LineState &state) {
  StepEnvelope &envelope = results.envelopes.back();
  double normal = 0., friction = 0.;
  bool any_impulse = false;
  for (unsigned int i = 0; i < envelope.supports.size(); ++i) {
    SupportEnvelope &support = envelope.supports[i];
    const SupportState now = support_state(model, state, i);
    const double along = friction_force(now), size = std::hypot(now.fn, along),
                 impulse = now.impulse - previous_impulse_of(i);
    support.impulse += impulse;
    const std::array<double, 6> values{{now.fn, now.ft1, now.ft2, now.gap, now.slip1, now.slip2}};
    if (strikes(state, i)) {
      ++support.n_impacts;
      support.impact.include(impulse, state.time);
    }
    const bool no_force = is_impulse(state, i);
    for (unsigned int c = no_force ? 3 : 0; c < 6; ++c)
      support.values[c].include(values[c], state.time);
    any_impulse = any_impulse || no_force;
    normal += std::abs(now.fn);
    friction += along;
    if (no_force)
      continue;
    support.friction.include(along, state.time);
    if (size > support.force.largest)
      support.at_largest = now;
    support.force.include(size, state.time);
  }
  if (any_impulse)
    return;
  envelope.sum_normal.include(normal, state.time);
  envelope.sum_friction.include(friction, state.time);
}

void Envelope::include_line(const LineState &state) {
  StepEnvelope &envelope = results.envelopes.back();
  const auto include = [&](const unsigned int first, const double *const forces,
                           const unsigned int n) { include_forces(state.time, first, forces, n); };
  if (model.cells.is_linear() && !tools->is_part) {
    include_reactions(state.time, tools->builder.reactions(state));
    const auto is_inside = [&](const unsigned int cell, const SectionForces::Bounds &bounds) {
      if (stresses)
        return false; // they may grow where no force does
      const SectionForces::Bounds &known = tools->known[cell];
      for (unsigned int c = 0; c < 6; ++c)
        if (bounds.low[c] < known.low[c] || bounds.high[c] > known.high[c])
          return false;
      return true;
    };
    tools->section_forces->evaluate(
        state, is_inside,
        [&](const unsigned int first, const double *const forces, const unsigned int n) {
          include(first, forces, n);
          tools->known[first / n] = met_by_all(envelope, first, n);
        });
    return;
  }
  Frame frame = tools->builder.make(state);
  include_reactions(state.time, frame.reactions);
  for (unsigned int i = 0; i < frame.line.size(); ++i)
    include(i, frame.line[i].force.data(), 1);
  if (!tools->is_part)
    return;
  if (!envelope.least_frame)
    envelope.least_frame = envelope.largest_frame = frame;
  for (unsigned int i = 0; i < frame.supports.size(); ++i)
    if (is_impulse(state, i))
      frame.supports[i] = envelope.least_frame->supports[i];
  widen(*envelope.least_frame, *envelope.largest_frame, frame);
}

void Envelope::include_reactions(const double time, const std::vector<Motion> &reactions) {
  StepEnvelope &envelope = results.envelopes.back();
  for (unsigned int i = 0; i < reactions.size(); ++i) {
    RestraintEnvelope &restraint = envelope.restraints[i];
    const Motion &force = reactions[i];
    for (unsigned int c = 0; c < 6; ++c)
      restraint.values[c].include(force[c], time);
    const double size = std::hypot(force[0], force[1], force[2]);
    if (size > restraint.force.largest)
      restraint.at_largest = force;
    restraint.force.include(size, time);
  }
  for (unsigned int i = 0; i < tools->nozzles.size(); ++i) {
    const auto &[nozzle, restraint] = tools->nozzles[i];
    const double use = utilization(model.scene.nozzles[nozzle], reactions[restraint]);
    if (use > envelope.nozzles[i].utilization)
      envelope.nozzles[i] = {use, time, reactions[restraint]};
  }
}

void Envelope::include_displacements(const LineState &state) {
  StepEnvelope &envelope = results.envelopes.back();
  for (unsigned int i = 0; i < tools->points.size(); ++i)
    for (unsigned int c = 0; c < 6; ++c)
      envelope.points[i][c].include(EnvelopeTools::value_at(state, tools->points[i][c]),
                                    state.time);
  double largest = -1.;
  const StationPlace *place = nullptr;
  for (const auto &[node, dofs] : tools->nodes) {
    const double x = state.dofs[dofs[0]], y = state.dofs[dofs[1]], z = state.dofs[dofs[2]],
                 square = x * x + y * y + z * z;
    if (square > largest) {
      largest = square;
      place = &node;
    }
  }
  if (place == nullptr)
    return;
  const double size = std::sqrt(largest);
  if (size > envelope.displacement.largest)
    envelope.displaced_most = *place;
  envelope.displacement.include(size, state.time);
}

void Envelope::include_forces(const double time, const unsigned int first,
                              const double *const forces, const unsigned int n_stations) {
  StepEnvelope &envelope = results.envelopes.back();
  const unsigned int n = 6 * n_stations;
  double *const least = envelope.least.data() + 6 * first, *const largest =
                                                               envelope.largest.data() + 6 * first;
  using Numbers = Eigen::Map<const Eigen::ArrayXd>;
  const Numbers now(forces, n), low(least, n), high(largest, n);
  if ((now - high).max(low - now).maxCoeff() > 0.)
    for (unsigned int k = 0; k < n; ++k) {
      if (forces[k] < least[k]) {
        least[k] = forces[k];
        envelope.least_at[6 * first + k] = time;
      }
      if (forces[k] > largest[k]) {
        largest[k] = forces[k];
        envelope.largest_at[6 * first + k] = time;
      }
    }
  if (!stresses)
    return;
  for (unsigned int k = 0; k < stresses->cases.size(); ++k) {
    StressEnvelope &most = envelope.stresses[k];
    for (unsigned int j = 0; j < n_stations; ++j) {
      const unsigned int i = first + j;
      const double stress = stresses->cases[k](i, forces + 6 * j);
      if (stress > most.stress[i]) {
        most.stress[i] = stress;
        most.time[i] = time;
        std::copy_n(forces + 6 * j, 6, most.force.begin() + 6 * i);
      }
    }
  }
}

} // namespace frictionbeam
