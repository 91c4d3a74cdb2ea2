// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_system.h"
#include "model/body/body_cell_matrices.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_Vector.h>

namespace frictionbeam {

using namespace dealii;

namespace {

// Residuals relative to the right-hand side: aimed at, and accepted where there is no more to gain.
constexpr double linear_tolerance = 1e-11, enough = 1e-4;
constexpr unsigned int most_linear_iterations = 400;

/// Products of a matrix with our vectors. The template of deal.II that does it has one name in a
/// library made by GCC and another in a program made by Clang.
class Product {
public:
  explicit Product(const TrilinosWrappers::SparseMatrix &matrix)
      : matrix(matrix.trilinos_matrix()) {}

  void vmult(ContinuumVector &y, const ContinuumVector &x) const {
    const Epetra_Vector from(View, matrix.DomainMap(), const_cast<double *>(x.begin()));
    Epetra_Vector to(View, matrix.RangeMap(), y.begin());
    const int error = matrix.Multiply(false, from, to);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }

private:
  const Epetra_CrsMatrix &matrix;
};

class DistributedSystem final : public ContinuumSystem {
public:
  template <int dim>
  DistributedSystem(const ContinuumBody<dim> &body, const bool direct)
      : direct(direct), constraints(body.constraints), degree(body.fe.degree) {
    TrilinosWrappers::SparsityPattern pattern(body.owned, body.owned, body.relevant,
                                              body.communicator);
    DoFTools::make_sparsity_pattern(body.dof_handler, pattern, body.constraints, false);
    pattern.compress();
    matrix.reinit(pattern);
    assemble_stiffness<dim>(
        body, body.dof_handler,
        [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
          body.constraints.distribute_local_to_global(local, dofs, matrix);
        });
    matrix.compress(VectorOperation::add);
    with_blocks.copy_from(matrix);
    DoFTools::extract_constant_modes(body.dof_handler, ComponentMask(), constant_modes);
  }

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override {
    Product(matrix).vmult(y, x);
  }
  double diagonal(const types::global_dof_index dof) const override {
    return matrix.diag_element(dof);
  }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;
  std::string name() const override {
    return direct ? "Trilinos, factorization (KLU)" : "Trilinos, algebraic multigrid (ML)";
  }

private:
  /// The stiffness with blocks, or with the positive part of their diagonals.
  void add_blocks(const std::vector<Block> &blocks, const bool diagonal_only,
                  TrilinosWrappers::SparseMatrix &result) const;
  bool solve_by_multigrid(const std::vector<Block> &blocks, const bool symmetric,
                          const ContinuumVector &right, ContinuumVector &x);

  const bool direct;
  const AffineConstraints<double> &constraints;
  const unsigned int degree;
  TrilinosWrappers::SparseMatrix matrix, with_blocks;
  std::vector<std::vector<bool>> constant_modes;
};

void DistributedSystem::add_blocks(const std::vector<Block> &blocks, const bool diagonal_only,
                                   TrilinosWrappers::SparseMatrix &result) const {
  result.copy_from(matrix);
  for (const Block &block : blocks) {
    const unsigned int n = block.dofs.size();
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < n; ++c)
        if (!constraints.is_constrained(block.dofs[a]) &&
            !constraints.is_constrained(block.dofs[c]) && (a == c || !diagonal_only))
          result.add(block.dofs[a], block.dofs[c],
                     diagonal_only ? std::max(0., block.values[a * n + c])
                                   : block.values[a * n + c]);
  }
  result.compress(VectorOperation::add);
}

bool DistributedSystem::solve_by_multigrid(const std::vector<Block> &blocks, const bool symmetric,
                                           const ContinuumVector &right, ContinuumVector &x) {
  // A preconditioner for the symmetric part: friction makes blocks unsymmetric, of contacts only.
  const TrilinosWrappers::SparseMatrix *definite = &with_blocks;
  TrilinosWrappers::SparseMatrix part;
  if (!symmetric) {
    part.copy_from(matrix);
    add_blocks(blocks, true, part);
    definite = &part;
  }
  TrilinosWrappers::PreconditionAMG multigrid;
  TrilinosWrappers::PreconditionAMG::AdditionalData data;
  data.elliptic = true;
  data.higher_order_elements = degree > 1;
  data.smoother_sweeps = 2;
  data.aggregation_threshold = 0.02;
  data.constant_modes = constant_modes;
  multigrid.initialize(*definite, data);
  const double size = right.l2_norm();
  SolverControl control(most_linear_iterations, linear_tolerance * size);
  try {
    if (symmetric)
      SolverCG<ContinuumVector>(control).solve(Product(with_blocks), x, right, multigrid);
    else
      SolverGMRES<ContinuumVector>(control, SolverGMRES<ContinuumVector>::AdditionalData(100, true))
          .solve(Product(with_blocks), x, right, multigrid);
  } catch (const SolverControl::NoConvergence &failure) {
    // Newton's method makes up for what rounding leaves of a direction.
    if (!(failure.last_residual <= enough * size))
      return false;
  }
  return true;
}

bool DistributedSystem::solve(const std::vector<Block> &blocks, const bool symmetric,
                              const ContinuumVector &b, ContinuumVector &x) {
  add_blocks(blocks, false, with_blocks);
  ContinuumVector right(b);
  constraints.set_zero(right);
  x = 0.;
  if (right.l2_norm() == 0.)
    return true;
  if (!direct) {
    if (!solve_by_multigrid(blocks, symmetric, right, x))
      return false;
  } else {
    SolverControl control;
    TrilinosWrappers::SolverDirect solver(control);
    solver.solve(with_blocks, x, right);
    ++n_factorizations;
  }
  constraints.set_zero(x);
  return true;
}

} // namespace

template <int dim>
std::unique_ptr<ContinuumSystem> make_distributed_system(const ContinuumBody<dim> &body,
                                                         const bool direct) {
  return std::make_unique<DistributedSystem>(body, direct);
}

template std::unique_ptr<ContinuumSystem> make_distributed_system<2>(const ContinuumBody<2> &,
                                                                     const bool);
template std::unique_ptr<ContinuumSystem> make_distributed_system<3>(const ContinuumBody<3> &,
                                                                     const bool);

} // namespace frictionbeam
