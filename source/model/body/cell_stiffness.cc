// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/cell_stiffness.h"

#include <Eigen/Core>

namespace frictionbeam {

using namespace dealii;

template <int dim>
FullMatrix<double> cell_stiffness(const FEValues<dim> &values, const FESystem<dim> &fe,
                                  const double lambda, const double mu, const double thickness) {
  const unsigned int n = fe.n_dofs_per_cell(), n_nodes = n / dim, n_q = values.n_quadrature_points;
  std::vector<unsigned int> index(n); // of component a of node i: dim i + a
  for (unsigned int i = 0; i < n; ++i)
    index[i] = fe.component_to_system_index(i % dim, i / dim);
  // The integrals of all products of derivatives, as one product of matrices.
  Eigen::MatrixXd derivative(n_q, n);
  Eigen::VectorXd weight(n_q);
  for (unsigned int q = 0; q < n_q; ++q) {
    weight[q] = values.JxW(q) * thickness;
    for (unsigned int i = 0; i < n_nodes; ++i) {
      const Tensor<1, dim> &gradient = values.shape_grad(index[dim * i], q);
      for (unsigned int a = 0; a < dim; ++a)
        derivative(q, dim * i + a) = gradient[a];
    }
  }
  const Eigen::MatrixXd products = derivative.transpose() * (weight.asDiagonal() * derivative);
  FullMatrix<double> matrix(n, n);
  for (unsigned int i = 0; i < n_nodes; ++i)
    for (unsigned int j = 0; j <= i; ++j) {
      const auto product = products.block<dim, dim>(dim * i, dim * j);
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b) {
          const double entry =
              lambda * product(a, b) + mu * product(b, a) + (a == b ? mu * product.trace() : 0.);
          matrix(index[dim * i + a], index[dim * j + b]) = entry;
          matrix(index[dim * j + b], index[dim * i + a]) = entry;
        }
    }
  return matrix;
}

template FullMatrix<double> cell_stiffness<2>(const FEValues<2> &, const FESystem<2> &,
                                              const double, const double, const double);
template FullMatrix<double> cell_stiffness<3>(const FEValues<3> &, const FESystem<3> &,
                                              const double, const double, const double);

} // namespace frictionbeam
