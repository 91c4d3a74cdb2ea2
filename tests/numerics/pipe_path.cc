// SPDX-License-Identifier: LGPL-2.1-or-later
// The axis of a pipe: a bend of radius r at a right angle takes r of both legs and gives pi r/2;
// tangents go on without a kink, points lie at a distance of r from the bend's centre.
#include "../check.h"

#include "base/user_error.h"
#include "mesh/pipe_path.h"

using namespace frictionbeam;

namespace {

constexpr double pi = 3.14159265358979323846;

Pipe elbow(const double radius) {
  Pipe pipe;
  pipe.name = "elbow";
  pipe.route = {{"A", {0., 0., 0.}, 0.}, {"corner", {3., 0., 0.}, radius}, {"B", {3., 4., 0.}, 0.}};
  return pipe;
}

bool is_refused(const Pipe &pipe) {
  try {
    PipePath(pipe, UnitSystem());
  } catch (const UserError &) {
    return true;
  }
  return false;
}

} // namespace

int pipe_path(int, char **) {
  const PipePath path(elbow(1.), UnitSystem());
  CHECK(path.segments().size() == 3);
  CHECK_NEAR(path.length(), 2. + pi / 2. + 3., 1e-14);
  CHECK_NEAR(path.point(2.).distance({2., 0., 0.}), 0., 1e-14);
  CHECK_NEAR(path.point(path.length()).distance({3., 4., 0.}), 0., 1e-14);
  const Point3 middle(2. + std::sqrt(0.5), 1. - std::sqrt(0.5), 0.);
  CHECK_NEAR(path.point(2. + pi / 4.).distance(middle), 0., 1e-14);

  for (unsigned int i = 0; i + 1 < path.segments().size(); ++i) {
    const auto &one = path.segments()[i], &next = path.segments()[i + 1];
    CHECK_NEAR(one.point(one.length).distance(next.point(0.)), 0., 1e-14);
    CHECK_NEAR((one.tangent(one.length) - next.tangent(0.)).norm(), 0., 1e-14);
  }
  const auto &bend = path.segments()[1];
  for (const double s : {0., 0.3, 1.2})
    CHECK_NEAR(bend.point(s).distance(bend.centre), 1., 1e-14);

  // The corner's name stands for the middle of the bend.
  bool named = false;
  for (const auto &place : path.route_points())
    if (place.name == "corner") {
      named = true;
      CHECK_NEAR(place.s, 2. + pi / 4., 1e-14);
    }
  CHECK(named);
  const std::vector<double> places = path.all_places(middle, 1e-9);
  CHECK(places.size() == 1);
  CHECK_NEAR(places[0], 2. + pi / 4., 1e-9);
  CHECK(path.all_places({2., 0., 0.}, 1e-9).size() == 1); // between two segments, once
  CHECK(path.all_places({3., 0., 0.}, 1e-9).empty());     // the corner itself is off the pipe

  CHECK(!is_refused(elbow(3.))); // the whole first leg
  CHECK(is_refused(elbow(3.1)));
  return check::report();
}
