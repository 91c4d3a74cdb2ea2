// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/difference.h"

#include "base/lagrange_weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace frictionbeam::accuracy {

namespace {

constexpr double floor_of_unit = 0.01; ///< as in frictionbeam chart
constexpr double floor_of_line = 1e-6; ///< of the largest anywhere: less than that is nothing

using Measure = QuantityKind::Measure;

const Quantity *find(const Scene &scene, const std::string &name) {
  const auto found = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                  [&](const Quantity &one) { return one.name == name; });
  return found == scene.quantities.end() ? nullptr : &*found;
}

const History *history_of(const Results &results, const std::string &point) {
  for (const History &history : results.histories)
    if (history.point == point)
      return &history;
  return nullptr;
}

/// Value of a history at @p time, by the cubic through the four instants around it.
double value_at(const History &history, const unsigned int component, const double time) {
  const std::vector<double> &t = history.time;
  const std::size_t n = t.size(), m = std::min<std::size_t>(4, n);
  const std::size_t after = std::lower_bound(t.begin(), t.end(), time) - t.begin();
  const std::size_t first = std::min(n - m, after < 2 ? 0 : after - 2);
  const std::vector<double> weights =
      lagrange_weights(std::vector<double>(t.begin() + first, t.begin() + first + m), time);
  double value = 0.;
  for (std::size_t i = 0; i < m; ++i)
    value += weights[i] * history.displacement[first + i][component];
  return value;
}

/// Largest displacement, rotation, force and moment of the line at the ends of steps, by unit.
std::map<std::string, double> largest_of_line(const UnitSystem &units, const Results &results) {
  std::map<std::string, double> largest;
  for (const Frame &frame : results.frames)
    for (const Station &station : frame.line)
      for (unsigned int c = 0; c < 6; ++c) {
        const std::string motion = c < 3 ? "m" : "rad", force = c < 3 ? "N" : "N m";
        for (const auto &[unit, value] :
             {std::pair(motion, station.displacement[c]), std::pair(force, station.force[c])}) {
          double &most = largest[units.name(unit)];
          most = std::max(most, std::abs(value) / units.factor(unit));
        }
      }
  largest[units.name("J")] = largest[units.name("m")] * units.factor("m") *
                             largest[units.name("N")] * units.factor("N") / units.factor("J");
  return largest;
}

/// Largest distance of two motions.
double distance(const ExactHistory &exact, const Results &coarse, const Results &fine) {
  const History *const a = history_of(coarse, exact.point), *const b =
                                                                history_of(fine, exact.point);
  double largest = 0.;
  if (a == nullptr || b == nullptr || b->time.size() < 2)
    return largest;
  for (std::size_t i = 0; i < a->time.size(); ++i)
    largest = std::max(largest, std::abs(a->displacement[i][exact.component] -
                                         value_at(*b, exact.component, a->time[i])));
  return largest / (exact.largest > 0. ? exact.largest : 1.);
}

} // namespace

std::vector<Difference> differences(const Scene &scene, const Results &coarse,
                                    const Results &fine) {
  std::map<std::string, double> largest; // by unit
  for (const QuantityResult &one : fine.quantities)
    if (const Quantity *const quantity = find(scene, one.name);
        quantity != nullptr && quantity->kind().measure != Measure::place) // and no motion
      largest[one.unit] = std::max(largest[one.unit], std::abs(one.value));
  std::map<std::string, double> of_line = largest_of_line(scene.units, fine);
  std::vector<Difference> result;
  for (const QuantityResult &one : fine.quantities) {
    const Quantity *const quantity = find(scene, one.name);
    if (quantity == nullptr || quantity->kind().measure == Measure::count || one.of_impact)
      continue;
    if (quantity->kind().measure == Measure::error) {
      if (scene.exact)
        result.push_back({distance(*scene.exact, coarse, fine), one.name, 1.});
      continue;
    }
    for (const QuantityResult &other : coarse.quantities)
      if (other.name == one.name && !other.of_impact) {
        double scale =
            std::max({std::abs(one.value), floor_of_unit * std::max(largest[one.unit], one.whole),
                      floor_of_line * of_line[one.unit]});
        if (scale == 0.)
          scale = 1.;
        result.push_back(
            {std::abs(other.value - one.value) / scale, one.name, scale, one.apart / scale});
      }
  }
  return result;
}

Difference largest(const std::vector<Difference> &differences) {
  Difference result;
  for (const Difference &one : differences)
    if (!(one.value <= result.value)) // nan counts as the largest
      result = one;
  return result;
}

std::vector<std::string> left_out(const Scene &scene) {
  std::vector<std::string> names;
  for (const Quantity &quantity : scene.quantities)
    if (quantity.kind().measure == Measure::count)
      names.push_back(quantity.name + ": a number of supports has no relative error");
  return names;
}

std::string left_out_of_walls() {
  return "largest_ovality and largest_wall_stress: cells are chosen for the other quantities, and "
         "where a held section or a patch's edge bends the wall, stress has no bound on finer "
         "meshes";
}

std::vector<std::string> left_out_by(const ModelKind model, const Scene &scene) {
  std::set<std::string> of_line, of_continuum;
  for (const Quantity &quantity : scene.quantities)
    of_line.insert(quantity.name);
  if (scene.continuum)
    for (const ContinuumQuantity &quantity : scene.continuum->quantities)
      of_continuum.insert(quantity.name);
  const bool is_line = model != ModelKind::continuum;
  std::vector<std::string> names;
  for (const std::string &name : is_line ? of_continuum : of_line)
    if ((is_line ? of_line : of_continuum).count(name) == 0)
      names.push_back(name + ": the " + (is_line ? "line" : "continuum") + " does not have it");
  return names;
}

} // namespace frictionbeam::accuracy
