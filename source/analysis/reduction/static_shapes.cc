// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/reduction/static_shapes.h"

#include "base/algebra/dense_algebra.h"

#include <cmath>

namespace frictionbeam {

namespace {
constexpr double same_shape = 1e-7;          ///< of its norm: less of a shape is in the others
constexpr double rounding_of_shapes = 1e-12; ///< of what a shape is the difference of
} // namespace

StaticShapes::StaticShapes(const PartOfLine &part, const Eigen::MatrixXd &modes,
                           const Vector &stiffness)
    : part(part), modes(modes), stiffness(stiffness) {}

void StaticShapes::add(Vector shape, const Eigen::SparseMatrix<double> &norm, const double of) {
  const auto size = [&](const Vector &x) { return std::sqrt(std::max(0., x.dot(norm * x))); };
  const double whole = size(shape);
  for (int pass = 0; pass < 2; ++pass) { // twice is enough
    const Vector forces = part.K * shape;
    shape -= modes * (modes.transpose() * forces).cwiseQuotient(stiffness);
    for (const Vector &other : shapes)
      shape -= other.dot(part.K * shape) * other;
  }
  const double left = size(shape);
  if (left > same_shape * whole && left > rounding_of_shapes * of)
    shapes.push_back(shape / std::sqrt(shape.dot(part.K * shape)));
}

void StaticShapes::add_loads(const LinearPart &line, const std::vector<bool> &acts) {
  const auto respond_to = [&](const Vector &all_forces) {
    const Vector forces = part.inner(all_forces);
    if (!forces.isZero(0.))
      add(part.factors->solve(forces), part.K, 0.);
  };
  for (unsigned int l = 0; l < acts.size(); ++l)
    if (acts[l]) {
      respond_to(line.forces(l));
      if (line.accelerates(l))
        respond_to(line.inertia(l));
    }
}

void StaticShapes::add_border_inertia() {
  const Eigen::MatrixXd inertia = part.M * part.constraint_modes + part.M_border;
  for (int b = 0; b < inertia.cols(); ++b)
    add(part.factors->solve(inertia.col(b)), part.K, 0.);
}

void StaticShapes::add_state(const Vector &unknowns, const Vector &border,
                             const Eigen::SparseMatrix<double> &norm) {
  const Vector x = part.inner(unknowns);
  const double size = std::sqrt(std::max(0., x.cwiseProduct(x).dot(norm.diagonal())));
  add(x - part.constraint_modes * border, norm, size);
}

Eigen::MatrixXd StaticShapes::orthogonal() const {
  Eigen::MatrixXd X(part.inside.size(), shapes.size());
  for (unsigned int j = 0; j < shapes.size(); ++j)
    X.col(j) = shapes[j];
  if (part.has_mass && !shapes.empty()) {
    const Eigen::MatrixXd mass = X.transpose() * (part.M * X);
    X = X * symmetric_eigen(mass).vectors;
  }
  for (int j = 0; j < X.cols(); ++j)
    X.col(j) /= X.col(j).lpNorm<Eigen::Infinity>();
  return X;
}

} // namespace frictionbeam
