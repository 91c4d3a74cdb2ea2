// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/linear_cells.h"

namespace frictionbeam {

using namespace dealii;

const std::vector<LinearCells::Element> &LinearCells::elements() const {
  if (!kept_elements.empty())
    return kept_elements;
  PipeElement element(discretization);
  const bool has_mass = linear.mass().rows() > 0;
  kept_elements.reserve(discretization.pipe_cells().size());
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const auto cell = discretization.pipe_cell(i);
    element.reinit(cell);
    kept_elements.push_back({std::vector<types::global_dof_index>(12), &element.profile(),
                             cell->vertex(1) - cell->vertex(0), element.stiffness(),
                             has_mass ? element.mass(cell) : Matrix12(Matrix12::Zero()),
                             element.unit_line_loads(), element.unit_axial_strain(),
                             element.unit_curvature(), element.unit_thrust()});
    cell->get_dof_indices(kept_elements.back().dofs);
  }
  return kept_elements;
}

Pose LinearCells::at_rest() const { return {Vector::Zero(space.n_dofs()), {}, &sections_at_rest}; }

Pose LinearCells::moved(const Pose &from, const Vector &change) const {
  return {from.dofs + change, {}, from.sections};
}

Pose LinearCells::halfway(const Pose &from, const Pose &to) const {
  return {(from.dofs + to.dofs) / 2., {}, from.sections};
}

LineCells::Vector12 LinearCells::ends_of(const unsigned int cell, const Vector &dofs) const {
  std::vector<types::global_dof_index> indices(12);
  discretization.pipe_cell(cell)->get_dof_indices(indices);
  Vector12 result;
  for (unsigned int i = 0; i < 12; ++i)
    result[i] = dofs[indices[i]];
  return result;
}

void LinearCells::answer(const unsigned int index, const Step &step,
                         const std::vector<double> &factors, CellAnswer &answer) const {
  const Element &element = elements()[index];
  const CellLoad load =
      load_on(discretization.pipe_cells()[index], *element.profile, element.chord, factors);
  const Vector12 before = ends_of(index, step.from.dofs), after = ends_of(index, step.to.dofs),
                 change = after - before;
  const Matrix12 &stiffness = element.stiffness;
  const double viscous = step.duration > 0. ? scene.time.stiffness_damping / step.duration : 0.;
  answer.dofs = element.dofs;
  answer.loads =
      element.line * Eigen::Vector3d(load.line_force[0], load.line_force[1], load.line_force[2]);
  answer.free = load.axial_strain * element.axial + load.curvature * element.curvature +
                load.pressure * element.thrust;
  answer.damping = viscous * change.dot(stiffness * change);
  if (sections.has(index)) {
    PipeSections::Answer inelastic;
    integrate_sections(index, step.began ? ends_of(index, step.began->dofs) : before, after, step,
                       factors, answer, inelastic);
    answer.stiffness = inelastic.stiffness + 2. * viscous * stiffness;
    answer.internal =
        (&step.from == &step.to ? inelastic.after : (inelastic.before + inelastic.after) / 2.) +
        viscous * (stiffness * change);
    return;
  }
  answer.stiffness = (1. + 2. * viscous) * stiffness;
  answer.internal = stiffness * ((before + after) / 2. + viscous * change) - answer.free;
  answer.free_work = answer.free.dot(change);
  answer.section_error = 0.;
  answer.failure = nullptr;
}

double LinearCells::stored_in(const unsigned int cell, const Pose &pose) const {
  if (sections.has(cell))
    return sections.stored_in(cell, *pose.sections);
  // By the second end's motion seen from the first: a rigid cell that moves far as a whole would
  // store the rounding of K u.
  const Element &element = elements()[cell];
  const Vector12 u = ends_of(cell, pose.dofs);
  Eigen::Matrix<double, 6, 1> seen = u.tail<6>() - u.head<6>();
  const Eigen::Vector3d chord(element.chord[0], element.chord[1], element.chord[2]);
  seen.head<3>() -= u.segment<3>(3).cross(chord);
  return seen.dot(element.stiffness.bottomRightCorner<6, 6>() * seen) / 2.;
}

Vector LinearCells::momenta(const Pose &, const Vector &velocity) const {
  Vector result = Vector::Zero(velocity.size());
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const Element &element = elements()[i];
    const Vector12 share = element.mass * ends_of(i, velocity);
    for (unsigned int j = 0; j < 12; ++j)
      result[element.dofs[j]] += share[j];
  }
  for (unsigned int v = 0; v < n_vertices; ++v)
    add_part(point_mass[v] * part(velocity, v, 0), v, 0, result);
  return result;
}

/// Forces on the ends of a cell of a solid part, of which no stiffness of its own is known: what
/// the sections before it need from outside, and the loads on them, pass through it.
LineCells::Vector12 LinearCells::ends_in_solid(const SolidPart &part, const PipeCell &of,
                                               const Pose &pose,
                                               const std::vector<double> &factors) const {
  const unsigned int n = part.vertices.size(), k = of.position - part.first_cell;
  Vector q(6 * n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < 6; ++c)
      q[6 * i + c] = pose.dofs[discretization.vertex_dofs().index(part.vertices[i], c)];
  Vector outside = part.stiffness * q;
  for (unsigned int l = 0; l < factors.size(); ++l)
    outside -= factors[l] * part.forces[l];
  if (const double p = part.pressure(factors); p != 0.) {
    const SolidPart::Pressed &pressed = part.pressed(p);
    outside += pressed.stiffness * q - pressed.by_itself -
               pressed.forces * Eigen::Map<const Vector>(factors.data(), factors.size());
  }
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Vector6 begin = Vector6::Zero(), end = Vector6::Zero();
  for (unsigned int i = 0; i <= k; ++i) {
    begin = outside.segment<6>(6 * i) - end;
    Vector6 on = begin; // and the loads between the two vertices, about the first
    for (unsigned int l = 0; l < factors.size(); ++l)
      on += factors[l] * Eigen::Map<const Vector6>(part.cell_loads[l][i].data());
    const Vector3 way = mesh.vertices[part.vertices[i]] - mesh.vertices[part.vertices[i + 1]];
    const Eigen::Vector3d arm(way[0], way[1], way[2]), force = on.head<3>();
    end.head<3>() = -force;
    end.tail<3>() = -(on.tail<3>() + arm.cross(force));
  }
  Vector12 ends;
  ends.segment<6>(of.reversed ? 6 : 0) = begin;
  ends.segment<6>(of.reversed ? 0 : 6) = end;
  return ends;
}

LineCells::CellState LinearCells::state_of(const unsigned int index, const PipeElement &element,
                                           const Pose &pose,
                                           const std::vector<double> &factors) const {
  const PipeCell &of = discretization.pipe_cells()[index];
  if (const SolidPart *const part = linear.solid_part(of))
    return {ends_in_solid(*part, of, pose, factors), ends_of(index, pose.dofs), {}};
  const auto cell = discretization.pipe_cell(index);
  const CellLoad load = load_on(of, element.profile(), cell->vertex(1) - cell->vertex(0), factors);
  const Eigen::Vector3d line_force(load.line_force[0], load.line_force[1], load.line_force[2]);
  const Vector12 u = ends_of(index, pose.dofs);
  CellState state;
  const bool vibrates = pose.sections == nullptr || pose.sections->size() == 0;
  state.ends = sections.has(index) && !vibrates
                   ? sections.forces(index, *pose.sections)
                   : element.stiffness() * u - load.axial_strain * element.unit_axial_strain() -
                         load.curvature * element.unit_curvature() -
                         load.pressure * element.unit_thrust();
  state.ends -= element.unit_line_loads() * line_force;
  state.motions = u;
  return state;
}

LineCells::Matrix12 LinearCells::mass_of(const unsigned int cell, PipeElement &element) const {
  return element.mass(discretization.pipe_cell(cell));
}

} // namespace frictionbeam
