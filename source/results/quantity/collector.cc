// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/impact_forces.h"
#include "results/quantity/point_forces.h"
#include "results/quantity/support_quantities.h"

#include "results/quantity/collector.h"
#include "results/stress/stresses.h"

#include "base/numbers.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

const std::vector<std::string> motions = {"ux", "uy", "uz", "rx", "ry", "rz"};
const std::vector<std::string> velocities = {"vx", "vy", "vz", "wx", "wy", "wz"};
const std::vector<std::string> forces = {"fx", "fy", "fz", "mx", "my", "mz"};
const std::vector<std::string> section_forces = {"N", "Vy", "Vz", "Mx", "My", "Mz", "N_mean"};

/// Of the whole line, in corotational kinematics.
const std::vector<std::string> of_motion = {
    "momentum_x",         "momentum_y",         "momentum_z", "angular_momentum_x",
    "angular_momentum_y", "angular_momentum_z", "energy"};

/// What is known only when everything else is: see finish().
const std::vector<std::string> of_the_end = {"frequency", "flexibility", "sif_in",     "sif_out",
                                             "SL",        "SE",          "utilization"};

/// Place in a list of words, or -1.
int place(const std::vector<std::string> &words, const std::string &word) {
  const auto found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

} // namespace

std::string unit_of(const std::string &what) {
  const int motion = place(motions, what), force = place(forces, what),
            section = place(section_forces, what);
  if (motion >= 0)
    return motion < 3 ? "m" : "rad";
  if (force >= 0 || section >= 0)
    return std::max(force, section) < 3 || section == 6 ? "N" : "N m";
  if (what == "fn" || what == "ft1" || what == "ft2" || what == "sum_normal" ||
      what == "sum_friction")
    return "N";
  if (what == "gap" || what == "slip1" || what == "slip2" || what == "slip_length" ||
      what == "max_error")
    return "m";
  if (const int velocity = place(velocities, what); velocity >= 0)
    return velocity < 3 ? "m/s" : "rad/s";
  if (what == "mt")
    return "N m";
  if (what == "impulse")
    return "N s";
  if (const int c = place(of_motion, what); c >= 0)
    return c < 3 ? "N s" : c < 6 ? "N m s" : "J";
  if (what == "frequency")
    return "Hz";
  if (what == "SL" || what == "SE")
    return "Pa";
  return what == "work" || what == "wear" ? "J" : "-";
}

namespace {

std::string unit_of(const Quantity &quantity) {
  const std::string unit = frictionbeam::unit_of(quantity.what);
  if (quantity.over == Quantity::Over::time_of)
    return "s";
  if (quantity.over == Quantity::Over::integral)
    return unit == "-" ? "s" : unit + " s";
  if (quantity.over == Quantity::Over::rate)
    return unit == "J" ? "W" : unit == "N s" ? "N" : unit + "/s";
  return unit;
}

} // namespace

Collector::Collector(const Model &model, Results &results, FrameSink sink)
    : model(model), results(results), sink(std::move(sink)),
      builder(model, !model.scene.combinations.empty() || !model.scene.spectra.empty() ||
                         !model.scene.stress.code.empty()),
      pending(model.scene.quantities.size()) {
  results.supports = builder.support_infos();
  results.restraints = builder.restraint_infos();
  for (const auto &[name, vertex] : model.mesh.points)
    results.points.emplace_back(name, model.mesh.vertices[vertex]);
  for (const std::string &point : model.scene.monitors)
    results.histories.push_back({point, {}, {}});
}

const Frame &Collector::current_frame(const LineState &state) {
  if (!frame_is_current)
    frame = builder.make(state);
  frame_is_current = true;
  return frame;
}

double Collector::force_at(const Quantity &quantity, const LineState &state,
                           const unsigned int component) {
  const Frame &now = current_frame(state);
  for (unsigned int i = 0; i < results.restraints.size(); ++i)
    if (results.restraints[i].name == quantity.where)
      return now.reactions[i][component];
  if (const auto force = force_of_supports(builder, results, quantity.where, state, component))
    return *force;
  const auto point = model.mesh.points.find(quantity.where);
  if (point == model.mesh.points.end())
    throw UserError("Quantity " + quantity.name +
                    ": there is no point, restraint, spring or "
                    "support called '" +
                    quantity.where +
                    "'. A repeated support's names are numbered: name.1, name.2, ...");
  return force_at_point(model, builder, results, point->first, state, component);
}

double Collector::evaluate(const Quantity &quantity, const LineState &state) {
  const double value = evaluate_signed(quantity, state);
  return !quantity.absolute ? value : std::copysign(value, quantity.scale);
}

double Collector::evaluate_signed(const Quantity &quantity, const LineState &state) {
  const std::string &what = quantity.what;
  double value = 0.;
  if (const int c = place(motions, what); c >= 0)
    value = builder.motion(state, quantity.where)[c];
  else if (const int c = place(velocities, what); c >= 0)
    value = builder.velocity(state, quantity.where)[c];
  else if (const int c = place(forces, what); c >= 0)
    value = force_at(quantity, state, c);
  else if (const int c = place(section_forces, what); c >= 0)
    value = section_force(quantity, current_frame(state), c);
  else if (const int c = place(of_motion, what); c >= 0)
    value = builder.momentum_and_energy(state)[c];
  else if (what == "max_error")
    value = largest_error;
  else if (quantity.where.empty())
    value = value_of_supports(results.supports, current_frame(state).supports, what);
  else {
    bool found = false;
    for (unsigned int i = 0; i < results.supports.size(); ++i)
      if (is_part_of(results.supports[i], quantity.where)) {
        value += support_value(builder.support_state(state, i), what);
        found = true;
      }
    if (!found)
      throw UserError("Quantity " + quantity.name + ": there is no friction support called '" +
                      quantity.where + "'. A repeated support's names are numbered: name.1, ...");
  }
  return quantity.scale * value;
}

namespace {

/// The station of a point on the asked side; null if no pipe, or none of the asked name, has it. A
/// pipe that ends at the point has nothing after it; another one may.
const Station *find_station(const Model &model, const Quantity &quantity, const Frame &made) {
  using Side = Quantity::Side;
  const unsigned int vertex = model.mesh.points.at(quantity.where);
  for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p) {
    if (!quantity.pipe.empty() && model.scene.pipes[p].name != quantity.pipe)
      continue;
    const MeshedPipe &pipe = model.mesh.pipes[p];
    for (unsigned int i = 0; i < pipe.vertices.size(); ++i) {
      const bool nothing_there = quantity.side != Side::any &&
                                 i == (quantity.side == Side::after ? pipe.vertices.size() - 1 : 0);
      if (pipe.vertices[i] != vertex || nothing_there)
        continue;
      const Station *last = nullptr;
      for (const Station &station : made.line)
        if (station.pipe == p && station.node &&
            std::abs(station.s - pipe.s[i]) <= same_place * pipe.s.back()) {
          last = &station;
          if (quantity.side != Side::after)
            break;
        }
      Assert(last != nullptr, dealii::ExcInternalError());
      return last;
    }
  }
  return nullptr;
}

} // namespace

const Station &Collector::station_at(const Quantity &quantity, const Frame &made) const {
  if (const Station *const station = find_station(model, quantity, made))
    return *station;
  const std::string on = quantity.pipe.empty() ? "" : " called '" + quantity.pipe + "'",
                    name = "Quantity " + quantity.name;
  Quantity any = quantity;
  any.side = Quantity::Side::any;
  if (find_station(model, any, made) == nullptr)
    throw UserError(name + ": the point '" + quantity.where + "' is on no pipe" + on +
                    ", and so has no section forces.");
  const bool after = quantity.side == Quantity::Side::after;
  throw UserError(name + ": there is no pipe" + on + (after ? " after" : " before") +
                  " the point '" + quantity.where + "', where the route " +
                  (after ? "ends. Take 'before'" : "begins. Take 'after'") + " or 'at'.");
}

double Collector::section_force(const Quantity &quantity, const Frame &made,
                                const unsigned int component) const {
  if (component < 6)
    return station_at(quantity, made).force[component];
  Quantity side = quantity; // N_mean; at an end, that of the one side there is
  side.side = Quantity::Side::before;
  const Station *const before = find_station(model, side, made);
  side.side = Quantity::Side::after;
  const Station *const after = find_station(model, side, made);
  if (before == nullptr || after == nullptr)
    return station_at(quantity, made).force[0];
  return 0.5 * (before->force[0] + after->force[0]);
}

double Collector::evaluate(const Quantity &quantity, const Frame &made) const {
  const std::string &what = quantity.what;
  double value = 0.;
  if (const int c = place(motions, what); c >= 0)
    value = station_at(quantity, made).displacement[c];
  else if (const int c = place(section_forces, what); c >= 0)
    value = section_force(quantity, made, c);
  else if (const int c = place(forces, what); c >= 0) {
    const auto point = model.mesh.points.find(quantity.where);
    for (unsigned int i = 0; i < results.restraints.size(); ++i)
      if (results.restraints[i].name == quantity.where ||
          (point != model.mesh.points.end() &&
           results.restraints[i].position.distance(model.mesh.vertices[point->second]) == 0.))
        value += made.reactions[i][c];
    for (unsigned int i = 0; i < results.supports.size(); ++i)
      if (is_part_of(results.supports[i], quantity.where) ||
          (point != model.mesh.points.end() && model.contacts[i].vertices[0] == point->second)) {
        const SupportState &s = made.supports[i];
        const SupportInfo &info = results.supports[i];
        value += c < 3 ? s.fn * info.normal[c] + s.ft1 * info.t1[c] + s.ft2 * info.t2[c]
                       : s.mt * info.normal[c - 3];
      }
  } else if (quantity.where.empty())
    value = value_of_supports(results.supports, made.supports, what);
  else
    for (unsigned int i = 0; i < results.supports.size(); ++i)
      if (is_part_of(results.supports[i], quantity.where))
        value += support_value(made.supports[i], what);
  return quantity.scale * (quantity.absolute ? std::abs(value) : value);
}

void Collector::observe_case(const std::string &name, const Frame &made) {
  for (unsigned int i = 0; i < pending.size(); ++i)
    if (model.scene.quantities[i].step == name &&
        place(of_the_end, model.scene.quantities[i].what) < 0)
      pending[i].value = evaluate(model.scene.quantities[i], made);
  sink(made);
  results.frames.push_back(made);
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
               of_line = quantity.where.empty() || place(forces, quantity.what) >= 0 ||
                         place(section_forces, quantity.what) >= 0;
    if (now && of_line && quantity.what != "max_error")
      return true;
  }
  return false;
}

void Collector::observe(const unsigned int step, const unsigned int increment,
                        const unsigned int n_increments, const LineState &state) {
  frame_is_current = false;
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
    else if (quantity.over != Quantity::Over::end)
      follow(quantity, state, pending[i]);
    else if (quantity.time) {
      if (pending[i].value)
        continue;
      const double rounding = 1e-9 * std::max(not_zero, std::abs(*quantity.time));
      if (*quantity.time > state.time + rounding) {
        pending[i].previous = evaluate(quantity, state);
      } else {
        const double now = evaluate(quantity, state);
        const double part =
            state.time > previous_time && !start
                ? std::min(1., (*quantity.time - previous_time) / (state.time - previous_time))
                : 1.;
        pending[i].value =
            part == 1. ? now : pending[i].previous + part * (now - pending[i].previous);
      }
    } else if (last && place(of_the_end, quantity.what) < 0 &&
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

void Collector::put_out(const LineState &state, const bool keep) {
  current_frame(state);
  frame.step = current_step;
  frame.increment = current_increment;
  frame.end_of_step = keep;
  sink(frame);
  is_put_out = true;
  if (keep)
    results.frames.push_back(frame);
}

void Collector::transfer(Archive &archive) {
  archive(results.frames, results.histories, results.remarks, pending, is_put_out, current_step,
          current_increment, previous_time, last_output, largest_error, previous_status);
  frame_is_current = false;
}

void Collector::finish(const LineState &state) {
  if (!is_put_out)
    put_out(state, true);
  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    if (quantity.what == "frequency")
      if (const std::size_t mode = std::stoul(quantity.where); mode <= results.modes.size())
        pending[i].value = quantity.scale * results.modes[mode - 1].frequency;
    if (place(of_the_end, quantity.what) > 0)
      if (const auto value = stress_quantity(quantity, model.mesh, results))
        pending[i].value = quantity.scale * *value;
    if (!pending[i].value) {
      results.remarks.push_back("Quantity " + quantity.name + " was not reached.");
      continue;
    }
    const bool relative =
        quantity.what == "max_error" && model.scene.exact && model.scene.exact->largest > 0.;
    const std::string unit = relative ? "-" : unit_of(quantity);
    const double factor = model.scene.units.factor(unit);
    QuantityResult result{
        quantity.name,      quantity.unit.empty() ? model.scene.units.name(unit) : quantity.unit,
        quantity.source,    *pending[i].value / factor,
        quantity.reference, {}};
    if (quantity.over == Quantity::Over::change)
      result.whole = pending[i].largest / factor;
    else if (quantity.over == Quantity::Over::rate && pending[i].duration > 0.)
      result.whole = pending[i].largest / pending[i].duration / factor;
    if (quantity.reference) {
      const double difference = std::abs(result.value - *quantity.reference);
      result.error =
          *quantity.reference != 0. ? difference / std::abs(*quantity.reference) : difference;
    }
    result.in_si = quantity.unit.empty() ? factor : 0.;
    result.of_impact = pending[i].struck;
    if (result.of_impact)
      results.remarks.push_back(remark_on_impact(quantity));
    results.quantities.push_back(result);
  }
}

} // namespace frictionbeam
