// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_builder.h"

#include "model/cell/corotational_line.h"

namespace frictionbeam {

using namespace dealii;

namespace {

Vector3 to_deal(const Eigen::Vector3d &v) { return Vector3({v[0], v[1], v[2]}); }
Eigen::Vector3d to_eigen(const Vector3 &v) { return {v[0], v[1], v[2]}; }

} // namespace

std::array<double, 7> FrameBuilder::momentum_and_energy(const LineState &state) const {
  const CorotationalLine &line = *model.corotational;
  const Pose pose{state.dofs, state.turns};
  Vector velocity;
  model.space.expand(state.velocity, velocity);
  const Motion momentum = line.momentum(pose, velocity);
  std::array<double, 7> result{};
  std::copy(momentum.begin(), momentum.end(), result.begin());
  result[6] = line.kinetic_energy(pose, velocity) + line.stored_energy(pose);
  return result;
}

void FrameBuilder::add_turned_cell(const LineState &state, const unsigned int index,
                                   std::vector<Station> &line) {
  const PipeCell &pipe_cell = model.discretization.pipe_cells()[index];
  const auto cell = model.discretization.pipe_cell(index);
  element.reinit(cell);
  const Pose pose{state.dofs, state.turns};
  const CorotationalLine::CellState turned =
      model.corotational->cell(index, pose, state.load_factors);
  for (const unsigned int v : {0u, 1u})
    for (unsigned int c = 0; c < 6; ++c)
      vertex_forces[cell->vertex_index(v)][c] += turned.ends[6 * v + c];

  // In the frame that goes along, the cell is the linear one, and so are its stations.
  const Eigen::Matrix3d back = turned.turn.transpose();
  PipeElement::Vector12 ends;
  for (int block = 0; block < 4; ++block)
    ends.segment<3>(3 * block) = back * turned.ends.segment<3>(3 * block);
  CellLoad load = load_on(state, pipe_cell, element.profile(), cell->vertex(1) - cell->vertex(0));
  load.line_force = to_deal(back * to_eigen(load.line_force));
  std::vector<Station> stations =
      stations_of(index, ends, element.inside(turned.motions, ends, load.pressure), load);

  // The frame carries the cell's first vertex to where it is: what is at X in it, moved by w, goes
  // to x_0 + turn (X + w - X_0 - w_0).
  const Eigen::Vector3d first = to_eigen(Vector3(cell->vertex(0))), own = turned.motions.head<3>();
  Eigen::Vector3d first_moved, near;
  const unsigned int begin = cell->vertex_index(pipe_cell.reversed ? 1 : 0);
  for (unsigned int d = 0; d < 3; ++d) {
    const VertexDofs &dofs = model.discretization.vertex_dofs();
    first_moved[d] = pose.dofs[dofs.index(cell->vertex_index(0), d)];
    near[d] = pose.dofs[dofs.index(begin, 3 + d)];
  }
  for (Station &station : stations) {
    Eigen::Vector3d moved, spin;
    for (unsigned int d = 0; d < 3; ++d) {
      moved[d] = station.displacement[d];
      spin[d] = station.displacement[3 + d];
    }
    const Eigen::Vector3d arm = to_eigen(Vector3(station.position)) - first,
                          now = first_moved + turned.turn * (arm + moved - own) - arm,
                          rotation = rotation_vector_near(
                              Eigen::Quaterniond(turned.turn) * turn_by(spin), near);
    for (unsigned int d = 0; d < 3; ++d) {
      station.displacement[d] = now[d];
      station.displacement[3 + d] = rotation[d];
    }
  }
  append(stations, line);
}

} // namespace frictionbeam
