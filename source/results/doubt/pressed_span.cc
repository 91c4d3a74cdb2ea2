// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/pressed_span.h"

#include "mesh/point_set.h"
#include "results/held_directions.h"
#include "results/stress/wall_stress.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {

using Run = std::vector<const Station *>;

/// Stations of pipes that go on into each other, where nothing else is joined to them.
class Runs {
public:
  explicit Runs(const std::vector<Station> &line) {
    for (std::size_t begin = 0; begin < line.size();) {
      pipes.emplace_back();
      const unsigned int pipe = line[begin].pipe;
      for (; begin < line.size() && line[begin].pipe == pipe; ++begin)
        pipes.back().push_back(&line[begin]);
    }
    for (std::size_t i = 0; i < pipes.size(); ++i)
      for (const Station *const station : pipes[i])
        if (station->is_node()) {
          const bool is_end = station == pipes[i].front() || station == pipes[i].back();
          n_sides[station->vertex] += is_end ? 1 : 2;
          if (is_end)
            pipes_ending_at[station->vertex].push_back(i);
        }
    is_in_run.resize(pipes.size(), false);
    for (std::size_t i = 0; i < pipes.size(); ++i) {
      if (is_in_run[i])
        continue;
      is_in_run[i] = true;
      Run run = pipes[i];
      for (int side = 0; side < 2; ++side) {
        extend(run);
        std::reverse(run.begin(), run.end());
      }
      all.push_back(std::move(run));
    }
  }

  bool is_end_of_line(const Station &station) const {
    return station.is_node() && n_sides.at(station.vertex) == 1;
  }

  std::vector<Run> all;

private:
  /// By the pipes behind its last station.
  void extend(Run &run) {
    while (run.back()->is_node() && n_sides.at(run.back()->vertex) == 2) {
      const std::vector<std::size_t> &there = pipes_ending_at.at(run.back()->vertex);
      const auto next = std::find_if(there.begin(), there.end(),
                                     [&](const std::size_t pipe) { return !is_in_run[pipe]; });
      if (next == there.end())
        return;
      is_in_run[*next] = true;
      Run behind = pipes[*next];
      if (behind.front()->vertex != run.back()->vertex)
        std::reverse(behind.begin(), behind.end());
      run.insert(run.end(), behind.begin(), behind.end());
    }
  }

  std::vector<Run> pipes;
  std::map<unsigned int, int> n_sides; ///< of pipe at each vertex
  std::map<unsigned int, std::vector<std::size_t>> pipes_ending_at;
  std::vector<bool> is_in_run;
};

/// What holds a line in a frame, by places.
class Holds {
public:
  Holds(const Scene &scene, const Results &results, const Frame &frame, const double touching)
      : places(touching) {
    for (const RestraintInfo &info : results.restraints)
      places.insert(info.position);
    std::vector<const Station *> stations(places.points.size(), nullptr);
    for (const Station &station : frame.line)
      if (station.is_node())
        if (const std::size_t place = places.insert(station.position); place < stations.size())
          stations[place] = &station;
    for (const RestraintInfo &info : results.restraints)
      if (const Station *const station = stations[places.insert(info.position)])
        for (const Vector3 &direction : held_directions(scene, info, *station))
          add(info.position, direction);
    for (std::size_t i = 0; i < frame.supports.size(); ++i) {
      const SupportInfo &info = results.supports[i];
      if (stands_off(frame.supports[i], touching))
        continue;
      add(info.position, info.normal);
      if (frame.supports[i].status == ContactStatus::stick)
        for (const Vector3 &direction : {info.t1, info.t2})
          add(info.position, direction);
    }
  }

  /// Whether anything holds the line there that has this direction.
  bool hold_aside(const Station &station, const Vector3 &along) {
    constexpr double aside = 0.1; // of a unit vector
    if (!station.is_node())
      return false;
    const std::size_t place = places.insert(station.position);
    return place < directions.size() &&
           std::any_of(
               directions[place].begin(), directions[place].end(),
               [&](const Vector3 &held) { return (held - (held * along) * along).norm() > aside; });
  }

private:
  void add(const Point3 &position, const Vector3 &direction) {
    const std::size_t place = places.insert(position);
    directions.resize(std::max(directions.size(), place + 1));
    directions[place].push_back(direction);
  }

  PointSet places;
  std::vector<std::vector<Vector3>> directions; ///< unit, of each place
};

/// Of a stretch of a run, unless it is bent.
std::optional<PressedSpan> straight_span(const Scene &scene, const Run &run,
                                         const std::size_t begin, const std::size_t end) {
  constexpr double straight = 1e-6;
  PressedSpan span;
  span.begin = *run[begin];
  span.end = *run[end];
  double length = 0., stiffness = 0.; // EI [N m2]
  span.compression = std::numeric_limits<double>::infinity();
  for (std::size_t i = begin; i <= end; ++i) {
    const Station &station = *run[i];
    if (i > begin)
      length += station.position.distance(run[i - 1]->position);
    span.has_nodes = span.has_nodes || (i > begin && i < end && station.is_node());
    span.compression = std::min(span.compression, -station.force[0]);
    stiffness =
        std::max(stiffness, scene.materials[scene.pipes[station.pipe].material].youngs_modulus *
                                section_at(scene, station).inertia);
  }
  if (length == 0. || length > (1. + straight) * span.begin.position.distance(span.end.position))
    return {};
  span.euler_load = stiffness * std::pow(dealii::numbers::PI / length, 2);
  return span;
}

} // namespace

std::optional<PressedSpan> most_pressed_span(const Scene &scene, const Results &results,
                                             const Frame &frame, const double touching) {
  constexpr double rounding = 1e-6;
  if (std::none_of(frame.line.begin(), frame.line.end(),
                   [](const Station &station) { return station.force[0] < 0.; }))
    return {};
  const Runs runs(frame.line);
  Holds holds(scene, results, frame, touching);
  std::optional<PressedSpan> worst;
  const auto consider = [&](const Run &run, const std::size_t begin, const std::size_t end,
                            const bool has_free_end) {
    std::optional<PressedSpan> span = straight_span(scene, run, begin, end);
    if (!span || span->euler_load == 0. || span->has_nodes)
      return;
    span->has_free_end = has_free_end;
    if (has_free_end)
      span->euler_load /= 4.;
    if (!worst || span->ratio() > (1. + rounding) * worst->ratio())
      worst = span;
  };
  for (const Run &run : runs.all) {
    std::optional<std::size_t> last_held;
    for (std::size_t i = 0; i < run.size(); ++i) {
      const std::size_t other = i > 0 ? i - 1 : 1; // of the straight pipe at i
      if (other >= run.size())
        break;
      Vector3 along = run[i]->position - run[other]->position;
      if (along.norm() == 0.)
        continue; // where the next pipe begins: as at the end of the one before
      along /= along.norm();
      const bool is_held = holds.hold_aside(*run[i], along),
                 is_free_end = i + 1 == run.size() && runs.is_end_of_line(*run[i]);
      if (last_held && (is_held || is_free_end))
        consider(run, *last_held, i, !is_held);
      else if (!last_held && is_held && runs.is_end_of_line(*run.front()))
        consider(run, 0, i, true);
      if (is_held)
        last_held = i;
    }
  }
  return worst;
}

} // namespace frictionbeam
