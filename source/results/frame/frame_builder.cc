// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/section_forces.h"

#include "results/frame/frame_builder.h"
#include "results/support/support_states.h"

#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

Quadrature<1> station_points(const unsigned int n) {
  std::vector<Point<1>> points;
  for (unsigned int i = 1; i <= n; ++i)
    points.emplace_back(static_cast<double>(i) / (n + 1));
  return Quadrature<1>(points);
}

/// Motion inside a straight clamped cell under its own load, which the shape functions leave out
/// (w_p in doc/theory.md, "The pipe").
/// @param line_force on the cell [N/m] @param x from its beginning [m] @param rest to its end [m]
Tensor<1, 6> clamped_motion(const Profile &profile, const Vector3 &axis, const Vector3 &line_force,
                            const double x, const double rest) {
  const Vector3 across = line_force - (line_force * axis) * axis;
  Vector3 bubble = x * rest / (2. * profile.EA) * (line_force - across);
  bubble += x * x * rest * rest / (24. * profile.EI) * across;
  if (profile.GA > 0.)
    bubble += x * rest / (2. * profile.GA) * across;
  const Vector3 turn = cross_product_3d(axis, x * rest * (rest - x) / (12. * profile.EI) * across);
  Tensor<1, 6> result;
  for (unsigned int d = 0; d < 3; ++d) {
    result[d] = bubble[d];
    result[3 + d] = turn[d];
  }
  return result;
}

} // namespace

FrameBuilder::FrameBuilder(const Model &model, const bool both_sides)
    : model(model), both_sides(both_sides), element(model.discretization),
      station_values(model.discretization.elements()[0],
                     station_points(model.scene.output.stations), update_values) {
  const auto &cells = model.discretization.pipe_cells();
  for (unsigned int i = 0; i < cells.size(); ++i)
    if (cells[i].position == 0)
      first_cell.push_back(i);
  // deal.II takes over what it computed of a like cell before, which differs by rounding: the first
  // frame of a resumed run shall be computed as one among many.
  for (unsigned int i = 0; i < cells.size(); ++i)
    element.reinit(model.discretization.pipe_cell(i));
  find_cells_at_restraints();
  find_places();
}

std::vector<RestraintInfo> FrameBuilder::restraint_infos() const {
  std::vector<RestraintInfo> infos;
  for (unsigned int i = 0; i < model.scene.restraints.size(); ++i)
    for (unsigned int site = 0; site < model.mesh.restraints[i].size(); ++site)
      infos.push_back(
          {name_of_place(model.scene.restraints[i].name, site, model.mesh.restraints[i].size() > 1),
           model.scene.restraints[i].kind,
           model.mesh.vertices[model.mesh.restraints[i][site].vertex],
           model.scene.restraints[i].capacity});
  for (const Spring &spring : model.scene.springs)
    infos.push_back(
        {spring.name, spring.kind, model.mesh.vertices[model.mesh.points.at(spring.point)]});
  return infos;
}

Motion FrameBuilder::motion(const LineState &state, const std::string &point) const {
  Motion result{};
  for (unsigned int c = 0; c < 6; ++c) {
    const auto dof = model.discretization.vertex_dofs().index(model.mesh.points.at(point), c);
    if (dof != numbers::invalid_dof_index)
      result[c] = state.dofs[dof];
  }
  return result;
}

Motion FrameBuilder::velocity(const LineState &state, const std::string &point) const {
  Motion result{};
  for (unsigned int c = 0; c < 6; ++c) {
    const auto dof = model.discretization.vertex_dofs().index(model.mesh.points.at(point), c);
    if (dof != numbers::invalid_dof_index)
      result[c] = model.linear.rate(dof, model.space, state.velocity, state.load_rates);
  }
  return result;
}

Motion FrameBuilder::spring_force(const LineState &state, const Spring &spring) const {
  /// Of the first point against the second, or against the ground.
  const auto relative = [&](const auto &of_point) {
    Motion result = of_point(spring.point);
    if (!spring.other.empty()) {
      const Motion other = of_point(spring.other);
      for (unsigned int c = 0; c < 6; ++c)
        result[c] -= other[c];
    }
    return result;
  };
  Motion force{};
  const auto push = [&](const Motion &direction, const double size) {
    for (unsigned int c = 0; c < 6; ++c)
      force[c] += size * direction[c];
  };
  const Motion moved = relative([&](const std::string &point) { return motion(state, point); });
  for (unsigned int k = 0; k < 6; ++k)
    push(spring.directions[k], -spring.stiffness[k] * product(spring.directions[k], moved));
  for (unsigned int l = 0; l < state.load_factors.size(); ++l)
    if (model.scene.loads[l].kind == Load::Kind::preload)
      push(spring.directions[2], state.load_factors[l] * spring.preload);
  if (state.velocity.size() == 0)
    return force;
  const Motion rate = relative([&](const std::string &point) { return velocity(state, point); });
  for (unsigned int k = 0; k < 6; ++k)
    push(spring.directions[k],
         -(spring.damping[k] + model.scene.time.stiffness_damping * spring.stiffness[k]) *
             product(spring.directions[k], rate));
  return force;
}

Frame FrameBuilder::make(const LineState &state) {
  Frame frame;
  frame.time = state.time;
  const Pose pose = pose_of(state);
  begin(state);
  frame.line.reserve(model.discretization.pipe_cells().size() * (model.scene.output.stations + 2));
  for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
    add_pipe(state, pose, p, frame.line);
  add_vertex_forces(state, pose);
  add_inertia(state);
  for (unsigned int i = 0; i < model.contacts.places().size(); ++i)
    frame.supports.push_back(support_state(model, state, i));
  frame.reactions = reactions_of_vertices(state);
  frame.together = together(state, frame);
  return frame;
}

std::vector<Station> FrameBuilder::stations() {
  LineState at_rest;
  at_rest.load_factors.assign(model.scene.loads.size(), 0.);
  const Pose pose = model.cells.at_rest();
  begin(at_rest);
  std::vector<Station> line;
  for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
    add_pipe(at_rest, pose, p, line);
  return line;
}

void FrameBuilder::add_pipe(const LineState &state, const Pose &pose, const unsigned int pipe,
                            std::vector<Station> &line) {
  const unsigned int n = model.mesh.pipes[pipe].bend_radius.size();
  for (unsigned int i = 0; i < n; ++i)
    add_cell(state, pose, first_cell[pipe] + i, line);
}

void FrameBuilder::append(const std::vector<Station> &stations, std::vector<Station> &line) const {
  begin_cell(stations.front(), line);
  line.insert(line.end(), stations.begin() + 1, stations.end());
}

std::vector<Station> FrameBuilder::stations_of(const unsigned int index,
                                               const PipeElement::Vector12 &ends,
                                               const PipeElement::Vector12 &u, const CellLoad &load,
                                               const CellCourse &inertia) {
  const PipeCell &pipe_cell = model.discretization.pipe_cells()[index];
  if (element.arc())
    return stations_of_arc(pipe_cell, ends, u, load, inertia);
  const MeshedPipe &meshed = model.mesh.pipes[pipe_cell.pipe];
  const auto cell = model.discretization.pipe_cell(index);
  // From here on in the direction of the route: F and M act on the face that looks forward.
  const unsigned int start = pipe_cell.reversed ? 6 : 0;
  const Point3 begin = cell->vertex(pipe_cell.reversed ? 1 : 0);
  const Vector3 axis = cell->vertex(pipe_cell.reversed ? 0 : 1) - begin;
  const LocalAxes axes(axis);
  const double length = axis.norm();
  const CellCourse course = course_of(-ends.segment<6>(start), load.line_force) + inertia;
  const auto station = [&](const double x) {
    Station result;
    result.pipe = pipe_cell.pipe;
    result.s = meshed.s[pipe_cell.position] +
               x / length * (meshed.s[pipe_cell.position + 1] - meshed.s[pipe_cell.position]);
    result.position = begin + x * axes.x;
    const auto [F, M] = section_of_straight(course, axes.x, x);
    result.force = {F * axes.x, F * axes.y, F * axes.z, M * axes.x, M * axes.y, M * axes.z};
    result.pressure = load.pressure;
    place(pipe_cell, axes, result);
    return result;
  };
  const auto at_node = [&](const double x, const unsigned int first) {
    Station result = station(x);
    result.vertex = meshed.vertices[pipe_cell.position + (x > 0.)];
    for (unsigned int c = 0; c < 6; ++c)
      result.displacement[c] = u[first + c];
    return result;
  };

  std::vector<Station> stations = {at_node(0., start)};
  const unsigned int n = model.scene.output.stations;
  const Eigen::Matrix3d turn = local_axes(cell).transpose();
  PipeElement::Vector12 local;
  for (int first = 0; first < 12; first += 3)
    local.segment<3>(first) = turn * u.segment<3>(first);
  const StationShapes &shapes = shapes_of(cell);
  for (unsigned int i = 0; i < n; ++i) {
    const double x = length * (i + 1) / (n + 1);
    Station result = station(x);
    const unsigned int q = pipe_cell.reversed ? n - 1 - i : i;
    const Eigen::Matrix<double, 6, 1> inside = shapes[q] * local;
    Eigen::Map<Eigen::Vector3d>(&result.displacement[0]) = turn.transpose() * inside.head<3>();
    Eigen::Map<Eigen::Vector3d>(&result.displacement[3]) = turn.transpose() * inside.tail<3>();
    const Tensor<1, 6> clamped =
        clamped_motion(element.profile(), axes.x, load.line_force, x, length - x);
    for (unsigned int c = 0; c < 6; ++c)
      result.displacement[c] += clamped[c];
    stations.push_back(result);
  }
  stations.push_back(at_node(length, 6 - start));
  return stations;
}

const FrameBuilder::StationShapes &FrameBuilder::shapes_of(const Discretization::Cell &cell) {
  constexpr std::size_t most_kept = 1000; // as PipeElement
  const Discretization::Cell first = model.discretization.like(cell);
  if (station_shapes.size() > most_kept)
    station_shapes.clear();
  const auto [entry, is_new] = station_shapes.try_emplace(first->active_cell_index());
  if (!is_new)
    return entry->second;
  const Eigen::Matrix3d turn = local_axes(first).transpose();
  station_values.reinit(first);
  for (unsigned int q = 0; q < station_values.n_quadrature_points; ++q) {
    Eigen::Matrix<double, 6, 12> shapes;
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int c = 0; c < 6; ++c)
        shapes(c, j) = station_values.shape_value_component(j, q, c);
    for (int row = 0; row < 6; row += 3)
      for (int column = 0; column < 12; column += 3)
        shapes.block<3, 3>(row, column) =
            (turn * shapes.block<3, 3>(row, column) * turn.transpose()).eval();
    entry->second.push_back(shapes);
  }
  return entry->second;
}

void FrameBuilder::place(const PipeCell &pipe_cell, const LocalAxes &axes, Station &station) const {
  const MeshedPipe &meshed = model.mesh.pipes[pipe_cell.pipe];
  station.y = station.y_now = axes.y;
  station.z = station.z_now = axes.z;
  station.part = station.s / meshed.s.back();
  station.bend_radius = meshed.bend_radius[pipe_cell.position];
  if (const auto axis = meshed.bend_axis.find(pipe_cell.position); axis != meshed.bend_axis.end())
    station.bend_axis = axis->second;
}

void FrameBuilder::begin_cell(const Station &first, std::vector<Station> &line) const {
  if (both_sides || line.empty() || line.back().pipe != first.pipe ||
      section_forces_jump(line.back().force, first.force))
    line.push_back(first);
}

std::vector<Station> FrameBuilder::stations_of_arc(const PipeCell &pipe_cell,
                                                   const PipeElement::Vector12 &ends,
                                                   const PipeElement::Vector12 &motions,
                                                   const CellLoad &load,
                                                   const CellCourse &inertia) const {
  const ArcBeam &arc = *element.arc();
  const MeshedPipe &meshed = model.mesh.pipes[pipe_cell.pipe];
  const unsigned int n = model.scene.output.stations, n_stations = n + 2;
  const CellCourse course = course_of(-ends.head<6>(), load.line_force) + inertia;
  FullMatrix<double> shapes, slopes;
  std::vector<Station> stations;
  for (unsigned int i = 0; i < n_stations; ++i) {
    // Along the route; psi along the deal.II cell.
    const double part = static_cast<double>(i) / (n + 1),
                 psi = arc.angle() * (pipe_cell.reversed ? 1. - part : part);
    Station station;
    station.pipe = pipe_cell.pipe;
    if (i == 0 || i == n + 1)
      station.vertex = meshed.vertices[pipe_cell.position + (i > 0)];
    station.s = meshed.s[pipe_cell.position] +
                part * (meshed.s[pipe_cell.position + 1] - meshed.s[pipe_cell.position]);
    station.position = arc.point(psi);
    arc.shapes(psi, shapes, slopes);
    Tensor<1, 6> clamped; // at the nodes there is none
    if (!station.is_node())
      clamped = arc.clamped_motion(psi, load.line_force, load.axial_strain, load.curvature);
    for (unsigned int c = 0; c < 6; ++c) {
      station.displacement[c] = clamped[c];
      for (unsigned int j = 0; j < 12; ++j)
        station.displacement[c] += shapes(c, j) * motions[j];
    }
    auto [F, M] = section_of_arc(course, arc, psi);
    const LocalAxes axes((pipe_cell.reversed ? -1. : 1.) * arc.tangent(psi));
    if (pipe_cell.reversed) { // the face that looks forward along the route is the other one
      F *= -1.;
      M *= -1.;
    }
    station.force = {F * axes.x, F * axes.y, F * axes.z, M * axes.x, M * axes.y, M * axes.z};
    station.pressure = load.pressure;
    place(pipe_cell, axes, station);
    stations.push_back(station);
  }
  return stations;
}

void FrameBuilder::add_vertex_forces(const LineState &state, const Pose &pose) {
  for (unsigned int l = 0; l < state.load_factors.size(); ++l)
    for (const auto &entry : model.linear.nodal(l)) {
      if (model.scene.loads[l].kind == Load::Kind::preload) // the springs below have it
        continue;
      const unsigned int vertex = entry.first;
      const Motion force = model.cells.nodal_load(l, vertex, pose);
      for (unsigned int c = 0; c < 6; ++c)
        vertex_forces[vertex][c] -= state.load_factors[l] * force[c];
    }
  for (const Spring &spring : model.scene.springs) {
    const Motion force = spring_force(state, spring);
    for (unsigned int c = 0; c < 6; ++c) {
      vertex_forces[model.mesh.points.at(spring.point)][c] -= force[c];
      if (!spring.other.empty())
        vertex_forces[model.mesh.points.at(spring.other)][c] += force[c];
    }
  }
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const auto &vertices = model.contacts[i].vertices;
    for (const unsigned int side : {0u, 1u})
      if (vertices[side] < vertex_forces.size()) {
        const Motion force = force_of_contact(model, i, state.contact_stress[i], side);
        for (unsigned int c = 0; c < 6; ++c)
          vertex_forces[vertices[side]][c] -= force[c];
      }
  }
}

} // namespace frictionbeam
