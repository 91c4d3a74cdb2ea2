// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/peaks_between_stations.h"

#include "base/lagrange_weights.h"

#include "results/stress/wall_stress.h"
#include "results/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double worth_more_stations = 0.01; // of the largest bending stress at stations
constexpr unsigned int n_places = 16;        // within three stations

/// Bending moment of a station over what makes a stress of it [Pa].
double bending_stress(const Section &section, const double My, const double Mz) {
  return std::hypot(My, Mz) * section.outer_radius / section.inertia;
}

struct Peak {
  double stress = 0., s = 0.;
  std::string pipe, step;
};

/// Moments of a straight cell under loads along it are parabolas: by those of three stations.
void look_between(const Scene &scene, const Frame &frame, const std::size_t first, Peak &largest) {
  const std::array<const Station *, 3> at = {&frame.line[first], &frame.line[first + 1],
                                             &frame.line[first + 2]};
  const std::array<double, 3> places = {at[0]->s, at[1]->s, at[2]->s};
  const Section section = section_at(scene, *at[1]);
  for (unsigned int i = 1; i < n_places; ++i) {
    const double s = at[0]->s + i * (at[2]->s - at[0]->s) / n_places;
    const std::array<double, 3> weights = lagrange_weights(places, s);
    double My = 0., Mz = 0.;
    for (unsigned int k = 0; k < at.size(); ++k) {
      My += weights[k] * at[k]->force[4];
      Mz += weights[k] * at[k]->force[5];
    }
    if (const double stress = bending_stress(section, My, Mz); stress > largest.stress)
      largest = {stress, s, scene.pipes[at[1]->pipe].name, frame.name};
  }
}

} // namespace

void remark_on_peaks_between_stations(const Scene &scene, Results &results) {
  const bool asks = !scene.stress.code.empty() ||
                    std::any_of(scene.materials.begin(), scene.materials.end(),
                                [](const Material &one) { return one.yield_stress > 0.; });
  if (!asks || scene.output.stations == 0)
    return;
  double at_stations = 0.;
  Peak between;
  for (const Frame &frame : results.frames) {
    if (!frame.end_of_step || frame.step >= scene.steps.size() || scene.steps[frame.step].transient)
      continue;
    for (const Station &station : frame.line)
      at_stations = std::max(at_stations, bending_stress(section_at(scene, station),
                                                         station.force[4], station.force[5]));
    for (std::size_t i = 0; i + 2 < frame.line.size(); ++i) {
      const Station &middle = frame.line[i + 1];
      if (!middle.is_node() && middle.bend_radius == 0. && frame.line[i].s < middle.s &&
          middle.s < frame.line[i + 2].s)
        look_between(scene, frame, i, between);
    }
  }
  const double missed = between.stress / at_stations - 1.;
  if (!(at_stations > 0.) || !(missed > worth_more_stations))
    return;
  const unsigned int enough =
      std::ceil((scene.output.stations + 1) * std::sqrt(missed / worth_more_stations));
  results.remarks.push_back(
      "Pipe " + between.pipe +
      " bends more at s = " + rounded_number(between.s / scene.units.factor("m"), 4) + " " +
      scene.units.name("m") + ", between two stations, than anywhere at stations, by " +
      rounded_number(100. * missed, 2) + " % in step " + between.step +
      ". Stresses are told of at stations alone: take Output/Stations = " + std::to_string(enough) +
      ".");
}

} // namespace frictionbeam
