// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/smoother.h"

#include <Eigen/LU>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr unsigned int smoothing_degree = 4, steps_of_power_method = 20;
constexpr double smoothing_range = 15., safety_of_largest = 1.2;

} // namespace

template <int dim>
ChebyshevSmoother<dim>::ChebyshevSmoother(const Operator &stiffness) : stiffness(stiffness) {
  stiffness.reinit(residual);
  stiffness.reinit(direction);
  inverse = stiffness.diagonal();
  for (float &entry : inverse)
    entry = 1.f / entry;
  estimate_largest();
}

template <int dim>
void ChebyshevSmoother<dim>::estimate_largest() {
  Vector x(direction), y(direction);
  // Every entry differs from its neighbours', in the same way in every run.
  for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
    x.local_element(i) = -0.5f + ((i * 2654435761u) >> 16) / 65536.f;
  stiffness.set_zero_constrained(x);
  for (unsigned int i = 0; i < steps_of_power_method; ++i) {
    const double size = x.l2_norm();
    if (size == 0.)
      break;
    x *= static_cast<float>(1. / size);
    stiffness.vmult(y, x);
    y.scale(inverse);
    largest = y.l2_norm();
    x.swap(y);
  }
  largest = std::max(1., safety_of_largest * largest);
}

template <int dim>
void ChebyshevSmoother<dim>::take_blocks() {
  node_inverses.clear();
  for (const NodeBlock<dim> &block : stiffness.node_blocks()) {
    NodeBlock<dim> of_node = block;
    for (unsigned int a = 0; a < dim; ++a)
      of_node.stiffness(a, a) += 1. / inverse(block.dofs[a]);
    of_node.stiffness = of_node.stiffness.inverse().eval();
    node_inverses.push_back(of_node);
  }
}

template <int dim>
void ChebyshevSmoother<dim>::divide(Vector &x) const {
  std::vector<Eigen::Matrix<double, dim, 1>> at_nodes(node_inverses.size());
  for (std::size_t i = 0; i < node_inverses.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      at_nodes[i][a] = x(node_inverses[i].dofs[a]);
  x.scale(inverse);
  for (std::size_t i = 0; i < node_inverses.size(); ++i) {
    const Eigen::Matrix<double, dim, 1> divided = node_inverses[i].stiffness * at_nodes[i];
    for (unsigned int a = 0; a < dim; ++a)
      x(node_inverses[i].dofs[a]) = divided[a];
  }
}

template <int dim>
void ChebyshevSmoother<dim>::smooth(Vector &x, const Vector &b, const bool is_zero) const {
  const double smallest = largest / smoothing_range, middle = 0.5 * (largest + smallest),
               radius = 0.5 * (largest - smallest);
  double rho = radius / middle;
  for (unsigned int k = 0; k < smoothing_degree; ++k) {
    if (k == 0 && is_zero)
      residual.copy_locally_owned_data_from(b);
    else {
      stiffness.vmult(residual, x);
      residual.sadd(-1.f, 1.f, b);
    }
    divide(residual);
    if (k == 0)
      direction.equ(static_cast<float>(1. / middle), residual);
    else {
      const double next = 1. / (2. * middle / radius - rho);
      direction.sadd(static_cast<float>(next * rho), static_cast<float>(2. * next / radius),
                     residual);
      rho = next;
    }
    x += direction;
  }
}

template class ChebyshevSmoother<2>;
template class ChebyshevSmoother<3>;

} // namespace frictionbeam
