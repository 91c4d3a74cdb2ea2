// SPDX-License-Identifier: LGPL-2.1-or-later
#include "load_jumps.h"

#include <frictionbeam/analysis/line_factorization.h>

#include <cmath>

namespace frictionbeam {

namespace {

/// Impulse of the inertia of imposed motions whose velocity jumps; empty if none does.
Vector impulse_of_inertia(const Model &model, const std::vector<double> &before,
                          const std::vector<double> &after) {
  Vector impulse;
  for (unsigned int l = 0; l < after.size(); ++l) {
    const double jump = after[l] - before[l];
    if (!model.linear.accelerates(l) ||
        std::abs(jump) <= 1e-6 * std::max(std::abs(after[l]), std::abs(before[l])))
      continue;
    if (impulse.size() == 0)
      impulse.setZero(model.space.n_unknowns());
    impulse += jump * model.linear.inertia(l);
  }
  return impulse;
}

} // namespace

EnergyAccount meet_jump(const Model &model, const LoadCourse &course, TimeIntegrator &integrator,
                        LineState &state) {
  EnergyAccount account;
  course.set_rates(state, LoadCourse::Side::before);
  const LineState before = state;
  state.load_factors = course.factors_after(state.time);
  course.set_rates(state, LoadCourse::Side::after);
  if (const Vector impulse = impulse_of_inertia(model, before.load_rates, state.load_rates);
      impulse.size() > 0 && !model.corotational) {
    LineFactorization mass;
    const SparseMatrix regular = regular_mass(model.linear.mass());
    mass.analyze(regular);
    const bool is_regular = mass.factorize(regular);
    AssertThrow(is_regular, dealii::ExcMessage("The mass matrix is singular."));
    const std::vector<bool> has_mass = unknowns_with_mass(model.linear.mass());
    Vector change = mass.solve(impulse);
    for (int i = 0; i < change.size(); ++i)
      if (!has_mass[i])
        change[i] = 0.;
    state.velocity += change;
    account.kinetic = (state.velocity.dot(model.linear.mass() * state.velocity) -
                       before.velocity.dot(model.linear.mass() * before.velocity)) /
                      2.;
    account.external = impulse.dot(before.velocity + state.velocity) / 2.;
    account += account_imposed(model, before, state, 1.);
    account.turnover = std::abs(account.kinetic) + std::abs(account.external);
  }
  integrator.start(state, course);
  return account;
}

} // namespace frictionbeam
