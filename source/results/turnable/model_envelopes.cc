// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_envelopes.h"
#include "results/envelope/kept_instants.h"
#include "results/turnable/packed_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned int digits = 6;

Json row(const Extremes &of, const double unit) {
  if (!of.is_known())
    return Json();
  return Json::array({rounded(of.least / unit, digits), rounded(of.least_at, digits),
                      rounded(of.largest / unit, digits), rounded(of.largest_at, digits)});
}

/// Section forces of the stations that are kept, each the extreme of those that it stands for.
void add_section_forces(const StepEnvelope &envelope, const std::vector<std::size_t> &places,
                        const ModelStations &stations, Json &json) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::size_t n = places.size();
  constexpr std::array<const char *, 6> names{{"N", "Vy", "Vz", "Mx", "My", "Mz"}};
  for (unsigned int c = 0; c < 6; ++c) {
    std::vector<double> least(n), least_at(n), largest(n), largest_at(n);
    for (std::size_t k = 0; k < n; ++k) {
      const auto [begin, end] = stations.stretch(k, places);
      std::size_t low = 6 * begin + c, high = low;
      for (std::size_t i = 6 * begin + c; i < 6 * end; i += 6) {
        low = envelope.least[i] < envelope.least[low] ? i : low;
        high = envelope.largest[i] > envelope.largest[high] ? i : high;
      }
      const bool is_known = envelope.least[low] <= envelope.largest[high];
      least[k] = is_known ? envelope.least[low] : unknown;
      least_at[k] = is_known ? envelope.least_at[low] : unknown;
      largest[k] = is_known ? envelope.largest[high] : unknown;
      largest_at[k] = is_known ? envelope.largest_at[high] : unknown;
    }
    json["forces"][names[c]] = {{"least", packed(least)},
                                {"least_at", packed(least_at)},
                                {"largest", packed(largest)},
                                {"largest_at", packed(largest_at)}};
  }
}

} // namespace

Json model_envelopes(const Scene &scene, const Results &results, const ModelStations &stations,
                     const std::vector<std::size_t> &supports, const std::size_t n_restraints) {
  Frame line; // as the envelopes know it
  for (const StationPlace &place : results.stations) {
    line.line.emplace_back();
    line.line.back().pipe = place.pipe;
    line.line.back().s = place.s;
  }
  const std::vector<std::size_t> places = stations.places_in(line);
  const MotionBudget budget(scene, stations.size(), supports.size());
  const double N = results.units.factor("N"), m = results.units.factor("m"),
               Nm = results.units.factor("N m");
  Json all = Json::array();
  for (const StepEnvelope &envelope : results.envelopes) {
    Json json{{"name", scene.steps[envelope.step].name},
              {"instants", envelope.n_instants},
              {"supports", Json::array()},
              {"restraints", Json::array()}};
    for (const std::size_t i : supports) {
      const SupportEnvelope &one = envelope.supports[i];
      json["supports"].push_back(Json{{"fn", row(one.values[0], N)},
                                      {"ft", row(one.friction, N)},
                                      {"gap", row(one.values[3], m)},
                                      {"slip1", row(one.values[4], m)},
                                      {"slip2", row(one.values[5], m)}});
    }
    for (std::size_t i = 0; i < std::min(n_restraints, envelope.restraints.size()); ++i) {
      constexpr std::array<const char *, 6> names{{"fx", "fy", "fz", "mx", "my", "mz"}};
      Json rows = Json::object();
      for (unsigned int c = 0; c < 6; ++c)
        rows[names[c]] = row(envelope.restraints[i].values[c], c < 3 ? N : Nm);
      json["restraints"].push_back(rows);
    }
    if (!places.empty() && budget.has_envelopes())
      add_section_forces(envelope, places, stations, json);
    all.push_back(json);
  }
  return all;
}

} // namespace frictionbeam
