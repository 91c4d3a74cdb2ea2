// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/multigrid_cycle.h"

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <Eigen/LU>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double margin = 1.1; ///< on the largest eigenvalue, which is approached from below
/// Of what a contact adds to the coarse stiffness, of the body's own there: more would only make
/// the couplings beside it look weak.
constexpr double most_of_contact = 10.;
/// Of the contacts, up to which the coarse multigrid is kept while they change, and a change of one
/// that counts, of the body's own stiffness there.
constexpr double few_changes = 0.03, small_change = 0.3;

/// Largest eigenvalue of D^-1 K, from what conjugate gradients learn of it. Contacts' tangents, on
/// both sides, do not make it larger.
double largest_eigenvalue(const ElasticOperator &stiffness, const ContinuumVector &inverse) {
  ContinuumVector right(inverse), x(inverse);
  for (unsigned int i = 0; i < right.locally_owned_size(); ++i)
    right.local_element(i) = inverse.local_element(i) == 0. ? 0. : (i * 7919U % 1009U) / 504. - 1.;
  x = 0.;
  DiagonalMatrix<ContinuumVector> jacobi;
  jacobi.reinit(inverse);
  IterationNumberControl control(14, 1e-10);
  SolverCG<ContinuumVector> solver(control);
  double largest = 1.;
  solver.connect_eigenvalues_slot([&](const std::vector<double> &eigenvalues) {
    for (const double value : eigenvalues)
      largest = std::max(largest, value);
  });
  solver.solve(stiffness, x, right, jacobi);
  return largest;
}

} // namespace

void ChebyshevSmoother::set_contacts(const std::vector<StiffnessWithContacts::Contact> &contacts) {
  blocks = contacts;
  for (StiffnessWithContacts::Contact &block : blocks) {
    for (unsigned int d = 0; d < 3; ++d)
      block.tangent(d, d) += block.is_free[d] ? 1. / inverse.local_element(block.dofs[d]) : 1.;
    block.tangent = Eigen::Matrix3d(block.tangent.inverse());
  }
}

void ChebyshevSmoother::scale(ContinuumVector &vector) const {
  std::vector<Eigen::Vector3d> at_contacts;
  at_contacts.reserve(blocks.size());
  for (const auto &block : blocks) {
    Eigen::Vector3d value;
    for (unsigned int d = 0; d < 3; ++d)
      value[d] = block.is_free[d] ? vector.local_element(block.dofs[d]) : 0.;
    at_contacts.push_back(block.tangent * value);
  }
  vector.scale(inverse);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      if (blocks[i].is_free[d])
        vector.local_element(blocks[i].dofs[d]) = at_contacts[i][d];
}

void ChebyshevSmoother::scale_contacts(ContinuumVector &vector, const bool transposed) const {
  for (const auto &block : blocks) {
    Eigen::Vector3d own, value;
    for (unsigned int d = 0; d < 3; ++d) {
      own[d] = block.is_free[d] ? 1. / inverse.local_element(block.dofs[d]) : 0.;
      value[d] = block.is_free[d] ? vector.local_element(block.dofs[d]) : 0.;
    }
    const Eigen::Vector3d scaled =
        transposed ? Eigen::Vector3d(own.asDiagonal() * (block.tangent * value))
                   : Eigen::Vector3d(block.tangent * (own.asDiagonal() * value));
    for (unsigned int d = 0; d < 3; ++d)
      if (block.is_free[d])
        vector.local_element(block.dofs[d]) = scaled[d];
  }
}

void ChebyshevSmoother::smooth(const StiffnessWithContacts &A, ContinuumVector &x,
                               const ContinuumVector &b, const bool from_zero) {
  const double smallest = largest / range, theta = 0.5 * (largest + smallest),
               delta = 0.5 * (largest - smallest);
  double rho = delta / theta;
  if (from_zero)
    step = b;
  else {
    A.vmult(left, x);
    step = b;
    step -= left;
  }
  scale(step);
  step *= 1. / theta;
  x += step;
  for (unsigned int k = 1; k < degree; ++k) {
    A.vmult(left, x);
    left.sadd(-1., 1., b);
    scale(left);
    const double next = 1. / (2. * theta / delta - rho);
    step.sadd(next * rho, 2. * next / delta, left);
    x += step;
    rho = next;
  }
}

MultigridCycle::MultigridCycle(const ContinuumBody<3> &body, const ElasticOperator &stiffness)
    : body(body), stiffness(stiffness), linear(body),
      multigrid(make_coarse_multigrid(linear, body)) {
  ContinuumVector inverse(stiffness.diagonal());
  inverse.zero_out_ghost_values();
  for (unsigned int i = 0; i < inverse.locally_owned_size(); ++i) {
    const double entry = inverse.local_element(i);
    inverse.local_element(i) = entry > 0. ? 1. / entry : 0.;
  }
  smoother =
      std::make_unique<ChebyshevSmoother>(inverse, margin * largest_eigenvalue(stiffness, inverse));
  body.reinit(left);
  body.reinit(correction);
  linear.reinit(coarse);
  linear.reinit(coarse_left);
}

std::vector<Eigen::Matrix3d>
MultigridCycle::coarse_tangents(const std::vector<Contact> &contacts) const {
  std::vector<Eigen::Matrix3d> result;
  for (const Contact &contact : contacts) {
    Eigen::Matrix3d most = Eigen::Matrix3d::Identity();
    for (unsigned int d = 0; d < 3; ++d)
      if (contact.is_free[d])
        most(d, d) = most_of_contact * stiffness.diagonal().local_element(contact.dofs[d]);
    // in series, so that it stays symmetric
    const Eigen::Matrix3d tangent = most * (contact.tangent + most).inverse() * contact.tangent;
    result.push_back(0.5 * (tangent + tangent.transpose()));
  }
  return result;
}

bool MultigridCycle::differ(const std::vector<Eigen::Matrix3d> &tangents,
                            const std::vector<Contact> &contacts) const {
  unsigned int n_changed = 0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    double own = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      if (contacts[i].is_free[d])
        own = std::max(own, stiffness.diagonal().local_element(contacts[i].dofs[d]));
    n_changed += (tangents[i] - last_tangents[i]).norm() > small_change * own;
  }
  const double n = Utilities::MPI::sum(double(tangents.size()), body.communicator);
  return Utilities::MPI::sum(double(n_changed), body.communicator) > few_changes * n;
}

bool MultigridCycle::set_contacts(const std::vector<Contact> &contacts) {
  definite = std::make_unique<StiffnessWithContacts>(stiffness, contacts);
  smoother->set_contacts(contacts);
  const std::vector<Eigen::Matrix3d> tangents = coarse_tangents(contacts);
  if (is_set_up && !differ(tangents, contacts))
    return false;
  std::vector<CoarseMultigrid::Entry> entries;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::array<std::vector<std::pair<types::global_dof_index, double>>, 3> rows;
    for (unsigned int d = 0; d < 3; ++d)
      if (contacts[i].is_free[d])
        rows[d] = linear.row(contacts[i].dofs[d]);
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b) {
        const double value = tangents[i](a, b);
        if (value == 0.)
          continue;
        for (const auto &[row, by_row] : rows[a])
          for (const auto &[column, by_column] : rows[b])
            entries.push_back({row, column, by_row * value * by_column});
      }
  }
  multigrid->set_up(entries);
  last_tangents = tangents;
  is_set_up = true;
  return true;
}

void MultigridCycle::vmult(ContinuumVector &x, const ContinuumVector &b) const {
  x = 0.;
  smoother->smooth(*definite, x, b, true);
  definite->vmult(left, x);
  left.sadd(-1., 1., b);
  smoother->scale_contacts(left, true);
  linear.restrict_to(coarse_left, left);
  multigrid->cycle(coarse, coarse_left);
  correction = 0.;
  linear.prolongate_add(correction, coarse);
  smoother->scale_contacts(correction, false);
  x += correction;
  smoother->smooth(*definite, x, b, false);
}

} // namespace frictionbeam
