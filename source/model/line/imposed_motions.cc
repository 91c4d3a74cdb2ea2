// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/line/linear_part.h"

#include <Eigen/QR>

#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The smallest motion of a vertex that has the values of @p given, in one load, and respects all
/// that is held there.
Eigen::VectorXd smallest_motion(const Load::AtPoint &given, const std::string &load,
                                const unsigned int vertex, const ReducedSpace &space) {
  Eigen::MatrixXd rows(0, 6);
  Eigen::VectorXd values(0);
  for (const auto &held : space.held()) {
    if (held.vertex != vertex)
      continue;
    const Eigen::Index n = rows.rows();
    rows.conservativeResize(n + 1, 6);
    values.conservativeResize(n + 1);
    values[n] = 0.;
    double left = 1., moves = 0.; // of the direction, what is not given; what of it is
    for (unsigned int c = 0; c < 6; ++c) {
      rows(n, c) = held.direction[c];
      if (!given.given[c])
        continue;
      const Motion axis = unit_motion(given.axes, c);
      double part = 0.;
      for (unsigned int d = 0; d < 6; ++d)
        part += held.direction[d] * axis[d];
      left -= part * part;
      moves += part * given.value[c];
    }
    if (std::abs(left) < no_component) // what is held along given motions moves with them
      values[n] = moves;
  }
  const Eigen::VectorXd motion = rows.completeOrthogonalDecomposition().solve(values);
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
      if (!imposed_motions[l].empty())
        load_inertia[l] = load_drag[l] = Vector::Zero(space.n_unknowns());
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
