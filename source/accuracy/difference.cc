// SPDX-License-Identifier: LGPL-2.1-or-later
#include "difference.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam::accuracy {

namespace {

constexpr double floor_of_unit = 0.01; ///< as in frictionbeam chart

bool is_count(const std::string &what) {
  return what == "n_stick" || what == "n_slip" || what == "n_open";
}

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
  double value = 0.;
  for (std::size_t i = first; i < first + m; ++i) {
    double weight = 1.;
    for (std::size_t j = first; j < first + m; ++j)
      if (j != i)
        weight *= (time - t[j]) / (t[i] - t[j]);
    value += weight * history.displacement[i][component];
  }
  return value;
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
    largest[one.unit] = std::max(largest[one.unit], std::abs(one.value));
  std::vector<Difference> result;
  for (const QuantityResult &one : fine.quantities) {
    const Quantity *const quantity = find(scene, one.name);
    if (quantity == nullptr || is_count(quantity->what))
      continue;
    if (quantity->what == "max_error") {
      if (scene.exact)
        result.push_back({distance(*scene.exact, coarse, fine), one.name});
      continue;
    }
    for (const QuantityResult &other : coarse.quantities)
      if (other.name == one.name) {
        const double scale = std::max(std::abs(one.value), floor_of_unit * largest[one.unit]);
        result.push_back({std::abs(other.value - one.value) / (scale > 0. ? scale : 1.), one.name});
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
    if (is_count(quantity.what))
      names.push_back(quantity.name + ": a number of supports has no relative error");
  return names;
}

} // namespace frictionbeam::accuracy
