// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/unknowns/discretization.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Unit normal of the plane of a branch and the run that it stands on, if they make one.
Vector3 plane_normal(const LineMesh &mesh, const unsigned int branch, const unsigned int vertex,
                     const Vector3 &along) {
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p) {
    const auto &vertices = mesh.pipes[p].vertices;
    const auto found = std::find(vertices.begin(), vertices.end(), vertex);
    if (p == branch || found == vertices.end())
      continue;
    const unsigned int i = found - vertices.begin();
    const Vector3 run = mesh.pipes[p].tangent(mesh.vertices, i > 0 ? i - 1 : 0, i > 0);
    const Vector3 normal = cross_product_3d(run, along);
    if (normal.norm() > no_direction)
      return normal / normal.norm();
  }
  return LocalAxes(along).z;
}

double inverse(const double stiffness) { return stiffness == Joint::rigid ? 0. : 1. / stiffness; }

/// Add the flexibility of a joint to an end of a cell (J in doc/theory.md, "Joints").
/// @param t tangent of the pipe there, along the route @param normal of the plane of its bend or
/// tee
/// @param at_end whether the route ends there
/// @param side of the cell that the joint is on
void add_joint(const Joint &joint, const Vector3 &t, const Vector3 &normal, const bool at_end,
               CellJoints &joints, const unsigned int side) {
  const bool planes = joint.in_plane > 0.;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j) {
      const double along = t[i] * t[j], across = (i == j ? 1. : 0.) - along,
                   about_normal = normal[i] * normal[j];
      joints.flexibility[side][i][j] +=
          inverse(joint.axial) * along + inverse(joint.lateral) * across;
      joints.flexibility[side][3 + i][3 + j] +=
          inverse(joint.torsion) * along +
          (planes ? about_normal / joint.in_plane + (across - about_normal) / joint.out_of_plane
                  : inverse(joint.bending) * across);
    }
  // Pressure moves the cell's end away from the point: forward where the cell begins there.
  if (joint.thrust_area > 0.)
    for (unsigned int d = 0; d < 3; ++d)
      joints.thrust[side][d] +=
          (at_end ? -1. : 1.) * inverse(joint.axial) * joint.thrust_area * t[d];
}

} // namespace

void Discretization::add_joints(const Scene &scene, const LineMesh &mesh) {
  for (const Joint &joint : scene.joints) {
    const auto pipe = std::find_if(scene.pipes.begin(), scene.pipes.end(),
                                   [&](const Pipe &p) { return p.name == joint.pipe; });
    const unsigned int p = pipe - scene.pipes.begin();
    const MeshedPipe &meshed = mesh.pipes[p];
    const unsigned int vertex = mesh.points.at(joint.point);
    const auto place = std::find(meshed.vertices.begin(), meshed.vertices.end(), vertex);
    if (place == meshed.vertices.end())
      throw UserError("The " + joint.kind + " " + joint.name + ": its point '" + joint.point +
                      "' is not on pipe '" + joint.pipe + "'. Name a point of that pipe.");
    const bool at_end = place + 1 == meshed.vertices.end();
    const unsigned int position = place - meshed.vertices.begin() - (at_end ? 1 : 0);
    const auto cell_at = std::find_if(pipes.begin(), pipes.end(), [&](const PipeCell &cell) {
      return cell.pipe == p && cell.position == position;
    });
    const auto cell = pipe_cell(cell_at - pipes.begin());
    const unsigned int side = cell->vertex_index(0) == vertex ? 0 : 1;
    const Vector3 t = meshed.tangent(mesh.vertices, position, at_end);
    add_joint(joint, t, plane_normal(mesh, p, vertex, t), at_end,
              cell_joints[cell->active_cell_index()], side);
  }
}

} // namespace frictionbeam
