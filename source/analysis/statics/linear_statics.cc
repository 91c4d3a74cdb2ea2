// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/linear_statics.h"

#include "analysis/contact/solver_library.h"

namespace frictionbeam {

LinearStatics::LinearStatics(const Model &model)
    : model(model), solver(make_equilibrium_solver(model.scene.solver, model.contacts, model.space,
                                                   model.linear.stiffness())) {}

EquilibriumResult LinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                       LineState &to, ContactResponse &response) {
  EquilibriumProblem problem{{model.linear.stiffness(), increment.course.forces(increment.factors)},
                             increment.course.imposed(increment.time)};
  increment.describe(model, problem);
  const EquilibriumResult result = solver->solve(problem, from.contacts, to.unknowns, response);
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += problem.imposed;
  return result;
}

EnergyAccount LinearStatics::account(const LineState &before, const LineState &after,
                                     const LoadCourse &course, const Vector &unbalanced) const {
  return account_increment(model, before, after, course.forces(before.load_factors) - unbalanced,
                           course.forces(after.load_factors));
}

Vector LinearStatics::forces_on_contacts(const LineState &state, const LoadCourse &course) const {
  return course.forces(state.load_factors) - model.linear.stiffness() * state.unknowns;
}

} // namespace frictionbeam
