// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_stations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam {

namespace {

constexpr std::size_t n_stations_at_most = 2500;

} // namespace

ModelStations::ModelStations(const Frame &first, const std::set<unsigned int> &named,
                             const std::set<std::array<double, 3>> &held)
    : first(first) {
  double length = 0.;
  for (std::size_t i = 1; i < first.line.size(); ++i)
    if (first.line[i].pipe == first.line[i - 1].pipe)
      length += first.line[i].position.distance(first.line[i - 1].position);
  const double spacing =
      first.line.size() > n_stations_at_most ? length / (0.7 * n_stations_at_most) : 0.;
  constexpr double turn = 0.97; // cosine of 14 degrees
  for (std::size_t i = 0; i < first.line.size(); ++i) {
    const Station &station = first.line[i];
    const bool begins = i == 0 || first.line[i - 1].pipe != station.pipe,
               ends = i + 1 == first.line.size() || first.line[i + 1].pipe != station.pipe;
    const auto is_kept = [&]() {
      if (begins || ends || spacing == 0. || (station.is_node() && named.count(station.vertex) > 0))
        return true;
      const Point3 &p = station.position;
      const Station &last = first.line[kept.back()];
      const double far = p.distance(last.position);
      return far > spacing || held.count({{p[0], p[1], p[2]}}) > 0 ||
             (far > 0. && station.y.norm_square() > 0. &&
              station.y * last.y + station.z * last.z < 2. * turn);
    };
    if (is_kept())
      kept.push_back(i);
  }
}

bool ModelStations::continues(const std::size_t k) const {
  return k + 1 < size() && (*this)[k].pipe == (*this)[k + 1].pipe;
}

std::vector<std::size_t> ModelStations::places_in(const Frame &frame) const {
  constexpr double same_place = 1e-9;                                  // of the way along a pipe
  std::map<unsigned int, std::pair<std::size_t, std::size_t>> of_pipe; // begin and end
  for (std::size_t i = 0; i < frame.line.size(); ++i)
    of_pipe.emplace(frame.line[i].pipe, std::make_pair(i, i)).first->second.second = i + 1;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < size(); ++k) {
    const Station &station = (*this)[k];
    const auto pipe = of_pipe.find(station.pipe);
    if (pipe == of_pipe.end())
      return {};
    const auto [begin, end] = pipe->second;
    const double margin = same_place * std::max(1., station.s);
    std::size_t i =
        std::lower_bound(frame.line.begin() + begin, frame.line.begin() + end, station.s - margin,
                         [](const Station &at, const double s) { return at.s < s; }) -
        frame.line.begin();
    i = std::min(i, end - 1);
    const bool is_second =
        k > 0 && (*this)[k - 1].pipe == station.pipe && station.s - (*this)[k - 1].s <= margin;
    while (is_second && i + 1 < end && frame.line[i + 1].s <= station.s + margin)
      ++i;
    places.push_back(i);
  }
  return places;
}

std::pair<std::size_t, std::size_t>
ModelStations::stretch(const std::size_t k, const std::vector<std::size_t> &places) const {
  return {places[k], continues(k) ? std::max(places[k + 1], places[k] + 1) : places[k] + 1};
}

std::vector<double> ModelStations::thinned(const std::vector<double> &values,
                                           const std::vector<std::size_t> &places) const {
  std::vector<double> result;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto [begin, end] = stretch(k, places);
    double value = values[begin];
    for (std::size_t i = begin + 1; i < end; ++i)
      if (!(std::abs(values[i]) <= std::abs(value)) && std::isfinite(values[i]))
        value = values[i];
    result.push_back(value);
  }
  return result;
}

std::size_t ModelStations::nearest(const Point3 &position) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < size(); ++i)
    if (const double distance = (*this)[i].position.distance_square(position); distance < least) {
      least = distance;
      best = i;
    }
  return best;
}

} // namespace frictionbeam
