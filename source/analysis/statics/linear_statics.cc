// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/linear_statics.h"

#include "analysis/contact/exact_method.h"
#include "analysis/contact/solver_library.h"
#include "base/unused_memory.h"

namespace frictionbeam {

namespace {

std::unique_ptr<EquilibriumSolver> make_solver(const Model &model) {
  const SolverSettings &settings = model.scene.solver;
  const SparseMatrix &stiffness = model.linear.stiffness();
  if (model.linear.has_all_places())
    return make_equilibrium_solver(settings, model.contacts, model.space, stiffness);
  // The whole matrix is there no longer than it takes to condense it.
  auto line = contact::condense_parts(model.linear.stiffness_with_places(),
                                      ExactMethod::kept_unknowns(model.contacts));
  return std::make_unique<ExactMethod>(settings, model.contacts, std::move(line),
                                       stiffness.diagonal());
}

} // namespace

LinearStatics::LinearStatics(const Model &model) : model(model), solver(make_solver(model)) {}

void LinearStatics::hold_less() {
  if (!solver)
    return;
  Archive archive;
  transfer(archive);
  put_away = archive.bytes();
  solver.reset();
  give_back_unused_memory();
}

EquilibriumSolver &LinearStatics::method() const {
  if (!solver) {
    solver = make_solver(model);
    Archive archive(std::move(put_away));
    archive(*solver);
  }
  return *solver;
}

EquilibriumResult LinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                       LineState &to, ContactResponse &response) {
  EquilibriumProblem problem{{model.linear.stiffness(), increment.course.forces(increment.factors)},
                             increment.course.imposed(increment.time)};
  increment.describe(model, problem);
  if (!model.linear.has_all_places()) { // of an exact method
    problem.unbalanced = [&](const Vector &unknowns, const Vector &low) {
      return model.linear.unbalanced(problem.right_hand_side, unknowns, low);
    };
    if (problem.imposed.isZero(0.))
      problem.imposed.resize(0);
  }
  const EquilibriumResult result = method().solve(problem, from.contacts, to.unknowns, response);
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += increment.course.imposed(increment.time);
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
