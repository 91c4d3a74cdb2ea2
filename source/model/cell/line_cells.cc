// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/line_cells.h"

#include "model/line/spring_extension.h"

#include "model/cell/rotation.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

using namespace dealii;
using Eigen::Vector3d;

LineCells::LineCells(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                     const ReducedSpace &space, const LinearPart &linear)
    : scene(scene), mesh(mesh), discretization(discretization), space(space), linear(linear),
      sections(scene, discretization), sections_at_rest(sections.at_rest()),
      n_vertices(discretization.n_line_vertices()), point_mass(n_vertices, 0.) {
  for (const PointMass &mass : scene.masses)
    for (const std::string &point : mass.points)
      point_mass[mesh.points.at(point)] += mass.mass;
}

void LineCells::add_stiffness(const unsigned int cell, const CellAnswer &answer,
                              SparseMatrix &matrix) const {
  if (places_in_stiffness.empty())
    places_in_stiffness.resize(discretization.pipe_cells().size());
  std::vector<Entry> &entries = places_in_stiffness[cell];
  if (entries.empty())
    for (int i = 0; i < 12; ++i)
      for (const auto &row : space.terms(answer.dofs[i]))
        for (int j = 0; j < 12; ++j)
          for (const auto &column : space.terms(answer.dofs[j]))
            entries.push_back({&matrix.coeffRef(row.unknown, column.unknown) - matrix.valuePtr(),
                               12 * j + i, row.weight * column.weight});
  for (const Entry &entry : entries)
    matrix.valuePtr()[entry.place] += entry.weight * answer.stiffness.data()[entry.local];
}

Vector3d LineCells::part(const Vector &dofs, const unsigned int vertex,
                         const unsigned int first) const {
  Vector3d result = Vector3d::Zero();
  for (unsigned int d = 0; d < 3; ++d)
    if (const auto dof = discretization.vertex_dofs().index(vertex, first + d);
        dof != numbers::invalid_dof_index)
      result[d] = dofs[dof];
  return result;
}

void LineCells::add_part(const Vector3d &value, const unsigned int vertex, const unsigned int first,
                         Vector &dofs) const {
  for (unsigned int d = 0; d < 3; ++d)
    if (const auto dof = discretization.vertex_dofs().index(vertex, first + d);
        dof != numbers::invalid_dof_index)
      dofs[dof] += value[d];
}

namespace {
/// Whether states of sections at the end are to be found: not of a step that has been taken.
bool integrates_sections(const LineCells::Step &step) {
  return step.to.sections == step.from.sections && !step.is_trial;
}
} // namespace

void LineCells::evaluate(const Step &step, const std::vector<double> &factors,
                         Balance &balance) const {
  balance.loads = balance.internal = Vector::Zero(space.n_dofs());
  if (!step.without_stiffness) {
    Assert(!is_linear(), ExcMessage("The stiffness of linear cells has no places for tangents."));
    balance.stiffness = linear.stiffness(); // its pattern
    std::fill(balance.stiffness.valuePtr(),
              balance.stiffness.valuePtr() + balance.stiffness.nonZeros(), 0.);
  }
  balance.largest = balance.free = balance.free_work = balance.damping = 0.;
  balance.section_error = 0.;
  balance.failure = nullptr;
  CellAnswer of_cell;
  if (sections.any()) {
    Assert(step.from.sections != nullptr, ExcMessage("A pose of such a line has states."));
    if (balance.sections.size() != sections_at_rest.size() && integrates_sections(step))
      balance.sections = sections_at_rest;
    of_cell.sections = &balance.sections;
  }
  const unsigned int n_cells = discretization.pipe_cells().size();
  const bool keeps_start = turns_far() && &step.from != &step.to;
  if (keeps_start && !(step.is_near_last && balance.at_start.cols() == n_cells))
    balance.at_start.setConstant(8, n_cells, std::numeric_limits<double>::quiet_NaN());
  for (unsigned int i = 0; i < n_cells; ++i) {
    of_cell.at_start = keeps_start ? balance.at_start.col(i).data() : nullptr;
    of_cell.failure = nullptr;
    answer(i, step, factors, of_cell);
    if (!step.without_stiffness)
      add_stiffness(i, of_cell, balance.stiffness);
    for (unsigned int j = 0; j < 12; ++j) {
      balance.internal[of_cell.dofs[j]] += of_cell.internal[j];
      balance.loads[of_cell.dofs[j]] += of_cell.loads[j];
    }
    balance.largest = std::max({balance.largest, of_cell.internal.lpNorm<Eigen::Infinity>(),
                                of_cell.loads.lpNorm<Eigen::Infinity>()});
    balance.free = std::max(balance.free, of_cell.free.lpNorm<Eigen::Infinity>());
    balance.free_work += of_cell.free_work;
    balance.damping += of_cell.damping;
    if (of_cell.failure != nullptr)
      balance.failure = of_cell.failure;
    balance.section_error = std::max(balance.section_error, of_cell.section_error);
  }
  add_springs(step, balance);
  if (step.duration > 0.)
    add_modal_damping(step, balance);
  add_nodal_loads(step, factors, balance);
  balance.forces = space.restrict_forces(balance.loads - balance.internal);
}

void LineCells::add_springs(const Step &step, Balance &balance) const {
  for (const Spring &spring : scene.springs)
    for (unsigned int c = 0; c < 6; ++c)
      if (spring.stiffness[c] != 0. || (spring.damping[c] != 0. && step.duration > 0.))
        add_spring(spring, c, step, balance);
}

void LineCells::add_spring(const Spring &spring, const unsigned int c, const Step &step,
                           Balance &balance) const {
  const SpringExtension e(spring, c, mesh, discretization.vertex_dofs());
  const double k = spring.stiffness[c],
               viscous =
                   step.duration > 0.
                       ? (scene.time.stiffness_damping * k + spring.damping[c]) / step.duration
                       : 0.,
               change = viscous != 0. ? e.of(step.change) : 0.;
  const Eigen::VectorXd force =
      (k * (e.of(step.from.dofs) + e.of(step.to.dofs)) / 2. + viscous * change) * e.weights;
  balance.damping += viscous * change * change;
  for (unsigned int i = 0; i < e.dofs.size(); ++i)
    balance.internal[e.dofs[i]] += force[i];
  balance.largest = std::max(balance.largest, force.lpNorm<Eigen::Infinity>());
  if (!step.without_stiffness)
    space.add_local((k + 2. * viscous) * e.unit_stiffness(), e.dofs, balance.stiffness);
}

Motion LineCells::nodal_load(const unsigned int load, const unsigned int vertex,
                             const Pose &) const {
  return linear.nodal(load).at(vertex);
}

void LineCells::add_nodal_loads(const Step &step, const std::vector<double> &factors,
                                Balance &balance) const {
  for (unsigned int l = 0; l < factors.size(); ++l) {
    if (factors[l] == 0.)
      continue;
    for (const auto &entry : linear.nodal(l)) {
      const unsigned int vertex = entry.first;
      Eigen::Matrix<double, 6, 1> force;
      const Motion value = nodal_load(l, vertex, step.half);
      std::vector<types::global_dof_index> dofs;
      for (unsigned int c = 0; c < 6; ++c) {
        force[c] = factors[l] * value[c];
        if (const auto dof = discretization.vertex_dofs().index(vertex, c);
            dof != numbers::invalid_dof_index) {
          dofs.push_back(dof);
          balance.loads[dof] += force[c];
        }
      }
      balance.largest = std::max(balance.largest, force.lpNorm<Eigen::Infinity>());
      if (step.without_stiffness || !scene.loads[l].follows || dofs.size() < 6)
        continue;
      Eigen::Matrix<double, 6, 6> turning = Eigen::Matrix<double, 6, 6>::Zero();
      turning.block<3, 3>(0, 3) = skew(force.head<3>());
      turning.block<3, 3>(3, 3) = skew(force.tail<3>());
      space.add_local(turning, dofs, balance.stiffness);
    }
  }
}

double LineCells::extension(const Spring &spring, const unsigned int c, const Vector &dofs) const {
  return SpringExtension(spring, c, mesh, discretization.vertex_dofs()).of(dofs);
}

double LineCells::stored_energy(const Pose &pose) const {
  double energy = 0.;
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i)
    energy += stored_in(i, pose);
  for (const Spring &spring : scene.springs)
    for (unsigned int c = 0; c < 6; ++c)
      if (spring.stiffness[c] != 0.) {
        const double u = extension(spring, c, pose.dofs);
        energy += spring.stiffness[c] * u * u / 2.;
      }
  return energy;
}

Vector LineCells::velocities(const Vector &velocity, const std::vector<double> &rates) const {
  Vector result = Vector::Zero(space.n_dofs());
  if (velocity.size() > 0)
    space.expand(velocity, result);
  for (unsigned int l = 0; l < rates.size(); ++l)
    if (rates[l] != 0.)
      for (const auto &[dof, value] : linear.imposed(l))
        result[dof] += rates[l] * value;
  return result;
}

double LineCells::kinetic_energy(const Pose &pose, const Vector &velocity,
                                 const std::vector<double> &rates) const {
  const Vector all = velocities(velocity, rates);
  return all.dot(momenta(pose, all)) / 2.;
}

Motion LineCells::momentum(const Pose &pose, const Vector &velocity) const {
  const Vector momenta_of_dofs = momenta(pose, velocity);
  Vector3d linear_sum = Vector3d::Zero(), angular_sum = Vector3d::Zero();
  for (unsigned int v = 0; v < n_vertices; ++v) {
    const Point3 &rest = discretization.vertices()[v];
    const Vector3d place = Vector3d(rest[0], rest[1], rest[2]) + part(pose.dofs, v, 0),
                   share = part(momenta_of_dofs, v, 0);
    linear_sum += share;
    angular_sum += place.cross(share) + part(momenta_of_dofs, v, 3);
  }
  return {linear_sum[0],  linear_sum[1],  linear_sum[2],
          angular_sum[0], angular_sum[1], angular_sum[2]};
}

Vector LineCells::inertia(const unsigned int load) const {
  Vector motion = Vector::Zero(space.n_dofs());
  for (const auto &[dof, value] : linear.imposed(load))
    motion[dof] += value;
  return -space.restrict_forces(momenta(at_rest(), motion));
}

CellLoad LineCells::load_on(const PipeCell &cell, const Profile &profile, const Vector3 &chord,
                            const std::vector<double> &factors) const {
  CellLoad load;
  for (unsigned int l = 0; l < factors.size(); ++l) {
    const CellLoad one = cell_load(scene.loads[l], scene.pipes[cell.pipe].name, profile, chord);
    load.line_force += factors[l] * one.line_force;
    load.axial_strain += factors[l] * one.axial_strain;
    load.curvature += factors[l] * one.curvature;
    load.pressure += factors[l] * one.pressure;
  }
  return load;
}

void LineCells::integrate_sections(const unsigned int cell, const Vector12 &before,
                                   const Vector12 &after, const Step &step,
                                   const std::vector<double> &factors, CellAnswer &answer,
                                   PipeSections::Answer &inelastic,
                                   const Eigen::Matrix3d &turn) const {
  const Vector &old = *step.from.sections;
  if (step.to.sections != step.from.sections)
    sections.between(cell, before, after, old, *step.to.sections, inelastic);
  else {
    PipeSections::Surroundings around =
        surroundings(cell, step.factors_at_end ? *step.factors_at_end : factors);
    around.line_force = (turn.transpose() * around.line_force).eval();
    if (step.is_trial)
      sections.answer_elastically(cell, before, after, around, old, inelastic);
    else if (sections.is_far(cell, after))
      inelastic.failed =
          true; // beyond a limit an iteration goes on and on, and laws take long there
    else
      sections.integrate(cell, before, after, around, step.clock, old, *answer.sections, inelastic,
                         step.is_near_last);
  }
  answer.failure = inelastic.failed ? "a section that yields or creeps has no answer" : nullptr;
  answer.section_error = inelastic.error;
  answer.free_work = inelastic.free_work;
}

PipeSections::Check LineCells::check_sections(const Vector &states,
                                              const std::vector<double> &factors) const {
  PipeSections::Check worst;
  if (sections.any())
    for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i)
      if (sections.has(i))
        sections.check(i, surroundings(i, factors), states, worst);
  return worst;
}

PipeSections::Surroundings LineCells::surroundings(const unsigned int cell,
                                                   const std::vector<double> &factors) const {
  const PipeCell &pipe_cell = discretization.pipe_cells()[cell];
  const Profile &profile = discretization.profiles()[discretization.pipe_cell(cell)->material_id()];
  PipeSections::Surroundings result;
  const auto deal_cell = discretization.pipe_cell(cell);
  const CellLoad load =
      load_on(pipe_cell, profile, deal_cell->vertex(1) - deal_cell->vertex(0), factors);
  result.axial_strain = load.axial_strain;
  for (unsigned int d = 0; d < 3; ++d)
    result.line_force[d] = load.line_force[d];
  result.curvature = load.curvature;
  result.pressure = load.pressure;
  result.temperature = scene.installation_temperature;
  const std::string &pipe = scene.pipes[pipe_cell.pipe].name;
  for (unsigned int l = 0; l < factors.size(); ++l)
    if (scene.loads[l].kind == Load::Kind::temperature && scene.loads[l].is_on(pipe))
      result.temperature += factors[l] * scene.loads[l].value;
  if (load.pressure != 0. && sections.has(cell)) {
    // What the hoop stress does goes by the modulus at this temperature, 2 nu p A_bore/(E(T) A).
    const double softer = sections.softening(cell, result.temperature);
    const double of_hoop = profile.bore_area / profile.EA - profile.pressure_strain;
    result.axial_strain -= (softer - 1.) * of_hoop * load.pressure;
    result.curvature *= softer;
  }
  return result;
}

} // namespace frictionbeam
