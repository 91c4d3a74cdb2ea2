// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/load_jumps.h"

#include "analysis/increment/time_step.h"
#include "analysis/time/mass_factorization.h"
#include "analysis/time/step_helpers.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "model/line_pose.h"
#include <frictionbeam/contact/line_factorization.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {

/// Impulse of the inertia of imposed motions whose velocity jumps; empty if none does, or if
/// nothing is known of the rates before.
Vector impulse_of_inertia(const Model &model, const std::vector<double> &before,
                          const std::vector<double> &after) {
  Vector impulse;
  for (unsigned int l = 0; l < before.size(); ++l) {
    const double jump = after[l] - before[l];
    if (!model.linear.accelerates(l) ||
        std::abs(jump) <= 1e-6 * std::max(std::abs(after[l]), std::abs(before[l])))
      continue;
    if (impulse.size() == 0)
      impulse.setZero(model.space.n_unknowns());
    impulse += jump * model.cells.inertia(l);
  }
  return impulse;
}

double kinetic_energy(const Model &model, const LineState &state) {
  return model.cells.kinetic_energy(pose_of(state), state.velocity, state.load_rates);
}

/// "A", "A, B and 3 more".
std::string moved_points(const Load &load) {
  std::vector<std::string> names;
  for (const Load::AtPoint &moved : load.at)
    if (std::count(names.begin(), names.end(), moved.point) == 0)
      names.push_back(moved.point);
  return first_of(names);
}

/// The largest motion of a point by a factor, "0.01 m" or "2 degrees".
std::string size_of_motion(const UnitSystem &units, const Load &load, const double factor) {
  double shift = 0., turn = 0.;
  for (const Load::AtPoint &moved : load.at) {
    shift = std::max(shift, std::hypot(moved.value[0], moved.value[1], moved.value[2]));
    turn = std::max(turn, std::hypot(moved.value[3], moved.value[4], moved.value[5]));
  }
  const bool shifts = shift > 0.;
  const double size = shifts ? shift / units.factor("m") : turn * 180. / M_PI;
  return rounded_number(std::abs(factor) * size, 3) + " " + (shifts ? units.name("m") : "degrees");
}

} // namespace

EnergyAccount meet_jump(const Model &model, const LoadCourse &course, TimeIntegrator &integrator,
                        LineState &state) {
  EnergyAccount account;
  const LineState before = state;
  state.load_factors = course.factors_after(state.time);
  course.set_rates(state, LoadCourse::Side::after);
  if (const Vector impulse = impulse_of_inertia(model, before.load_rates, state.load_rates);
      impulse.size() > 0) {
    contact::LineFactorization mass;
    factor_mass(model.cells.mass(), mass);
    const std::vector<bool> has_mass = unknowns_with_mass(model.cells.mass());
    Vector change = mass.solve(impulse);
    for (int i = 0; i < change.size(); ++i)
      if (!has_mass[i])
        change[i] = 0.;
    state.velocity += change;
    account.kinetic = kinetic_energy(model, state) - kinetic_energy(model, before);
    account.external = account.kinetic; // the reactions' work, and nothing else does any
    account.turnover = std::abs(account.kinetic) + std::abs(account.external);
  }
  integrator.start(state, course);
  return account;
}

std::vector<unsigned int> loads_with_velocity_jumps(const Model &model, const LoadCourse &course,
                                                    std::vector<double> before, const double start,
                                                    const double end) {
  constexpr double clearly = 0.05; // of the largest rate: one-sided differences are no nearer
  constexpr unsigned int n_samples = 32;
  std::vector<unsigned int> with_jumps;
  for (unsigned int l = 0; l < model.scene.loads.size(); ++l)
    if (model.linear.accelerates(l))
      with_jumps.push_back(l);
  if (with_jumps.empty())
    return with_jumps;
  LineState at;
  std::vector<double> largest(model.scene.loads.size(), 0.), jump = largest;
  const auto rates = [&](const double time, const LoadCourse::Side side) {
    at.time = time;
    course.set_rates(at, side);
    for (unsigned int l = 0; l < largest.size(); ++l)
      largest[l] = std::max(largest[l], std::abs(at.load_rates[l]));
    return at.load_rates;
  };
  for (unsigned int i = 0; i < n_samples; ++i)
    rates(start + (i + 0.5) / n_samples * (end - start), LoadCourse::Side::both);
  for (double time = start; time < end;
       time = course.next_break(time + same_instant_of_step * time_step(model))) {
    if (time > start)
      before = rates(time, LoadCourse::Side::before);
    const std::vector<double> after = rates(time, LoadCourse::Side::after);
    for (unsigned int l = 0; l < before.size(); ++l)
      jump[l] = std::max(jump[l], std::abs(after[l] - before[l]));
  }
  with_jumps.erase(
      std::remove_if(with_jumps.begin(), with_jumps.end(),
                     [&](const unsigned int l) { return !(jump[l] > clearly * largest[l]); }),
      with_jumps.end());
  return with_jumps;
}

std::string jumps_of_motions(const Model &model, const LoadCourse &course,
                             const LoadCourse::Factors &before, const double start,
                             const double end, const std::string &step) {
  struct Jump {
    double factor = 0., time = 0.;
  };
  std::map<unsigned int, Jump> largest; // by load
  const Eigen::MatrixXd &mass = model.linear.imposed_products().mass;
  const auto note = [&](const LoadCourse::Factors &jumps, const double time) {
    for (unsigned int l = 0; l < jumps.size(); ++l)
      if (jumps[l] != 0. && model.linear.accelerates(l) && mass(l, l) > 0.)
        if (Jump &known = largest[l]; std::abs(jumps[l]) > std::abs(known.factor))
          known = {jumps[l], time};
  };
  note(course.jumps_between(before, course.factors_after(start), start), start);
  const double rounding = same_instant_of_step * time_step(model);
  for (double time = course.next_break(start + rounding); time < end - rounding;
       time = course.next_break(time))
    note(course.jumps_between(course.factors_before(time), course.factors_after(time), time), time);
  std::string text;
  for (const auto &[l, jump] : largest) {
    const Load &load = model.scene.loads[l];
    text += (text.empty() ? "Load " : " Load ") + load.name + " makes " + moved_points(load) +
            " jump by " + size_of_motion(model.scene.units, load, jump.factor) + " at " +
            rounded_number(jump.time, 6) + " s, in step " + step +
            ". No mass does that with a finite force: velocities and forces behind it, their "
            "extremes and integrals depend on the time step and on the cells. Give it a History "
            "without jumps, or the step a Ramp.";
  }
  return text;
}

std::string forbidden_by_damping(const Model &model, const LoadCourse::Factors &jumps) {
  for (unsigned int l = 0; l < jumps.size(); ++l)
    if (jumps[l] != 0. && model.linear.accelerates(l) && !model.linear.drag(l).isZero(0.))
      return "load " + model.scene.loads[l].name +
             " jumps, and moves an end of a dashpot or of a damped pipe: that takes infinite work; "
             "give its motion a ramp, or leave the damping out";
  return "";
}

std::string forbidden_jump(const Model &model, const LoadCourse &course, const LineState &state,
                           const double time) {
  const Vector jumps = course.imposed_jumps(state.time, time);
  if (jumps.size() == 0)
    return "";
  if (const std::string why = forbidden_by_damping(model, course.factor_jumps(state.time, time));
      !why.empty())
    return why;
  constexpr double rounding = 1e-9; // of a jump
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (!contact.law.is_rigid_along_normal() || !contact.law.has_closed_form() ||
        contact.platen_force != 0.)
      continue;
    const double opens = contact.length * contact.strain(jumps)[0],
                 gap = contact.length * state.contacts.strain[i][0] + contact.law.closed_form().gap,
                 least = rounding * jumps.lpNorm<Eigen::Infinity>();
    if (opens < -least && gap + opens < -least)
      return "at support " + model.scene.supports[contact.support].name +
             ", ground or pipe jumps into the other, and the support is rigid: no finite force "
             "does that; give the motion a ramp, or the support an Axial rigidity";
  }
  return "";
}

} // namespace frictionbeam
