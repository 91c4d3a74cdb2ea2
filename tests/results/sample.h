// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <cmath>
#include <limits>

/// Made-up results with everything that is hard on a writer: names with commas, quotes, line breaks
/// and signs of HTML, text that is no UTF-8, numbers that are none.
struct Sample {
  frictionbeam::Scene scene;
  frictionbeam::Results results;
};

inline const std::string hard_name = "rest, \"north\"\n<b>&'1";

inline Sample make_sample(const unsigned int n_supports, const unsigned int n_stations) {
  using namespace frictionbeam;
  Sample sample;
  Scene &scene = sample.scene;
  Results &results = sample.results;
  const double length = 120.;

  scene.name = "sample";
  scene.title = "A <script>line</script> of \xff pipe";
  scene.input = "set Title = <script>";
  scene.pipes.resize(1);
  scene.pipes[0].name = "pipe, 1";
  scene.materials.resize(1);
  scene.sections.resize(1);
  scene.monitors = {"tip", "a/b"};
  for (const char *name : {"weight", "heating, \"hot\" <1>"}) {
    scene.steps.emplace_back();
    scene.steps.back().name = name;
  }

  for (unsigned int i = 0; i < n_supports; ++i) {
    SupportInfo info;
    info.name = i == 0 ? hard_name : "rests." + std::to_string(i);
    info.kind = "rest";
    info.position = Point3(length * (i + 1.) / (n_supports + 1.), 0., 3.);
    info.normal[2] = info.t1[0] = info.t2[1] = 1.;
    results.supports.push_back(info);
  }
  results.restraints = {{"anchor", "anchor", Point3(0., 0., 3.)}};

  const std::array<ContactStatus, 4> statuses{
      {ContactStatus::stick, ContactStatus::slip, ContactStatus::open, ContactStatus::closed}};
  for (unsigned int step = 0; step < 2; ++step)
    for (unsigned int increment = 1; increment <= 2; ++increment) {
      Frame frame;
      frame.name = scene.steps[step].name;
      frame.step = step;
      frame.step_before = static_cast<int>(step) - 1;
      frame.increment = increment;
      frame.time = step + 0.5 * increment;
      frame.end_of_step = increment == 2;
      for (unsigned int i = 0; i < n_stations; ++i) {
        Station station;
        station.s = length * i / (n_stations - 1.);
        station.position = Point3(station.s, 0., 3.);
        station.displacement = {
            {1e-3 * step * station.s, 0., -0.01 * std::sin(station.s), 0., 0., 0.}};
        station.force = {{-2e4 * step, 0., 0.1, 0., 3e3 * std::cos(station.s), 0.}};
        frame.line.push_back(station);
      }
      for (unsigned int i = 0; i < n_supports; ++i)
        frame.supports.push_back({statuses[i % 4], 0.1 + i, -0.03, 0., 0., 1e-3, 0., 2.5});
      frame.reactions.push_back({{1., 2., 3., 4., 5., std::numeric_limits<double>::quiet_NaN()}});
      results.frames.push_back(frame);
    }
  for (const auto &point : scene.monitors) {
    results.histories.emplace_back();
    results.histories.back().point = point;
  }

  QuantityResult quantity;
  quantity.name = "displacement \"x\" \\ \t\x01 \xc3\xa9 \xff";
  quantity.value = 0.1;
  quantity.unit = "m";
  quantity.reference = 0.2;
  quantity.error = std::numeric_limits<double>::infinity();
  results.quantities.push_back(quantity);
  quantity.value = std::numeric_limits<double>::quiet_NaN();
  quantity.reference.reset();
  quantity.error.reset();
  results.quantities.push_back(quantity);

  results.steps.resize(2);
  for (unsigned int step = 0; step < 2; ++step) {
    results.steps[step].step = scene.steps[step].name;
    results.steps[step].converged = step == 0;
  }
  results.certificate = {{"equilibrium", "-", "largest force left over", 1e-13}};
  results.remarks = {"a remark"};
  results.method = "none";
  results.status = RunStatus::converged;
  return sample;
}
