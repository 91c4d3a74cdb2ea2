// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/linear_statics.h"

#include "analysis/contact/exact_method.h"
#include "analysis/contact/solver_library.h"
#include "base/unused_memory.h"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace frictionbeam {

LinearStatics::LinearStatics(const Model &model)
    : model(model), parts(model), pressures(model.linear.parts().size(), 0.),
      solver(make_method()) {}

std::unique_ptr<EquilibriumSolver> LinearStatics::make_method() const {
  return make_equilibrium_solver(model.scene.solver, model.contacts, model.space, stiffness());
}

void LinearStatics::put_method_away() {
  if (!solver)
    return;
  Archive archive;
  transfer(archive);
  put_away = archive.bytes();
  solver.reset();
}

void LinearStatics::hold_less() {
  put_method_away();
  give_back_unused_memory();
}

EquilibriumSolver &LinearStatics::method() const {
  if (!solver) {
    solver = make_method();
    Archive archive(std::move(put_away));
    archive(*solver);
  }
  return *solver;
}

std::optional<EquilibriumResult> LinearStatics::stiffen(const std::vector<double> &factors) {
  EquilibriumResult refused;
  refused.rounding_bars = true; // no smaller increment ends elsewhere
  const PressedParts::Stability stability = parts.stability(factors);
  if (stability == PressedParts::Stability::buckled) {
    refused.no_equilibrium = true;
    refused.remark = "the wall of a solid part buckles under its pressure, however its sections "
                     "are held";
    return refused;
  }
  if (stability == PressedParts::Stability::of_the_line) {
    refused.no_equilibrium =
        model.contacts.size() == 0 &&
        Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(parts.stiffness(factors)).info() !=
            Eigen::Success;
    refused.remark =
        refused.no_equilibrium
            ? "the wall of a solid part buckles under its pressure: with it the line's "
              "stiffness is not positive definite any more"
            : "the wall of a solid part buckles under its pressure if the line does "
              "not hold its ends, and whether it does is not known: Model = solid "
              "would tell";
    return refused;
  }
  if (std::vector<double> now = parts.pressures(factors); now != pressures) {
    put_method_away();
    pressures = std::move(now);
    stiffened = parts.stiffness(factors);
  }
  return {};
}

EquilibriumResult LinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                       LineState &to, ContactResponse &response) {
  if (const auto refused = stiffen(increment.factors))
    return *refused;
  EquilibriumProblem problem{{stiffness(), increment.course.forces(increment.factors)},
                             increment.course.imposed(increment.time)};
  if (stiffened)
    problem.right_hand_side += parts.forces(increment.factors, problem.imposed);
  increment.describe(model, problem);
  const EquilibriumResult result = method().solve(problem, from.contacts, to.unknowns, response);
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += increment.course.imposed(increment.time);
  return result;
}

EnergyAccount LinearStatics::account(const LineState &before, const LineState &after,
                                     const LoadCourse &course, const Vector &unbalanced) const {
  EnergyAccount account =
      account_increment(model, before, after, course.forces(before.load_factors) - unbalanced,
                        course.forces(after.load_factors));
  if (!stiffened)
    return account;
  // Added forces do work, and so does a pressure on what it stiffens as it grows: what is stored
  // beyond the work of the forces that the added stiffness needs.
  const double stored =
      parts.energy(after.load_factors, after.dofs) - parts.energy(before.load_factors, before.dofs);
  account.stored += stored;
  account.external += stored + 0.5 * (parts.forces(before.load_factors, before.dofs) +
                                      parts.forces(after.load_factors, after.dofs))
                                         .dot(after.unknowns - before.unknowns);
  account.turnover += std::abs(stored);
  return account;
}

Vector LinearStatics::forces_on_contacts(const LineState &state, const LoadCourse &course) const {
  Vector forces = course.forces(state.load_factors) - model.linear.stiffness() * state.unknowns;
  if (stiffened)
    forces += parts.forces(state.load_factors, state.dofs);
  return forces;
}

} // namespace frictionbeam
