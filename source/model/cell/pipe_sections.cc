// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/pipe_sections.h"

#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

using Vector6 = PipeSections::Vector6;
using Vector12 = PipeSections::Vector12;
using Tangent = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Values = Eigen::Map<const Vector6>;

Vector6 PipeSections::beam_stress(const double *const values) {
  Vector6 result = Values(values + stress);
  result[0] -= values[thrust];
  return result;
}

PipeSections::PipeSections(const Scene &scene, const Discretization &discretization) {
  const auto &profiles = discretization.profiles();
  if (std::none_of(profiles.begin(), profiles.end(),
                   [](const Profile &profile) { return profile.law.is_set(); }))
    return;
  PipeElement element(discretization);
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    element.reinit(discretization.pipe_cell(i));
    Cell &cell = cells.emplace_back();
    if (!element.profile().law.is_set())
      continue;
    if (element.has_joints())
      throw UserError("Pipe " + scene.pipes[discretization.pipe_cells()[i].pipe].name +
                      ": a joint stands in its cell, whose section has the law '" +
                      element.profile().law.name() +
                      "'.\n  read:    a joint beside a section that yields or creeps\n  allowed: "
                      "joints between cells of elastic sections\n  try:     a short pipe of its "
                      "own with an elastic section at the joint");
    cell.profile = &element.profile();
    cell.first = points.size();
    cell.n_points = element.n_points();
    cell.first_value = n_values;
    double along = 0., length = 0.;
    for (unsigned int q = 0; q < cell.n_points; ++q)
      length += element.length_at(q);
    for (unsigned int q = 0; q < cell.n_points; ++q) {
      const double own = element.length_at(q);
      points.push_back({element.strain_matrix(q), element.curvature_strain(q), own,
                        (along + own / 2.) / length});
      along += own;
    }
    n_values += cell.n_points * n_values_of(cell);
  }
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

bool PipeSections::answer_of_law(const Cell &cell, const Surroundings &surroundings,
                                 const Clock &clock, const Vector6 &total, const double *const old,
                                 double *const now, Tangent &tangent, double &error) const {
  const Profile &profile = *cell.profile;
  const BoundLaw &law = profile.law;
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
  increment.pressure = surroundings.pressure;
  const unsigned int n = law.n_internal_variables();
  const bool is_virgin = std::all_of(old + internal, old + internal + n,
                                     [](const double value) { return value == 0.; });
  const bool is_cold = increment.temperature == LawIncrement().temperature; // as the tangent
  if (is_virgin && is_cold && law.elastic_bound(of_wall.data(), 1., increment) < 1.) {
    tangent = Eigen::Map<const Tangent>(&profile.tangent(0, 0));
    Eigen::Map<Vector6>(now + stress) = tangent * of_wall;
    std::fill(now + internal, now + internal + n, 0.);
    set_energies(pushes, 0., old, now);
    return true;
  }
  LawOutput output{now + stress, tangent.data(), now + internal, 0., ContactStatus::none};
  if (law.integrate(of_wall.data(), rate.data(), 1., increment, old + internal,
                    LawTangent::consistent, output) != LawStatus::ok)
    return false;
  set_energies(pushes, output.dissipation, old, now);
  error = std::max(error, output.error);
  return true;
}

void PipeSections::integrate(const unsigned int index, const Vector12 &from, const Vector12 &to,
                             const Surroundings &surroundings, const Clock &clock,
                             const Vector &old, Vector &now, Answer &answer) const {
  const Cell &cell = cells[index];
  answer = {};
  Tangent tangent;
  for (unsigned int q = 0; q < cell.n_points; ++q) {
    const Point &point = points[cell.first + q];
    const unsigned int place = cell.first_value + q * n_values_of(cell);
    const double *const before = old.data() + place;
    double *const after = now.data() + place;
    Vector6 free = surroundings.curvature * point.curvature;
    free[0] += surroundings.axial_strain;
    if (!answer_of_law(cell, surroundings, clock, point.B * to - free, before, after, tangent,
                       answer.error)) {
      answer.failed = true;
      return;
    }
    answer.stiffness.noalias() += point.length * (point.B.transpose() * (tangent * point.B).eval());
  }
  between(index, from, to, old, now, answer);
}

void PipeSections::between(const unsigned int index, const Vector12 &from, const Vector12 &to,
                           const Vector &old, const Vector &now, Answer &answer) const {
  const Cell &cell = cells[index];
  answer.before = forces(index, old);
  answer.after = forces(index, now);
  answer.free_work = sum(cell, now, stored) - sum(cell, old, stored) + sum(cell, now, lost) -
                     sum(cell, old, lost) - (answer.before + answer.after).dot(to - from) / 2.;
}

double PipeSections::sum(const Cell &cell, const Vector &states, const Value value) const {
  double result = 0.;
  for (unsigned int q = 0; q < cell.n_points; ++q)
    result +=
        points[cell.first + q].length * states[cell.first_value + q * n_values_of(cell) + value];
  return result;
}

Vector12 PipeSections::forces(const unsigned int index, const Vector &states) const {
  const Cell &cell = cells[index];
  Vector12 result = Vector12::Zero();
  for (unsigned int q = 0; q < cell.n_points; ++q) {
    const Point &point = points[cell.first + q];
    const double *const values = states.data() + cell.first_value + q * n_values_of(cell);
    result += point.length * (point.B.transpose() * beam_stress(values));
  }
  return result;
}

double PipeSections::stored_in(const unsigned int index, const Vector &states) const {
  return sum(cells[index], states, stored);
}

double PipeSections::dissipated(const Vector &states) const {
  double result = 0.;
  for (const Cell &cell : cells)
    if (cell.n_points > 0)
      result += sum(cell, states, lost);
  return result;
}

double PipeSections::plastic_power(const unsigned int index, const Vector12 &motions,
                                   const Surroundings &surroundings) const {
  constexpr double far = 1e5; // of the strain at which it begins to yield
  constexpr double none = std::numeric_limits<double>::infinity();
  const Cell &cell = cells[index];
  const BoundLaw &law = cell.profile->law;
  LawIncrement increment;
  increment.temperature = surroundings.temperature;
  increment.pressure = surroundings.pressure;
  const std::vector<double> rest(law.n_internal_variables() + 1, 0.);
  std::vector<double> states(rest.size());
  const Vector6 no_rate = Vector6::Zero();
  double power = 0.;
  for (unsigned int q = 0; q < cell.n_points; ++q) {
    const Point &point = points[cell.first + q];
    Vector6 direction = point.B * motions;
    direction.segment<2>(1).setZero();
    const double bound = law.elastic_bound(direction.data(), 1., increment);
    if (!(bound > 0.)) // nothing is strained
      continue;
    if (std::isinf(bound))
      return none;
    double of_point[2];
    for (const int further : {0, 1}) { // hardening shows in twice the strain
      const double length = (1 + further) * far / bound;
      const Vector6 there = length * direction;
      Vector6 result;
      LawOutput output{result.data(), nullptr, states.data(), 0., ContactStatus::none};
      if (law.integrate(there.data(), no_rate.data(), 1., increment, rest.data(), LawTangent::none,
                        output) != LawStatus::ok)
        return none;
      of_point[further] = result.dot(direction);
    }
    constexpr double same = 1e-3;
    if (!(of_point[1] <= (1. + same) * of_point[0]))
      return none;
    power += point.length * of_point[1];
  }
  return power;
}

std::vector<PipeSections::Report> PipeSections::reports(const unsigned int index,
                                                        const Surroundings &surroundings,
                                                        const Vector &states) const {
  const Cell &cell = cells[index];
  LawIncrement increment;
  increment.temperature = surroundings.temperature;
  increment.pressure = surroundings.pressure;
  std::vector<Report> result;
  for (unsigned int q = 0; q < cell.n_points; ++q) {
    const double *const values = states.data() + cell.first_value + q * n_values_of(cell);
    result.push_back({points[cell.first + q].part, Values(values + strain), Values(values + stress),
                      cell.profile->law.report(values + strain, 1., increment, values + internal)});
  }
  return result;
}

} // namespace frictionbeam
