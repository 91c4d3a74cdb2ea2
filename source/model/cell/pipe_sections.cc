// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/pipe_sections.h"

#include "base/user_error.h"
#include "model/unknowns/section_law.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/LU>

#include <algorithm>

namespace frictionbeam {

using Vector6 = PipeSections::Vector6;
using Vector12 = PipeSections::Vector12;
using Tangent = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Values = Eigen::Map<const Vector6>;

namespace {

/// The matrix of v x.
Eigen::Matrix3d cross(const Eigen::Vector3d &v) {
  Eigen::Matrix3d result;
  result << 0., -v[2], v[1], v[2], 0., -v[0], -v[1], v[0], 0.;
  return result;
}

/// Length of a cell beyond a part of its way, and the integral there of the way from a vertex.
struct Beyond {
  double length = 0.;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();

  Beyond(const PipeElement &element, const Discretization::Cell &cell, const double part,
         const unsigned int from_vertex) {
    static const dealii::QGauss<1> straight(1), curved(12); // finding their points takes long
    const dealii::QGauss<1> &points = element.arc() ? curved : straight;
    for (unsigned int k = 0; k < points.size(); ++k) {
      const double at = part + (1. - part) * points.point(k)[0];
      const Vector3 chord = cell->vertex(1) - cell->vertex(0);
      const Point3 place = element.arc() ? element.arc()->point(at * element.arc()->angle())
                                         : Point3(cell->vertex(0) + at * chord);
      const double own =
          points.weight(k) * (1. - part) * (element.arc() ? element.arc()->length() : chord.norm());
      length += own;
      const Vector3 arm = place - cell->vertex(from_vertex);
      way += own * Eigen::Vector3d(arm[0], arm[1], arm[2]);
    }
  }
  /// Force and moment of a unit load per length there, about the vertex.
  Eigen::Matrix<double, 6, 3> forces() const {
    Eigen::Matrix<double, 6, 3> result;
    result.topRows<3>() = length * Eigen::Matrix3d::Identity();
    result.bottomRows<3>() = cross(way);
    return result;
  }
};

/// Stress of the section at a part of the way by force and moment on the cell's second end: those
/// of equilibrium, whatever the section is.
SectionChain::Matrix6 carried_from_end(const PipeElement &element, const Discretization::Cell &cell,
                                       const double part) {
  const Vector3 chord = cell->vertex(1) - cell->vertex(0);
  const auto &arc = element.arc();
  const Point3 place =
      arc ? arc->point(part * arc->angle()) : Point3(cell->vertex(0) + part * chord);
  const LocalAxes axes(arc ? arc->tangent(part * arc->angle()) : chord);
  Eigen::Matrix3d to_local;
  to_local << axes.x[0], axes.x[1], axes.x[2], axes.y[0], axes.y[1], axes.y[2], axes.z[0],
      axes.z[1], axes.z[2];
  const Vector3 arm = cell->vertex(1) - place;
  SectionChain::Matrix6 b = SectionChain::Matrix6::Zero();
  b.topLeftCorner<3, 3>() = b.bottomRightCorner<3, 3>() = to_local;
  b.bottomLeftCorner<3, 3>() = to_local * cross({arm[0], arm[1], arm[2]});
  return b;
}

/// Section strains in the axes of an arc, y inwards and z about its centre, of those in local axes.
SectionChain::Matrix6 to_axes_of(const ArcBeam &arc, const double part) {
  const double psi = part * arc.angle();
  const LocalAxes local(arc.tangent(psi));
  const Vector3 inward = arc.inward(psi), axis = arc.axis();
  SectionChain::Matrix6 turn = SectionChain::Matrix6::Identity();
  for (const int first : {1, 4})
    turn.block<2, 2>(first, first) << inward * local.y, inward * local.z, axis * local.y,
        axis * local.z;
  return turn;
}

} // namespace

PipeSections::PipeSections(const Scene &scene, const Discretization &discretization)
    : installation(scene.installation_temperature) {
  const auto &profiles = discretization.profiles();
  if (std::none_of(profiles.begin(), profiles.end(),
                   [](const Profile &profile) { return profile.law.is_set(); }))
    return;
  const dealii::QGaussLobatto<1> points(scene.mesh.section_points);
  PipeElement exact(discretization), at_points(discretization, points, points);
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    exact.reinit(discretization.pipe_cell(i));
    if (!exact.profile().law.is_set()) {
      cells.push_back(nullptr);
      continue;
    }
    if (exact.has_joints())
      throw UserError("Pipe " + scene.pipes[discretization.pipe_cells()[i].pipe].name +
                      ": a joint stands in its cell, whose section has the law '" +
                      exact.profile().law.name() +
                      "'.\n  read:    a joint beside a section that yields or creeps\n  allowed: "
                      "joints between cells of elastic sections\n  try:     a short pipe of its "
                      "own with an elastic section at the joint");
    cells.push_back(make_cell(discretization, i, exact, at_points));
    n_values += n_values_of_cell + cells.back()->chain.size() * n_values_of(*cells.back());
  }
}

std::unique_ptr<const PipeSections::Cell>
PipeSections::make_cell(const Discretization &discretization, const unsigned int index,
                        PipeElement &exact, PipeElement &at_points) const {
  const auto deal_cell = discretization.pipe_cell(index);
  at_points.reinit_points(deal_cell);
  const Profile &profile = exact.profile();
  const SectionChain::Matrix6 D = Eigen::Map<const Tangent>(&profile.tangent(0, 0));
  const Matrix12 K = exact.stiffness();
  const SectionChain::Matrix6 compliance = K.bottomRightCorner<6, 6>().inverse();
  Eigen::Matrix<double, 6, 12> G;
  G.leftCols<6>() = compliance * K.bottomLeftCorner<6, 6>();
  G.rightCols<6>().setIdentity();
  std::vector<SectionChain::Matrix6> turn;
  std::vector<BoundLaw> laws;
  std::vector<SectionChain::Point> points;
  const bool of_bend = exact.arc() && profile.bend.radius > 0.,
             reversed = discretization.pipe_cells()[index].reversed;
  for (unsigned int q = 0; q < at_points.n_points(); ++q) {
    const double part = at_points.place_of(q);
    turn.push_back(of_bend ? to_axes_of(*exact.arc(), part)
                           : SectionChain::Matrix6(SectionChain::Matrix6::Identity()));
    SectionChain::Point &point = points.emplace_back();
    point.b = turn[q] * carried_from_end(exact, deal_cell, part);
    point.load_stress = point.b * Beyond(exact, deal_cell, part, 1).forces();
    point.length = at_points.length_at(q);
    point.elastic = D;
    if (profile.bend.changes_along()) {
      laws.push_back(law_at(profile, reversed ? 1. - part : part));
      const auto tangent = elastic_tangent(laws.back());
      point.elastic = Eigen::Map<const Tangent>(&tangent(0, 0));
    }
  }
  auto cell = std::make_unique<Cell>(profile, SectionChain(std::move(points), G));
  for (unsigned int q = 0; q < at_points.n_points(); ++q) {
    cell->B.push_back(turn[q] * at_points.strain_matrix(q));
    cell->curvature.push_back(turn[q] * at_points.curvature_strain(q));
    cell->part.push_back(at_points.place_of(q));
  }
  cell->laws = std::move(laws);
  if (of_bend)
    cell->turn = std::move(turn);
  cell->carried = exact.unit_line_loads();
  cell->carried.topRows<6>() -= Beyond(exact, deal_cell, 0., 0).forces();
  cell->first_value = n_values;
  return cell;
}

double PipeSections::softening(const unsigned int index, const double temperature) const {
  const Cell &cell = *cells[index];
  return cell.profile.EA / elastic_tangent(cell.law(0), temperature)(0, 0);
}

void PipeSections::set_energies(const double pushes, const double dissipation,
                                const double *const old, double *const now) {
  now[thrust] = pushes;
  now[lost] = old[lost] + dissipation;
  now[stored] = old[stored] - dissipation +
                (Values(old + stress) + Values(now + stress))
                        .dot(Values(now + strain) - Values(old + strain)) /
                    2.;
}

bool PipeSections::answer_of_law(const Cell &cell, const unsigned int point,
                                 const Surroundings &surroundings, const Clock &clock,
                                 const Vector6 &total, const double rise, const double *const old,
                                 double *const now, SectionChain::Matrix6 &stiffness,
                                 double &error) const {
  const Profile &profile = cell.profile;
  const BoundLaw &law = cell.law(point);
  const double pushes = surroundings.pressure * profile.bore_area;
  Eigen::Map<Vector6> of_wall(now + strain);
  of_wall = total;
  of_wall[0] += pushes / profile.EA;
  const Vector6 rate = clock.length > 0. ? Vector6((of_wall - Values(old + strain)) / clock.length)
                                         : Vector6(Vector6::Zero());
  LawIncrement increment;
  increment.time = clock.time;
  increment.length = clock.length;
  increment.temperature = surroundings.temperature;
  increment.temperature_change = surroundings.temperature - installation - rise;
  increment.pressure = surroundings.pressure;
  Tangent tangent;
  LawOutput output{now + stress, tangent.data(), now + internal, 0., ContactStatus::none};
  now[flowed] = 1.; // whatever it leaves if it fails
  if (law.integrate(of_wall.data(), rate.data(), 1., increment, old + internal,
                    LawTangent::consistent, output) != LawStatus::ok)
    return false;
  stiffness = tangent;
  const double *const variables = now + internal;
  now[flowed] = std::any_of(variables, variables + law.n_internal_variables(),
                            [](const double x) { return x != 0.; });
  set_energies(pushes, output.dissipation, old, now);
  error = std::max(error, output.error);
  return true;
}

bool PipeSections::is_as_stiff_as_cold(const Cell &cell, const unsigned int point,
                                       const LawIncrement &increment, const double *const of_wall,
                                       const double *const old, double *const now) {
  const LawIncrement cold;
  if (increment.temperature == cold.temperature && increment.pressure == cold.pressure)
    return true;
  const Vector6 no_rate = Vector6::Zero();
  Vector6 unused;
  Tangent warm;
  now[flowed] = 1.;
  LawOutput output{unused.data(), warm.data(), now + internal, 0., ContactStatus::none};
  return cell.law(point).integrate(of_wall, no_rate.data(), 1., increment, old + internal,
                                   LawTangent::elastic, output) == LawStatus::ok &&
         warm == cell.chain[point].elastic;
}

bool PipeSections::stays_elastic(const Cell &cell, const Vector12 &motions,
                                 const std::vector<Vector6> &free, const Surroundings &surroundings,
                                 const Vector &old, Vector &now,
                                 SectionChain::Solution &solution) const {
  for (unsigned int q = 0; q < cell.chain.size(); ++q)
    if (old[place_of(cell, q) + flowed] != 0.)
      return false;
  LawIncrement increment;
  increment.temperature = surroundings.temperature;
  increment.pressure = surroundings.pressure;
  const double pushes = surroundings.pressure * cell.profile.bore_area;
  cell.chain.solve_elastically(motions, free, surroundings.line_force, solution);
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    const double *const before = old.data() + place_of(cell, q);
    double *const values = now.data() + place_of(cell, q);
    Eigen::Map<Vector6> of_wall(values + strain);
    of_wall = solution.strain[q];
    of_wall[0] += pushes / cell.profile.EA;
    if (!(cell.law(q).elastic_bound(values + strain, 1., increment) < 1.) ||
        (q == 0 && !is_as_stiff_as_cold(cell, q, increment, values + strain, before, values)))
      return false;
    Eigen::Map<Vector6>(values + stress) = cell.chain[q].elastic * of_wall;
    if (values[flowed] != 0.)
      std::fill(values + flowed, values + n_values_of(cell), 0.);
    set_energies(pushes, 0., before, values);
  }
  return true;
}

std::vector<Vector6> PipeSections::strains_of(const Cell &cell, const Vector &states) const {
  std::vector<Vector6> result;
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    result.emplace_back(Values(states.data() + place_of(cell, q) + strain));
    result.back()[0] -= states[place_of(cell, q) + thrust] / cell.profile.EA;
  }
  return result;
}

std::vector<Vector6> PipeSections::first_guess(const Cell &cell, const Vector12 &motion,
                                               const Surroundings &surroundings,
                                               const Vector &old) const {
  const double *const of_cell_before = old.data() + cell.first_value + 12;
  std::vector<Vector6> result = strains_of(cell, old);
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    result[q] +=
        cell.B[q] * motion - (surroundings.curvature - of_cell_before[1]) * cell.curvature[q];
    result[q][0] -= surroundings.axial_strain - of_cell_before[0];
  }
  return result;
}

void PipeSections::integrate(const unsigned int index, const Vector12 &from, const Vector12 &to,
                             const Surroundings &surroundings, const Clock &clock,
                             const Vector &old, Vector &now, Answer &answer,
                             const bool is_near) const {
  const Cell &cell = *cells[index];
  answer = {};
  SectionChain::Solution solution;
  std::vector<Vector6> free;
  free.reserve(cell.chain.size());
  for (const Vector6 &unit : cell.curvature) {
    free.push_back(surroundings.curvature * unit);
    free.back()[0] += surroundings.axial_strain;
  }
  const auto law = [&](const unsigned int q, const Vector6 &strain_of_point, Vector6 &result,
                       SectionChain::Matrix6 &tangent) {
    double *const values = now.data() + place_of(cell, q);
    if (!answer_of_law(cell, q, surroundings, clock, strain_of_point, old[cell.first_value + risen],
                       old.data() + place_of(cell, q), values, tangent, answer.error))
      return false;
    result = Values(values + stress);
    result[0] -= values[thrust];
    return true;
  };
  std::vector<Vector6> near_by;
  if (is_near) // before the elastic answer is written over it
    near_by = strains_of(cell, now);
  if (!stays_elastic(cell, to, free, surroundings, old, now, solution)) {
    solution.strain = is_near ? near_by : first_guess(cell, to - from, surroundings, old);
    cell.chain.solve(law, to, free, surroundings.line_force, solution);
  }
  answer.failed = !solution.solved;
  answer.compatible = solution.compatible;
  if (answer.failed)
    return;
  Eigen::Map<Vector12>(now.data() + cell.first_value) =
      solution.forces + cell.carried * surroundings.line_force;
  double *const of_cell = now.data() + cell.first_value + 12;
  of_cell[0] = surroundings.axial_strain;
  of_cell[1] = surroundings.curvature;
  Eigen::Map<Eigen::Vector3d>(of_cell + 2) = surroundings.line_force;
  now[cell.first_value + risen] = surroundings.temperature - installation;
  answer.stiffness = solution.stiffness;
  between(index, from, to, old, now, answer);
}

void PipeSections::answer_elastically(const unsigned int index, const Vector12 &from,
                                      const Vector12 &to, const Surroundings &surroundings,
                                      const Vector &old, Answer &answer) const {
  const Cell &cell = *cells[index];
  const double *const of_cell = old.data() + cell.first_value + 12;
  const Eigen::Vector3d load =
      surroundings.line_force - Eigen::Map<const Eigen::Vector3d>(of_cell + 2);
  std::vector<Vector6> free;
  for (const Vector6 &unit : cell.curvature) {
    free.push_back((surroundings.curvature - of_cell[1]) * unit);
    free.back()[0] += surroundings.axial_strain - of_cell[0];
  }
  answer = {};
  answer.after =
      forces(index, old) + cell.carried * load + cell.chain.elastic_change(to - from, free, load);
  answer.stiffness = cell.chain.elastic_stiffness();
}

void PipeSections::between(const unsigned int index, const Vector12 &from, const Vector12 &to,
                           const Vector &old, const Vector &now, Answer &answer) const {
  const Cell &cell = *cells[index];
  answer.before = forces(index, old);
  answer.after = forces(index, now);
  answer.free_work = sum(cell, now, stored) - sum(cell, old, stored) + sum(cell, now, lost) -
                     sum(cell, old, lost) - (answer.before + answer.after).dot(to - from) / 2.;
}

double PipeSections::sum(const Cell &cell, const Vector &states, const Value value) const {
  double result = 0.;
  for (unsigned int q = 0; q < cell.chain.size(); ++q)
    result += cell.chain[q].length * states[place_of(cell, q) + value];
  return result;
}

Vector12 PipeSections::forces(const unsigned int index, const Vector &states) const {
  return Eigen::Map<const Vector12>(states.data() + cells[index]->first_value);
}

double PipeSections::stored_in(const unsigned int index, const Vector &states) const {
  return sum(*cells[index], states, stored);
}

double PipeSections::dissipated(const Vector &states) const {
  double result = 0.;
  for (const auto &cell : cells)
    if (cell)
      result += sum(*cell, states, lost);
  return result;
}

} // namespace frictionbeam
