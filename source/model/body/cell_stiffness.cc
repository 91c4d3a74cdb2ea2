// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/cell_stiffness.h"

namespace frictionbeam {

using namespace dealii;

template <int dim>
FullMatrix<double> cell_stiffness(const FEValues<dim> &values, const FESystem<dim> &fe,
                                  const double lambda, const double mu, const double thickness) {
  const unsigned int n = fe.n_dofs_per_cell(), n_nodes = n / dim;
  FullMatrix<double> matrix(n, n);
  std::vector<Tensor<1, dim>> gradient(n_nodes);
  // FESystem searches its list for each answer.
  std::vector<unsigned int> index_of(n);
  for (unsigned int k = 0; k < n; ++k) {
    const auto [component, node] = fe.system_to_component_index(k);
    index_of[node * dim + component] = k;
  }
  const auto index = [&](const unsigned int component, const unsigned int node) {
    return index_of[node * dim + component];
  };
  for (const unsigned int q : values.quadrature_point_indices()) {
    const double weight = values.JxW(q) * thickness;
    for (unsigned int i = 0; i < n_nodes; ++i)
      gradient[i] = values.shape_grad(index(0, i), q);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int j = 0; j <= i; ++j) {
        const Tensor<1, dim> &gi = gradient[i], &gj = gradient[j];
        const double product = mu * (gi * gj);
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b < dim; ++b)
            matrix(index(a, i), index(b, j)) +=
                weight * (lambda * gi[a] * gj[b] + mu * gi[b] * gj[a] + (a == b ? product : 0.));
      }
  }
  for (unsigned int i = 0; i < n_nodes; ++i)
    for (unsigned int j = 0; j < i; ++j)
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          matrix(index(b, j), index(a, i)) = matrix(index(a, i), index(b, j));
  return matrix;
}

template FullMatrix<double> cell_stiffness<2>(const FEValues<2> &, const FESystem<2> &,
                                              const double, const double, const double);
template FullMatrix<double> cell_stiffness<3>(const FEValues<3> &, const FESystem<3> &,
                                              const double, const double, const double);

} // namespace frictionbeam
