// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/block_cholesky.h"
#include "analysis/algebra/elastic_system.h"
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/body/body_cell_matrices.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace frictionbeam {

using namespace dealii;

namespace {

class CondensedSystem final : public ContinuumSystem {
public:
  template <int dim>
  CondensedSystem(const ContinuumBody<dim> &body, const AssembleMatrices &stiffening);

  bool stiffen(const double p) override;
  void multiply_stiffening(const ContinuumVector &x, ContinuumVector &y) const override;

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override;
  double diagonal(const types::global_dof_index dof) const override {
    const int i = unknown_of[dof];
    return i < 0 ? mean_diagonal : stiffness.coeff(i, i);
  }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;
  bool solve_all(std::vector<ContinuumVector> &b) override;
  std::string name() const override { return "factorization, contacts condensed"; }

private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Dense = Eigen::MatrixXd;

  /// Unknowns: interior dofs, then those of contacts, in the order of the dofs.
  void number(const std::vector<bool> &is_free,
              const std::vector<types::global_dof_index> &contact_dofs);
  /// The lower triangle of a sum of matrices.
  Sparse assemble(const AssembleMatrices &matrices,
                  const AffineConstraints<double> &constraints) const;
  /// Put the interior unknowns in an order that keeps the factor sparse.
  void reorder();
  /// @return whether the stiffness is positive definite but for what contacts hold
  bool factorize();
  void factorize_or_throw();
  /// Whether the stiffness without contacts has no negative eigenvalue.
  bool is_stable_without_contacts() const;
  /// Stiffness of the contacts' unknowns with those of the contacts themselves.
  Dense tangent(const std::vector<Block> &blocks) const;
  /// Each column from right-hand side to solution.
  bool solve_columns(const std::vector<Block> &blocks, const bool symmetric, Dense &y) const;
  void take(const ContinuumVector &values, Eigen::Ref<Eigen::VectorXd> y) const {
    for (std::size_t i = 0; i < dof_of.size(); ++i)
      y[i] = values(dof_of[i]);
  }
  void give(const Eigen::Ref<const Eigen::VectorXd> &y, ContinuumVector &values) const {
    values = 0.;
    for (std::size_t i = 0; i < dof_of.size(); ++i)
      values(dof_of[i]) = y[i];
  }

  std::vector<types::global_dof_index> dof_of;
  std::vector<int> unknown_of; ///< by dof; -1: none
  int n_interior = 0, n_contact = 0;
  Sparse stiffness;  ///< lower triangle, of K
  Sparse stiffening; ///< of S; empty: none
  double pressure = 0.;
  bool has_factors = false;
  double mean_diagonal = 0.;
  BlockCholesky factors;
  Dense condensed; ///< stiffness of the contacts' unknowns
};

template <int dim>
CondensedSystem::CondensedSystem(const ContinuumBody<dim> &body,
                                 const AssembleMatrices &of_stiffening) {
  std::vector<bool> is_free(body.dof_handler.n_dofs());
  for (types::global_dof_index dof = 0; dof < is_free.size(); ++dof)
    is_free[dof] = !body.constraints.is_constrained(dof);
  std::vector<types::global_dof_index> contact_dofs;
  for (const auto &node : body.nodes) {
    // Along the normal a prescribed pressure is a load, which has no tangent.
    const bool is_pressed = body.continuum.contacts[node.surface].pressure.has_value();
    for (unsigned int d = 0; d < dim; ++d)
      if (is_free[node.dofs[d]] && !(is_pressed && std::abs(node.frame[0][d]) > 1. - no_component))
        contact_dofs.push_back(node.dofs[d]);
  }
  number(is_free, contact_dofs);
  stiffness =
      assemble([&](const AddMatrix &add) { assemble_stiffness<dim>(body, body.dof_handler, add); },
               body.constraints);
  if (of_stiffening)
    stiffening = assemble(of_stiffening, body.constraints);
  reorder();
  mean_diagonal = dof_of.empty() ? 1. : Eigen::VectorXd(stiffness.diagonal()).mean();
  if (!of_stiffening)
    factorize_or_throw();
}

void CondensedSystem::number(const std::vector<bool> &is_free,
                             const std::vector<types::global_dof_index> &contact_dofs) {
  unknown_of.assign(is_free.size(), -1);
  for (const auto dof : contact_dofs)
    unknown_of[dof] = 0;
  for (types::global_dof_index dof = 0; dof < is_free.size(); ++dof)
    if (unknown_of[dof] < 0 && is_free[dof])
      dof_of.push_back(dof);
  n_interior = dof_of.size();
  n_contact = contact_dofs.size();
  dof_of.insert(dof_of.end(), contact_dofs.begin(), contact_dofs.end());
  for (unsigned int i = 0; i < dof_of.size(); ++i)
    unknown_of[dof_of[i]] = i;
}

CondensedSystem::Sparse
CondensedSystem::assemble(const AssembleMatrices &matrices,
                          const AffineConstraints<double> &constraints) const {
  constexpr std::size_t most_entries = 4000000; // that wait to be added up
  const int n = dof_of.size();
  Sparse sum(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_up = [&]() {
    Sparse part(n, n);
    part.setFromTriplets(entries.begin(), entries.end());
    sum = sum.nonZeros() == 0 ? part : Sparse(sum + part);
    entries.clear();
  };
  matrices([&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
    add_to_free_dofs(local, dofs, constraints,
                     [&](const auto row, const auto column, const double value) {
                       if (unknown_of[row] >= unknown_of[column])
                         entries.emplace_back(unknown_of[row], unknown_of[column], value);
                     });
    if (entries.size() > most_entries)
      add_up();
  });
  add_up();
  return sum;
}

void CondensedSystem::reorder() {
  const bool is_stiffened = stiffening.size() > 0;
  const Eigen::VectorXi order =
      sparse_order(is_stiffened ? Sparse(stiffness + 0. * stiffening) : stiffness, n_contact);
  const std::vector<types::global_dof_index> old = dof_of;
  for (int i = 0; i < order.size(); ++i) {
    dof_of[i] = old[order[i]];
    unknown_of[dof_of[i]] = i;
  }
  stiffness = in_order(stiffness, order);
  if (is_stiffened)
    stiffening = in_order(stiffening, order);
}

void CondensedSystem::multiply(const ContinuumVector &x, ContinuumVector &y) const {
  Eigen::VectorXd values(dof_of.size());
  take(x, values);
  Eigen::VectorXd product = stiffness.selfadjointView<Eigen::Lower>() * values;
  if (pressure != 0.) {
    const Eigen::VectorXd added = stiffening.selfadjointView<Eigen::Lower>() * values;
    product += pressure * added;
  }
  give(product, y);
}

void CondensedSystem::multiply_stiffening(const ContinuumVector &x, ContinuumVector &y) const {
  Eigen::VectorXd values(dof_of.size());
  take(x, values);
  give(stiffening.selfadjointView<Eigen::Lower>() * values, y);
}

bool CondensedSystem::stiffen(const double p) {
  Assert(stiffening.size() > 0 || p == 0., ExcInternalError());
  if (has_factors && p == pressure)
    return true;
  pressure = p;
  if (p == 0.)
    factorize_or_throw();
  else if (!factorize() || !is_stable_without_contacts()) {
    pressure = 0.;
    factorize_or_throw(); // as it is a body that nothing holds which has no inverse, too
    return false;
  }
  return true;
}

bool CondensedSystem::is_stable_without_contacts() const {
  constexpr double rounding = 1e-10; // of the largest stiffness, of rigid motions of a free body
  if (n_contact == 0)
    return true;
  Dense shifted = condensed;
  shifted.diagonal().array() += rounding * stiffness.diagonal().maxCoeff();
  return Eigen::LLT<Dense>(shifted).info() == Eigen::Success;
}

bool CondensedSystem::factorize() {
  const int n = dof_of.size();
  Sparse stiffened;
  if (pressure != 0.)
    stiffened = stiffness + pressure * stiffening;
  Sparse &matrix = pressure != 0. ? stiffened : stiffness;
  const Eigen::VectorXd diagonals = matrix.diagonal();
  const double largest = n > 0 ? diagonals.maxCoeff() : 0.;
  for (int i = n_interior; i < n; ++i)
    matrix.coeffRef(i, i) += largest;
  has_factors = factors.compute(matrix, n_contact);
  for (int i = n_interior; i < n; ++i)
    matrix.coeffRef(i, i) = diagonals[i];
  ++n_factorizations;
  if (!has_factors)
    return false;
  const auto last_block = factors.last_block().triangularView<Eigen::Lower>();
  condensed = last_block * factors.last_block().transpose();
  // A body that only its contacts hold would rise or fall by the sign of what rounding has left,
  // while they are open.
  constexpr double above_rounding = 1e-13;
  condensed.diagonal().array() -= (1. - above_rounding) * largest;
  return true;
}

void CondensedSystem::factorize_or_throw() {
  if (!factorize())
    throw UserError(
        "The body's stiffness has no inverse.\n  read:    a body that what is Held and "
        "Frictional does not hold well enough\n  allowed: a body that cannot move as a "
        "whole, with a Poisson's ratio not too near to 0.5\n  try:     another group in "
        "Held");
}

CondensedSystem::Dense CondensedSystem::tangent(const std::vector<Block> &blocks) const {
  Dense result = condensed;
  for (const Block &block : blocks)
    for (unsigned int a = 0, v = 0; a < block.dofs.size(); ++a)
      for (unsigned int c = 0; c < block.dofs.size(); ++c, ++v) {
        const int i = unknown_of[block.dofs[a]] - n_interior,
                  j = unknown_of[block.dofs[c]] - n_interior;
        if (i >= 0 && j >= 0)
          result(i, j) += block.values[v];
      }
  return result;
}

bool CondensedSystem::solve_columns(const std::vector<Block> &blocks, const bool symmetric,
                                    Dense &y) const {
  factors.solve_lower(y);
  if (n_contact > 0) { // products of matrices without rows end in a division by zero
    const Dense &L = factors.last_block();
    const Dense right = L.triangularView<Eigen::Lower>() * y.bottomRows(n_contact),
                contact = symmetric
                              ? Dense(Eigen::LDLT<Dense>(tangent(blocks)).solve(right))
                              : Dense(Eigen::PartialPivLU<Dense>(tangent(blocks)).solve(right));
    if (!contact.allFinite())
      return false;
    y.bottomRows(n_contact) = L.transpose().triangularView<Eigen::Upper>() * contact;
  }
  factors.solve_upper(y);
  return true;
}

bool CondensedSystem::solve(const std::vector<Block> &blocks, const bool symmetric,
                            const ContinuumVector &b, ContinuumVector &x) {
  Dense y(dof_of.size(), 1);
  take(b, y.col(0));
  if (!solve_columns(blocks, symmetric, y))
    return false;
  give(y.col(0), x);
  return true;
}

bool CondensedSystem::solve_all(std::vector<ContinuumVector> &b) {
  if (b.empty())
    return true;
  Dense y(dof_of.size(), b.size());
  for (std::size_t k = 0; k < b.size(); ++k)
    take(b[k], y.col(k));
  if (!solve_columns({}, true, y))
    return false;
  for (std::size_t k = 0; k < b.size(); ++k)
    give(y.col(k), b[k]);
  return true;
}

} // namespace

template <int dim>
std::unique_ptr<ContinuumSystem> make_condensed_system(const ContinuumBody<dim> &body) {
  return std::make_unique<CondensedSystem>(body, AssembleMatrices());
}

std::unique_ptr<ContinuumSystem> make_stiffened_system(const ContinuumBody<3> &body,
                                                       const AssembleMatrices &assemble) {
  return std::make_unique<CondensedSystem>(body, assemble);
}

template std::unique_ptr<ContinuumSystem> make_condensed_system<2>(const ContinuumBody<2> &);
template std::unique_ptr<ContinuumSystem> make_condensed_system<3>(const ContinuumBody<3> &);

} // namespace frictionbeam
