// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/pipe_sections.h"

#include "base/lagrange_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace frictionbeam {

using Vector6 = PipeSections::Vector6;
using Vector12 = PipeSections::Vector12;
using Values = Eigen::Map<const Vector6>;

namespace {

/// Of a thin ring that is as stiff [m].
double radius_of(const Profile &profile) { return std::sqrt(2. * profile.EI / profile.EA); }

/// Of a section's strains, equivalent, in the wall at this radius [-].
double size_of(const PipeSections::Vector6 &strain, const double radius) {
  return std::hypot(std::abs(strain[0]) + radius * std::hypot(strain[4], strain[5]),
                    radius * strain[3] / std::sqrt(3.));
}

/// Of its forces [N]: they do at most this times the strain's size as work.
double force_of(const PipeSections::Vector6 &stress, const double radius) {
  const double along = std::max(std::abs(stress[0]), std::hypot(stress[4], stress[5]) / radius);
  return std::hypot(along, std::sqrt(3.) * stress[3] / radius);
}

/// Of a section that has never flowed: the bound its law tells, else 0 where it answers without any
/// internal variable, and infinity where it does not.
double bound_of_untouched(const BoundLaw &law, const Vector6 &strains,
                          const LawIncrement &increment) {
  const double told = law.elastic_bound(strains.data(), 1., increment);
  if (std::isfinite(told))
    return told;
  const Vector6 no_rate = Vector6::Zero();
  const std::vector<double> before(law.n_internal_variables(), 0.);
  std::vector<double> after = before;
  Vector6 stress;
  std::array<double, 36> unused;
  LawOutput output{stress.data(), unused.data(), after.data(), 0., ContactStatus::none};
  const bool is_elastic = law.integrate(strains.data(), no_rate.data(), 1., increment,
                                        before.data(), LawTangent::none, output) == LawStatus::ok &&
                          after == before;
  return is_elastic ? 0. : told;
}

} // namespace

void PipeSections::Check::include(const Check &other) {
  yield_violation = std::max(yield_violation, other.yield_violation);
  imbalance = std::max(imbalance, other.imbalance);
  unseen_yield = std::max(unseen_yield, other.unseen_yield);
}

double PipeSections::bound_between(const Cell &cell, const LawIncrement &increment,
                                   const Vector &states) const {
  constexpr unsigned int n_places = 32;
  const unsigned int n = cell.chain.size(), middle = n / 2;
  const std::array<unsigned int, 3> points = {0, middle, n - 1};
  const std::array<double, 3> parts = {cell.part[0], cell.part[middle], cell.part[n - 1]};
  double largest = 0.;
  for (unsigned int i = 1; i < n_places; ++i) {
    const std::array<double, 3> weights =
        lagrange_weights(parts, static_cast<double>(i) / n_places);
    Vector6 strains = Vector6::Zero();
    for (unsigned int k = 0; k < points.size(); ++k)
      strains += weights[k] * Values(states.data() + place_of(cell, points[k]) + strain);
    largest = std::max(largest, bound_of_untouched(cell.law(middle), strains, increment));
  }
  return largest;
}

void PipeSections::check(const unsigned int index, const Surroundings &surroundings,
                         const Vector &states, Check &worst) const {
  const Cell &cell = *cells[index];
  LawIncrement increment;
  increment.temperature = surroundings.temperature;
  increment.pressure = surroundings.pressure;
  const double *const of_cell = states.data() + cell.first_value;
  const Eigen::Map<const Eigen::Vector3d> load(of_cell + 14);
  const Vector6 beta = (forces(index, states) - cell.carried * load).tail<6>();
  constexpr double nothing = 1e-7; // a strain whose stresses are no more than rounding of motions
  double largest = 0., off = 0.;
  bool has_flowed = false;
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    const double *const values = states.data() + place_of(cell, q);
    has_flowed = has_flowed || values[flowed] != 0.;
    if (values[flowed] != 0. || !(cell.law(q).elastic_bound(values + strain, 1., increment) < 1.)) {
      const double ratio =
          cell.law(q).report(values + strain, 1., increment, values + internal).utilization;
      worst.yield_violation = std::max(worst.yield_violation, ratio - 1.);
    }
    Vector6 left =
        Values(values + stress) - cell.chain[q].b * beta - cell.chain[q].load_stress * load;
    left[0] -= values[thrust];
    Vector6 free = of_cell[13] * cell.curvature[q];
    free[0] += of_cell[12];
    for (unsigned int c = 0; c < 6; ++c)
      if (const double scale = std::sqrt(cell.profile.tangent(c, c)); scale > 0.) {
        largest = std::max({largest, std::abs(values[stress + c]) / scale,
                            std::abs(free[c]) * scale, c == 0 ? nothing * scale : 0.});
        off = std::max(off, std::abs(left[c]) / scale);
      }
  }
  if (largest > 0.)
    worst.imbalance = std::max(worst.imbalance, off / largest);
  if (!has_flowed && !load.isZero(0.) && cell.chain.size() > 2)
    worst.unseen_yield = std::max(worst.unseen_yield, bound_between(cell, increment, states) - 1.);
}

bool PipeSections::is_far(const unsigned int index, const Vector12 &motions) const {
  constexpr double most = 10.; // of the wall
  const Cell &cell = *cells[index];
  const double radius = radius_of(cell.profile);
  return std::any_of(cell.B.begin(), cell.B.end(), [&](const auto &B) {
    const Vector6 strain = B * motions;
    return !(std::abs(strain[0]) + radius * std::hypot(strain[4], strain[5]) < most) ||
           !(radius * std::abs(strain[3]) < most);
  });
}

PipeSections::Flow PipeSections::plastic_flow(const unsigned int index, const Vector12 &at,
                                              const Vector12 &motion,
                                              const Surroundings &surroundings,
                                              const Vector &states) const {
  constexpr double far = 1000.; // times the motion at which it begins to yield
  constexpr double same = 1e-3;
  const Flow none{std::numeric_limits<double>::infinity()};
  const Cell &cell = *cells[index];
  constexpr double rounding = 1e-12;
  const double radius = radius_of(cell.profile);
  double bound = 0.;
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    Vector6 direction = cell.B[q] * motion;
    const Vector6 terms = cell.B[q].cwiseAbs() * motion.cwiseAbs();
    for (unsigned int c = 0; c < 6; ++c) // a cell that only moves along
      direction[c] = std::abs(direction[c]) > rounding * terms[c] ? direction[c] : 0.;
    const double told = cell.law(q).elastic_bound(direction.data(), 1., {});
    bound = std::max(bound, std::isfinite(told) ? told : size_of(direction, radius) / proof_strain);
  }
  if (bound == 0.)
    return Flow();
  Vector there = states;
  Vector12 place = at;
  const double length = far / bound;
  std::array<double, 4> work{};
  Flow flow;
  for (double &so_far : work) {
    const Vector begin = there;
    const Vector12 end = place + length * motion;
    Answer answer;
    integrate(index, place, end, surroundings, {}, begin, there, answer);
    if (answer.failed && !answer.compatible) // any strains of the motion give a bound
      return none;
    place = end;
    so_far = sum(cell, there, stored) + sum(cell, there, lost);
    flow.interior = -cell.carried.transpose() * motion;
    flow.bore = 0.;
    double most = 0.;
    for (unsigned int q = 0; q < cell.chain.size(); ++q) {
      const double *const from = begin.data() + place_of(cell, q), *const to = there.data() +
                                                                               place_of(cell, q);
      const Vector6 by =
          cell.chain[q].length / length * (Values(to + strain) - Values(from + strain));
      flow.interior += cell.chain[q].load_stress.transpose() * by;
      flow.bore += cell.profile.bore_area * by[0];
      if (const double power = Values(to + stress).dot(by); power > most) {
        most = power;
        flow.part = cell.part[q];
      }
    }
  }
  flow.power = (work[2] - work[1]) / length;
  return work[3] - work[2] <= (1. + same) * (work[2] - work[1]) ? flow : none;
}

PipeSections::Change PipeSections::largest_change(const Vector &before, const Vector &after) const {
  constexpr double closed = 1e-3, no_flow = 1e-5, least_flow = 1e-3, most_yield_strain = 1e-3;
  const Vector6 stretch = Vector6::Unit(0);
  Change change;
  double most_untold = 0.;
  unsigned int cell_of_flow = 0;
  double part_of_flow = 0.5;
  for (unsigned int i = 0; i < cells.size(); ++i) {
    if (!cells[i])
      continue;
    const Cell &cell = *cells[i];
    change.dissipated += sum(cell, after, lost) - sum(cell, before, lost);
    const double radius = radius_of(cell.profile);
    for (unsigned int q = 0; q < cell.chain.size(); ++q) {
      const double *const from = before.data() + place_of(cell, q), *const to = after.data() +
                                                                                place_of(cell, q);
      const Vector6 by = Values(to + strain) - Values(from + strain);
      const double growth = size_of(by, radius);
      const SectionReport gained =
          cell.law(q).report(to + strain, 1., {}, to + internal, from + internal);
      const double bound = cell.law(q).elastic_bound(stretch.data(), 1., {}),
                   yield_strain = std::isfinite(bound) ? std::min(most_yield_strain, 1. / bound)
                                                       : most_yield_strain;
      double flow = gained.plastic_strain + gained.creep_strain;
      const bool is_told = !std::isnan(flow);
      if (!is_told) { // what the largest force dissipates by; a law may count that as stored
        constexpr double least = 1e-3; // of the force at yield
        const double dissipated = to[lost] - from[lost], kept = to[stored] - from[stored];
        flow =
            (dissipated + std::max(kept, 0.)) / std::max({force_of(Values(from + stress), radius),
                                                          force_of(Values(to + stress), radius),
                                                          least * yield_strain * cell.profile.EA});
      }
      const bool flows = flow > no_flow * yield_strain,
                 comes_back =
                     !flows || growth <= closed * std::max(flow, least_flow * yield_strain);
      if (change.comes_back && !comes_back)
        change.growth = 0.; // of those that count from here on
      if ((!comes_back || change.comes_back) && growth > change.growth) {
        change.growth = growth;
        change.cell = i;
        change.part = cell.part[q];
      }
      change.comes_back = change.comes_back && comes_back;
      change.flows = change.flows || flows;
      if (flows && !is_told && flow > most_untold) {
        most_untold = flow;
        change.flow = std::numeric_limits<double>::quiet_NaN();
        cell_of_flow = i;
        part_of_flow = cell.part[q];
      }
      if (is_told && flow > change.flow) {
        change.flow = flow;
        cell_of_flow = i;
        part_of_flow = cell.part[q];
      }
    }
  }
  if (change.comes_back && !(change.flow <= 0.)) {
    change.cell = cell_of_flow;
    change.part = part_of_flow;
  }
  return change;
}

std::vector<PipeSections::Report> PipeSections::reports(const unsigned int index,
                                                        const Surroundings &surroundings,
                                                        const Vector &states) const {
  const Cell &cell = *cells[index];
  LawIncrement increment;
  increment.temperature = surroundings.temperature;
  increment.pressure = surroundings.pressure;
  std::vector<Report> result;
  for (unsigned int q = 0; q < cell.chain.size(); ++q) {
    const double *const values = states.data() + place_of(cell, q);
    Vector6 of_strain = Values(values + strain), of_stress = Values(values + stress);
    if (!cell.turn.empty()) { // back to the local axes
      of_strain = cell.turn[q].transpose() * of_strain;
      of_stress = cell.turn[q].transpose() * of_stress;
    }
    result.push_back({cell.part[q], of_strain, of_stress,
                      cell.law(q).report(values + strain, 1., increment, values + internal),
                      cell.chain[q].length, values[lost]});
  }
  return result;
}

} // namespace frictionbeam
