// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/section_motion.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>

#include <Eigen/LU>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Tractions of unit forces and moments on a section at @p arm from its middle [1/m2, 1/m3].
/// @param A area @param I moment of inertia of the section
std::array<Vector3, 6> tractions(const double A, const double I, const Vector3 &tangent,
                                 const Vector3 &arm) {
  const Vector3 out = arm / arm.norm(), around = cross_product_3d(tangent, out);
  std::array<Vector3, 6> result;
  for (unsigned int d = 0; d < 3; ++d) {
    const Vector3 e = Point3::unit_vector(d);
    result[d] = (e * tangent) / A * tangent + 2. * (e * around) / A * around;
    result[3 + d] = e * cross_product_3d(arm, tangent) / I * tangent +
                    (e * tangent) / (2. * I) * cross_product_3d(tangent, arm);
  }
  return result;
}

} // namespace

SectionMotion::SectionMotion(const PipeWall &wall, const ContinuumBody<3> &body,
                             const unsigned int ring)
    : centre(wall.rings[ring].centre), tangent(wall.rings[ring].tangent) {
  const WallRing &at = wall.rings[ring];
  const unsigned int layer = ring == 0 ? 0 : ring - 1, face = ring == 0 ? 4 : 5;
  const double A = wall.area(), I = wall.inertia();
  FEFaceValues<3> values(body.mapping, body.fe, QGauss<2>(body.fe.degree + 2),
                         update_values | update_quadrature_points | update_JxW_values);
  std::array<ContinuumVector, 6> raw;
  for (unsigned int c = 0; c < 6; ++c) {
    body.reinit(raw[c]);
    body.reinit(columns[c]);
  }
  Eigen::Matrix<double, 6, 6> work = Eigen::Matrix<double, 6, 6>::Zero(); // of tractions, motions
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (wall.layer_of(cell->index()) != layer)
      continue;
    values.reinit(cell, face);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Vector3 arm = values.quadrature_point(q) - at.centre;
      const std::array<Vector3, 6> t = tractions(A, I, at.tangent, arm);
      for (unsigned int c = 0; c < 6; ++c) {
        for (unsigned int k = 0; k < 6; ++k)
          work(c, k) += values.JxW(q) * t[c] *
                        (k < 3 ? Vector3(Point3::unit_vector(k))
                               : Vector3(cross_product_3d(Point3::unit_vector(k - 3), arm)));
        for (unsigned int i = 0; i < dofs.size(); ++i)
          raw[c](dofs[i]) += values.JxW(q) * values.shape_value(i, q) *
                             t[c][body.fe.system_to_component_index(i).first];
      }
    }
  }
  const Eigen::Matrix<double, 6, 6> share = work.inverse();
  for (unsigned int c = 0; c < 6; ++c)
    for (unsigned int k = 0; k < 6; ++k)
      columns[c].add(share(c, k), raw[k]);
}

void SectionMotion::add_forces(const Vector6 &forces, ContinuumVector &to) const {
  for (unsigned int c = 0; c < 6; ++c)
    to.add(forces[c], columns[c]);
}

SectionMotion::Vector6 SectionMotion::motion(const ContinuumVector &displacement) const {
  Vector6 result;
  for (unsigned int c = 0; c < 6; ++c)
    result[c] = columns[c] * displacement;
  return result;
}

ContinuumVector SectionMotion::pressure(const PipeWall &wall, const ContinuumBody<3> &body,
                                        const unsigned int patch) const {
  constexpr unsigned int outside = 1, first_patch = 4; // face of a cell, part of the boundary
  const WallPatch &at = wall.patches[patch];
  FEFaceValues<3> values(body.mapping, body.fe, QGauss<2>(body.fe.degree + 2),
                         update_values | update_quadrature_points | update_JxW_values);
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  const auto add = [&](const double weight, const Vector3 &direction, const unsigned int q,
                       ContinuumVector &to) {
    for (unsigned int i = 0; i < dofs.size(); ++i)
      to(dofs[i]) +=
          weight * values.shape_value(i, q) * direction[body.fe.system_to_component_index(i).first];
  };
  // What presses, and as much as it presses along the radius as an even push outwards.
  ContinuumVector forces, widening;
  body.reinit(forces);
  body.reinit(widening);
  double area = 0., along_radius = 0., ring_area = 0.;
  Vector3 moment;
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    const unsigned int layer = wall.layer_of(cell->index());
    const double middle = 0.5 * (wall.rings[layer].s + wall.rings[layer + 1].s);
    if (!cell->at_boundary(outside) || !at.covers(middle))
      continue;
    const bool is_pressed = cell->face(outside)->boundary_id() == first_patch + patch;
    values.reinit(cell, outside);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Vector3 arm = values.quadrature_point(q) - centre,
                    across = arm - (arm * tangent) * tangent, radius = across / across.norm();
      ring_area += values.JxW(q);
      add(values.JxW(q), radius, q, widening);
      const double cosine = at.outward * radius;
      if (!is_pressed || cosine < at.least_cosine())
        continue;
      area += values.JxW(q);
      along_radius += values.JxW(q) * cosine;
      moment -= values.JxW(q) * cross_product_3d(arm, at.outward);
      add(-values.JxW(q), at.outward, q, forces);
    }
  }
  Assert(area > 0., ExcMessage("a patch without faces"));
  forces.add(along_radius / ring_area, widening);
  forces /= area;
  for (unsigned int d = 0; d < 3; ++d)
    forces.add(at.outward[d], columns[d], -moment[d] / area, columns[3 + d]);
  return forces;
}

ContinuumVector rigid_displacement(const ContinuumBody<3> &body, const Point3 &about,
                                   const SectionMotion::Vector6 &motion) {
  std::map<types::global_dof_index, Point<3>> places;
  DoFTools::map_dofs_to_support_points(body.mapping, body.dof_handler, places);
  const Vector3 shift({motion[0], motion[1], motion[2]}), turn({motion[3], motion[4], motion[5]});
  ContinuumVector result;
  body.reinit(result);
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      result(dofs[i]) =
          (shift +
           cross_product_3d(turn, Vector3(places.at(dofs[i]) -
                                          about)))[body.fe.system_to_component_index(i).first];
  }
  return result;
}

} // namespace frictionbeam
