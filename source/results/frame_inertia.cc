// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/frame_builder.h>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Of displacements linear along a cell, without rotary inertia.
PipeElement::Matrix12 mass_in_any_frame(const double mass) {
  PipeElement::Matrix12 result = PipeElement::Matrix12::Zero();
  for (unsigned int d = 0; d < 3; ++d) {
    result(d, d) = result(6 + d, 6 + d) = mass / 3.;
    result(d, 6 + d) = result(6 + d, d) = mass / 6.;
  }
  return result;
}

} // namespace

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
    if (is_held[cell->vertex_index(0)] || is_held[cell->vertex_index(1)])
      cells_at_restraints.push_back(i);
  }
}

void FrameBuilder::add_inertia(const LineState &state) {
  const bool at_rest =
      state.load_rates.empty() && state.velocity.isZero(0.) && state.acceleration.isZero(0.);
  if (at_rest)
    return;
  Vector velocity, acceleration;
  model.space.expand(state.velocity, velocity);
  model.space.expand(state.acceleration, acceleration);
  for (unsigned int l = 0; l < state.load_rates.size(); ++l)
    for (const auto &[dof, value] : model.linear.imposed(l)) {
      velocity[dof] += state.load_rates[l] * value;
      acceleration[dof] += state.load_accelerations[l] * value;
    }
  const auto add = [&](const unsigned int vertex, const unsigned int c, const double force) {
    if (is_held[vertex])
      vertex_forces[vertex][c] += force;
  };
  const TimeSettings &time = model.scene.time;
  std::vector<types::global_dof_index> dofs(12);
  for (const unsigned int i : cells_at_restraints) {
    const auto cell = model.discretization.pipe_cell(i);
    cell->get_dof_indices(dofs);
    PipeElement::Vector12 v, a;
    for (unsigned int c = 0; c < 12; ++c) {
      v[c] = velocity[dofs[c]];
      a[c] = acceleration[dofs[c]];
    }
    const Profile &profile = model.discretization.profiles()[cell->material_id()];
    const PipeElement::Matrix12 mass = model.corotational
                                           ? mass_in_any_frame(profile.mass * cell->diameter())
                                           : element.mass(cell);
    PipeElement::Vector12 forces = mass * (a + time.mass_damping * v);
    if (time.stiffness_damping != 0. && !model.corotational)
      forces += time.stiffness_damping * (element.stiffness() * v);
    for (const unsigned int end : {0u, 1u})
      for (unsigned int c = 0; c < 6; ++c)
        add(cell->vertex_index(end), c, forces[6 * end + c]);
  }
  const VertexDofs &at = model.discretization.vertex_dofs();
  for (const PointMass &mass : model.scene.masses)
    for (const std::string &point : mass.points)
      for (unsigned int d = 0; d < 3; ++d) {
        const unsigned int vertex = model.mesh.points.at(point);
        const auto dof = at.index(vertex, d);
        add(vertex, d, mass.mass * (acceleration[dof] + time.mass_damping * velocity[dof]));
      }
  for (const Spring &spring : model.scene.springs)
    for (unsigned int c = 0; c < 6; ++c) {
      const double damping = spring.damping[c] + time.stiffness_damping * spring.stiffness[c];
      if (damping == 0.)
        continue;
      const unsigned int one = model.mesh.points.at(spring.point);
      double rate = velocity[at.index(one, c)];
      if (!spring.other.empty()) {
        const unsigned int other = model.mesh.points.at(spring.other);
        rate -= velocity[at.index(other, c)];
        add(other, c, -damping * rate);
      }
      add(one, c, damping * rate);
    }
}

} // namespace frictionbeam
