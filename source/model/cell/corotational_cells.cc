// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_cells.h"

#include "model/line/pipe_element.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Vector7 = CorotationalBeam::Vector7;
using Matrix7 = Eigen::Matrix<double, 7, 7>;
using Vector12 = CorotationalBeam::Vector12;

namespace {

Vector3d to_eigen(const Vector3 &v) { return {v[0], v[1], v[2]}; }

/// Free strains of a cell per unit of a load, as forces on its deformations.
Vector7 free_forces(const CorotationalBeam &beam, const PipeElement &element,
                    const CellLoad &load) {
  return beam.on_deformations(load.axial_strain * element.unit_axial_strain() +
                              load.curvature * element.unit_curvature() +
                              load.pressure * element.unit_thrust());
}

/**
 * What to add to the mean forces s of a step so that their work on the motions halfway, s . (B
 * change), is s . (d1 - d0) exactly: along the change of the deformations, as a discrete gradient
 * (O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449-467, doi:10.1007/BF02440162). B of a rigid motion is
 * zero, so that forces without resultant stay so.
 *
 * The two differ by the square of the angle turned times the change of the deformations, in the
 * turns of the ends alone: of lengths (l1^2 - l0^2)/(l0 + l1) is both. What rounding leaves between
 * them there would go with the axial force, and where a stiff bar hardly stretches by all its
 * digits. Where the deformations hardly change, by that square of themselves or by rounding, the
 * correction fades out: the energy is then wrong by the fourth power of the angle times what the
 * cell stores.
 */
Vector7 energy_correction(const CorotationalBeam &beam, const Vector7 &moved, const Vector7 &before,
                          const Vector7 &after, const double angle, const Vector7 &s) {
  constexpr double rounding = 1e-9; // of deformations, relative to the length or in radians
  Vector7 least = Vector7::Constant(rounding);
  least[0] *= beam.length_at_rest();
  const Vector7 direction = beam.stiffness() * moved;
  Vector7 missed = after - before - moved;
  missed[0] = 0.;
  const double size = moved.dot(direction), square = angle * angle,
               smallest =
                   least.dot(beam.stiffness() * least) +
                   square * square * (before + after).dot(beam.stiffness() * (before + after)) / 4.;
  return direction * (missed.dot(s) * size / (size * size + smallest * smallest));
}

/**
 * Whether an end that a joint or the pipe itself holds with some stiffness turns against its cell
 * by nearly half a turn, or in one increment by so much that it may have gone beyond: there its
 * rotation vector is that of the way round the other side, and what holds it would push on.
 * @param begin gives the deformations with which the increment began, asked for where they matter
 */
template <typename Begin>
bool is_wound(const CorotationalBeam &beam, const Vector7 &at, const Begin &begin,
              const double bending) {
  constexpr double nearly_half = 3., much = 1.5; // [rad]
  constexpr double least =
      1.; // [rad]: no step of at most `much` ends below that beyond half a turn
  constexpr double unfelt = 1e-5; // stiffness of a joint, of that of the pipe beside it
  if (std::max(at.segment<3>(1).norm(), at.segment<3>(4).norm()) <= least)
    return false;
  const Vector7 change = at - begin();
  for (const int first : {1, 4}) {
    const Vector3d turn = at.segment<3>(first), by = change.segment<3>(first),
                   axis = turn.normalized();
    if ((turn.norm() > nearly_half || by.norm() > much) &&
        axis.dot(beam.stiffness().block<3, 3>(first, first) * axis) > unfelt * bending)
      return true;
  }
  return false;
}

/// The rotation between two poses.
Quaterniond between_turns(const Quaterniond &from, const Quaterniond &to) {
  Quaterniond result = to * from.conjugate();
  if (result.w() < 0.)
    result.coeffs() *= -1.;
  return result;
}

/// Projector on the range of a symmetric positive semidefinite matrix.
Matrix3d range_of(const Matrix3d &matrix) {
  constexpr double rounding = 1e-12; // of the largest eigenvalue
  const Eigen::SelfAdjointEigenSolver<Matrix3d> pairs(matrix);
  Matrix3d projector = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (pairs.eigenvalues()[i] > rounding * pairs.eigenvalues()[2])
      projector += pairs.eigenvectors().col(i) * pairs.eigenvectors().col(i).transpose();
  return projector;
}

} // namespace

CorotationalCells::CorotationalCells(const Scene &scene, const LineMesh &mesh,
                                     const Discretization &discretization,
                                     const ReducedSpace &space, const LinearPart &linear)
    : LineCells(scene, mesh, discretization, space, linear),
      vertex_inertia(n_vertices, Matrix3d::Zero()) {
  PipeElement element(discretization);
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const auto deal_cell = discretization.pipe_cell(i);
    element.reinit(deal_cell);
    const Vector3 chord = deal_cell->vertex(1) - deal_cell->vertex(0);
    const LocalAxes local(chord);
    Matrix3d axes;
    axes << to_eigen(local.x), to_eigen(local.y), to_eigen(local.z);
    Cell cell{CorotationalBeam(to_eigen(chord), axes, element.stiffness()),
              {static_cast<unsigned int>(deal_cell->vertex_index(0)),
               static_cast<unsigned int>(deal_cell->vertex_index(1))},
              std::vector<types::global_dof_index>(12),
              element.unit_line_loads(),
              {}};
    deal_cell->get_dof_indices(cell.dofs);
    const Profile &profile = element.profile();
    const std::string &pipe = scene.pipes[discretization.pipe_cells()[i].pipe].name;
    for (unsigned int l = 0; l < scene.loads.size(); ++l) {
      const CellLoad load = cell_load(scene.loads[l], pipe, profile, chord);
      if (load.axial_strain != 0. || load.curvature != 0. || load.line_force.norm() != 0. ||
          load.pressure != 0.)
        cell.loads.push_back({l, free_forces(cell.beam, element, load), to_eigen(load.line_force)});
    }
    const double length = element.arc() ? element.arc()->length() : chord.norm();
    const Matrix3d about_axis = axes.col(0) * axes.col(0).transpose();
    for (const unsigned int v : cell.vertices)
      vertex_inertia[v] += length / 2. *
                           (profile.rotary_inertia * (Matrix3d::Identity() - about_axis) +
                            profile.twist_inertia * about_axis);
    cell.bending = profile.EI / length;
    cell.mass = length * profile.mass;
    cells.push_back(std::move(cell));
  }
  for (const Matrix3d &inertia : vertex_inertia)
    inert.push_back(range_of(inertia));
  if (linear.mass().rows() > 0)
    add_mass();
  if (linear.mass().rows() > 0 && scene.time.modal_damping != 0.)
    find_damped_modes();
}

bool CorotationalCells::turns(const unsigned int vertex) const {
  return discretization.vertex_dofs().index(vertex, 3) != numbers::invalid_dof_index;
}

Pose CorotationalCells::at_rest() const {
  Pose pose{Vector::Zero(space.n_dofs()), Vector::Zero(4 * n_vertices), &sections_at_rest};
  for (unsigned int v = 0; v < n_vertices; ++v)
    pose.turns[4 * v + 3] = 1.;
  return pose;
}

namespace {
/// Turn a vertex, and choose its rotation vector.
void turn_vertex(const Quaterniond &by, double *const turn, const Vector3d &near,
                 Vector3d &vector) {
  Eigen::Map<Quaterniond> rotation(turn);
  rotation = (by * Quaterniond(rotation)).normalized();
  vector = rotation_vector_near(rotation, near);
}
} // namespace

Pose CorotationalCells::moved(const Pose &from, const Vector &change) const {
  Pose pose{from.dofs + change, from.turns, from.sections};
  for (unsigned int v = 0; v < n_vertices; ++v)
    if (turns(v)) {
      const Vector3d near = part(pose.dofs, v, 3);
      Vector3d vector;
      turn_vertex(turn_by(part(change, v, 3)), pose.turns.data() + 4 * v, near, vector);
      add_part(vector - near, v, 3, pose.dofs);
    }
  return pose;
}

Pose CorotationalCells::stepped(const Pose &from, const Vector &change) const {
  Pose pose{from.dofs + change, from.turns, from.sections};
  for (unsigned int v = 0; v < n_vertices; ++v)
    if (turns(v)) {
      const Quaterniond by = cayley(part(change, v, 3));
      const Vector3d now = part(pose.dofs, v, 3),
                     near = part(from.dofs, v, 3) + rotation_vector(by);
      Vector3d vector;
      turn_vertex(by, pose.turns.data() + 4 * v, near, vector);
      add_part(vector - now, v, 3, pose.dofs);
    }
  return pose;
}

Vector CorotationalCells::change(const Pose &from, const Pose &to) const {
  Vector result = to.dofs - from.dofs;
  for (unsigned int v = 0; v < n_vertices; ++v)
    add_part(rotation_vector(between_turns(turn(from, v), turn(to, v))) - part(result, v, 3), v, 3,
             result);
  return result;
}

Pose CorotationalCells::halfway(const Pose &from, const Pose &to) const {
  Pose pose{(from.dofs + to.dofs) / 2., from.turns, from.sections};
  for (unsigned int v = 0; v < n_vertices; ++v) {
    Eigen::Map<Quaterniond> rotation(pose.turns.data() + 4 * v);
    rotation = half_of(between_turns(turn(from, v), turn(to, v))) * Quaterniond(rotation);
  }
  return pose;
}

CorotationalBeam::Ends CorotationalCells::ends(const Cell &cell, const Pose &pose) const {
  CorotationalBeam::Ends result;
  for (unsigned int d = 0; d < 3; ++d)
    result.relative[d] = pose.dofs[cell.dofs[6 + d]] - pose.dofs[cell.dofs[d]];
  for (unsigned int end = 0; end < 2; ++end)
    result.turn[end] = turn(pose, cell.vertices[end]);
  return result;
}

Vector12 CorotationalCells::on_line(const Cell &cell, const Matrix3d &axes,
                                    const std::vector<double> &factors, Vector7 &free) const {
  free.setZero();
  Vector3d line_force = Vector3d::Zero();
  for (const CellForces &load : cell.loads) {
    free += factors[load.load] * load.free;
    line_force += factors[load.load] * load.line_force;
  }
  Vector12 result = Vector12::Zero();
  if (line_force.isZero(0.))
    return result;
  const Matrix3d turned = axes * cell.beam.axes_at_rest().transpose();
  const Vector12 forces = cell.line_loads * (turned.transpose() * line_force);
  for (int block = 0; block < 4; ++block)
    result.segment<3>(3 * block) = turned * forces.segment<3>(3 * block);
  return result;
}

void CorotationalCells::answer(const unsigned int index, const Step &step,
                               const std::vector<double> &factors, CellAnswer &answer) const {
  const Pose &from = step.from, &half = step.half, &to = step.to;
  const bool is_step = &from != &to;
  const double viscous = step.duration > 0. ? scene.time.stiffness_damping / step.duration : 0.;
  const Cell &cell = cells[index];
  const CorotationalBeam &beam = cell.beam;
  const CorotationalBeam::Deformed after = beam.deform(ends(cell, to)),
                                   mean = is_step ? beam.deform(ends(cell, half)) : after;
  Vector7 d_before = after.d;
  double length_before = after.length;
  if (is_step) {
    Eigen::Map<Eigen::Matrix<double, 8, 1>> at_start(answer.at_start);
    if (std::isnan(at_start[7])) {
      const CorotationalBeam::Deformed before = beam.deform(ends(cell, from));
      at_start << before.d, before.length;
    }
    d_before = at_start.head<7>();
    length_before = at_start[7];
  }
  const auto begin = [&]() -> Vector7 {
    return step.began ? beam.deform(ends(cell, *step.began)).d : d_before;
  };
  Vector7 free;
  answer.dofs = cell.dofs;
  answer.loads = on_line(cell, mean.axes, factors, free);
  const Vector7 deformed = after.d - d_before;
  Vector7 s = beam.stiffness() * (d_before + after.d) / 2. - free;
  Matrix7 stiffness = beam.stiffness();
  answer.free_work = free.dot(deformed);
  if (sections.has(index)) {
    PipeSections::Answer inelastic;
    integrate_sections(index, beam.motions_of(begin()), beam.motions_of(after.d), step, factors,
                       answer, inelastic, after.axes * beam.axes_at_rest().transpose());
    s = beam.on_deformations(is_step ? Vector12((inelastic.before + inelastic.after) / 2.)
                                     : inelastic.after);
    stiffness = beam.stiffness_on_deformations(inelastic.stiffness);
  }
  if (viscous != 0.)
    s += viscous * (beam.stiffness() * deformed);
  const double length = (length_before + after.length) / 2.;
  Vector12 change = Vector12::Zero();
  if (is_wound(beam, after.d, begin, cell.bending))
    answer.failure = "a joint or the end of a cell turns by nearly half a turn, beyond which its "
                     "moment is not known";
  if (is_step) {
    double angle = 0.;
    for (int end = 0; end < 2; ++end) {
      const unsigned int v = cell.vertices[end];
      const Vector3d turned = cayley_vector(between_turns(turn(from, v), turn(to, v)));
      change.segment<3>(6 * end) = part(to.dofs, v, 0) - part(from.dofs, v, 0);
      change.segment<3>(6 * end + 3) = turned;
      angle = std::max(angle, turned.norm());
    }
    s += energy_correction(beam, beam.of_motion(mean, length, change), d_before, after.d, angle, s);
  }
  answer.internal = beam.on_ends(mean, length, s);
  answer.free.setZero();
  if (!free.isZero(0.))
    answer.free = beam.on_ends(mean, length, free);
  if (!step.without_stiffness) {
    const CorotationalBeam::Matrix7_9 B = beam.derivative_by_relative(mean, length);
    CorotationalBeam::Matrix7_9 B_after = B;
    if (is_step) {
      B_after = beam.derivative_by_relative(after, after.length);
      for (int end = 0; end < 2; ++end)
        B_after.middleCols<3>(3 + 3 * end) =
            (B_after.middleCols<3>(3 + 3 * end) * cayley_spin(change.segment<3>(6 * end + 3)))
                .eval();
    }
    stiffness += 2. * viscous * beam.stiffness();
    // Lazily, for Eigen's blocked products are slow on matrices this small.
    const CorotationalBeam::Matrix7_9 on_deformations = stiffness.lazyProduct(B_after);
    CorotationalBeam::Matrix9 by_relative = beam.geometric_stiffness(mean, s);
    by_relative += B.transpose().lazyProduct(on_deformations);
    answer.stiffness = CorotationalBeam::of_ends(by_relative);
  }
  answer.damping = viscous * deformed.dot(beam.stiffness() * deformed);
}

Motion CorotationalCells::nodal_load(const unsigned int load, const unsigned int vertex,
                                     const Pose &pose) const {
  Motion value = linear.nodal(load).at(vertex);
  if (!scene.loads[load].follows)
    return value;
  for (const unsigned int first : {0u, 3u}) {
    const Vector3d turned =
        turn(pose, vertex) * Vector3d(value[first], value[first + 1], value[first + 2]);
    for (unsigned int d = 0; d < 3; ++d)
      value[first + d] = turned[d];
  }
  return value;
}

double CorotationalCells::stored_in(const unsigned int cell, const Pose &pose) const {
  if (sections.has(cell))
    return sections.stored_in(cell, *pose.sections);
  const Vector7 d = cells[cell].beam.deform(ends(cells[cell], pose)).d;
  return d.dot(cells[cell].beam.stiffness() * d) / 2.;
}

LineCells::CellState CorotationalCells::state_of(const unsigned int index, const PipeElement &,
                                                 const Pose &pose,
                                                 const std::vector<double> &factors) const {
  const Cell &cell = cells[index];
  const CorotationalBeam::Deformed deformed = cell.beam.deform(ends(cell, pose));
  Vector7 free;
  const Vector12 loads = on_line(cell, deformed.axes, factors, free);
  CellState state;
  const Vector7 forces = sections.has(index)
                             ? cell.beam.on_deformations(sections.forces(index, *pose.sections))
                             : Vector7(cell.beam.stiffness() * deformed.d - free);
  state.ends = cell.beam.on_ends(deformed, deformed.length, forces) - loads;
  state.motions = cell.beam.motions_of(deformed.d);
  state.frame = CellFrame{deformed.axes * cell.beam.axes_at_rest().transpose(),
                          to_eigen(Vector3(discretization.vertices()[cell.vertices[0]])),
                          part(pose.dofs, cell.vertices[0], 0), state.motions.head<3>()};
  return state;
}

Vector12 CorotationalCells::motions_of_cell(const unsigned int index, const Pose &pose,
                                            const Vector &motion) const {
  const Cell &cell = cells[index];
  const CorotationalBeam::Deformed deformed = cell.beam.deform(ends(cell, pose));
  Vector12 of_ends;
  for (int i = 0; i < 12; ++i)
    of_ends[i] = motion[cell.dofs[i]];
  return cell.beam.motions_of(cell.beam.of_motion(deformed, deformed.length, of_ends));
}

LineCells::Unbent CorotationalCells::unbent(const Pose &pose) const {
  Unbent unbent;
  for (const Cell &cell : cells) {
    const Point3 &first = discretization.vertices()[cell.vertices[0]],
                 &last = discretization.vertices()[cell.vertices[1]];
    const Vector3d at_rest = to_eigen(last - first),
                   chord = (at_rest + part(pose.dofs, cell.vertices[1], 0) -
                            part(pose.dofs, cell.vertices[0], 0))
                               .normalized();
    const auto angles = [&](const unsigned int vertex) -> Vector3d {
      return turn(pose, vertex) * at_rest.normalized() - chord;
    };
    const Vector3d one = angles(cell.vertices[0]), two = angles(cell.vertices[1]);
    unbent.bow = std::max(unbent.bow, at_rest.norm() * (one.norm() + two.norm()) / 8.);
    unbent.length +=
        at_rest.norm() * (2. * one.squaredNorm() - one.dot(two) + 2. * two.squaredNorm()) / 30.;
  }
  return unbent;
}

} // namespace frictionbeam
