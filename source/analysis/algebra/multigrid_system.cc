// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_multigrid.h"
#include "analysis/algebra/elastic_system.h"
#include "base/algebra/dense_algebra.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

namespace frictionbeam {

using namespace dealii;

namespace {

// Residuals relative to the right-hand side: aimed at, and accepted where there is no more to gain.
constexpr double aim_of_multigrid = 1e-9, enough_of_multigrid = 1e-4;
constexpr unsigned int most_cycles = 200, most_kept_directions = 60;

/**
 * A symmetric matrix without negative eigenvalues near a contact's block. Where the block is not
 * symmetric, friction follows the normal force: column n is (k, f k), k the large stiffness along
 * the normal. Its symmetric part would hold what slips. Without the couplings of normal and
 * tangents the product with the inverse from the right is (1, f), which a Krylov method does not
 * mind.
 */
template <int dim>
Eigen::Matrix<double, dim, dim> definite_part(const Eigen::Matrix<double, dim, dim> &block,
                                              const std::array<Tensor<1, dim>, dim> &frame,
                                              const bool symmetric) {
  using Matrix = Eigen::Matrix<double, dim, dim>;
  Matrix axes; // rows: normal, tangents
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int d = 0; d < dim; ++d)
      axes(a, d) = frame[a][d];
  Matrix local = axes * block * axes.transpose();
  if (!symmetric)
    for (unsigned int a = 1; a < dim; ++a)
      local(0, a) = local(a, 0) = 0.;
  const SymmetricEigen parts = symmetric_eigen(0.5 * (local + local.transpose()));
  const Matrix directions = axes.transpose() * parts.vectors;
  return directions * parts.values.cwiseMax(0.).asDiagonal() * directions.transpose();
}

/// Krylov methods with a matrix-free stiffness and one V-cycle (ElasticMultigrid).
template <int dim>
class MultigridSystem final : public ContinuumSystem {
public:
  explicit MultigridSystem(const ContinuumBody<dim> &body)
      : body(body), constraints(body.constraints),
        stiffness(body, body.dof_handler, body.constraints), multigrid(body) {
    diagonals = stiffness.diagonal();
    give_held_dofs_the_mean();
    for (auto *const vector : {&own_x, &own_b})
      stiffness.reinit(*vector);
  }

  void multiply(const ContinuumVector &x, ContinuumVector &y) const override {
    own_x.copy_locally_owned_data_from(x);
    stiffness.multiply_without_blocks(own_b, own_x);
    y.copy_locally_owned_data_from(own_b);
  }
  double diagonal(const types::global_dof_index dof) const override { return diagonals(dof); }
  bool solve(const std::vector<Block> &blocks, const bool symmetric, const ContinuumVector &b,
             ContinuumVector &x) override;
  std::string name() const override {
    return "geometric multigrid of " + std::to_string(multigrid.n_levels()) +
           " levels, matrix-free, at most " + std::to_string(most_iterations) + " iterations";
  }

private:
  /// Contacts are measured by these diagonals, those of held dofs as well: 1 N/m would make light
  /// of what slips beside them.
  void give_held_dofs_the_mean();
  std::vector<NodeBlock<dim>> on_free_dofs(const std::vector<Block> &blocks) const;

  const ContinuumBody<dim> &body;
  const AffineConstraints<double> &constraints;
  ElasticOperator<dim, double> stiffness;
  ElasticMultigrid<dim> multigrid;
  ContinuumVector diagonals;
  mutable ContinuumVector own_x, own_b; ///< with the operator's own neighbours
};

template <int dim>
void MultigridSystem<dim>::give_held_dofs_the_mean() {
  std::vector<double> sums(2, 0.); // of the free ones, and their number
  for (const auto dof : diagonals.locally_owned_elements())
    if (!constraints.is_constrained(dof)) {
      sums[0] += diagonals(dof);
      sums[1] += 1.;
    }
  Utilities::MPI::sum(sums, body.communicator, sums);
  for (const auto dof : diagonals.locally_owned_elements())
    if (constraints.is_constrained(dof))
      diagonals(dof) = sums[1] > 0. ? sums[0] / sums[1] : 1.;
}

template <int dim>
std::vector<NodeBlock<dim>>
MultigridSystem<dim>::on_free_dofs(const std::vector<Block> &blocks) const {
  std::vector<NodeBlock<dim>> result(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a) {
      result[i].dofs[a] = blocks[i].dofs[a];
      for (unsigned int c = 0; c < dim; ++c)
        result[i].stiffness(a, c) = constraints.is_constrained(blocks[i].dofs[a]) ||
                                            constraints.is_constrained(blocks[i].dofs[c])
                                        ? 0.
                                        : blocks[i].values[a * dim + c];
    }
  return result;
}

template <int dim>
bool MultigridSystem<dim>::solve(const std::vector<Block> &blocks, const bool symmetric,
                                 const ContinuumVector &b, ContinuumVector &x) {
  const std::vector<NodeBlock<dim>> of_contacts = on_free_dofs(blocks);
  std::vector<NodeBlock<dim>> positive = of_contacts;
  for (std::size_t i = 0; i < positive.size(); ++i) // block by block those of the body's nodes
    positive[i].stiffness =
        definite_part<dim>(positive[i].stiffness, body.nodes[i].frame, symmetric);
  const bool factored = multigrid.take_blocks(positive);
  ++n_factorizations;
  stiffness.set_blocks(of_contacts);
  x = 0.;
  own_x = 0.;
  own_b.copy_locally_owned_data_from(b);
  stiffness.set_zero_constrained(own_b);
  const double size = own_b.l2_norm();
  if (size == 0.)
    return true;
  if (!factored)
    return false;
  SolverControl control(most_cycles, aim_of_multigrid * size);
  try {
    if (symmetric)
      SolverCG<ContinuumVector>(control).solve(stiffness, own_x, own_b, multigrid);
    else
      SolverFGMRES<ContinuumVector>(
          control, SolverFGMRES<ContinuumVector>::AdditionalData(most_kept_directions))
          .solve(stiffness, own_x, own_b, multigrid);
  } catch (const SolverControl::NoConvergence &failure) {
    // Newton's method makes up for what rounding leaves of a direction.
    if (!(failure.last_residual <= enough_of_multigrid * size))
      return false;
  }
  most_iterations = std::max(most_iterations, control.last_step());
  stiffness.set_zero_constrained(own_x);
  x.copy_locally_owned_data_from(own_x);
  return true;
}

} // namespace

template <int dim>
std::unique_ptr<ContinuumSystem> make_multigrid_system(const ContinuumBody<dim> &body) {
  return std::make_unique<MultigridSystem<dim>>(body);
}

template std::unique_ptr<ContinuumSystem> make_multigrid_system<2>(const ContinuumBody<2> &);
template std::unique_ptr<ContinuumSystem> make_multigrid_system<3>(const ContinuumBody<3> &);

} // namespace frictionbeam
