// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/quick_line.h"

#include "model/line_model.h"
#include "results/quantity/shown_quantity.h"
#include "results/stress/inner_pressure.h"
#include "results/stress/stresses.h"
#include "results/support/support_states.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace frictionbeam::study {

namespace {

using Of = QuantityKind::Of;

/// Of a stress the largest of the line: places and factors are not kept.
bool can_evaluate(const Quantity &quantity) {
  const bool is_largest =
      quantity.where.empty() &&
      (quantity.what == "SL" || quantity.what == "SE" || quantity.what == "utilization");
  return quantity.over == Quantity::Over::end && !quantity.time &&
         (quantity.is(Of::motion) || quantity.is(Of::section) || quantity.is(Of::holder) ||
          quantity.is(Of::support) || quantity.is(Of::supports) ||
          (quantity.is(Of::stress) && is_largest));
}

unsigned int place_of_step(const Scene &scene, const std::string &name) {
  const auto step = std::find_if(scene.steps.begin(), scene.steps.end(),
                                 [&](const LoadStep &one) { return one.name == name; });
  Assert(step != scene.steps.end(), dealii::ExcInternalError());
  return step - scene.steps.begin();
}

/// Step at whose end a quantity is taken.
unsigned int step_of(const Quantity &quantity, const Scene &scene) {
  return quantity.step.empty() ? scene.steps.size() - 1 : place_of_step(scene, quantity.step);
}

bool are_equal(const StressPoint &one, const StressPoint &other) {
  const auto numbers = [](const StressPoint &p) {
    return std::make_tuple(p.part, p.diameter, p.wall, p.corrosion, p.bend_radius, p.youngs_modulus,
                           p.stiffening_pressure, p.tee, p.pad, p.crotch_radius, p.run_diameter,
                           p.run_wall, p.run_corrosion, p.allowable_cold, p.allowable_hot);
  };
  return numbers(one) == numbers(other);
}

} // namespace

bool QuickLine::can_do(const Scene &scene) {
  return !has_transient_step(scene) && scene.kinematics == Kinematics::linear && !scene.yields() &&
         scene.combinations.empty() && scene.spectra.empty() && scene.modal.n_modes == 0 &&
         !scene.exact && scene.initial.empty() &&
         std::none_of(scene.steps.begin(), scene.steps.end(),
                      [](const LoadStep &step) { return step.finds_limit; }) &&
         std::all_of(scene.quantities.begin(), scene.quantities.end(), can_evaluate);
}

QuickLine::QuickLine(const Model &model)
    : model(model), scene(model.scene), collector(model, results, [](const Frame &) {}),
      builder(model, true), section_forces(model), values(scene.quantities.size()) {
  results.units = scene.units;
  const std::vector<Station> line = builder.stations();
  forces.assign(scene.steps.size(), std::vector<double>(6 * line.size()));
  for (unsigned int step = 0; step < scene.steps.size(); ++step) {
    Frame &frame = results.frames.emplace_back();
    frame.name = scene.steps[step].name;
    frame.step = step;
    frame.line = line;
    frame.supports.resize(model.contacts.places().size());
  }
  if (scene.stress.code.empty())
    return;
  evaluation = std::make_unique<StressEvaluation>(scene, model.mesh, results);
  find_points();
  for (const std::string &step : scene.stress.sustained)
    add_case("sustained", "", step);
  for (const std::string &step : scene.stress.occasional)
    add_case("occasional", "", step);
  for (const auto &[from, to] : scene.stress.expansion)
    add_case("expansion", from, to);
}

void QuickLine::find_points() {
  for (const Station &station : results.frames.front().line) {
    const StressPoint point = evaluation->point(station);
    const auto like = std::find_if(points.begin(), points.end(), [&](const StressPoint &known) {
      return are_equal(known, point);
    });
    point_of.push_back(like - points.begin());
    if (like == points.end())
      points.push_back(point);
  }
}

void QuickLine::add_case(const std::string &kind, const std::string &from, const std::string &to) {
  Case &of = cases.emplace_back();
  of.kind = kind;
  of.is_range = !from.empty();
  of.name = of.is_range ? from + " to " + to : to;
  of.step = place_of_step(scene, to);
  if (of.is_range)
    of.from = place_of_step(scene, from);
  const StressCode &code = evaluation->code;
  std::vector<double> allowed;
  for (const StressPoint &point : points) {
    of.formulas.push_back(of.is_range ? code.expansion_range(point) : code.sustained(point));
    allowed.push_back(of.is_range           ? 0.
                      : kind == "sustained" ? code.allowed(StressLimit::sustained, point)
                                            : code.allowed(StressLimit::occasional, point));
  }
  for (std::size_t i = 0; i < point_of.size(); ++i) {
    const Station &station = results.frames.front().line[i];
    of.axes.push_back(
        evaluation->axes(station, of.is_range ? 0. : pressure_in(scene, to, station.pipe)));
    of.allowed.push_back(allowed[point_of[i]]);
  }
}

void QuickLine::set_forces(const LineState &state, Frame &frame) {
  std::vector<double> &of_step = forces[frame.step];
  section_forces.evaluate(
      state, [](const unsigned int, const SectionForces::Bounds &) { return false; },
      [&](const unsigned int first, const double *const of_cell, const unsigned int n) {
        std::copy_n(of_cell, 6 * n, of_step.begin() + 6 * first);
      });
  if (std::any_of(scene.quantities.begin(), scene.quantities.end(), [&](const Quantity &one) {
        return one.is(Of::section) && step_of(one, scene) == frame.step;
      }))
    for (std::size_t i = 0; i < frame.line.size(); ++i)
      std::copy_n(of_step.begin() + 6 * i, 6, frame.line[i].force.begin());
}

void QuickLine::observe(const unsigned int step, const LineState &state) {
  Frame &frame = results.frames[step];
  frame.time = state.time;
  frame.reactions = builder.reactions(state);
  for (unsigned int i = 0; i < frame.supports.size(); ++i)
    frame.supports[i] = support_state(model, state, i);
  frame.together = builder.together(state, frame);
  set_forces(state, frame);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Quantity &quantity = scene.quantities[i];
    if (!quantity.is(Of::stress) && step == step_of(quantity, scene))
      values[i] = evaluate(quantity, frame, state);
  }
}

double QuickLine::evaluate(const Quantity &quantity, const Frame &frame, const LineState &state) {
  const unsigned int component = quantity.kind().component;
  if (!quantity.is(Of::motion))
    return collector.evaluate(quantity, frame);
  const double value = builder.motion(state, quantity.where)[component];
  return quantity.scale * (quantity.absolute ? std::abs(value) : value);
}

void QuickLine::evaluate(const Case &of, std::vector<double> &stress) const {
  const double *at = forces[of.step].data(), *before = forces[of.from].data();
  stress.resize(point_of.size());
  for (std::size_t i = 0; i < stress.size(); ++i, at += 6, before += 6) {
    Motion force;
    for (unsigned int c = 0; c < 6; ++c)
      force[c] = of.is_range ? at[c] - before[c] : at[c];
    stress[i] = of.formulas[point_of[i]](of.axes[i].forces(force.data()));
  }
}

void QuickLine::find_stresses() {
  results.stresses.clear();
  std::vector<double> sustained(point_of.size(), 0.), stress;
  for (const Case &of : cases) {
    evaluate(of, stress);
    if (of.kind == "sustained")
      for (std::size_t i = 0; i < stress.size(); ++i)
        sustained[i] = std::max(sustained[i], stress[i]);
    StressCase &one = results.stresses.emplace_back();
    one.kind = of.kind;
    one.name = of.name;
    one.step = scene.steps[of.step].name;
    one.stress = stress;
    one.allowed = of.allowed;
    for (std::size_t i = 0; i < stress.size() && of.is_range; ++i)
      one.allowed[i] =
          evaluation->code.allowed(StressLimit::range, points[point_of[i]], sustained[i]);
    for (unsigned int i = 0; i < stress.size(); ++i)
      if (stress[i] / one.allowed[i] > stress[one.worst] / one.allowed[one.worst])
        one.worst = i;
  }
}

void QuickLine::find_quantities() {
  results.quantities.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Quantity &quantity = scene.quantities[i];
    if (quantity.is(Of::stress))
      if (const auto largest = stress_quantity(quantity, scene, model.mesh, results))
        values[i] = quantity.scale * *largest;
    if (values[i])
      results.quantities.push_back(shown(scene, quantity, *values[i]));
  }
}

const Results &QuickLine::conclude() {
  find_stresses();
  results.nozzles = evaluate_nozzles(scene, results);
  find_quantities();
  return results;
}

} // namespace frictionbeam::study
