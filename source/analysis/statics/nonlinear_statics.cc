// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/nonlinear_statics.h"

#include "base/interruption.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
constexpr double largest_turn = 0.5; // of a vertex in one iteration [rad]
}

EquilibriumResult NonlinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                          LineState &to, ContactResponse &response) {
  const LineCells &line = model.cells;
  const SolverSettings &settings = model.scene.solver;
  LineCells::Balance balance;
  line.evaluate({from.dofs, from.turns}, from.load_factors, balance);
  const double largest_before =
      std::max(increment.least_force, balance.largest); // a line may lose all its forces
  Pose pose = line.moved({from.dofs, from.turns}, increment.course.imposed(increment.time) -
                                                      increment.course.imposed(from.time));
  EquilibriumResult result;
  Vector change, dofs, moved = Vector::Zero(from.unknowns.size());
  bool judged = false; // whether the contacts' forces are those at the pose
  for (;;) {
    interruption::end_if_overdue();
    line.evaluate(pose, increment.factors, balance);
    const Vector forces = balance.forces + model.contacts.platen_forces();
    if (!forces.allFinite()) {
      result.remark = "the iteration diverges";
      return result;
    }
    double largest = std::max(largest_before, balance.largest);
    if (judged) {
      Vector of_contacts = Vector::Zero(forces.size());
      model.contacts.add_forces(response, of_contacts);
      largest = std::max(largest, largest_contact_force(model.contacts, response));
      const double size = (forces - of_contacts).lpNorm<Eigen::Infinity>();
      const double scale = std::max(largest, balance.free);
      result.residual = scale > 0. ? size / scale : size;
      const auto rounding = [&]() {
        LineCells::Balance beside;
        line.evaluate(with_other_digits(model, pose), increment.factors, beside);
        return (beside.forces - balance.forces).lpNorm<Eigen::Infinity>();
      };
      if (is_balanced(model, balance.stiffness, size, largest, pose, rounding, balance.free)) {
        result.converged = true;
        to.unknowns = from.unknowns + moved;
        set_pose(model, pose, to);
        return result;
      }
    }
    if (result.iterations == settings.max_iterations) {
      result.remark = "no convergence in " + std::to_string(result.iterations) + " iterations";
      return result;
    }
    EquilibriumProblem problem{balance.stiffness, forces, pose.dofs};
    problem.increment = {increment.time, 0., model.contacts.temperatures(increment.factors)};
    problem.largest_force = largest;
    problem.force_so_far = std::max(increment.force_so_far, balance.free);
    const EquilibriumResult inner = linearized.solve(problem, from.contacts, change, response);
    ++result.iterations;
    result.factorizations += inner.factorizations;
    result.check = inner.check;
    if (!inner.converged) {
      result.remark = inner.remark;
      return result;
    }
    model.space.expand(change, dofs);
    double turn = 0.;
    for (unsigned int v = 0; v < model.discretization.n_line_vertices(); ++v)
      for (unsigned int c = 3; c < 6; ++c)
        if (const auto dof = model.discretization.vertex_dofs().index(v, c);
            dof != numbers::invalid_dof_index)
          turn = std::max(turn, std::abs(dofs[dof]));
    const double part = turn > largest_turn ? largest_turn / turn : 1.;
    judged = part == 1.;
    moved += part * change;
    pose = line.moved(pose, part * dofs);
  }
}

Vector NonlinearStatics::forces_on_contacts(const LineState &state, const LoadCourse &) const {
  LineCells::Balance balance;
  model.cells.evaluate({state.dofs, state.turns}, state.load_factors, balance);
  return balance.forces + model.contacts.platen_forces();
}

EnergyAccount NonlinearStatics::account(const LineState &before, const LineState &after,
                                        const LoadCourse &course, const Vector &unbalanced) const {
  const LineCells &line = model.cells;
  const Pose from{before.dofs, before.turns}, to{after.dofs, after.turns};
  std::vector<double> factors(after.load_factors);
  for (unsigned int l = 0; l < factors.size(); ++l)
    factors[l] = (factors[l] + before.load_factors[l]) / 2.;
  LineCells::Balance mean;
  const Vector change = line.change(from, to);
  line.evaluate({from, line.halfway(from, to), to, change}, factors, mean);
  EnergyAccount account;
  account.external =
      mean.loads.dot(change) + mean.free_work +
      model.contacts.platen_forces().dot(after.unknowns - before.unknowns) +
      (mean.internal - mean.loads).dot(course.imposed(after.time) - course.imposed(before.time));
  account.stored = line.stored_energy(to) - line.stored_energy(from);
  account.turnover = std::abs(account.external) + std::abs(account.stored);
  account += account_contacts(model, before, after, {});
  account.external -= unbalanced.dot(after.unknowns - before.unknowns) / 2.;
  return account;
}

} // namespace frictionbeam
