// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/load_course.h>
#include <frictionbeam/analysis/time_integrator.h>

#include <algorithm>
#include <limits>

namespace frictionbeam {

LoadCourse::LoadCourse(const Model &model)
    : model(model), from(model.scene.loads.size(), 0.), to(from) {}

void LoadCourse::begin_step(const Factors &before, const Factors &after, const double start_time,
                            const double ramp_time) {
  from = before;
  to = after;
  start = start_time;
  ramp = ramp_time;
}

LoadCourse::Factors LoadCourse::declared(const double time) const {
  const double part = ramp > 0. ? std::clamp((time - start) / ramp, 0., 1.) : 1.;
  Factors result = to;
  if (part < 1.)
    for (unsigned int l = 0; l < result.size(); ++l)
      result[l] = from[l] + part * (to[l] - from[l]);
  return result;
}

LoadCourse::Factors
LoadCourse::declared_times(const double time,
                           const std::function<double(const TimeFunction &)> &value) const {
  Factors result = declared(time);
  for (unsigned int l = 0; l < result.size(); ++l)
    if (result[l] != 0.)
      result[l] *= value(model.scene.loads[l].history);
  return result;
}

LoadCourse::Factors LoadCourse::factors(const double time) const {
  return declared_times(time, [time](const TimeFunction &history) { return history(time); });
}

LoadCourse::Factors LoadCourse::factors_before(const double time) const {
  return declared_times(time, [time](const TimeFunction &history) { return history.before(time); });
}

LoadCourse::Factors LoadCourse::factors_after(const double time) const {
  return declared_times(time, [time](const TimeFunction &history) { return history.after(time); });
}

Vector LoadCourse::forces(const Factors &factors) const {
  Vector result = model.contacts.platen_forces() + model.linear.preload();
  for (unsigned int l = 0; l < factors.size(); ++l)
    if (factors[l] != 0.)
      result += factors[l] * model.linear.forces(l);
  return result;
}

Vector LoadCourse::forces(const double time) const { return forces(factors(time)); }

LoadCourse::Derivatives LoadCourse::derivatives(const double time) const {
  bool any = false;
  for (unsigned int l = 0; l < to.size(); ++l)
    any = any || model.linear.accelerates(l);
  if (!any)
    return {};
  const double h = time_step(model), middle = std::max(time, h); // nothing is known before 0
  const Factors before = factors(middle - h), now = factors(middle), after = factors(middle + h);
  Derivatives result{Factors(to.size(), 0.), Factors(to.size(), 0.)};
  for (unsigned int l = 0; l < to.size(); ++l)
    if (model.linear.accelerates(l)) {
      result.first[l] = (after[l] - before[l]) / (2. * h);
      result.second[l] = (after[l] - 2. * now[l] + before[l]) / (h * h);
    }
  return result;
}

void LoadCourse::add_inertia(const double time, Vector &forces) const {
  const Derivatives factors = derivatives(time);
  for (unsigned int l = 0; l < factors.first.size(); ++l)
    if (model.linear.accelerates(l))
      forces +=
          factors.second[l] * model.linear.inertia(l) + factors.first[l] * model.linear.drag(l);
}

void LoadCourse::set_rates(LineState &state) const {
  const Derivatives factors = derivatives(state.time);
  state.load_rates = factors.first;
  state.load_accelerations = factors.second;
}

Vector LoadCourse::imposed(const double time) const {
  Vector result = Vector::Zero(model.space.n_dofs());
  const Factors now = factors(time);
  for (unsigned int l = 0; l < now.size(); ++l)
    if (now[l] != 0.)
      for (const auto &[dof, value] : model.linear.imposed(l))
        result[dof] += now[l] * value;
  model.contacts.add_ground_motion(time, result);
  return result;
}

double LoadCourse::next_break(const double time) const {
  double next = std::numeric_limits<double>::infinity();
  const auto include = [&](const double instant) {
    if (instant > time)
      next = std::min(next, instant);
  };
  if (ramp > 0.)
    include(start + ramp);
  const auto include_all = [&](const TimeFunction &function) {
    const auto after = std::upper_bound(function.breaks.begin(), function.breaks.end(), time);
    if (after != function.breaks.end())
      include(*after);
  };
  for (unsigned int l = 0; l < to.size(); ++l)
    if (to[l] != 0. || from[l] != 0.)
      include_all(model.scene.loads[l].history);
  for (const FrictionSupport &support : model.scene.supports)
    for (const TimeFunction &motion : support.ground_motion)
      include_all(motion);
  return next;
}

bool LoadCourse::may_jump(const double start, const double end) const {
  const double rounding = 1e-9 * (end - start);
  return next_break(start - rounding) < end - rounding;
}

} // namespace frictionbeam
