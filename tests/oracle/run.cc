// SPDX-License-Identifier: LGPL-2.1-or-later
#include "frame.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

/// A member's end at a point.
struct Leg {
  int pipe;
  Vec outward, along; ///< from the point, and as the pipe goes
};

const double straight = std::cos(10. * pi / 180.);

Vec between(const Leg &a, const Leg &b) {
  const Vec way = b.outward - a.outward;
  if (way.norm() < 1e-9) // folded
    return a.along;
  return (way.dot(a.along) < 0. ? -1. : 1.) * way.normalized();
}

} // namespace

Vec Frame::tangent_of(const int pipe, const int node) const {
  Vec sum = Vec::Zero();
  for (const Member &member : members)
    for (const int end : {0, 1})
      if (member.pipe == pipe && member.node[end] == node)
        sum += member.tangent[end];
  return sum.normalized();
}

Vec Frame::run_through(const int node) const {
  std::vector<Leg> all, run;
  for (const Member &member : members)
    for (const int end : {0, 1})
      if (member.node[end] == node)
        all.push_back(
            {member.pipe, (end == 0 ? 1. : -1.) * member.tangent[end], member.tangent[end]});
  for (const Leg &leg : all)
    if (std::none_of(scene.tees.begin(), scene.tees.end(), [&](const Tee &tee) {
          return point_node.at(tee.at) == node && tee.branch == scene.pipes[leg.pipe].name;
        }))
      run.push_back(leg);
  if (run.empty())
    run = all;
  if (run.size() < 2)
    return run.empty() ? Vec(Vec::Zero()) : run[0].along;
  if (run.size() == 2)
    return between(run[0], run[1]);
  std::vector<Vec> of_one, of_two;
  for (std::size_t i = 0; i < run.size(); ++i)
    for (std::size_t j = i + 1; j < run.size(); ++j)
      if (run[i].outward.dot(run[j].outward) < -straight)
        (run[i].pipe == run[j].pipe ? of_one : of_two).push_back(between(run[i], run[j]));
  const std::vector<Vec> &found = of_one.empty() ? of_two : of_one;
  if (found.empty())
    return Vec::Zero();
  const bool same = std::all_of(found.begin(), found.end(), [&](const Vec &other) {
    return std::abs(other.dot(found[0])) >= straight;
  });
  return same ? found[0] : Vec(Vec::Zero());
}

double Frame::bed_cell(const int pipe, const double from, const double to) const {
  double shortest = 0.;
  for (const Support &support : scene.supports) {
    if (!support.continuous || support.pipe != scene.pipes[pipe].name)
      continue;
    double begin = 0., end = paths[pipe].length;
    for (const auto &[corner, s] : paths[pipe].names) {
      if (corner == support.from)
        begin = s;
      if (corner == support.to)
        end = s;
    }
    const double middle = (from + to) / 2.;
    if (middle < begin || middle > end)
      continue;
    const bool inches = scene.units.find("in ") == 0 || scene.units.find("ft ") == 0;
    const Figures f = figures(scene.sections[scene.pipes[pipe].section], inches);
    const double diameter = f.radius > 0. ? 2. * f.radius : std::sqrt(8. * f.inertia / f.area),
                 cell = std::min((end - begin) / 100., 2. * diameter);
    shortest = shortest > 0. ? std::min(shortest, cell) : cell;
  }
  return shortest;
}

} // namespace oracle
