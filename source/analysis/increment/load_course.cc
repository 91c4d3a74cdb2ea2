// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/load_course.h"
#include "analysis/increment/time_step.h"
#include "base/numbers.h"
#include "model/load_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {
constexpr double no_jump = 1e-9; ///< of a motion: what a table bends by at a corner, to rounding
constexpr double smallest_motion = 1e-3; ///< of what a load declares
} // namespace

LoadCourse::LoadCourse(const Model &model)
    : model(model), from(model.scene.loads.size(), 0.), to(from) {
  origins.loads.assign(from.size(), 0.);
}

void LoadCourse::begin_step(const unsigned int step, const Factors &before, const Factors &after,
                            const double start_time, const double ramp_time) {
  origins = HistoryOrigins(model.scene, step);
  from = before;
  to = after;
  start = start_time;
  ramp = ramp_time;
  is_static = !model.scene.steps[step].transient;
}

double LoadCourse::history_of(const unsigned int load, const double time, const Side side) const {
  const TimeFunction &history = model.scene.loads[load].history;
  return is_static && to[load] == 0. ? value(history, origins.loads[load], start, Side::before)
                                     : value(history, origins.loads[load], time, side);
}

LoadCourse::Factors LoadCourse::declared(const double time) const {
  const double part = ramp > 0. ? std::clamp((time - start) / ramp, 0., 1.) : 1.;
  Factors result = to;
  if (part < 1.)
    for (unsigned int l = 0; l < result.size(); ++l)
      result[l] = from[l] + part * (to[l] - from[l]);
  return result;
}

double LoadCourse::value(const TimeFunction &history, const double origin, const double time,
                         const Side side) {
  if (!history.is_given())
    return 1.;
  const double rounding = origin != 0. ? 4. * std::numeric_limits<double>::epsilon() * time : 0.,
               of_history = time - origin;
  if (side == Side::before)
    return history.before(of_history, rounding);
  if (side == Side::after)
    return history.after(of_history, rounding);
  // An instant that is a break but for rounding is that break.
  const std::vector<double> &breaks = history.breaks;
  const auto at = std::lower_bound(breaks.begin(), breaks.end(), of_history);
  return history(at != breaks.end() && *at <= of_history + rounding ? *at : of_history);
}

LoadCourse::Factors LoadCourse::factors_at(const double time, const Side side) const {
  Factors result = declared(time);
  for (unsigned int l = 0; l < result.size(); ++l)
    if (result[l] != 0.)
      result[l] *= history_of(l, time, side);
  return result;
}

double LoadCourse::factor(const unsigned int load, const double time, const Side side) const {
  const double part = ramp > 0. ? std::clamp((time - start) / ramp, 0., 1.) : 1.;
  return (part < 1. ? from[load] + part * (to[load] - from[load]) : to[load]) *
         history_of(load, time, side);
}

LoadCourse::Factors LoadCourse::factors(const double time) const {
  return factors_at(time, Side::both);
}

LoadCourse::Factors LoadCourse::factors_before(const double time) const {
  return factors_at(time, Side::before);
}

LoadCourse::Factors LoadCourse::factors_after(const double time) const {
  return factors_at(time, Side::after);
}

Vector LoadCourse::forces(const Factors &factors) const { return load_forces(model, factors); }

Vector LoadCourse::forces(const double time) const { return forces(factors(time)); }

LoadCourse::Derivatives LoadCourse::derivatives(const double time, const Side side) const {
  bool any = false;
  for (unsigned int l = 0; l < to.size(); ++l)
    any = any || model.linear.accelerates(l);
  if (!any)
    return {};
  const double step = time_step(model), rounding = same_instant_of_step * step;
  Derivatives result{Factors(to.size(), 0.), Factors(to.size(), 0.)};
  const double next = next_break(time + rounding), last = last_break(time - rounding);
  const bool at_break = next_break(time - rounding) <= time + rounding;
  for (unsigned int l = 0; l < to.size(); ++l) {
    if (!model.linear.accelerates(l))
      continue;
    double h = step, middle = std::max(time, origins.loads[l] + h); // nothing is known before
    if (side == Side::after && at_break) {
      h = std::min(h, (next - time) / 2.);
      middle = time + h;
    } else if (side == Side::before && at_break) {
      h = std::min(h, (time - std::max(last, origins.loads[l])) / 2.);
      middle = time - h;
    } else if (side != Side::both && time >= origins.loads[l] + rounding) {
      h = std::min({h, next - time, time - std::max(last, origins.loads[l])});
      middle = time;
    }
    const double before = factor(l, middle - h, Side::after), now = factor(l, middle, Side::both),
                 after = factor(l, middle + h, Side::before);
    const double curvature = (after - 2. * now + before) / (h * h);
    result.first[l] = (after - before) / (2. * h) + (time - middle) * curvature;
    result.second[l] = curvature;
  }
  return result;
}

void LoadCourse::add_inertia(const double time, Vector &forces, const Side side) const {
  const Derivatives factors = derivatives(time, side);
  for (unsigned int l = 0; l < factors.first.size(); ++l)
    if (model.linear.accelerates(l))
      forces +=
          factors.second[l] * model.linear.inertia(l) + factors.first[l] * model.linear.drag(l);
}

void LoadCourse::set_rates(LineState &state, const Side side) const {
  const Derivatives factors = derivatives(state.time, side);
  state.load_rates = factors.first;
  state.load_accelerations = factors.second;
}

Vector LoadCourse::imposed(const double time, const Side side) const {
  Vector result = Vector::Zero(model.space.n_dofs());
  const Factors now = factors_at(time, side);
  for (unsigned int l = 0; l < now.size(); ++l)
    if (now[l] != 0.)
      for (const auto &[dof, value] : model.linear.imposed(l))
        result[dof] += now[l] * value;
  model.contacts.add_ground_motion(
      [&](const TimeFunction &motion) {
        return value(motion, origins.of_ground(motion), time, side);
      },
      result);
  return result;
}

bool LoadCourse::imposes_motion() const {
  bool any = model.contacts.ground_moves();
  for (unsigned int l = 0; l < to.size(); ++l)
    any = any || ((to[l] != 0. || from[l] != 0.) && !model.linear.imposed(l).empty());
  return any;
}

Vector LoadCourse::imposed_rates(const double time, const Side side, const double span) const {
  if (!imposes_motion())
    return Vector::Zero(model.space.n_dofs());
  const double rounding = same_instant_of_step * span,
               later = std::min(span, next_break(time + rounding) - time),
               earlier = std::min(span, time - std::max(last_break(time - rounding), start));
  const bool at_break = next_break(time - rounding) <= time + rounding;
  const bool forward = at_break ? side != Side::before : later >= earlier;
  const double reach = forward ? later : earlier;
  if (!at_break && std::min(later, earlier) >= span / 2.) {
    const double h = std::min(later, earlier) / 2.;
    return (8. * (imposed(time + h) - imposed(time - h)) -
            (imposed(time + 2. * h, Side::before) - imposed(time - 2. * h, Side::after))) /
           (12. * h);
  }
  const double h = (forward ? reach : -reach) / 4.;
  return (-25. * imposed(time, forward ? Side::after : Side::before) + 48. * imposed(time + h) -
          36. * imposed(time + 2. * h) + 16. * imposed(time + 3. * h) -
          3. * imposed(time + 4. * h, forward ? Side::before : Side::after)) /
         (12. * h);
}

Vector LoadCourse::imposed_jumps(const double begin, const double end) const {
  Vector result;
  for (double time = next_break(begin); time <= end; time = next_break(time)) {
    const Vector before = imposed(time, Side::before), after = imposed(time, Side::after);
    const Vector jump = after - before;
    double size = std::max(before.lpNorm<Eigen::Infinity>(), after.lpNorm<Eigen::Infinity>());
    for (const double instant : around(time))
      size = std::max(size, imposed(instant).lpNorm<Eigen::Infinity>());
    if (!(jump.lpNorm<Eigen::Infinity>() > no_jump * size))
      continue;
    result = result.size() == 0 ? jump : Vector(result + jump);
  }
  return result;
}

std::array<double, 2> LoadCourse::around(const double time) const {
  const double step = time_step(model);
  return {std::max(time - step, std::min(start, time)), time + step};
}

LoadCourse::Factors LoadCourse::jumps_between(const Factors &before, const Factors &after,
                                              const double time) const {
  Factors size(after.size());
  for (unsigned int l = 0; l < size.size(); ++l)
    size[l] = std::max({std::abs(after[l]), std::abs(before[l]),
                        smallest_motion * std::max(std::abs(from[l]), std::abs(to[l]))});
  for (const double instant : around(time)) {
    const Factors nearby = factors(instant);
    for (unsigned int l = 0; l < size.size(); ++l)
      size[l] = std::max(size[l], std::abs(nearby[l])); // of what is no number, the size so far
  }
  Factors result(after.size(), 0.);
  for (unsigned int l = 0; l < after.size(); ++l)
    if (const double jump = after[l] - before[l]; std::abs(jump) > no_jump * size[l])
      result[l] = jump;
  return result;
}

LoadCourse::Factors LoadCourse::factor_jumps(const double begin, const double end) const {
  Factors result(to.size(), 0.);
  for (double time = next_break(begin); time <= end; time = next_break(time)) {
    const Factors jumps = jumps_between(factors_before(time), factors_after(time), time);
    for (unsigned int l = 0; l < result.size(); ++l)
      result[l] += jumps[l];
  }
  return result;
}

void LoadCourse::each_history(
    const std::function<void(const TimeFunction &, const double)> &call) const {
  for (unsigned int l = 0; l < to.size(); ++l)
    if (to[l] != 0. || from[l] != 0.)
      call(model.scene.loads[l].history, origins.loads[l]);
  for (const FrictionSupport &support : model.scene.supports)
    for (const TimeFunction &motion : support.ground_motion)
      call(motion, origins.of_ground(motion));
}

double LoadCourse::next_break(const double time) const {
  double next = std::numeric_limits<double>::infinity();
  if (ramp > 0. && start + ramp > time)
    next = start + ramp;
  const double rounding = 4. * std::numeric_limits<double>::epsilon() * std::abs(time);
  each_history([&](const TimeFunction &history, const double origin) {
    const std::vector<double> &breaks = history.breaks;
    for (auto at = std::lower_bound(breaks.begin(), breaks.end(), time - origin - rounding);
         at != breaks.end(); ++at)
      if (origin + *at > time) {
        next = std::min(next, origin + *at);
        return;
      }
  });
  return next;
}

double LoadCourse::last_break(const double time) const {
  double last = -std::numeric_limits<double>::infinity();
  if (ramp > 0. && start + ramp < time)
    last = start + ramp;
  each_history([&](const TimeFunction &history, const double origin) {
    const std::vector<double> &breaks = history.breaks;
    const auto at = std::lower_bound(breaks.begin(), breaks.end(), time - origin);
    if (at != breaks.begin())
      last = std::max(last, origin + *(at - 1));
  });
  return last;
}

bool LoadCourse::may_jump(const double start, const double end) const {
  const double rounding = same_instant_of_step * (end - start);
  return next_break(start - rounding) < end - rounding;
}

bool LoadCourse::is_straight(const double begin, const double end) const {
  constexpr double between[] = {0.137, 0.311, 0.5, 0.723}, same = 1e-9;
  const Scene &scene = model.scene;
  if (std::none_of(scene.loads.begin(), scene.loads.end(),
                   [](const Load &load) { return load.history.is_given(); }) &&
      !model.contacts.ground_moves())
    return true;
  const auto values_at = [&](const double time, const Side of = Side::both) {
    const Factors factors_then = factors_at(time, of);
    const Vector motions = imposed(time, of);
    Vector values(factors_then.size() + motions.size());
    values << Eigen::Map<const Vector>(factors_then.data(), factors_then.size()), motions;
    return values;
  };
  std::vector<Vector> values = {values_at(begin, Side::after)};
  for (const double part : between)
    values.push_back(values_at(begin + part * (end - begin)));
  values.push_back(values_at(end, Side::before));
  Vector largest = Vector::Zero(values[0].size());
  for (const Vector &value : values)
    largest = largest.cwiseMax(value.cwiseAbs());
  for (Vector &value : values)
    for (int i = 0; i < value.size(); ++i)
      value[i] /= largest[i] > 0. ? largest[i] : 1.;
  const Vector way = values.back() - values.front();
  const double square = way.squaredNorm();
  double last = 0.; // how far along the way
  for (const Vector &value : values) {
    const Vector gone = value - values.front();
    const double part = square > 0. ? gone.dot(way) / square : 0.;
    if ((gone - part * way).lpNorm<Eigen::Infinity>() > same || part < last - same ||
        part > 1. + same)
      return false;
    last = part;
  }
  return true;
}

bool LoadCourse::forces_jump(const double time) const {
  if (!is_break(time))
    return false;
  const Factors before = factors_before(time), after = factors_after(time);
  for (unsigned int l = 0; l < to.size(); ++l)
    if (std::abs(after[l] - before[l]) >
        equal_numbers * std::max(std::abs(after[l]), std::abs(before[l])))
      return true;
  return false;
}

bool LoadCourse::jumps(const double time) const {
  if (!is_break(time))
    return false;
  for (unsigned int l = 0; l < to.size(); ++l)
    if (model.linear.accelerates(l))
      return true;
  return forces_jump(time);
}

bool LoadCourse::is_break(const double time) const {
  const double rounding = 8. * std::numeric_limits<double>::epsilon() * std::abs(time);
  return next_break(time - rounding) <= time + rounding;
}

} // namespace frictionbeam
