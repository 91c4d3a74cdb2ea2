// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/model_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

template <typename Value>
std::vector<double> of_stations(const Frame &frame, const Value &value) {
  std::vector<double> values;
  for (const Station &station : frame.line)
    values.push_back(value(station));
  return values;
}

std::vector<double> axial_force(const Scene &, const Results &, const Frame &frame, const bool) {
  return of_stations(frame, [](const Station &at) { return at.force[0]; });
}

std::vector<double> shear_force(const Scene &, const Results &, const Frame &frame, const bool) {
  return of_stations(frame, [](const Station &at) { return std::hypot(at.force[1], at.force[2]); });
}

std::vector<double> torsion(const Scene &, const Results &, const Frame &frame, const bool) {
  return of_stations(frame, [](const Station &at) { return at.force[3]; });
}

std::vector<double> bending(const Scene &, const Results &, const Frame &frame, const bool) {
  return of_stations(frame, [](const Station &at) { return std::hypot(at.force[4], at.force[5]); });
}

/// Over the stress cases that belong to a step, the largest of a number at each station.
template <typename Value>
std::vector<double> largest_of_cases(const Results &results, const Frame &frame,
                                     const Value &value) {
  std::vector<double> values;
  for (const StressCase &one : results.stresses)
    if (one.step == frame.name && one.stress.size() == frame.line.size()) {
      values.resize(frame.line.size(), not_known);
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::fmax(values[i], value(one, i));
    }
  return values;
}

std::vector<double> stress(const Scene &, const Results &results, const Frame &frame,
                           const bool is_instant) {
  return is_instant ? std::vector<double>()
                    : largest_of_cases(results, frame, [](const StressCase &one, std::size_t i) {
                        return one.stress[i];
                      });
}

std::vector<double> utilization(const Scene &, const Results &results, const Frame &frame,
                                const bool is_instant) {
  return is_instant ? std::vector<double>()
                    : largest_of_cases(results, frame, [](const StressCase &one, std::size_t i) {
                        return one.stress[i] / one.allowed[i];
                      });
}

/// Of pipes that yield or creep: equivalent stress over the yield stress reached, of the section
/// beside each station.
std::vector<double> yield_utilization(const Scene &, const Results &, const Frame &frame,
                                      const bool) {
  if (frame.sections.empty())
    return {};
  const auto before = [](const SectionState &section, const Station &at) {
    return section.pipe != at.pipe ? section.pipe < at.pipe : section.s < at.s;
  };
  return of_stations(frame, [&](const Station &at) {
    double largest = not_known;
    auto after = std::lower_bound(frame.sections.begin(), frame.sections.end(), at, before);
    for (const auto *one : {after == frame.sections.begin() ? nullptr : &*std::prev(after),
                            after == frame.sections.end() ? nullptr : &*after})
      if (one != nullptr && one->pipe == at.pipe && std::abs(one->s - at.s) <= one->length)
        largest = std::fmax(largest, one->utilization);
    return largest;
  });
}

/// By the loads at the end of a static step; unknown where a history multiplies them.
std::vector<double> temperature(const Scene &scene, const Results &, const Frame &frame,
                                const bool is_instant) {
  if (is_instant || frame.step >= scene.steps.size() ||
      std::none_of(scene.loads.begin(), scene.loads.end(),
                   [](const Load &load) { return load.kind == Load::Kind::temperature; }))
    return {};
  std::vector<double> of_pipe;
  for (const Pipe &pipe : scene.pipes) {
    double rise = 0., from = scene.installation_temperature;
    for (const auto &[number, factor] : scene.steps[frame.step].loads) {
      const Load &load = scene.loads[number];
      if (load.kind != Load::Kind::temperature || !load.is_on(pipe.name))
        continue;
      from = load.installation;
      rise += load.history.is_given() ? not_known : factor * load.value;
    }
    of_pipe.push_back(from + rise);
  }
  return of_stations(frame, [&](const Station &at) { return of_pipe[at.pipe]; });
}

} // namespace

const std::vector<ModelField> &model_fields() {
  static const std::vector<ModelField> fields{
      {"N", "axial force N", "N", true, &axial_force},
      {"V", "shear force", "N", false, &shear_force},
      {"Mx", "torsional moment Mx", "N m", true, &torsion},
      {"M", "bending moment", "N m", false, &bending},
      {"stress", "code stress", "Pa", false, &stress},
      {"utilization", "utilization of the code", "%", false, &utilization},
      {"yield", "equivalent stress over yield stress", "%", false, &yield_utilization},
      {"temperature", "temperature", "degC", false, &temperature}};
  return fields;
}

} // namespace frictionbeam
