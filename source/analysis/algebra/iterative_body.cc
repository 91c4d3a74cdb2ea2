// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/multigrid_cycle.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

// Accepted though less than what was asked for, relative to the right-hand side: Newton's method
// makes up for what rounding leaves of a direction.
constexpr double least_accuracy = 1e-7;
/// Iterations for a digit: more where there are too many unknowns to factor.
constexpr double most_per_digit = 25., most_per_digit_of_large = 150.;
constexpr unsigned int most_failures = 2;
/// Iterations, of those of the first system after a set-up, that call for the next one.
constexpr double many_iterations = 1.5;
constexpr types::global_dof_index most_by_fallback = 250000; ///< unknowns that are factored

class IterativeSystem final : public ContinuumSystem {
public:
  explicit IterativeSystem(const ContinuumBody<3> &body);

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override {
    stiffness.vmult(y, x);
  }
  double diagonal(const types::global_dof_index dof) const override {
    const double own = stiffness.diagonal()(dof);
    return own > 0. ? own : mean_diagonal;
  }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;
  void begin_increment() override { cycle.set_up_next(); }
  std::string description() const override;

private:
  using Contact = StiffnessWithContacts::Contact;

  bool iterate(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &right,
               ContinuumVector &x);
  bool solve_directly(const std::vector<Block> &blocks, const bool symmetric,
                      const ContinuumVector &b, ContinuumVector &x);
  Contact contact(const Block &block, const std::vector<double> &values) const;

  const ContinuumBody<3> &body;
  const ElasticOperator stiffness;
  MultigridCycle cycle;
  double mean_diagonal = 1.;
  std::unique_ptr<ContinuumSystem> direct; ///< where iterations fail
  double after_set_up = 0.; ///< iterations for a digit of the first system with the present cycle
};

IterativeSystem::IterativeSystem(const ContinuumBody<3> &body)
    : body(body), stiffness(body), cycle(body, stiffness) {
  const double sum = stiffness.diagonal().mean_value();
  mean_diagonal = sum > 0. ? sum : 1.;
}

StiffnessWithContacts::Contact IterativeSystem::contact(const Block &block,
                                                        const std::vector<double> &values) const {
  Contact result;
  for (unsigned int a = 0; a < 3; ++a) {
    result.is_free[a] = !body.constraints.is_constrained(block.dofs[a]);
    result.dofs[a] = stiffness.diagonal().get_partitioner()->global_to_local(block.dofs[a]);
  }
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      result.tangent(a, c) = result.is_free[a] && result.is_free[c] ? values[3 * a + c] : 0.;
  return result;
}

bool IterativeSystem::iterate(const std::vector<Block> &blocks, const bool symmetric,
                              const ContinuumVector &right, ContinuumVector &x) {
  std::vector<Contact> contacts, definite;
  for (const Block &block : blocks) {
    contacts.push_back(contact(block, block.values));
    definite.push_back(contact(block, block.definite));
  }
  const StiffnessWithContacts matrix(stiffness, contacts);
  const bool is_new = cycle.set_contacts(definite);
  const double size = right.l2_norm();
  const double digits = -std::log10(std::min(0.1, tolerance));
  const unsigned int most =
      digits *
      (body.dof_handler.n_dofs() > most_by_fallback ? most_per_digit_of_large : most_per_digit);
  SolverControl control(most, tolerance * size);
  try {
    if (symmetric)
      SolverCG<ContinuumVector>(control).solve(matrix, x, right, cycle);
    else
      SolverGMRES<ContinuumVector>(control, SolverGMRES<ContinuumVector>::AdditionalData(60, true))
          .solve(matrix, x, right, cycle);
  } catch (const SolverControl::NoConvergence &failure) {
    n_iterations += failure.last_step;
    return failure.last_residual <= std::max(tolerance, least_accuracy) * size;
  }
  n_iterations += control.last_step();
  const double per_digit = control.last_step() / digits;
  if (is_new)
    after_set_up = per_digit;
  else if (per_digit > many_iterations * after_set_up)
    cycle.set_up_next();
  return true;
}

bool IterativeSystem::solve_directly(const std::vector<Block> &blocks, const bool symmetric,
                                     const ContinuumVector &b, ContinuumVector &x) {
  if (body.dof_handler.n_dofs() > most_by_fallback)
    return false;
  if (!direct)
    direct = body.is_parallel ? make_distributed_system(body, true) : make_condensed_system(body);
  const unsigned int before = direct->n_factorizations;
  const bool solved = direct->solve(blocks, symmetric, b, x);
  n_factorizations += direct->n_factorizations - before;
  return solved;
}

bool IterativeSystem::solve(const std::vector<Block> &blocks, const bool symmetric,
                            const ContinuumVector &b, ContinuumVector &x) {
  ++n_systems;
  if (n_failures >= most_failures)
    return solve_directly(blocks, symmetric, b, x);
  ContinuumVector right(b);
  right.zero_out_ghost_values();
  body.constraints.set_zero(right);
  x = 0.;
  if (right.l2_norm() == 0. || iterate(blocks, symmetric, right, x))
    return true;
  ++n_failures;
  return solve_directly(blocks, symmetric, b, x);
}

std::string IterativeSystem::description() const {
  return "multigrid without a matrix, " + std::to_string(n_iterations) + " iterations for " +
         std::to_string(n_systems) + " systems" +
         (n_failures > 0 ? ", " + std::to_string(n_failures) +
                               " of which did not converge and went to a factorization"
                         : std::string());
}

} // namespace

std::unique_ptr<ContinuumSystem> make_iterative_system(const ContinuumBody<3> &body) {
  return std::make_unique<IterativeSystem>(body);
}

} // namespace frictionbeam
