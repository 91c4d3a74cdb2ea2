// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/bore_loop.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

BoreLoop::BoreLoop(const PipeWall &wall, const ContinuumBody<3> &body, const unsigned int ring) {
  read_nodes(wall, body, ring);
  Vector3 area;
  for (unsigned int i = 0; i < arms.size(); ++i)
    area += cross_product_3d(arms[i], arms[(i + 1) % arms.size()]);
  integrate(body.fe.degree, area * wall.rings[ring].tangent > 0. ? 1. : -1.);
}

void BoreLoop::read_nodes(const PipeWall &wall, const ContinuumBody<3> &body,
                          const unsigned int ring) {
  const FiniteElement<3> &scalar = body.fe.base_element(0);
  const std::vector<Point<3>> &points = scalar.get_unit_support_points();
  const double end = ring == 0 ? 0. : 1.;
  constexpr double on_edge = 1e-9;
  std::vector<unsigned int> on_loop; // of a cell, along its circumference; the last is the next's
  for (unsigned int i = 0; i < points.size(); ++i)
    if (points[i][0] < on_edge && std::abs(points[i][2] - end) < on_edge &&
        points[i][1] < 1. - on_edge)
      on_loop.push_back(i);
  std::sort(on_loop.begin(), on_loop.end(), [&](const unsigned int a, const unsigned int b) {
    return points[a][1] < points[b][1];
  });
  const unsigned int layer = ring == 0 ? 0 : ring - 1;
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (unsigned int i = 0; i < wall.around; ++i) {
    const typename DoFHandler<3>::active_cell_iterator cell(
        body.triangulation.get(), 0, layer * wall.around * wall.through + i, &body.dof_handler);
    cell->get_dof_indices(dofs);
    for (const unsigned int node : on_loop) {
      for (unsigned int d = 0; d < 3; ++d)
        unknowns.push_back(dofs[body.fe.component_to_system_index(d, node)]);
      arms.push_back(body.mapping.transform_unit_to_real_cell(cell, points[node]) -
                     wall.rings[ring].centre);
    }
  }
}

void BoreLoop::integrate(const unsigned int degree, const double sign) {
  const unsigned int n = arms.size();
  const auto basis =
      Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(degree + 1).get_points());
  const QGauss<1> rule(2 * degree);
  first.reinit(3 * n);
  second.reinit(3 * n, 3 * n);
  std::vector<Vector3> turned(n); // int N_j r' ds: a(u) is the sum of u_j x turned_j
  std::vector<double> value(2);
  for (unsigned int begin = 0; begin < n; begin += degree)
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double weight = sign * rule.weight(q);
      std::vector<double> N(degree + 1), dN(degree + 1);
      Vector3 r, dr;
      for (unsigned int k = 0; k <= degree; ++k) {
        basis[k].value(rule.point(q)[0], value);
        N[k] = value[0];
        dN[k] = value[1];
        r += N[k] * arms[(begin + k) % n];
        dr += dN[k] * arms[(begin + k) % n];
      }
      const Vector3 area = cross_product_3d(r, dr);
      for (unsigned int i = 0; i <= degree; ++i) {
        const unsigned int row = (begin + i) % n;
        turned[row] += weight * N[i] * dr;
        for (unsigned int a = 0; a < 3; ++a) {
          first[3 * row + a] += weight * N[i] * area[a] / 3.;
          for (unsigned int of = 0; of < n; ++of) // v_0 is the mean
            first[3 * of + a] += weight * N[i] * 0.5 * area[a] / (3. * n);
        }
        for (unsigned int j = 0; j <= degree; ++j)
          for (unsigned int b = 0; b < 3; ++b) {
            const Vector3 moved = N[j] * cross_product_3d(Point3::unit_vector(b), dr) +
                                  dN[j] * cross_product_3d(r, Point3::unit_vector(b));
            for (unsigned int a = 0; a < 3; ++a)
              second(3 * row + a, 3 * ((begin + j) % n) + b) += weight * N[i] * moved[a] / 3.;
          }
      }
    }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          second(3 * i + a, 3 * j + b) += (cross_product_3d(Point3::unit_vector(b), turned[j])[a] +
                                           cross_product_3d(Point3::unit_vector(a), turned[i])[b]) /
                                          (3. * n);
}

Motion BoreLoop::moved_cap(const ContinuumVector &u) const {
  Vector<double> of_nodes(unknowns.size()), forces(unknowns.size());
  for (unsigned int i = 0; i < unknowns.size(); ++i)
    of_nodes[i] = u(unknowns[i]);
  second.vmult(forces, of_nodes);
  Vector3 force, moment;
  for (unsigned int i = 0; i < arms.size(); ++i) {
    const Vector3 one({forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]});
    force += one;
    moment += cross_product_3d(arms[i], one);
  }
  return {{force[0], force[1], force[2], moment[0], moment[1], moment[2]}};
}

} // namespace frictionbeam
