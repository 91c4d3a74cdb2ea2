// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/linear_part.h"

#include "base/user_error.h"
#include "model/line/modal_damping.h"
#include "model/line/pipe_element.h"
#include "model/line/point_loads.h"
#include "model/line/spring_extension.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

using namespace dealii;

CellLoad cell_load(const Load &load, const std::string &pipe, const Profile &profile,
                   const Vector3 &chord) {
  CellLoad result;
  if (!load.is_on(pipe))
    return result;
  switch (load.kind) {
  case Load::Kind::weight:
    result.line_force = profile.mass * load.vector;
    break;
  case Load::Kind::line_force:
    result.line_force = load.vector;
    break;
  case Load::Kind::temperature:
    result.axial_strain =
        profile.material.thermal_strain(load.installation, load.installation + load.value);
    break;
  case Load::Kind::pressure:
    result.axial_strain = profile.pressure_strain * load.value;
    result.curvature = profile.pressure_curvature * load.value;
    result.pressure = load.value;
    break;
  case Load::Kind::wind: {
    const double q = load.vector.norm();
    const Vector3 t = chord / chord.norm(), across = (load.vector - (load.vector * t) * t) / q;
    result.line_force = q * profile.wind_diameter * across.norm() * across;
    break;
  }
  case Load::Kind::force:
  case Load::Kind::displacement:
  case Load::Kind::preload:
    break;
  }
  return result;
}

namespace {

/// Pressure needs a bore to act on; a section that is given by its figures has none.
void check_pressure(const Scene &scene) {
  for (const Load &load : scene.loads)
    for (const Pipe &pipe : scene.pipes)
      if (load.kind == Load::Kind::pressure && scene.sections[pipe.section].wall == 0. &&
          (load.pipes.empty() || std::count(load.pipes.begin(), load.pipes.end(), pipe.name) > 0))
        throw UserError("Load " + load.name + " puts pressure into pipe '" + pipe.name +
                        "', whose section '" + scene.sections[pipe.section].name +
                        "' is given by its area and inertia and so has no bore. Give its outer "
                        "diameter and wall, or name the pipes under pressure in 'Pipes'.");
}

std::vector<types::global_dof_index> dofs_of_vertices(const VertexDofs &vertex_dofs,
                                                      const std::vector<unsigned int> &vertices) {
  std::vector<types::global_dof_index> dofs;
  for (const unsigned int v : vertices)
    for (unsigned int c = 0; c < 6; ++c)
      if (vertex_dofs.index(v, c) != numbers::invalid_dof_index)
        dofs.push_back(vertex_dofs.index(v, c));
  return dofs;
}

/// Unknowns of vertices, each once.
std::vector<int> unknowns_of(const std::vector<unsigned int> &vertices, const VertexDofs &dofs,
                             const ReducedSpace &space) {
  std::set<int> unknowns;
  for (const auto dof : dofs_of_vertices(dofs, vertices))
    for (const auto &term : space.terms(dof))
      unknowns.insert(term.unknown);
  return {unknowns.begin(), unknowns.end()};
}

/// Places for what springs and masses that turn couple, whatever their entries are now.
void add_places_of_points(const Scene &scene, const LineMesh &mesh,
                          const Discretization &discretization, const ReducedSpace &space,
                          MatrixEntries &entries) {
  const auto add = [&](const std::vector<unsigned int> &vertices) {
    entries.add_places(unknowns_of(vertices, discretization.vertex_dofs(), space));
  };
  for (const Spring &spring : scene.springs)
    if (spring.other.empty())
      add({mesh.points.at(spring.point)});
    else
      add({mesh.points.at(spring.point), mesh.points.at(spring.other)});
  for (const PointMass &mass : scene.masses)
    for (const std::string &point : mass.points)
      add({mesh.points.at(point)});
}

/// Those that a contact couples, and the others of its vertex: columns of a tangent's factors are
/// alike where they are coupled from the beginning.
std::vector<int> unknowns_at(const Contact &contact) {
  std::vector<int> result = contact.unknowns;
  for (const int unknown : contact.vertex_unknowns)
    if (std::find(result.begin(), result.end(), unknown) == result.end())
      result.push_back(unknown);
  return result;
}

/// Whether cells turn or yield, so that tangents of the line have other entries than its stiffness
/// now.
bool tangents_change(const Scene &scene, const Discretization &discretization) {
  const auto &profiles = discretization.profiles();
  return scene.kinematics == Kinematics::corotational ||
         std::any_of(profiles.begin(), profiles.end(),
                     [](const Profile &profile) { return profile.law.is_set(); });
}

/// @throws UserError for what a cell of a solid part cannot have in it
void check_solid_cell(const Scene &scene, const Discretization &discretization,
                      const Discretization::Cell &cell) {
  if (discretization.joints(cell) == nullptr)
    return;
  const unsigned int index = discretization.info(cell).index;
  throw UserError(
      "Pipe " + scene.pipes[discretization.pipe_cells()[index].pipe].name +
      ": a joint or tee stands on a stretch of it that is solid.\n  read:    a joint or "
      "the foot of a branch beside a solid bend\n  allowed: joints of the beams\n  "
      "try:     At in section Solid with the names of other bends");
}

} // namespace

LinearPart::LinearPart(const Scene &scene, const LineMesh &mesh,
                       const Discretization &discretization, const ReducedSpace &space,
                       const Contacts &contacts, const bool with_mass, std::vector<SolidPart> parts)
    : load_forces(scene.loads.size(), Vector::Zero(space.n_unknowns())),
      load_inertia(scene.loads.size()), load_drag(scene.loads.size()),
      moves_mass(scene.loads.size(), false), imposed_motions(scene.loads.size()),
      nodal_loads(scene.loads.size()), solid_parts(std::move(parts)) {
  check_pressure(scene);
  find_imposed_motions(scene, mesh, discretization, space, with_mass);
  find_nodal_loads(scene, mesh, discretization, space);
  const MatrixEntries::Zeros zeros = tangents_change(scene, discretization)
                                         ? MatrixEntries::Zeros::kept
                                         : MatrixEntries::Zeros::left_out;
  const std::size_t n_pipe_cells = discretization.pipe_cells().size(),
                    n_expected = n_pipe_cells * (zeros == MatrixEntries::Zeros::kept ? 144 : 40) +
                                 36 * contacts.size() + space.n_unknowns();
  MatrixEntries of_stiffness(zeros, n_expected), of_mass(zeros, with_mass ? n_expected : 0);
  add_pipes(scene, discretization, space, with_mass, of_stiffness, of_mass);
  add_solid_parts(discretization, space, of_stiffness);
  add_springs(scene, mesh, discretization, space, with_mass, of_stiffness);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    of_stiffness.add_places(unknowns_at(contacts[i]));
  if (zeros == MatrixEntries::Zeros::kept)
    add_places_of_points(scene, mesh, discretization, space, of_stiffness);
  K = of_stiffness.matrix(space.n_unknowns());
  if (with_mass) {
    add_point_masses(scene, mesh, discretization, space, of_mass);
    M = of_mass.matrix(space.n_unknowns());
    make_damping(scene, mesh, discretization, space);
  }
}

LinearPart::LinearPart(Matrices matrices)
    : K(std::move(matrices.stiffness)), M(std::move(matrices.mass)), C(std::move(matrices.damping)),
      load_forces(std::move(matrices.forces)), load_inertia(std::move(matrices.inertia)),
      load_drag(std::move(matrices.drag)), moves_mass(std::move(matrices.moves_mass)),
      imposed_motions(std::move(matrices.imposed)), products(std::move(matrices.products)),
      nodal_loads(load_forces.size()) {
  sort_imposed_motions();
}

void LinearPart::add_point_masses(const Scene &scene, const LineMesh &mesh,
                                  const Discretization &discretization, const ReducedSpace &space,
                                  MatrixEntries &of_mass) {
  for (const PointMass &mass : scene.masses)
    for (const std::string &point : mass.points) {
      const auto dofs = dofs_of_vertices(discretization.vertex_dofs(), {mesh.points.at(point)});
      const std::vector<types::global_dof_index> places(dofs.begin(), dofs.begin() + 3);
      const Eigen::Matrix3d local = mass.mass * Eigen::Matrix3d::Identity();
      space.add_local(local, places, of_mass);
      add_imposed(local, places, space, load_inertia, products.mass);
      add_imposed(scene.time.mass_damping * local, places, space, load_drag, products.damping);
    }
}

void LinearPart::make_damping(const Scene &scene, const LineMesh &mesh,
                              const Discretization &discretization, const ReducedSpace &space) {
  C.resize(K.rows(), K.cols());
  const TimeSettings &time = scene.time;
  if (time.mass_damping != 0. || time.stiffness_damping != 0.)
    C = time.mass_damping * M + time.stiffness_damping * K;
  if (time.modal_damping != 0.)
    for (const FrictionSupport &support : scene.supports)
      if (support.normal_force > 0.)
        throw UserError("Support " + support.name +
                        ": the platen of its Normal force has no mass, and 'Modal damping' needs "
                        "mass at all that can move. Press the pipe on by a load of kind force and "
                        "leave Normal force out, or use 'Mass damping' and 'Stiffness damping'.");
  if (time.modal_damping != 0.)
    C = C + modal_damping(K, M, time.modal_damping);
  MatrixEntries dashpots(MatrixEntries::Zeros::left_out);
  bool any = false;
  for (const Spring &spring : scene.springs)
    for (unsigned int c = 0; c < 6; ++c)
      if (spring.damping[c] != 0.) {
        const SpringExtension extension(spring, c, mesh, discretization.vertex_dofs());
        const Eigen::MatrixXd local = spring.damping[c] * extension.unit_stiffness();
        space.add_local(local, extension.dofs, dashpots);
        add_imposed(local, extension.dofs, space, load_drag, products.damping);
        any = true;
      }
  if (any)
    C = C + dashpots.matrix(space.n_unknowns());
}

void LinearPart::find_nodal_loads(const Scene &scene, const LineMesh &mesh,
                                  const Discretization &discretization, const ReducedSpace &space) {
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    nodal_loads[l] = point_loads(scene, mesh, load);
    for (const auto &[vertex, force] : nodal_loads[l])
      for (unsigned int c = 0; c < 6; ++c) {
        const auto dof = discretization.vertex_dofs().index(vertex, c);
        if (force[c] == 0.)
          continue;
        if (dof == numbers::invalid_dof_index || (c >= 3 && !discretization.turns(vertex, c - 3)))
          throw UserError("Load " + load.name +
                          " puts a moment on a point that has no rotations. "
                          "Leave the moment out.");
        for (const auto &term : space.terms(dof))
          load_forces[l][term.unknown] += term.weight * force[c];
      }
  }
}

void LinearPart::add_pipes(const Scene &scene, const Discretization &discretization,
                           const ReducedSpace &space, const bool with_mass,
                           MatrixEntries &of_stiffness, MatrixEntries &of_mass) {
  PipeElement element(discretization);
  std::vector<types::global_dof_index> dofs(12);
  for (const auto &cell : discretization.dof_handler().active_cell_iterators()) {
    const auto &info = discretization.info(cell);
    if (info.kind != Discretization::CellKind::pipe)
      continue;
    if (solid_part(discretization.pipe_cells()[info.index]) != nullptr) {
      check_solid_cell(scene, discretization, cell);
      continue;
    }
    const std::string &pipe = scene.pipes[discretization.pipe_cells()[info.index].pipe].name;
    cell->get_dof_indices(dofs);
    element.reinit(cell);
    const PipeElement::Matrix12 stiffness = element.stiffness();
    space.add_local(stiffness, dofs, of_stiffness);
    add_imposed(stiffness, dofs, space, load_forces, products.stiffness);
    if (with_mass) {
      const PipeElement::Matrix12 mass = element.mass(cell);
      space.add_local(mass, dofs, of_mass);
      add_imposed(mass, dofs, space, load_inertia, products.mass);
      add_imposed(scene.time.mass_damping * mass + scene.time.stiffness_damping * stiffness, dofs,
                  space, load_drag, products.damping);
    }

    const auto line = element.unit_line_loads();
    const PipeElement::Vector12 strain = element.unit_axial_strain(),
                                curvature = element.unit_curvature(),
                                thrust = element.unit_thrust();
    for (unsigned int l = 0; l < scene.loads.size(); ++l) {
      const CellLoad load =
          cell_load(scene.loads[l], pipe, element.profile(), cell->vertex(1) - cell->vertex(0));
      if (load.axial_strain == 0. && load.line_force.norm() == 0. && load.pressure == 0.)
        continue;
      const PipeElement::Vector12 forces =
          line * Eigen::Vector3d(load.line_force[0], load.line_force[1], load.line_force[2]) +
          load.axial_strain * strain + load.curvature * curvature + load.pressure * thrust;
      for (unsigned int i = 0; i < 12; ++i)
        for (const auto &term : space.terms(dofs[i]))
          load_forces[l][term.unknown] += term.weight * forces[i];
    }
  }
}

bool LinearPart::has_pressed_parts() const {
  return std::any_of(solid_parts.begin(), solid_parts.end(),
                     [](const SolidPart &part) { return part.pressed != nullptr; });
}

const SolidPart *LinearPart::solid_part(const PipeCell &cell) const {
  const auto found =
      std::find_if(solid_parts.begin(), solid_parts.end(),
                   [&](const SolidPart &part) { return part.has(cell.pipe, cell.position); });
  return found == solid_parts.end() ? nullptr : &*found;
}

void LinearPart::add_solid_parts(const Discretization &discretization, const ReducedSpace &space,
                                 MatrixEntries &of_stiffness) {
  for (const SolidPart &part : solid_parts) {
    const auto dofs = dofs_of_vertices(discretization.vertex_dofs(), part.vertices);
    space.add_local(part.stiffness, dofs, of_stiffness);
    add_imposed(part.stiffness, dofs, space, load_forces, products.stiffness);
    for (unsigned int l = 0; l < part.forces.size(); ++l)
      for (unsigned int i = 0; i < dofs.size(); ++i)
        for (const auto &term : space.terms(dofs[i]))
          load_forces[l][term.unknown] += term.weight * part.forces[l][i];
  }
}

void LinearPart::add_springs(const Scene &scene, const LineMesh &mesh,
                             const Discretization &discretization, const ReducedSpace &space,
                             const bool with_mass, MatrixEntries &of_stiffness) {
  const VertexDofs &vertex_dofs = discretization.vertex_dofs();
  for (const Spring &spring : scene.springs)
    for (unsigned int c = 0; c < 6; ++c) {
      if (spring.stiffness[c] == 0.)
        continue;
      const SpringExtension extension(spring, c, mesh, vertex_dofs);
      const auto &dofs = extension.dofs;
      const Eigen::MatrixXd local = spring.stiffness[c] * extension.unit_stiffness();
      space.add_local(local, dofs, of_stiffness);
      add_imposed(local, dofs, space, load_forces, products.stiffness);
      if (with_mass)
        add_imposed(scene.time.stiffness_damping * local, dofs, space, load_drag, products.damping);
    }
}

} // namespace frictionbeam
