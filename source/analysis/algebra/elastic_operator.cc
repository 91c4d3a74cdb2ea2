// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_operator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/tools.h>

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
  lambda.resize(matrix_free.n_cell_batches(), VectorizedArray<Number>(0.));
  two_mu = lambda;
  for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
    for (unsigned int v = 0; v < matrix_free.n_active_entries_per_cell_batch(batch); ++v) {
      const LameConstants lame =
          lame_constants(body.continuum, matrix_free.get_cell_iterator(batch, v)->material_id());
      lambda[batch][v] = lame.lambda * body.thickness();
      two_mu[batch][v] = 2. * lame.mu * body.thickness();
    }
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::apply_on_cell(Evaluation &cell) const {
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
void ElasticOperator<dim, Number>::apply(const Cells &, Vector &y, const Vector &x,
                                         const std::pair<unsigned int, unsigned int> &range) const {
  Evaluation cell(matrix_free, range);
  for (unsigned int batch = range.first; batch < range.second; ++batch) {
    cell.reinit(batch);
    cell.read_dof_values(x);
    apply_on_cell(cell);
    cell.distribute_local_to_global(y);
  }
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::vmult(Vector &y, const Vector &x) const {
  matrix_free.cell_loop(&ElasticOperator::apply, this, y, x, true);
  for (const auto &block : blocks)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        if (block.stiffness(a, b) != 0.)
          y(block.dofs[a]) += block.stiffness(a, b) * x(block.dofs[b]);
  for (const unsigned int i : matrix_free.get_constrained_dofs())
    y.local_element(i) = x.local_element(i);
}

template <int dim, typename Number>
void ElasticOperator<dim, Number>::find_diagonal(Vector &diagonal) const {
  reinit(diagonal);
  MatrixFreeTools::compute_diagonal(matrix_free, diagonal, &ElasticOperator::apply_on_cell, this);
  for (const unsigned int i : matrix_free.get_constrained_dofs())
    diagonal.local_element(i) = 1.;
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
