// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/algebra/dense_algebra.h"
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/line/linear_part.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The smallest motion of a vertex that has the values of @p given, in one load, and respects all
/// that is held there. What is held along a given motion moves with it, either way it points, and
/// so does an anchor along one that lies askew between the directions it holds.
Eigen::VectorXd smallest_motion(const Load::AtPoint &given, const std::string &load,
                                const unsigned int vertex, const ReducedSpace &space) {
  std::vector<Vector6> rows_held, axes;
  std::vector<double> values_given;
  for (unsigned int c = 0; c < 6; ++c)
    if (given.given[c]) {
      axes.emplace_back(unit_motion(given.axes, c).data());
      values_given.push_back(given.value[c]);
    }
  Eigen::MatrixXd others(6, 0); // held, and none of the given motions
  for (const auto &held : space.held()) {
    if (held.vertex != vertex)
      continue;
    Vector6 &row = rows_held.emplace_back();
    for (unsigned int c = 0; c < 6; ++c)
      row[c] = held.direction[c];
    if (std::none_of(axes.begin(), axes.end(), [&](const Vector6 &axis) {
          return std::abs(std::abs(row.dot(axis)) - 1.) < no_component;
        })) {
      others.conservativeResize(6, others.cols() + 1);
      others.col(others.cols() - 1) = row;
    }
  }
  Vector6 carried = Vector6::Zero(); // by what is held askew to the given motions
  for (std::size_t k = 0; k < axes.size() && others.cols() > 0; ++k)
    if ((others * LeastSquares(others).solve(axes[k]) - axes[k]).norm() < no_direction)
      carried += values_given[k] * axes[k];
  Eigen::MatrixXd rows(rows_held.size(), 6);
  Eigen::VectorXd values(rows_held.size());
  for (std::size_t n = 0; n < rows_held.size(); ++n) {
    rows.row(n) = rows_held[n];
    values[n] = rows_held[n].dot(carried);
    for (std::size_t k = 0; k < axes.size(); ++k)
      if (const double part = rows_held[n].dot(axes[k]);
          std::abs(std::abs(part) - 1.) < no_component)
        values[n] = part * values_given[k];
  }
  const Eigen::VectorXd motion = LeastSquares(rows).solve(values);
  if ((rows * motion - values).norm() > 1e-9 * values.norm())
    throw UserError("Load " + load + ": the motion imposed at point '" + given.point +
                    "' contradicts a restraint there. Impose it only in directions "
                    "that are free otherwise.");
  return motion;
}

} // namespace

void LinearPart::find_imposed_motions(const Scene &scene, const LineMesh &mesh,
                                      const Discretization &discretization,
                                      const ReducedSpace &space, const bool with_mass) {
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    if (scene.loads[l].kind != Load::Kind::displacement)
      continue;
    for (const Load::AtPoint &at : scene.loads[l].at) {
      const unsigned int vertex = mesh.points.at(at.point);
      const Eigen::VectorXd motion = smallest_motion(at, scene.loads[l].name, vertex, space);
      for (unsigned int c = 0; c < 6; ++c) {
        const auto dof = discretization.vertex_dofs().index(vertex, c);
        if (motion[c] != 0. && dof != numbers::invalid_dof_index)
          imposed_motions[l].emplace_back(dof, motion[c]);
      }
    }
  }
  sort_imposed_motions();
  const unsigned int n = imposed_at.empty() ? 0 : scene.loads.size();
  products.stiffness = products.mass = products.damping = Eigen::MatrixXd::Zero(n, n);
  if (with_mass)
    for (unsigned int l = 0; l < n; ++l)
      if (!imposed_motions[l].empty()) {
        moves_mass[l] = true;
        load_inertia[l] = load_drag[l] = Vector::Zero(space.n_unknowns());
      }
}

void LinearPart::sort_imposed_motions() {
  for (unsigned int l = 0; l < imposed_motions.size(); ++l)
    for (const auto &[dof, value] : imposed_motions[l])
      imposed_at[dof].emplace_back(l, value);
}

double LinearPart::rate(const types::global_dof_index dof, const ReducedSpace &space,
                        const Vector &unknowns, const std::vector<double> &factors) const {
  double result = 0.;
  if (const auto imposed = imposed_at.find(dof); imposed != imposed_at.end() && !factors.empty())
    for (const auto &[load, value] : imposed->second)
      result += factors[load] * value;
  if (unknowns.size() == 0)
    return result;
  for (const auto &term : space.terms(dof))
    result += term.weight * unknowns[term.unknown];
  return result;
}

void LinearPart::add_imposed(const Eigen::Ref<const Eigen::MatrixXd> &local,
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
