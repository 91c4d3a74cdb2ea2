// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/linear_cells.h"

namespace frictionbeam {

using namespace dealii;

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

namespace {

/// Forces on a cell's ends that its line forces, and those that its free strains make.
struct FixedEndForces {
  LineCells::Vector12 line, free;
};

FixedEndForces fixed_end_forces(const PipeElement &element, const CellLoad &load) {
  const Eigen::Vector3d force(load.line_force[0], load.line_force[1], load.line_force[2]);
  return {element.unit_line_loads() * force, load.axial_strain * element.unit_axial_strain() +
                                                 load.curvature * element.unit_curvature() +
                                                 load.pressure * element.unit_thrust()};
}

} // namespace

void LinearCells::answer(const unsigned int index, const Step &step,
                         const std::vector<double> &factors, CellAnswer &answer) const {
  const auto cell = discretization.pipe_cell(index);
  PipeElement element(discretization);
  element.reinit(cell);
  const FixedEndForces forces =
      fixed_end_forces(element, load_on(discretization.pipe_cells()[index], element.profile(),
                                        cell->vertex(1) - cell->vertex(0), factors));
  const Vector12 before = ends_of(index, step.from.dofs), after = ends_of(index, step.to.dofs),
                 change = after - before;
  const Matrix12 stiffness = element.stiffness();
  const double viscous = step.duration > 0. ? scene.time.stiffness_damping / step.duration : 0.;
  answer.dofs.resize(12);
  cell->get_dof_indices(answer.dofs);
  answer.stiffness = (1. + 2. * viscous) * stiffness;
  answer.internal = stiffness * ((before + after) / 2. + viscous * change) - forces.free;
  answer.loads = forces.line;
  answer.free = forces.free;
  answer.free_work = forces.free.dot(change);
  answer.damping = viscous * change.dot(stiffness * change);
  if (!sections.has(index))
    return;
  PipeSections::Answer inelastic;
  integrate_sections(index, step.began ? ends_of(index, step.began->dofs) : before, after, step,
                     factors, answer, inelastic);
  answer.stiffness = inelastic.stiffness + 2. * viscous * stiffness;
  answer.internal =
      (&step.from == &step.to ? inelastic.after : (inelastic.before + inelastic.after) / 2.) +
      viscous * (stiffness * change);
}

double LinearCells::stored_in(const unsigned int cell, const Pose &pose) const {
  if (sections.has(cell))
    return sections.stored_in(cell, *pose.sections);
  PipeElement element(discretization);
  element.reinit(discretization.pipe_cell(cell));
  const Vector12 u = ends_of(cell, pose.dofs);
  return u.dot(element.stiffness() * u) / 2.;
}

Vector LinearCells::momenta(const Pose &, const Vector &velocity) const {
  Vector result = Vector::Zero(velocity.size());
  PipeElement element(discretization);
  std::vector<types::global_dof_index> dofs(12);
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const auto cell = discretization.pipe_cell(i);
    cell->get_dof_indices(dofs);
    const Vector12 share = element.mass(cell) * ends_of(i, velocity);
    for (unsigned int j = 0; j < 12; ++j)
      result[dofs[j]] += share[j];
  }
  for (unsigned int v = 0; v < n_vertices; ++v)
    add_part(point_mass[v] * part(velocity, v, 0), v, 0, result);
  return result;
}

LineCells::CellState LinearCells::state_of(const unsigned int index, const PipeElement &element,
                                           const Pose &pose,
                                           const std::vector<double> &factors) const {
  const auto cell = discretization.pipe_cell(index);
  const CellLoad load = load_on(discretization.pipe_cells()[index], element.profile(),
                                cell->vertex(1) - cell->vertex(0), factors);
  const Eigen::Vector3d line_force(load.line_force[0], load.line_force[1], load.line_force[2]);
  const Vector12 u = ends_of(index, pose.dofs);
  CellState state;
  state.ends = sections.has(index)
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
