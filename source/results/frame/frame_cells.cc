// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/rotation.h"
#include "results/frame/frame_builder.h"

namespace frictionbeam {

using namespace dealii;

namespace {

Vector3 to_deal(const Eigen::Vector3d &v) { return Vector3({v[0], v[1], v[2]}); }
Eigen::Vector3d to_eigen(const Vector3 &v) { return {v[0], v[1], v[2]}; }

} // namespace

std::array<double, 7> FrameBuilder::momentum_and_energy(const LineState &state) const {
  const Pose pose = pose_of(state);
  const Motion momentum =
      model.cells.momentum(pose, model.cells.velocities(state.velocity, state.load_rates));
  std::array<double, 7> result{};
  std::copy(momentum.begin(), momentum.end(), result.begin());
  result[6] = model.cells.kinetic_energy(pose, state.velocity, state.load_rates) +
              model.cells.stored_energy(pose);
  return result;
}

void FrameBuilder::add_cell(const LineState &state, const Pose &pose, const unsigned int index,
                            std::vector<Station> &line) {
  const PipeCell &pipe_cell = model.discretization.pipe_cells()[index];
  const auto cell = model.discretization.pipe_cell(index);
  element.reinit(cell);
  const LineCells::CellState of_cell =
      model.cells.state_of(index, element, pose, state.load_factors);
  for (const unsigned int v : {0u, 1u})
    for (unsigned int c = 0; c < 6; ++c)
      vertex_forces[cell->vertex_index(v)][c] += of_cell.ends[6 * v + c];
  const CellLoad load = model.cells.load_on(pipe_cell, element.profile(),
                                            cell->vertex(1) - cell->vertex(0), state.load_factors);
  Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
  if (of_cell.frame)
    back = of_cell.frame->turn.transpose();
  const CellCourse inertia = inertia_along(state, index, back);
  append(of_cell.frame ? stations_in(*of_cell.frame, of_cell, pose, index, load, inertia)
                       : stations_of(index, of_cell.ends,
                                     element.inside(of_cell.motions, of_cell.ends, load.pressure),
                                     load, inertia + beside_line_force(index, of_cell.ends, load)),
         line);
}

std::vector<Station> FrameBuilder::stations_in(const CellFrame &frame,
                                               const LineCells::CellState &of_cell,
                                               const Pose &pose, const unsigned int index,
                                               CellLoad load, const CellCourse &inertia) {
  // In the frame that goes along, the cell is the linear one, and so are its stations.
  const Eigen::Matrix3d back = frame.turn.transpose();
  PipeElement::Vector12 ends;
  for (int block = 0; block < 4; ++block)
    ends.segment<3>(3 * block) = back * of_cell.ends.segment<3>(3 * block);
  load.line_force = to_deal(back * to_eigen(load.line_force));
  std::vector<Station> stations =
      stations_of(index, ends, element.inside(of_cell.motions, ends, load.pressure), load,
                  inertia + beside_line_force(index, ends, load));

  // The frame carries the cell's first vertex to where it is: what is at X in it, moved by w, goes
  // to x_0 + turn (X + w - X_0 - w_0).
  const auto cell = model.discretization.pipe_cell(index);
  const unsigned int begin =
      cell->vertex_index(model.discretization.pipe_cells()[index].reversed ? 1 : 0);
  Eigen::Vector3d near;
  for (unsigned int d = 0; d < 3; ++d)
    near[d] = pose.dofs[model.discretization.vertex_dofs().index(begin, 3 + d)];
  for (Station &station : stations) {
    Eigen::Vector3d moved, spin;
    for (unsigned int d = 0; d < 3; ++d) {
      moved[d] = station.displacement[d];
      spin[d] = station.displacement[3 + d];
    }
    const Eigen::Vector3d arm = to_eigen(Vector3(station.position)) - frame.first,
                          now = frame.first_moved + frame.turn * (arm + moved - frame.own) - arm,
                          rotation = rotation_vector_near(
                              Eigen::Quaterniond(frame.turn) * turn_by(spin), near);
    station.y_now = to_deal(frame.turn * to_eigen(station.y));
    station.z_now = to_deal(frame.turn * to_eigen(station.z));
    for (unsigned int d = 0; d < 3; ++d) {
      station.displacement[d] = now[d];
      station.displacement[3 + d] = rotation[d];
    }
  }
  return stations;
}

} // namespace frictionbeam
