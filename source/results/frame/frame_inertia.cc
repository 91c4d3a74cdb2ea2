// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_builder.h"

#include "model/line/full_matrices.h"
#include "model/unknowns/restraint_forces.h"
#include "results/frame/section_forces.h"

namespace frictionbeam {

using namespace dealii;

void FrameBuilder::find_cells_at_restraints() {
  is_held.assign(model.discretization.n_line_vertices(), false);
  for (const auto &sites : model.mesh.restraints)
    for (const Site &site : sites)
      is_held[site.vertex] = true;
  for (const Load &load : model.scene.loads)
    if (load.kind == Load::Kind::displacement)
      for (const Load::AtPoint &at : load.at)
        is_held[model.mesh.points.at(at.point)] = true;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const auto cell = model.discretization.pipe_cell(i);
    if (!is_held[cell->vertex_index(0)] && !is_held[cell->vertex_index(1)])
      continue;
    HeldCell held;
    held.index = i;
    held.vertices = {{cell->vertex_index(0), cell->vertex_index(1)}};
    held.dofs.resize(12);
    cell->get_dof_indices(held.dofs);
    const Profile &profile = model.discretization.profiles()[cell->material_id()];
    held.mass = model.cells.mass_of(i, element);
    element.reinit(cell);
    held.stiffness = element.stiffness();
    const Vector3 chord = cell->vertex(1) - cell->vertex(0);
    for (unsigned int l = 0; l < model.scene.loads.size(); ++l) {
      const CellLoad load = cell_load(
          model.scene.loads[l], model.scene.pipes[model.discretization.pipe_cells()[i].pipe].name,
          profile, chord);
      const PipeElement::Vector12 forces =
          element.unit_line_loads() *
              Eigen::Vector3d(load.line_force[0], load.line_force[1], load.line_force[2]) +
          load.axial_strain * element.unit_axial_strain() +
          load.curvature * element.unit_curvature() + load.pressure * element.unit_thrust();
      if (!forces.isZero(0.))
        held.loads.emplace_back(l, forces);
    }
    held_cells.push_back(held);
  }
}

std::vector<Motion> FrameBuilder::reactions(const LineState &state) {
  Assert(model.cells.is_linear(), ExcMessage("Turned cells are evaluated with the frame."));
  begin(state);
  for (const HeldCell &cell : held_cells) {
    PipeElement::Vector12 u;
    for (unsigned int c = 0; c < 12; ++c)
      u[c] = state.dofs[cell.dofs[c]];
    PipeElement::Vector12 ends = cell.stiffness * u;
    for (const auto &[l, forces] : cell.loads)
      ends -= state.load_factors[l] * forces;
    for (const unsigned int v : {0u, 1u})
      for (unsigned int c = 0; c < 6; ++c)
        vertex_forces[cell.vertices[v]][c] += ends[6 * v + c];
  }
  add_vertex_forces(state, pose_of(state));
  add_inertia(state);
  return reactions_of_vertices(state);
}

std::vector<Motion> FrameBuilder::reactions_of_vertices(const LineState &state) const {
  std::vector<Motion> result = restraint_forces(
      model.scene, model.mesh, [&](const unsigned int vertex) { return vertex_forces[vertex]; });
  for (const Spring &spring : model.scene.springs)
    result.push_back(spring_force(state, spring));
  return result;
}

void FrameBuilder::begin(const LineState &state) {
  vertex_forces.assign(model.discretization.n_line_vertices(), Motion{});
  tells_inertia = given != nullptr || has_inertia(model, state);
}

Frame FrameBuilder::make(const LineState &state, const Vector &accelerations) {
  given = &accelerations;
  Frame frame = make(state);
  given = nullptr;
  return frame;
}

double FrameBuilder::acceleration(const LineState &state, const types::global_dof_index dof) const {
  return given != nullptr ? (*given)[dof] : damped_acceleration(model, state, dof);
}

PipeElement::Matrix12 FrameBuilder::mass_of(const unsigned int index) {
  return given != nullptr && model.scene.modal.lumped
             ? mass_of_cell(model.discretization.pipe_cell(index), true, element)
             : model.cells.mass_of(index, element);
}

CellCourse FrameBuilder::inertia_along(const LineState &state, const unsigned int index,
                                       const Eigen::Matrix3d &back) {
  if (!tells_inertia)
    return CellCourse::Zero();
  const auto cell = model.discretization.pipe_cell(index);
  std::vector<types::global_dof_index> dofs(12);
  cell->get_dof_indices(dofs);
  PipeElement::Vector12 accelerations;
  for (unsigned int i = 0; i < 12; ++i)
    accelerations[i] = acceleration(state, dofs[i]);
  PipeElement::Vector12 ends = mass_of(index) * accelerations;
  for (unsigned int part = 0; part < 12; part += 3)
    ends.segment<3>(part) = (back * ends.segment<3>(part)).eval();
  return in_balance(index, ends);
}

CellCourse FrameBuilder::in_balance(const unsigned int index, PipeElement::Vector12 ends) const {
  if (element.arc())
    return course_in_balance(ends, *element.arc());
  const auto cell = model.discretization.pipe_cell(index);
  const Vector3 chord = cell->vertex(1) - cell->vertex(0);
  Eigen::Vector3d axis(chord[0], chord[1], chord[2]);
  if (model.discretization.pipe_cells()[index].reversed) {
    ends.head<6>().swap(ends.tail<6>());
    axis *= -1.;
  }
  return course_in_balance(ends, axis);
}

CellCourse FrameBuilder::beside_line_force(const unsigned int index,
                                           const PipeElement::Vector12 &ends,
                                           const CellLoad &load) const {
  const PipeCell &pipe_cell = model.discretization.pipe_cells()[index];
  if (!model.cells.turns_far() && model.linear.solid_part(pipe_cell) == nullptr)
    return CellCourse::Zero();
  const unsigned int start = pipe_cell.reversed && !element.arc() ? 6 : 0;
  return in_balance(index, ends) - course_of(-ends.segment<6>(start), load.line_force);
}

void FrameBuilder::add_inertia(const LineState &state) {
  if (given == nullptr && is_at_rest(state))
    return;
  const auto add = [&](const unsigned int vertex, const unsigned int c, const double force) {
    if (is_held[vertex])
      vertex_forces[vertex][c] += force;
  };
  const TimeSettings &time = model.scene.time;
  for (const HeldCell &cell : held_cells) {
    PipeElement::Vector12 v, a;
    for (unsigned int c = 0; c < 12; ++c) {
      v[c] = model.linear.rate(cell.dofs[c], model.space, state.velocity, state.load_rates);
      a[c] = acceleration(state, cell.dofs[c]);
    }
    PipeElement::Vector12 forces = (given != nullptr ? mass_of(cell.index) : cell.mass) * a;
    // Velocities at a step's end stretch a cell that turns, which times its stiffness would be a
    // force where there is none: of turning cells the share of damping is left out.
    if (time.stiffness_damping != 0. && model.cells.is_linear())
      forces += time.stiffness_damping * (cell.stiffness * v);
    for (const unsigned int end : {0u, 1u})
      for (unsigned int c = 0; c < 6; ++c)
        add(cell.vertices[end], c, forces[6 * end + c]);
  }
  const VertexDofs &at = model.discretization.vertex_dofs();
  for (const PointMass &mass : model.scene.masses)
    for (const std::string &point : mass.points)
      for (unsigned int d = 0; d < 3; ++d) {
        const unsigned int vertex = model.mesh.points.at(point);
        add(vertex, d, mass.mass * acceleration(state, at.index(vertex, d)));
      }
}

} // namespace frictionbeam
