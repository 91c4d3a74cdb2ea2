// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/collector.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "results/inelastic/section_states.h"
#include "results/quantity/fibre_quantities.h"
#include "results/quantity/impact_forces.h"
#include "results/quantity/shown_quantity.h"
#include "results/quantity/station_at.h"
#include "results/quantity/support_quantities.h"
#include "results/quantity/wall_quantities.h"
#include "results/stress/stresses.h"
#include "results/support/support_names.h"
#include "results/support/support_states.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
using Of = QuantityKind::Of;

/// Part of a vector along a quantity's direction.
/// @param motion of its place, or the rate of that @param force component of what holds it
/// @param frame where stations are, which is asked for only if they are
template <typename MotionAt, typename ForceAt, typename FrameAt>
double part_along(const Model &model, const Quantity &quantity, const MotionAt &motion,
                  const ForceAt &force, const FrameAt &frame) {
  const auto vector = [&]() -> Motion {
    switch (const auto which = static_cast<Directed>(quantity.kind().component)) {
    case Directed::section_force:
    case Directed::section_moment:
      return section_force_in_space(station_at(model, quantity, frame()));
    case Directed::force:
    case Directed::moment: {
      Motion held;
      for (unsigned int c = 0; c < 6; ++c)
        held[c] = force(c);
      return held;
    }
    default:
      return motion(which == Directed::velocity || which == Directed::spin);
    }
  };
  const Motion value = vector();
  return along(quantity,
               quantity.along == Quantity::Along::local ? local_axes_of(model, quantity, frame)
                                                        : global_axes(),
               value);
}

[[noreturn]] void refuse_support(const Quantity &quantity) {
  throw UserError("Quantity " + quantity.name + ": there is no friction support called '" +
                  quantity.where + "'. A repeated support's names are numbered: name.1, ...");
}

} // namespace

Collector::Collector(const Model &model, Results &results, FrameSink sink)
    : model(model), results(results), sink(std::move(sink)),
      builder(model, !model.scene.combinations.empty() || !model.scene.spectra.empty() ||
                         !model.scene.stress.code.empty()),
      pending(model.scene.quantities.size()) {
  results.supports = support_infos(model);
  results.support_of = supports_of_contacts(model.contacts);
  results.restraints = builder.restraint_infos();
  for (const auto &[name, vertex] : model.mesh.points)
    results.points.push_back({name, vertex, model.mesh.vertices[vertex]});
  for (const std::string &point : model.scene.monitors)
    results.histories.push_back({point, {}, {}});
}

const Frame &Collector::current_frame(const LineState &state) {
  if (!frame_is_current)
    frame = builder.make(state);
  frame_is_current = true;
  return frame;
}

double Collector::evaluate(const Quantity &quantity, const LineState &state) {
  const double value = evaluate_signed(quantity, state);
  return !quantity.absolute ? value : std::copysign(value, quantity.scale);
}

double Collector::evaluate_signed(const Quantity &quantity, const LineState &state) {
  const QuantityKind &kind = quantity.kind();
  const auto value = [&]() -> double {
    switch (kind.of) {
    case Of::motion:
      return builder.motion(state, quantity.where)[kind.component];
    case Of::velocity:
      return builder.velocity(state, quantity.where)[kind.component];
    case Of::holder:
      return force_at(quantity, current_frame(state), kind.component);
    case Of::section:
      return section_force(quantity, current_frame(state), kind.component);
    case Of::directed:
      return along_direction(quantity, state);
    case Of::fibre:
      return value_of_fibre(model, quantity, current_frame(state));
    case Of::wall:
      return value_of_wall(model, quantity, state);
    case Of::line:
      if (!momentum_and_energy)
        momentum_and_energy = builder.momentum_and_energy(state);
      return (*momentum_and_energy)[kind.component];
    case Of::exact:
      return largest_error;
    case Of::supports:
      return of_supports(quantity, current_frame(state));
    default:
      return of_support(quantity, [&](const unsigned int i) {
        return support_state(model, state, i).*support_numbers[kind.component];
      });
    }
  };
  return quantity.scale * value();
}

double Collector::along_direction(const Quantity &quantity, const LineState &state) {
  return part_along(
      model, quantity,
      [&](const bool is_rate) {
        return is_rate ? builder.velocity(state, quantity.where)
                       : builder.motion(state, quantity.where);
      },
      [&](const unsigned int c) { return force_at(quantity, current_frame(state), c); },
      [&]() -> const Frame & { return current_frame(state); });
}

double Collector::along_direction(const Quantity &quantity, const Frame &made) const {
  return part_along(
      model, quantity,
      [&](const bool is_rate) { // of which a frame knows nothing
        return is_rate ? Motion{} : station_at(model, quantity, made).displacement;
      },
      [&](const unsigned int c) { return force_at(quantity, made, c); },
      [&]() -> const Frame & { return made; });
}

double Collector::of_supports(const Quantity &quantity, const Frame &made) const {
  const unsigned int component = quantity.kind().component;
  if (const auto place = builder.place_of(quantity.where, true); place && component < 2) {
    const SupportState &sum = made.together[*place]; // one number in cases
    return std::abs(component == 0 ? sum.fn : sum.ft1);
  }
  std::vector<SupportInfo> infos;
  std::vector<SupportState> states;
  for (unsigned int i = 0; i < results.supports.size(); ++i)
    if (quantity.where.empty() || is_one_of(results.supports[i], quantity.where)) {
      infos.push_back(results.supports[i]);
      states.push_back(made.supports[i]);
    }
  return value_of_supports(infos, states, quantity.kind());
}

double Collector::of_support(const Quantity &quantity,
                             const std::function<double(const unsigned int)> &number) const {
  double sum = 0.;
  bool found = false;
  for (unsigned int i = 0; i < results.supports.size(); ++i)
    if (is_part_of(results.supports[i], quantity.where)) {
      sum += number(i);
      found = true;
    }
  if (!found)
    refuse_support(quantity);
  return sum;
}

double Collector::section_force(const Quantity &quantity, const Frame &made,
                                const unsigned int component) const {
  if (component < 6)
    return station_at(model, quantity, made).force[component];
  Quantity side = quantity; // N_mean; at an end, that of the one side there is
  side.side = Quantity::Side::before;
  const Station *const before = find_station(model, side, made);
  side.side = Quantity::Side::after;
  const Station *const after = find_station(model, side, made);
  if (before == nullptr || after == nullptr)
    return station_at(model, quantity, made).force[0];
  return 0.5 * (before->force[0] + after->force[0]);
}

double Collector::force_at(const Quantity &quantity, const Frame &made,
                           const unsigned int component) const {
  for (unsigned int i = 0; i < results.restraints.size(); ++i)
    if (results.restraints[i].name == quantity.where)
      return made.reactions[i][component];
  if (const auto place = builder.place_of(quantity.where, false))
    return made.together[*place].on_pipe[component];
  throw UserError("Quantity " + quantity.name +
                  ": there is no point, restraint, spring or support called '" + quantity.where +
                  "'. A repeated support's names are numbered: name.1, name.2, ...");
}

double Collector::evaluate(const Quantity &quantity, const Frame &made) const {
  const QuantityKind &kind = quantity.kind();
  const auto value = [&]() -> double {
    switch (kind.of) {
    case Of::motion:
      return station_at(model, quantity, made).displacement[kind.component];
    case Of::section:
      return section_force(quantity, made, kind.component);
    case Of::holder:
      return force_at(quantity, made, kind.component);
    case Of::directed:
      return along_direction(quantity, made);
    case Of::supports:
      return of_supports(quantity, made);
    case Of::support:
      if (const auto place = builder.place_of(quantity.where, false))
        return made.together[*place].*support_numbers[kind.component];
      refuse_support(quantity);
    default:
      return 0.;
    }
  };
  return quantity.scale * (quantity.absolute ? std::abs(value()) : value());
}

void Collector::observe_case(Frame made) {
  made.is_judged = is_judged(model.scene, made.name);
  for (unsigned int i = 0; i < pending.size(); ++i)
    if (model.scene.quantities[i].step == made.name &&
        !model.scene.quantities[i].kind().is_of_the_end())
      pending[i].value = evaluate(model.scene.quantities[i], made);
  sink(made);
  results.frames.push_back(std::move(made));
}

bool Collector::output_is_due(const LoadStep &step, const double time, const bool last) const {
  if (last)
    return true;
  if (step.transient)
    return model.scene.time.output_interval == 0. ||
           time >= last_output + model.scene.time.output_interval * (1. - same_instant_of_step);
  return model.scene.output.every_increment;
}

bool Collector::needs_line(const unsigned int step, const unsigned int increment,
                           const unsigned int n_increments, const double time) const {
  if (output_is_due(model.scene.steps[step], time, increment == n_increments))
    return true;
  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    const bool now = quantity.over != Quantity::Over::end || (quantity.time && !pending[i].value),
               of_line = quantity.where.empty() || quantity.is(Of::supports) ||
                         quantity.is(Of::holder) || quantity.is(Of::section) ||
                         quantity.is(Of::directed) || quantity.is(Of::fibre);
    if (now && of_line && !quantity.is(Of::exact))
      return true;
  }
  return false;
}

void Collector::observe(const unsigned int step, const unsigned int increment,
                        const unsigned int n_increments, const LineState &state) {
  forget_state();
  const bool start = n_increments == 0, last = !start && increment == n_increments;
  for (History &history : results.histories) {
    history.time.push_back(state.time);
    history.displacement.push_back(builder.motion(state, history.point));
  }
  if (model.scene.exact) {
    const ExactHistory &exact = *model.scene.exact;
    const double error = std::abs(builder.motion(state, exact.point)[exact.component] -
                                  exact.value(state.time)),
                 scale = exact.largest > 0. ? exact.largest : 1.;
    largest_error = std::max(largest_error, error / scale);
  }

  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    if (quantity.over == Quantity::Over::time_of)
      find_change(quantity, state, last && !model.scene.steps[step].transient, pending[i]);
    else if (quantity.over != Quantity::Over::end) {
      if (start && step > 0)
        follow_back(quantity, state, pending[i]);
      else
        follow(quantity, state, pending[i]);
    } else if (quantity.time)
      await(quantity, state, start, pending[i]);
    else if (last && !quantity.kind().is_of_the_end() &&
             (quantity.step.empty() || quantity.step == model.scene.steps[step].name))
      pending[i].value = evaluate(quantity, state);
  }
  watch_impacts(!start && model.scene.steps[step].transient, state);
  previous_time = state.time;

  current_step = step;
  current_increment = increment;
  is_put_out = start;
  if (!start && output_is_due(model.scene.steps[step], state.time, last)) {
    last_output = state.time;
    put_out(state, last);
  }
}

void Collector::await(const Quantity &quantity, const LineState &state, const bool is_start,
                      Pending &result) {
  if (result.value)
    return;
  const double rounding = 1e-9 * std::max(not_zero, std::abs(*quantity.time));
  const double now = evaluate(quantity, state);
  if (*quantity.time > state.time + rounding) {
    result.previous = now;
    return;
  }
  const double part =
      state.time > previous_time && !is_start
          ? std::min(1., (*quantity.time - previous_time) / (state.time - previous_time))
          : 1.;
  result.value = part == 1. ? now : result.previous + part * (now - result.previous);
}

void Collector::put_out(const LineState &state, const bool keep) {
  current_frame(state);
  frame.step = current_step;
  frame.name = model.scene.steps[current_step].name;
  const auto before = step_before(model.scene, current_step);
  frame.step_before = before ? static_cast<int>(*before) : -1;
  frame.increment = current_increment;
  frame.end_of_step = keep;
  if (keep)
    frame.sections = sections_of_line(model, state);
  sink(frame);
  is_put_out = true;
  if (!keep)
    return;
  results.frames.push_back(std::move(frame));
  forget_state();
}

void Collector::transfer(Archive &archive) {
  archive(results.frames, results.histories, results.remarks, pending, is_put_out, current_step,
          current_increment, previous_time, last_output, largest_error, contacts_before);
  forget_state();
}

void Collector::finish(const LineState &state) {
  if (!is_put_out)
    put_out(state, true);
  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    if (quantity.is(Of::mode))
      if (const std::size_t mode = std::stoul(quantity.where); mode <= results.modes.size())
        pending[i].value = quantity.scale * results.modes[mode - 1].frequency;
    if (quantity.is(Of::stress))
      if (const auto value = stress_quantity(quantity, model.scene, model.mesh, results))
        pending[i].value = quantity.scale * *value;
    for (const StepReport &step : results.steps)
      if (const auto value = value_of_step(quantity, step))
        pending[i].value = quantity.scale * *value;
    const bool is_untold = (quantity.is(Of::wall) || quantity.is(Of::cycle)) && pending[i].value &&
                           std::isnan(*pending[i].value);
    if (!pending[i].value || is_untold) {
      results.remarks.push_back(
          "Quantity " + quantity.name +
          (is_untold ? " is not known: the law of a section does not tell how far it has flowed."
                     : why_no_value(quantity, results.steps)));
      continue;
    }
    QuantityResult result =
        shown(model.scene, quantity,
              quantity.wants_time ? quantity.scale * pending[i].at : *pending[i].value);
    const double factor = model.scene.units.factor(unit_of(quantity));
    if (quantity.over == Quantity::Over::change)
      result.whole = pending[i].largest / factor;
    else if (quantity.over == Quantity::Over::rate && pending[i].duration > 0.)
      result.whole = pending[i].largest / pending[i].duration / factor;
    result.apart = pending[i].apart / factor;
    result.of_impact = pending[i].struck;
    if (result.of_impact)
      results.remarks.push_back(remark_on_impact(quantity));
    if (pending[i].lacks_impulse)
      results.remarks.push_back(remark_on_lost_impulse(quantity));
    if (const auto text = remark_on_velocity_jump(quantity, model.scene, results.steps);
        !text.empty())
      results.remarks.push_back(text);
    results.quantities.push_back(result);
  }
}

} // namespace frictionbeam
