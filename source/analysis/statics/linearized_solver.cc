// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/linearized_solver.h"

#include "analysis/contact/solver_library.h"
#include "model/unknowns/line_extent.h"
#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace frictionbeam {

using namespace dealii;

SparseMatrix symmetric_part(const SparseMatrix &matrix) {
  SparseMatrix result = matrix;
  result.makeCompressed();
  // Rows ask for the entries above the diagonal of a row before in the order in which they stand.
  std::vector<int> next(matrix.rows());
  const int *const begin = result.outerIndexPtr(), *const columns = result.innerIndexPtr();
  double *const values = result.valuePtr();
  for (int row = 0; row < matrix.rows(); ++row) {
    int k = begin[row];
    for (; k < begin[row + 1] && columns[k] < row; ++k) {
      const int column = columns[k];
      const int other = next[column]++;
      Assert(columns[other] == row, ExcMessage("The pattern is not symmetric."));
      values[k] = values[other] = 0.5 * (values[k] + values[other]);
    }
    next[row] = k < begin[row + 1] && columns[k] == row ? k + 1 : k;
  }
  return result;
}

namespace {
/// Of the same pattern.
bool are_equal(const SparseMatrix &one, const SparseMatrix &other) {
  return one.nonZeros() == other.nonZeros() &&
         std::equal(one.valuePtr(), one.valuePtr() + one.nonZeros(), other.valuePtr());
}

bool all_are_open(const ContactResponse &response) {
  return std::all_of(response.status.begin(), response.status.end(),
                     [](const ContactStatus one) { return one == ContactStatus::open; });
}
} // namespace

void LinearizedSolver::keep(const SparseMatrix &matrix) {
  if (model.contacts.size() == 0)
    return;
  kept.emplace(Method{matrix, symmetric_part(matrix), {}});
  kept->solver = make_equilibrium_solver(model.scene.solver, model.contacts, model.space,
                                         kept->symmetric, parts.get());
}

void LinearizedSolver::transfer(Archive &archive) {
  if (kept)
    kept->solver->transfer(archive);
}

bool LinearizedSolver::solve_without_contacts(const SparseMatrix &matrix,
                                              const Vector &right_hand_side, Vector &change) {
  if (matrix.rows() == 0) {
    change.resize(0);
    return true;
  }
  if (!analyzed)
    factorization.analyze(matrix);
  analyzed = true;
  if (!factorization.factorize(matrix))
    return false;
  change = factorization.solve(right_hand_side);
  return change.allFinite();
}

EquilibriumResult LinearizedSolver::solve(EquilibriumProblem &problem,
                                          const ContactState &committed, Vector &change,
                                          ContactResponse &response) {
  change.setZero(problem.right_hand_side.size());
  EquilibriumResult result;
  if (model.contacts.size() == 0) {
    model.contacts.prepare(response);
    response.state = committed;
    result.factorizations = 1;
    result.converged = solve_without_contacts(problem.matrix, problem.right_hand_side, change);
    if (!result.converged)
      result.remark = "the tangent stiffness is singular: something moves freely or buckles";
    return result;
  }
  const bool is_kept = kept && are_equal(kept->matrix, problem.matrix);
  SparseMatrix own;
  if (!is_kept)
    own = symmetric_part(problem.matrix);
  const SparseMatrix &symmetric = is_kept ? kept->symmetric : own;
  EquilibriumProblem linear{{symmetric, problem.right_hand_side, problem.increment,
                             problem.overrides, problem.largest_force},
                            problem.imposed};
  linear.force_so_far = problem.force_so_far;
  linear.forces_before = problem.forces_before;
  const auto solve = [&](EquilibriumSolver &solver) {
    return solver.solve(linear, committed, change, response);
  };
  result = is_kept ? solve(*kept->solver)
                   : solve(*make_equilibrium_solver(model.scene.solver, model.contacts, model.space,
                                                    symmetric, parts.get()));
  result.no_equilibrium = false; // of this pose it is no proof
  if (result.converged && all_are_open(response) && !are_equal(symmetric, problem.matrix)) {
    correct_freely(problem, committed, change, response);
    ++result.factorizations;
  }
  return result;
}

void LinearizedSolver::correct_freely(const EquilibriumProblem &problem,
                                      const ContactState &committed, Vector &change,
                                      ContactResponse &response) {
  Vector freely;
  if (!solve_without_contacts(problem.matrix, problem.right_hand_side, freely))
    return;
  ContactResponse there;
  Residual residual(problem, model.contacts, model.space,
                    [&](const Vector &dofs, const LawTangent wanted, ContactResponse &r) {
                      model.contacts.evaluate(dofs, committed, problem.increment, wanted, r);
                    });
  residual(freely, LawTangent::consistent, there);
  if (there.failed || !all_are_open(there))
    return;
  change = freely;
  response = there;
}

EquilibriumResult LinearizedSolver::solve_led_freely(const SparseMatrix &matrix,
                                                     const Vector &right_hand_side, Lead &lead,
                                                     Vector &change) {
  EquilibriumResult result;
  result.factorizations = 1;
  Vector of_loads;
  if (solve_without_contacts(matrix, right_hand_side, change))
    of_loads = solve_again(lead.forces);
  result.converged = of_loads.size() > 0 && of_loads.allFinite() && of_loads[lead.unknown] != 0.;
  if (result.converged && lead.by_work)
    result.converged = solve_by_work(lead, of_loads, change);
  else if (result.converged) {
    lead.more = (lead.change - change[lead.unknown]) / of_loads[lead.unknown];
    change += lead.more * of_loads;
  }
  if (!result.converged)
    result.remark = "the tangent stiffness is singular: something moves freely or buckles";
  return result;
}

bool LinearizedSolver::solve_by_work(Lead &lead, const Vector &of_loads, Vector &change) const {
  Vector held = Vector::Zero(change.size());
  held[lead.unknown] = lead.stiffness;
  const Vector of_spring = solve_again(held);
  // The spring is taken off by a force on its unknown that goes with the unknown's own change.
  Eigen::Matrix2d matrix;
  matrix << of_loads[lead.unknown], of_spring[lead.unknown] - 1., lead.forces.dot(of_loads),
      lead.forces.dot(of_spring);
  const Eigen::Vector2d sizes = matrix.fullPivLu().solve(
      Eigen::Vector2d(-change[lead.unknown], lead.change - lead.forces.dot(change)));
  if (!sizes.allFinite())
    return false;
  lead.more = sizes[0];
  change += sizes[0] * of_loads + sizes[1] * of_spring;
  return true;
}

std::optional<double> LinearizedSolver::find_load(const Overshoot &overshoot, const Lead &lead,
                                                  const double allowed) {
  constexpr unsigned int most_tries = 20;
  constexpr double good_enough = 1e-7; // of the whole way: the next iteration goes on from there
  double last = 0.;
  std::optional<double> of_last = overshoot(last), low, high; // sizes too small, and too large
  double next = of_last ? -*of_last * lead.loads_by_change : 0.;
  for (unsigned int k = 0; k < most_tries && of_last; ++k) {
    if (std::abs(*of_last) <= allowed)
      return last;
    (*of_last < 0. ? low : high) = last;
    if (low && high && (next - *low) * (next - *high) >= 0.)
      next = (*low + *high) / 2.;
    const std::optional<double> of_next = overshoot(next);
    if (!of_next) { // further than anything holds
      next = (last + next) / 2.;
      continue;
    }
    if (std::abs(*of_next) <= good_enough * std::abs(lead.whole) &&
        std::abs(*of_next) >= 0.5 * std::abs(*of_last))
      return next; // rounding
    const double secant = *of_next == *of_last
                              ? 2. * next - last
                              : next - *of_next * (next - last) / (*of_next - *of_last);
    last = next;
    of_last = of_next;
    next = secant;
  }
  return {};
}

EquilibriumResult LinearizedSolver::solve_led(EquilibriumProblem &problem, Lead &lead,
                                              const ContactState &committed, Vector &change,
                                              ContactResponse &response) {
  constexpr double unbalanced = 0.1; // of what the residual may be, in the spring
  SparseMatrix matrix = model.contacts.size() > 0 ? symmetric_part(problem.matrix) : problem.matrix;
  matrix.coeffRef(lead.unknown, lead.unknown) += lead.stiffness;
  Vector forces = problem.right_hand_side;
  if (!lead.by_work)
    forces[lead.unknown] += lead.stiffness * lead.change;
  change.setZero(forces.size());
  if (model.contacts.size() == 0) {
    model.contacts.prepare(response);
    response.state = committed;
    return solve_led_freely(matrix, forces, lead, change);
  }
  const auto solver =
      make_equilibrium_solver(model.scene.solver, model.contacts, model.space, matrix, parts.get());
  EquilibriumProblem linear{
      {matrix, forces, problem.increment, problem.overrides, problem.largest_force},
      problem.imposed};
  linear.force_so_far = problem.force_so_far;
  std::vector<Contact::Strains> stress = *problem.forces_before;
  linear.forces_before = &stress;
  EquilibriumResult result;
  const auto overshoot = [&](const double more) -> std::optional<double> {
    linear.right_hand_side = forces + more * lead.forces;
    const EquilibriumResult one = solver->solve(linear, committed, change, response);
    const unsigned int factorizations = result.factorizations + one.factorizations;
    result = one;
    result.factorizations = factorizations;
    if (!one.converged)
      return {};
    stress = response.stress;
    return change[lead.unknown] - lead.change;
  };
  const double allowed = unbalanced * model.scene.solver.tolerance *
                         std::max(problem.largest_force, problem.force_so_far) / lead.stiffness;
  const auto more = find_load(overshoot, lead, allowed);
  if (more)
    lead.more = *more;
  else if (result.converged)
    result.remark = "no size of the loads moves the line as far as it is led";
  result.converged = more.has_value();
  result.no_equilibrium = false;
  return result;
}

bool iterate(const unsigned int most, const std::function<EquilibriumResult()> &solve_linearized,
             EquilibriumResult &result) {
  if (result.iterations == most) {
    result.remark = "no convergence in " + std::to_string(most) + " iterations";
    return false;
  }
  const EquilibriumResult inner = solve_linearized();
  ++result.iterations;
  result.factorizations += inner.factorizations;
  result.check = inner.check;
  if (!inner.converged)
    result.remark = inner.remark;
  return inner.converged;
}

double largest_diagonal(const SparseMatrix &matrix) {
  double largest = 0.;
  for (int i = 0; i < matrix.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(matrix, i); entry; ++entry)
      if (entry.col() == i)
        largest = std::max(largest, std::abs(entry.value()));
  return largest;
}

Pose with_other_digits(const Model &model, const Pose &pose, const bool of_places) {
  constexpr double digits = 4. * std::numeric_limits<double>::epsilon();
  const bool turns_far = model.cells.turns_far();
  Vector nudge = Vector::Zero(pose.dofs.size());
  std::minstd_rand random; // always the same sequence
  for (unsigned int v = 0; v < model.discretization.n_line_vertices(); ++v)
    for (unsigned int c = 0; c < 6; ++c)
      if (const auto dof = model.discretization.vertex_dofs().index(v, c);
          dof != numbers::invalid_dof_index)
        nudge[dof] =
            (random() % 2 == 0 ? digits : -digits) *
            (turns_far && c >= 3      ? 1.
             : turns_far && of_places ? model.discretization.vertices()[v][c] + pose.dofs[dof]
                                      : pose.dofs[dof]);
  return model.cells.moved(pose, nudge);
}

bool is_balanced(const Model &model, const double stiffness, const double size,
                 const double largest, const Pose &pose, const std::function<double()> &measure,
                 const double scale) {
  // A solution that runs away has rounding errors of any size: they excuse nothing then.
  constexpr double most_rounding = 2e-7;
  const double by_metre = 8. * std::numeric_limits<double>::epsilon() * stiffness,
               rounding = by_metre * largest_displacement(model.discretization, pose.dofs);
  if (size <= std::max(model.scene.solver.tolerance * largest,
                       std::min(rounding, contact::most_excused * std::max(largest, scale))))
    return true;
  // Lengths of chords are differences of places, whose rounding is there without any force.
  return size <= std::max(most_rounding * std::max(largest, scale),
                          by_metre * largest_coordinate(model.discretization)) &&
         size <= measure();
}

double largest_contact_force(const Contacts &contacts, const ContactResponse &response) {
  double largest = 0.;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    largest = std::max(largest, contacts[i].largest_force(response.stress[i]));
  return largest;
}

void set_rotations(const Model &model, const Vector &dofs, Vector &unknowns) {
  for (unsigned int v = 0; v < model.discretization.n_line_vertices(); ++v)
    for (unsigned int c = 3; c < 6; ++c)
      if (const auto dof = model.discretization.vertex_dofs().index(v, c);
          dof != numbers::invalid_dof_index)
        for (const auto &term : model.space.terms(dof))
          if (term.weight == 1.)
            unknowns[term.unknown] = dofs[dof];
}

void set_pose(const Model &model, const Pose &pose, LineState &state) {
  state.dofs = pose.dofs;
  state.turns = pose.turns;
  set_rotations(model, pose.dofs, state.unknowns);
}

} // namespace frictionbeam
