// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/neighbours.h"

#include "base/number_text.h"
#include "mesh/point_set.h"

#include <algorithm>

namespace frictionbeam::import {

namespace {

constexpr double least_distance = 1e-8; ///< that points are told apart by [m]

/// What goes on from component to component along a line.
constexpr Property going_on[] = {Property::temperature,        Property::pressure,
                                 Property::contents,           Property::insulation,
                                 Property::insulation_density, Property::corrosion_allowance};

bool says_nothing(const PcfComponent &component) {
  return component.properties.material.empty() &&
         std::none_of(std::begin(going_on), std::end(going_on), [&](const Property property) {
           return component.properties.number(property).has_value();
         });
}

} // namespace

void complete_by_neighbours(PcfLine &line, const double tolerance, Notes &notes) {
  PointSet points(std::max(tolerance, least_distance));
  std::vector<std::vector<std::size_t>> at; // components at each point
  std::vector<std::vector<int>> of(line.components.size());
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < line.components.size(); ++i) {
    const PcfComponent &component = line.components[i];
    if (component.shape == Shape::support || component.shape == Shape::joint)
      continue;
    for (const std::vector<PcfPoint> *const list : {&component.ends, &component.branches})
      for (const PcfPoint &point : *list) {
        of[i].push_back(points.insert(point.position));
        at.resize(points.points.size());
        at[of[i].back()].push_back(i);
      }
    if (!says_nothing(component))
      known.push_back(i);
  }
  std::vector<std::string> completed;
  for (std::size_t k = 0; k < known.size(); ++k) // it grows
    for (const int point : of[known[k]])
      for (const std::size_t i : at[point]) {
        PcfComponent &component = line.components[i];
        if (!says_nothing(component))
          continue;
        const Properties &source = line.components[known[k]].properties;
        for (const Property property : going_on)
          if (const auto value = source.number(property))
            component.properties.numbers[property] = *value;
        component.properties.material = source.material;
        known.push_back(i);
        completed.push_back(component.keyword + " of line " + std::to_string(component.line));
      }
  if (!completed.empty())
    notes.assumed.push_back(
        {0,
         "temperature, pressure, contents, insulation and metal as of what they are joined to: " +
             first_of(completed)});
}

} // namespace frictionbeam::import
