// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_operator.h"
#include "model/body/body_cell_matrices.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>

namespace frictionbeam {

using namespace dealii;

template <int dim, typename Number>
ElasticOperator<dim, Number>::ElasticOperator(const ContinuumBody<dim> &body,
                                              const DoFHandler<dim> &dof_handler,
                                              const AffineConstraints<double> &constraints) {
  typename Cells::AdditionalData data;
  data.tasks_parallel_scheme = Cells::AdditionalData::none;
  data.mapping_update_flags = update_gradients | update_JxW_values;
  matrix_free.reinit(body.mapping, dof_handler, constraints,
                     QGauss<1>(dof_handler.get_fe().degree + 1), data);
  sort_cells(body, dof_handler);
  reinit(diagonal_of_cells);
  assemble_stiffness<dim>(
      body, dof_handler,
      [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
        add_to_free_dofs(local, dofs, constraints,
                         [&](const auto row, const auto column, const double value) {
                           if (row == column)
                             diagonal_of_cells(row) += value;
                         });
      });
  diagonal_of_cells.compress(VectorOperation::add);
  for (const unsigned int i : matrix_free.get_constrained_dofs())
    diagonal_of_cells.local_element(i) = 1.;
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::sort_cells(const ContinuumBody<dim> &body,
                                              const DoFHandler<dim> &dof_handler) {
  const unsigned int n_batches = matrix_free.n_cell_batches();
  const auto &fe = dynamic_cast<const FESystem<dim> &>(dof_handler.get_fe());
  BodyCellMatrices<dim> matrices(body, fe);
  kinds.resize(n_batches);
  factors.resize(n_batches, VectorizedArray<Number>(0.));
  lambda = two_mu = factors;
  for (unsigned int batch = 0; batch < n_batches; ++batch)
    for (unsigned int v = 0; v < matrix_free.n_active_entries_per_cell_batch(batch); ++v) {
      const auto cell = matrix_free.get_cell_iterator(batch, v);
      const auto multiple = matrices.kind_of(cell);
      kinds[batch] = v == 0 || kinds[batch] == multiple.kind ? multiple.kind : matrices.no_kind;
      factors[batch][v] = multiple.factor;
      const LameConstants lame = lame_constants(body.continuum, cell->material_id());
      lambda[batch][v] = lame.lambda * body.thickness();
      two_mu[batch][v] = 2. * lame.mu * body.thickness();
    }
  // FEEvaluation's order: components, each with its nodes line by line.
  const auto nodes = FETools::lexicographic_to_hierarchic_numbering<dim>(fe.degree);
  std::vector<unsigned int> numbering;
  for (unsigned int d = 0; d < dim; ++d)
    for (const unsigned int node : nodes)
      numbering.push_back(fe.component_to_system_index(d, node));
  for (unsigned int kind = 0; kind < matrices.n_kinds(); ++kind)
    products.emplace_back(matrices.of_kind(kind), numbering);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::integrate_on_cell(Evaluation &cell) const {
  const unsigned int batch = cell.get_current_cell_index();
  cell.evaluate(EvaluationFlags::gradients);
  for (unsigned int q = 0; q < cell.n_q_points; ++q) {
    const auto strain = cell.get_symmetric_gradient(q);
    auto stress = two_mu[batch] * strain;
    const auto pressure = lambda[batch] * trace(strain);
    for (unsigned int d = 0; d < dim; ++d)
      stress[d][d] += pressure;
    cell.submit_symmetric_gradient(stress, q);
  }
  cell.integrate(EvaluationFlags::gradients);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::add_products(const unsigned int kind, Waiting &waiting,
                                                Evaluation &cell, Vector &y) const {
  constexpr unsigned int n_lanes = CellProduct<Number>::n_lanes;
  products[kind].multiply(waiting.x.data(), waiting.y.data());
  unsigned int lane = 0;
  for (const unsigned int batch : waiting.batches) {
    cell.reinit(batch);
    const unsigned int n_cells = matrix_free.n_active_entries_per_cell_batch(batch);
    for (unsigned int i = 0; i < cell.dofs_per_cell; ++i)
      for (unsigned int v = 0; v < n_cells; ++v)
        cell.begin_dof_values()[i][v] = waiting.y[i * n_lanes + lane + v];
    cell.distribute_local_to_global(y);
    lane += n_cells;
  }
  waiting.batches.clear();
  waiting.n_cells = 0;
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::apply(const Cells &, Vector &y, const Vector &x,
                                         const std::pair<unsigned int, unsigned int> &range) const {
  constexpr unsigned int n_lanes = CellProduct<Number>::n_lanes;
  Evaluation cell(matrix_free, range);
  std::vector<Waiting> waiting(products.size());
  for (unsigned int kind = 0; kind < products.size(); ++kind) {
    waiting[kind].x.resize(cell.dofs_per_cell * n_lanes);
    waiting[kind].y.resize(products[kind].padded_size() * n_lanes);
  }
  for (unsigned int batch = range.first; batch < range.second; ++batch) {
    cell.reinit(batch);
    cell.read_dof_values(x);
    const unsigned int kind = kinds[batch];
    if (kind == BodyCellMatrices<dim>::no_kind) {
      integrate_on_cell(cell);
      cell.distribute_local_to_global(y);
      continue;
    }
    Waiting &those = waiting[kind];
    const unsigned int n_cells = matrix_free.n_active_entries_per_cell_batch(batch);
    for (unsigned int i = 0; i < cell.dofs_per_cell; ++i)
      for (unsigned int v = 0; v < n_cells; ++v)
        those.x[i * n_lanes + those.n_cells + v] =
            factors[batch][v] * cell.begin_dof_values()[i][v];
    those.batches.push_back(batch);
    those.n_cells += n_cells;
    if (those.n_cells + VectorizedArray<Number>::size() > n_lanes)
      add_products(kind, those, cell, y);
  }
  for (unsigned int kind = 0; kind < products.size(); ++kind)
    if (waiting[kind].n_cells > 0)
      add_products(kind, waiting[kind], cell, y);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::multiply_without_blocks(Vector &y, const Vector &x) const {
  matrix_free.cell_loop(&ElasticOperator::apply, this, y, x, true);
  for (const unsigned int i : matrix_free.get_constrained_dofs())
    y.local_element(i) = x.local_element(i);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::vmult(Vector &y, const Vector &x) const {
  multiply_without_blocks(y, x);
  for (const auto &block : blocks)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        if (block.stiffness(a, b) != 0.)
          y(block.dofs[a]) += block.stiffness(a, b) * x(block.dofs[b]);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::set_zero_constrained(Vector &vector) const {
  for (const unsigned int i : matrix_free.get_constrained_dofs())
    vector.local_element(i) = 0.;
}

template class ElasticOperator<2, double>;
template class ElasticOperator<3, double>;
template class ElasticOperator<2, float>;
template class ElasticOperator<3, float>;

} // namespace frictionbeam
