// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/body/continuum_newton.h"

#include <frictionbeam/contact/local_solver.h>

namespace frictionbeam {

namespace {

constexpr unsigned int most_rows = 400; ///< of the flexibility, each a linear system
constexpr double weak_springs = 1e-6;   ///< of the diagonal stiffness
constexpr double near_enough = 1e-10;   ///< natural map
constexpr double most_seconds = 10.;

/// Forces and displacements of the contact problem are positive away from the ground, tractions and
/// displacements of the body towards it.
double sign_of(const unsigned int component) { return component == 0 ? -1. : 1.; }

/// What an order of the contact problem's unknowns is to the contacts: their dim components.
template <int dim>
Eigen::VectorXd in_line(const std::vector<LocalVector> &of_contacts) {
  Eigen::VectorXd result(dim * of_contacts.size());
  for (unsigned int i = 0; i < of_contacts.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      result[dim * i + a] = sign_of(a) * of_contacts[i][a];
  return result;
}

bool suits(const FoundationContacts &contacts) {
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (!contacts.is_exact(i) || contacts.has_pressure(i))
      return false;
  return contacts.size() > 0;
}

} // namespace

template <int dim>
bool ContinuumNewton<dim>::find_condensed_start(ContinuumVector &u) {
  const unsigned int n = dim * contacts.size();
  if (body.is_parallel || n > most_rows || !suits(contacts))
    return false;
  const std::vector<LocalMatrix> no_tangent(contacts.size(), LocalMatrix::Zero());
  ContinuumVector motion;
  const auto motions_by = [&](const ContinuumVector &forces) {
    return find_direction(no_tangent, weak_springs, forces, motion);
  };
  if (!motions_by(*loads))
    return false;
  contact::LocalProblem problem;
  problem.dimension = dim;
  problem.q = in_line<dim>(local(motion));
  Eigen::MatrixXd W(n, n);
  std::vector<LocalVector> tractions(contacts.size(), LocalVector::Zero());
  for (unsigned int column = 0; column < n; ++column) {
    const unsigned int i = column / dim, a = column % dim;
    ContinuumVector pull;
    body.reinit(pull);
    tractions[i][a] = sign_of(a) / contacts[i].weight;
    add_forces(tractions, pull);
    tractions[i].setZero();
    if (!motions_by(pull))
      return false;
    W.col(column) = in_line<dim>(local(motion));
  }
  const std::vector<double> &friction = contacts.friction_coefficients();
  problem.friction = Eigen::Map<const Eigen::VectorXd>(friction.data(), friction.size());
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const FoundationContacts::Rest rest = contacts.rest(i, *committed);
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
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      tractions[i][a] = sign_of(a) * solution.reactions[dim * i + a] / contacts[i].weight;
  ContinuumVector forces = *loads;
  add_forces(tractions, forces);
  if (!motions_by(forces))
    return false;
  contacts.centre = tractions;
  u = motion;
  return true;
}

template bool ContinuumNewton<2>::find_condensed_start(ContinuumVector &);
template bool ContinuumNewton<3>::find_condensed_start(ContinuumVector &);

} // namespace frictionbeam
