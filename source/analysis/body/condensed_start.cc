// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/body/condensed_start.h"

#include <frictionbeam/contact/local_solver.h>

namespace frictionbeam {

namespace {

constexpr unsigned int most_rows = 400; ///< of the flexibility, each a linear system
constexpr double weak = 1e-6;           ///< springs, of the diagonal stiffness
constexpr double near_enough = 1e-10;   ///< natural map
constexpr double most_seconds = 10.;

/// Directions of the contact problem in the contacts' axes: away from the ground, then along it.
double sign_of(const unsigned int component) { return component == 0 ? -1. : 1.; }

template <int dim>
bool suits(const ContinuumBody<dim> &body, const FoundationContacts &contacts) {
  if (body.is_parallel || contacts.size() == 0 || dim * contacts.size() > most_rows)
    return false;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!contacts.is_exact(i) || contacts.has_pressure(i))
      return false;
  return true;
}

/// The body on weak springs at its contacts.
template <int dim>
class OnWeakSprings {
public:
  OnWeakSprings(const ContinuumBody<dim> &body, ContinuumSystem &system,
                const FoundationContacts &contacts)
      : body(body), system(system), blocks(contacts.size()) {
    for (unsigned int i = 0; i < blocks.size(); ++i) {
      const auto &node = body.nodes[i];
      blocks[i].dofs.assign(node.dofs.begin(), node.dofs.end());
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          blocks[i].values.push_back(a == b ? weak * node.weight * contacts[i].normal_diagonal
                                            : 0.);
    }
  }

  bool solve(const ContinuumVector &forces, ContinuumVector &u) {
    body.reinit(u);
    return system.solve(blocks, true, forces, u);
  }
  /// Add forces in the directions of the contact problem.
  void add(const Eigen::VectorXd &reactions, ContinuumVector &forces) const {
    for (unsigned int i = 0; i < blocks.size(); ++i)
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int d = 0; d < dim; ++d)
          if (const auto dof = body.nodes[i].dofs[d]; !body.constraints.is_constrained(dof))
            forces(dof) += sign_of(a) * body.nodes[i].frame[a][d] * reactions[dim * i + a];
  }
  /// Displacements of the contacts in these directions.
  Eigen::VectorXd motions(const ContinuumVector &u) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(dim * blocks.size());
    for (unsigned int i = 0; i < blocks.size(); ++i)
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int d = 0; d < dim; ++d)
          result[dim * i + a] += sign_of(a) * body.nodes[i].frame[a][d] * u(body.nodes[i].dofs[d]);
    return result;
  }

private:
  const ContinuumBody<dim> &body;
  ContinuumSystem &system;
  std::vector<ContinuumSystem::Block> blocks;
};

} // namespace

template <int dim>
bool find_condensed_start(const ContinuumBody<dim> &body, ContinuumSystem &system,
                          const FoundationContacts &contacts, const FoundationState &committed,
                          const ContinuumVector &forces, std::vector<LocalVector> &tractions,
                          ContinuumVector &u) {
  if (!suits(body, contacts))
    return false;
  OnWeakSprings<dim> springs(body, system, contacts);
  const unsigned int n = dim * contacts.size();
  ContinuumVector motion, pull;
  if (!springs.solve(forces, motion))
    return false;
  contact::LocalProblem problem;
  problem.dimension = dim;
  problem.q = springs.motions(motion);
  Eigen::MatrixXd W(n, n);
  for (unsigned int column = 0; column < n; ++column) {
    body.reinit(pull);
    springs.add(Eigen::VectorXd::Unit(n, column), pull);
    if (!springs.solve(pull, motion))
      return false;
    W.col(column) = springs.motions(motion);
  }
  const std::vector<double> &friction = contacts.friction_coefficients();
  problem.friction = Eigen::Map<const Eigen::VectorXd>(friction.data(), friction.size());
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const FoundationContacts::Rest rest = contacts.rest(i, committed);
    for (unsigned int a = 0; a < dim; ++a) {
      problem.q[dim * i + a] += rest.at_zero[a];
      W(dim * i + a, dim * i + a) += rest.compliance[a] / contacts[i].weight;
    }
  }
  problem.W = ((W + W.transpose()) / 2.).sparseView();
  const contact::LocalSolution solution =
      contact::solve_local_contact(problem, near_enough, most_seconds);
  if (!solution.converged)
    return false;
  pull = forces;
  springs.add(solution.reactions, pull);
  if (!springs.solve(pull, motion))
    return false;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    tractions[i].setZero();
    for (unsigned int a = 0; a < dim; ++a)
      tractions[i][a] = sign_of(a) * solution.reactions[dim * i + a] / contacts[i].weight;
  }
  u = motion;
  return true;
}

template bool find_condensed_start(const ContinuumBody<2> &, ContinuumSystem &,
                                   const FoundationContacts &, const FoundationState &,
                                   const ContinuumVector &, std::vector<LocalVector> &,
                                   ContinuumVector &);
template bool find_condensed_start(const ContinuumBody<3> &, ContinuumSystem &,
                                   const FoundationContacts &, const FoundationState &,
                                   const ContinuumVector &, std::vector<LocalVector> &,
                                   ContinuumVector &);

} // namespace frictionbeam
