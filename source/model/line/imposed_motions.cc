// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/line/linear_part.h"

#include <Eigen/QR>

#include <cmath>

namespace frictionbeam {

using namespace dealii;

void LinearPart::find_imposed_motions(const Scene &scene, const LineMesh &mesh,
                                      const Discretization &discretization,
                                      const ReducedSpace &space, const bool with_mass) {
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    if (scene.loads[l].kind != Load::Kind::displacement)
      continue;
    for (const Load::AtPoint &at : scene.loads[l].at) {
      const unsigned int vertex = mesh.points.at(at.point);
      // The smallest motion of the vertex that has the given values and respects all that is held.
      Eigen::MatrixXd rows(0, 6);
      Eigen::VectorXd values(0);
      const auto append = [&](const Tensor<1, 6> &direction, const double value) {
        rows.conservativeResize(rows.rows() + 1, 6);
        values.conservativeResize(values.size() + 1);
        for (unsigned int c = 0; c < 6; ++c)
          rows(rows.rows() - 1, c) = direction[c];
        values[values.size() - 1] = value;
      };
      for (const auto &held : space.held()) {
        if (held.vertex != vertex)
          continue;
        double value = 0.; // what is held along an axis moves with it, either way it points
        for (unsigned int c = 0; c < 6; ++c)
          if (at.given[c] && std::abs(std::abs(held.direction[c]) - 1.) < no_component)
            value = held.direction[c] * at.value[c];
        append(held.direction, value);
      }
      const Eigen::VectorXd motion = rows.completeOrthogonalDecomposition().solve(values);
      if ((rows * motion - values).norm() > 1e-9 * values.norm())
        throw UserError("Load " + scene.loads[l].name + ": the motion imposed at point '" +
                        at.point +
                        "' contradicts a restraint there. Impose it only in directions "
                        "that are free otherwise.");
      for (unsigned int c = 0; c < 6; ++c) {
        const auto dof = discretization.vertex_dofs().index(vertex, c);
        if (motion[c] != 0. && dof != numbers::invalid_dof_index) {
          imposed_motions[l].emplace_back(dof, motion[c]);
          imposed_at[dof].emplace_back(l, motion[c]);
        }
      }
    }
  }
  const unsigned int n = imposed_at.empty() ? 0 : scene.loads.size();
  products.stiffness = products.mass = products.damping = Eigen::MatrixXd::Zero(n, n);
  if (with_mass)
    for (unsigned int l = 0; l < n; ++l)
      if (!imposed_motions[l].empty())
        load_inertia[l] = load_drag[l] = Vector::Zero(space.n_unknowns());
}

void LinearPart::add_imposed(const Eigen::MatrixXd &local,
                             const std::vector<types::global_dof_index> &dofs,
                             const ReducedSpace &space, std::vector<Vector> &forces,
                             Eigen::MatrixXd &products_of_motions) const {
  if (imposed_at.empty())
    return;
  for (unsigned int j = 0; j < dofs.size(); ++j) {
    const auto moved = imposed_at.find(dofs[j]);
    if (moved == imposed_at.end())
      continue;
    for (const auto &[l, value] : moved->second)
      for (unsigned int i = 0; i < dofs.size(); ++i) {
        for (const auto &term : space.terms(dofs[i]))
          forces[l][term.unknown] -= term.weight * local(i, j) * value;
        if (const auto other = imposed_at.find(dofs[i]); other != imposed_at.end())
          for (const auto &[k, other_value] : other->second)
            products_of_motions(k, l) += other_value * local(i, j) * value;
      }
  }
}

namespace {

/// -sum_l x_l f_l . y + x^T P x / 2
double mixed_energy(const std::vector<double> &x, const Vector &y,
                    const std::vector<Vector> &forces, const Eigen::MatrixXd &products) {
  double energy = 0.;
  for (int l = 0; l < products.rows(); ++l)
    if (products(l, l) != 0. && x[l] != 0.) {
      energy -= x[l] * forces[l].dot(y);
      for (int k = 0; k < products.cols(); ++k)
        energy += x[l] * products(l, k) * x[k] / 2.;
    }
  return energy;
}

} // namespace

double LinearPart::stored_by_imposed(const std::vector<double> &factors,
                                     const Vector &unknowns) const {
  return mixed_energy(factors, unknowns, load_forces, products.stiffness);
}

double LinearPart::kinetic_by_imposed(const std::vector<double> &rates,
                                      const Vector &velocity) const {
  return mixed_energy(rates, velocity, load_inertia, products.mass);
}

} // namespace frictionbeam
