// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/continuum_system.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

namespace frictionbeam {

using namespace dealii;

namespace {

class CondensedSystem final : public ContinuumSystem {
public:
  template <int dim>
  explicit CondensedSystem(const ContinuumBody<dim> &body) {
    DynamicSparsityPattern dynamic(body.dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(body.dof_handler, dynamic, body.constraints, false);
    pattern.copy_from(dynamic);
    matrix.reinit(pattern);
    body.assemble_stiffness(
        [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
          body.constraints.distribute_local_to_global(local, dofs, matrix);
        });
    std::vector<types::global_dof_index> contact_dofs;
    for (const auto &node : body.nodes) {
      // Along the normal a prescribed pressure is a load, which has no tangent.
      const bool is_pressed = body.continuum.contacts[node.surface].pressure.has_value();
      for (unsigned int d = 0; d < dim; ++d)
        if (!body.constraints.is_constrained(node.dofs[d]) &&
            !(is_pressed && std::abs(node.frame[0][d]) > 1. - 1e-12))
          contact_dofs.push_back(node.dofs[d]);
    }
    number([&](const types::global_dof_index dof) { return body.constraints.is_constrained(dof); },
           contact_dofs);
    factorize();
  }

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override { matrix.vmult(y, x); }
  double diagonal(const types::global_dof_index dof) const override {
    return matrix.diag_element(dof);
  }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;

private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Factors = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  using Dense = Eigen::MatrixXd;

  /// Unknowns: interior dofs in an order that keeps the factor sparse, then those of contacts.
  template <typename IsHeld>
  void number(const IsHeld &is_held, const std::vector<types::global_dof_index> &contact_dofs);
  void factorize();

  SparsityPattern pattern;
  SparseMatrix<double> matrix;
  std::vector<types::global_dof_index> dof_of;
  std::vector<int> unknown_of; ///< by dof; -1: none
  int n_interior = 0, n_contact = 0;
  Factors factors;
  Dense condensed;  ///< stiffness of the contacts' unknowns
  Dense last_block; ///< of the factor L
};

template <typename IsHeld>
void CondensedSystem::number(const IsHeld &is_held,
                             const std::vector<types::global_dof_index> &contact_dofs) {
  unknown_of.assign(matrix.m(), -1);
  for (const auto dof : contact_dofs)
    unknown_of[dof] = 0;
  std::vector<types::global_dof_index> interior;
  std::vector<int> place(matrix.m(), -1);
  for (types::global_dof_index dof = 0; dof < matrix.m(); ++dof)
    if (unknown_of[dof] < 0 && !is_held(dof)) {
      place[dof] = interior.size();
      interior.push_back(dof);
    }
  std::vector<Eigen::Triplet<double>> entries;
  for (unsigned int i = 0; i < interior.size(); ++i)
    for (auto entry = matrix.begin(interior[i]); entry != matrix.end(interior[i]); ++entry)
      if (place[entry->column()] >= 0)
        entries.emplace_back(i, place[entry->column()], 1.);
  Sparse graph(interior.size(), interior.size());
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int> ordering;
  Eigen::AMDOrdering<int>::PermutationType order;
  ordering(graph, order);
  n_interior = interior.size();
  n_contact = contact_dofs.size();
  for (int i = 0; i < n_interior; ++i)
    dof_of.push_back(interior[order.indices()[i]]);
  dof_of.insert(dof_of.end(), contact_dofs.begin(), contact_dofs.end());
  for (unsigned int i = 0; i < dof_of.size(); ++i)
    unknown_of[dof_of[i]] = i;
}

void CondensedSystem::factorize() {
  const int n = dof_of.size();
  double largest = 0.;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    for (auto entry = matrix.begin(dof_of[i]); entry != matrix.end(dof_of[i]); ++entry) {
      const int j = unknown_of[entry->column()];
      if (j >= 0 && j <= i)
        entries.emplace_back(i, j, entry->value());
      if (j == i)
        largest = std::max(largest, double(entry->value()));
    }
  for (int i = n_interior; i < n; ++i)
    entries.emplace_back(i, i, largest);
  Sparse lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  factors.compute(lower);
  ++n_factorizations;
  AssertThrow(factors.info() == Eigen::Success, ExcMessage("The body is not held well enough."));
  last_block = Dense::Identity(n_contact, n_contact);
  const Sparse &L = factors.matrixL().nestedExpression();
  for (int j = n_interior; j < n; ++j)
    for (Sparse::InnerIterator entry(L, j); entry; ++entry)
      if (entry.row() > j)
        last_block(entry.row() - n_interior, j - n_interior) = entry.value();
  condensed = last_block * factors.vectorD().tail(n_contact).asDiagonal() * last_block.transpose();
  condensed.diagonal().array() -= largest;
}

bool CondensedSystem::solve(const std::vector<Block> &blocks, const bool symmetric,
                            const ContinuumVector &b, ContinuumVector &x) {
  const int n = dof_of.size();
  Eigen::VectorXd y(n);
  for (int i = 0; i < n; ++i)
    y[i] = b(dof_of[i]);
  factors.matrixL().solveInPlace(y);
  const Eigen::VectorXd right = last_block.triangularView<Eigen::UnitLower>() * y.tail(n_contact);
  y.head(n_interior).array() /= factors.vectorD().head(n_interior).array();

  Dense tangent = condensed;
  for (const Block &block : blocks)
    for (unsigned int a = 0, v = 0; a < block.dofs.size(); ++a)
      for (unsigned int c = 0; c < block.dofs.size(); ++c, ++v) {
        const int i = unknown_of[block.dofs[a]] - n_interior,
                  j = unknown_of[block.dofs[c]] - n_interior;
        if (i >= 0 && j >= 0)
          tangent(i, j) += block.values[v];
      }
  Eigen::VectorXd contact;
  if (symmetric) {
    const Eigen::LDLT<Dense> dense(tangent);
    contact = dense.solve(right);
  } else
    contact = Eigen::PartialPivLU<Dense>(tangent).solve(right);
  if (!contact.allFinite())
    return false;
  y.tail(n_contact) = last_block.transpose().triangularView<Eigen::UnitUpper>() * contact;
  factors.matrixU().solveInPlace(y);
  x = 0.;
  for (int i = 0; i < n; ++i)
    x(dof_of[i]) = y[i];
  return true;
}

} // namespace

template <int dim>
std::unique_ptr<ContinuumSystem> make_condensed_system(const ContinuumBody<dim> &body) {
  return std::make_unique<CondensedSystem>(body);
}

template std::unique_ptr<ContinuumSystem> make_condensed_system<2>(const ContinuumBody<2> &);
template std::unique_ptr<ContinuumSystem> make_condensed_system<3>(const ContinuumBody<3> &);

} // namespace frictionbeam
