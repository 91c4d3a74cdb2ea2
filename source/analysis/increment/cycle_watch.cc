// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/cycle_watch.h"

#include "base/number_text.h"
#include "model/cell/line_cells.h"
#include "model/mechanism.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double steady = 0.02; ///< by which a rate may differ from that of the cycle before

CycleVerdict::Kind kind_of(const CycleVerdict &cycle, const PipeSections::Change &change,
                           const bool has_lost) {
  using Kind = CycleVerdict::Kind;
  if (!has_lost)
    return Kind::elastic;
  if (!change.flows)
    return Kind::shakedown;
  if (cycle.number == 1)
    return Kind::unsettled;
  if (change.comes_back)
    return Kind::alternating;
  return std::abs(cycle.growth - cycle.growth_before) <= steady * cycle.growth_before
             ? Kind::ratchet
             : Kind::unsettled;
}

std::string words_of(const CycleVerdict &cycle, const double part, const Model &model,
                     const LineState &state) {
  using Kind = CycleVerdict::Kind;
  const auto number = [](const double value) { return rounded_number(value, 4); };
  const std::string there = " (" + place_in_words(model, cycle.cell, part) + ")";
  switch (cycle.kind) {
  case Kind::elastic:
    return "elastic: nothing has yielded or crept";
  case Kind::shakedown:
    return "shakedown: the last cycle is elastic";
  case Kind::alternating:
    return "alternating plasticity: strains close, and " +
           (std::isnan(cycle.flow)
                ? "work is lost in each cycle; how far it yields, its law does not tell"
                : number(cycle.flow) + " is yielded in a cycle") +
           there +
           (model.cells.surroundings(cycle.cell, state.load_factors).pressure == 0.
                ? ""
                : "; whether the wall widens in each cycle, under its pressure, is not judged");
  case Kind::ratchet:
    return "ratchet: a section strains by " + number(cycle.growth) + " a cycle" + there;
  case Kind::unsettled:
    break;
  }
  return cycle.number == 1 ? "not settled: one cycle tells nothing"
                           : "not settled: a section strains by " + number(cycle.growth) +
                                 " in the last cycle, by " + number(cycle.growth_before) +
                                 " in the one before" + there + "; take more cycles";
}

} // namespace

void CycleWatch::step_begins(const LoadStep &step, const LineState &state) {
  if (!step.cycle.begins || step.cycle.number != 1)
    return;
  before = state.sections;
  growth_before = 0.;
  has_lost = false;
}

std::optional<CycleVerdict> CycleWatch::step_ends(const LoadStep &step, const LineState &state) {
  if (!step.cycle.ends || !model.cells.pipe_sections().any())
    return {};
  const PipeSections::Change change =
      model.cells.pipe_sections().largest_change(before, state.sections);
  CycleVerdict cycle;
  cycle.number = step.cycle.number;
  cycle.of = step.cycle.of;
  cycle.dissipated = change.dissipated;
  cycle.growth = change.growth;
  cycle.growth_before = growth_before;
  cycle.flow = change.flow;
  cycle.cell = change.cell;
  has_lost = has_lost || cycle.dissipated > 0. || change.flows;
  cycle.kind = kind_of(cycle, change, has_lost);
  cycle.words = words_of(cycle, change.part, model, state);
  before = state.sections;
  growth_before = cycle.growth;
  return cycle;
}

} // namespace frictionbeam
