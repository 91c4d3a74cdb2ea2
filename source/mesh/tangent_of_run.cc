// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/tangent_of_run.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double cosine_of_straight = 0.985; // of 10 degrees

struct Leg {
  Vector3 outward, along; ///< unit tangents: away from the vertex, and in the pipe's direction
  unsigned int pipe;
  bool is_branch;
};

Vector3 unit(const Vector3 &vector) { return vector / vector.norm(); }

bool is_branch(const Scene &scene, const LineMesh &mesh, const unsigned int pipe,
               const unsigned int vertex) {
  return std::any_of(scene.tees.begin(), scene.tees.end(), [&](const Tee &tee) {
    const auto at = mesh.points.find(tee.point);
    return at != mesh.points.end() && at->second == vertex && tee.branch == scene.pipes[pipe].name;
  });
}

/// From one leg to another, in the direction of the first one's pipe; its own where they fold.
Vector3 through(const Leg &one, const Leg &other) {
  const Vector3 way = other.outward - one.outward;
  if (way.norm() < no_direction)
    return one.along;
  return way * one.along < 0. ? -unit(way) : unit(way);
}

bool goes_on(const Leg &one, const Leg &other) {
  return one.outward * other.outward < -cosine_of_straight;
}

} // namespace

Vector3 tangent_of_pipe(const LineMesh &mesh, const MeshedPipe &pipe, const unsigned int place) {
  Vector3 sum;
  if (place > 0)
    sum += pipe.tangent(mesh.vertices, place - 1, true);
  if (place + 1 < pipe.vertices.size())
    sum += pipe.tangent(mesh.vertices, place, false);
  return sum.norm() < no_direction ? pipe.tangent(mesh.vertices, place - 1, true) : unit(sum);
}

PlacesInPipes places_in_pipes(const LineMesh &mesh, const unsigned int vertex) {
  PlacesInPipes places;
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p)
    for (unsigned int i = 0; i < mesh.pipes[p].vertices.size(); ++i)
      if (mesh.pipes[p].vertices[i] == vertex)
        places.emplace_back(p, i);
  return places;
}

std::vector<PlacesInPipes> places_in_pipes(const LineMesh &mesh) {
  std::vector<PlacesInPipes> places(mesh.vertices.size());
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p)
    for (unsigned int i = 0; i < mesh.pipes[p].vertices.size(); ++i)
      places[mesh.pipes[p].vertices[i]].emplace_back(p, i);
  return places;
}

std::optional<Vector3> tangent_of_run(const Scene &scene, const LineMesh &mesh,
                                      const unsigned int vertex, const PlacesInPipes &places) {
  std::vector<Leg> legs;
  for (const auto &[p, i] : places) {
    const MeshedPipe &pipe = mesh.pipes[p];
    const bool branches = is_branch(scene, mesh, p, vertex);
    if (i > 0) {
      const Vector3 along = pipe.tangent(mesh.vertices, i - 1, true);
      legs.push_back({-along, along, p, branches});
    }
    if (i + 1 < pipe.vertices.size()) {
      const Vector3 along = pipe.tangent(mesh.vertices, i, false);
      legs.push_back({along, along, p, branches});
    }
  }
  if (std::any_of(legs.begin(), legs.end(), [](const Leg &leg) { return !leg.is_branch; }))
    legs.erase(
        std::remove_if(legs.begin(), legs.end(), [](const Leg &leg) { return leg.is_branch; }),
        legs.end());
  if (legs.empty())
    return Vector3();
  if (legs.size() == 1)
    return legs[0].along;
  if (legs.size() == 2)
    return through(legs[0], legs[1]);
  std::vector<Vector3> passing, in_line;
  for (unsigned int i = 0; i < legs.size(); ++i)
    for (unsigned int j = i + 1; j < legs.size(); ++j)
      if (goes_on(legs[i], legs[j]))
        (legs[i].pipe == legs[j].pipe ? passing : in_line).push_back(through(legs[i], legs[j]));
  const std::vector<Vector3> &runs = passing.empty() ? in_line : passing;
  if (runs.empty() || std::any_of(runs.begin(), runs.end(), [&](const Vector3 &run) {
        return std::abs(run * runs[0]) < cosine_of_straight;
      }))
    return {};
  return runs[0];
}

} // namespace frictionbeam
