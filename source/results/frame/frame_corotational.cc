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
  const MeshedPipe &meshed = model.mesh.pipes[pipe_cell.pipe];
  const auto cell = model.discretization.pipe_cell(index);
  const Pose pose{state.dofs, state.turns};
  const CorotationalLine::CellState turned =
      model.corotational->cell(index, pose, state.load_factors);
  for (const unsigned int v : {0u, 1u})
    for (unsigned int c = 0; c < 6; ++c)
      vertex_forces[cell->vertex_index(v)][c] += turned.ends[6 * v + c];

  // In the direction of the route, in the cell's frame: F' = -q, M' = -x cross F.
  const unsigned int start = pipe_cell.reversed ? 6 : 0, first = pipe_cell.reversed ? 1 : 0;
  const Vector3 route = cell->vertex(1 - first) - cell->vertex(first);
  const double length = route.norm();
  LocalAxes axes(route);
  const LocalAxes at_rest = axes;
  for (Vector3 *const axis : {&axes.x, &axes.y, &axes.z})
    *axis = to_deal(turned.turn * to_eigen(*axis));
  const Profile &profile = model.discretization.profiles()[cell->material_id()];
  const Vector3 q = load_on(state, pipe_cell, profile, route).line_force,
                force = to_deal(-turned.ends.segment<3>(start)),
                moment = to_deal(-turned.ends.segment<3>(start + 3));
  const auto station = [&](const double x) {
    Station result;
    result.pipe = pipe_cell.pipe;
    result.s = meshed.s[pipe_cell.position] +
               x / length * (meshed.s[pipe_cell.position + 1] - meshed.s[pipe_cell.position]);
    result.position = cell->vertex(first) + x * at_rest.x;
    const Vector3 F = force - x * q,
                  M = moment - cross_product_3d(axes.x, x * force - x * x / 2. * q);
    result.force = {F * axes.x, F * axes.y, F * axes.z, M * axes.x, M * axes.y, M * axes.z};
    place(pipe_cell, at_rest, result);
    return result;
  };
  const auto at_node = [&](const double x, const unsigned int node) {
    Station result = station(x);
    for (unsigned int c = 0; c < 6; ++c)
      result.displacement[c] =
          pose.dofs[model.discretization.vertex_dofs().index(cell->vertex_index(node), c)];
    return result;
  };

  const Station begin = at_node(0., first);
  begin_cell(begin, line);
  station_values.reinit(cell);
  const CorotationalBeam::Vector12 &u = turned.motions;
  const unsigned int n = model.scene.output.stations;
  for (unsigned int i = 0; i < n; ++i) {
    const double x = length * (i + 1) / (n + 1);
    Station result = station(x);
    result.node = false;
    const unsigned int point = pipe_cell.reversed ? n - 1 - i : i;
    Eigen::Matrix<double, 6, 1> local = Eigen::Matrix<double, 6, 1>::Zero();
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int c = 0; c < 6; ++c)
        local[c] += u[j] * station_values.shape_value_component(j, point, c);
    // The elastic motions of the cell count from its first deal.II vertex, the route's place from
    // its own.
    const Eigen::Vector3d own = pipe_cell.reversed ? Eigen::Vector3d(u.segment<3>(6))
                                                   : Eigen::Vector3d(u.segment<3>(0)),
                          arm = x * to_eigen(at_rest.x),
                          place_now = turned.turn * (arm + local.head<3>() - own) - arm;
    const Eigen::Vector3d rotation =
        rotation_vector_near(Eigen::Quaterniond(turned.turn) * turn_by(local.tail<3>()),
                             {begin.displacement[3], begin.displacement[4], begin.displacement[5]});
    for (unsigned int d = 0; d < 3; ++d) {
      result.displacement[d] = begin.displacement[d] + place_now[d];
      result.displacement[3 + d] = rotation[d];
    }
    line.push_back(result);
  }
  line.push_back(at_node(length, 1 - first));
}

} // namespace frictionbeam
