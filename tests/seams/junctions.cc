// Pipes shall be joined where their routes say so and nowhere else, and what the routes do not both
// say shall be in a remark. References: the number of vertices and of connected lines, counted by
// hand.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/build_line_mesh.h"

#include "../check.h"

#include <numeric>
#include <set>

using namespace frictionbeam;

namespace {

RoutePoint at(const std::string &name, const double x, const double y, const double z = 0.,
              const double bend = 0.) {
  return {name, Point3(x, y, z), bend};
}

struct Line {
  Scene scene;

  Line &pipe(const std::string &name, const std::vector<RoutePoint> &route) {
    Pipe pipe;
    pipe.name = name;
    pipe.route = route;
    scene.pipes.push_back(pipe);
    return *this;
  }
  Line &point(const std::string &name, const double x, const double y) {
    scene.points.push_back({name, Point3(x, y, 0.)});
    return *this;
  }
  Line &every(const std::string &pipe, const double distance) {
    FrictionSupport support;
    support.name = "on_" + pipe;
    support.placement.pipe = pipe;
    support.placement.every = distance;
    scene.supports.push_back(support);
    return *this;
  }

  /// @param n_vertices of the mesh, n_lines of these that hang together, and how many remarks begin
  /// with each of the three words
  void expect(const unsigned int n_vertices, const unsigned int n_lines, const unsigned int joined,
              const unsigned int apart, const unsigned int overlap, const int line) {
    scene.mesh.arcs = true;
    const LineMesh mesh = build_line_mesh(scene);
    std::vector<unsigned int> part(mesh.vertices.size());
    std::iota(part.begin(), part.end(), 0);
    const auto root = [&](unsigned int v) {
      while (part[v] != v)
        v = part[v];
      return v;
    };
    for (const MeshedPipe &pipe : mesh.pipes)
      for (unsigned int i = 0; i + 1 < pipe.vertices.size(); ++i)
        part[root(pipe.vertices[i])] = root(pipe.vertices[i + 1]);
    std::set<unsigned int> lines;
    for (unsigned int v = 0; v < part.size(); ++v)
      lines.insert(root(v));
    const auto n_remarks = [&](const std::string &word) {
      unsigned int n = 0;
      for (const std::string &remark : mesh.remarks)
        n += remark.find(word) == 0 ? 1 : 0;
      return n;
    };
    const bool right = mesh.vertices.size() == n_vertices && lines.size() == n_lines &&
                       n_remarks("Joined:") == joined && n_remarks("Not joined:") == apart &&
                       n_remarks("Overlap:") == overlap;
    check::truth(right, "vertices, lines, remarks", __FILE__, line);
    if (right)
      return;
    std::cerr << mesh.vertices.size() << " vertices, " << lines.size() << " lines\n";
    for (const std::string &remark : mesh.remarks)
      std::cerr << remark << '\n';
  }
};

// Its own line is part of what a failure says.
#define EXPECT(...) expect(__VA_ARGS__, __LINE__)

/// A run along x, from 0 to 10.
Line run() { return Line().pipe("run", {at("A", 0, 0), at("B", 10, 0)}); }

void tees_and_crosses() {
  // A branch on a point of the run's route, by name or by place, and on none of its points.
  Line()
      .pipe("run", {at("A", 0, 0), at("T", 5, 0), at("B", 10, 0)})
      .pipe("branch", {at("T", 5, 0), at("C", 5, 5)})
      .EXPECT(4, 1, 0, 0, 0);
  Line()
      .pipe("run", {at("A", 0, 0), at("T", 5, 0), at("B", 10, 0)})
      .pipe("branch", {at("", 5, 0), at("C", 5, 5)})
      .EXPECT(4, 1, 0, 0, 0);
  run().pipe("branch", {at("T", 5, 0), at("C", 5, 5)}).EXPECT(4, 1, 1, 0, 0);
  // Two branches on one place of a run.
  run()
      .pipe("up", {at("T", 5, 0), at("C", 5, 5)})
      .pipe("down", {at("T", 5, 0), at("D", 5, -5)})
      .EXPECT(5, 1, 1, 0, 0);
  // A crossing: named by neither, by one route, by both, and by a Point.
  run().pipe("other", {at("C", 5, -5), at("D", 5, 5)}).EXPECT(4, 2, 0, 0, 0);
  run().pipe("other", {at("C", 5, -5), at("X", 5, 0), at("D", 5, 5)}).EXPECT(5, 2, 0, 1, 0);
  Line()
      .pipe("run", {at("A", 0, 0), at("X", 5, 0), at("B", 10, 0)})
      .pipe("other", {at("C", 5, -5), at("X", 5, 0), at("D", 5, 5)})
      .EXPECT(5, 1, 0, 0, 0);
  run().pipe("other", {at("C", 5, -5), at("D", 5, 5)}).point("X", 5, 0).EXPECT(5, 1, 1, 0, 0);
  run()
      .pipe("other", {at("C", 5, -5), at("X", 5, 0), at("D", 5, 5)})
      .point("X", 5, 0)
      .EXPECT(5, 1, 1, 0, 0);
  // Supports repeated to the place of a crossing: the two pipes have nothing to do with each other.
  run()
      .pipe("other", {at("C", 5, -5), at("D", 5, 5)})
      .every("run", 5.)
      .every("other", 5.)
      .EXPECT(6, 2, 0, 0, 0);
  // A ring that closes, and a route that ends on its own run.
  Line()
      .pipe("ring", {at("A", 0, 0), at("", 5, 0), at("", 5, 5), at("A", 0, 0)})
      .EXPECT(3, 1, 0, 0, 0);
  Line()
      .pipe("loop", {at("A", 0, 0), at("", 10, 0), at("", 10, 5), at("", 5, 5), at("", 5, 0)})
      .EXPECT(5, 1, 1, 0, 0);
  // A trunnion that goes straight on where a bend begins is a tee, not an overlap.
  Line()
      .pipe("bent", {at("A", 0, 0), at("", 5, 0, 0, 1), at("B", 5, 5)})
      .pipe("trunnion", {at("", 4, 0), at("", 6, 0)})
      .EXPECT(5, 1, 1, 0, 0);
}

void overlaps() {
  // In part, end to end, reversed; in the whole, with a Point that only one route has.
  run().pipe("inside", {at("B", 10, 0), at("M", 4, 0)}).EXPECT(3, 1, 0, 0, 1);
  run().pipe("inside", {at("M", 4, 0), at("B", 10, 0)}).EXPECT(3, 1, 0, 0, 1);
  run().pipe("inside", {at("B", 10, 0), at("M", 4, 0)}).point("M", 4, 0).EXPECT(3, 1, 0, 0, 1);
  run().pipe("inside", {at("M", 4, 0), at("N", 6, 0)}).EXPECT(4, 2, 0, 0, 1);
  run().pipe("further", {at("M", 4, 0), at("N", 16, 0)}).EXPECT(4, 2, 0, 0, 1);
  run().pipe("same", {at("A", 0, 0), at("B", 10, 0)}).EXPECT(2, 1, 0, 0, 1);
  run().pipe("back", {at("B", 10, 0), at("A", 0, 0)}).EXPECT(2, 1, 0, 0, 1);
  // A spacer, a point of both routes, joins a pipe to its jacket; an idle one does not.
  Line()
      .pipe("jacket", {at("A", 0, 0), at("X", 5, 0), at("B", 10, 0)})
      .pipe("core", {at("C", -1, 0), at("X", 5, 0), at("D", 11, 0)})
      .EXPECT(5, 1, 0, 0, 1);
  run().pipe("core", {at("C", -1, 0), at("X", 5, 0), at("D", 11, 0)}).EXPECT(5, 2, 0, 0, 1);
  // A Point that is in no route is on both.
  run().pipe("core", {at("C", -1, 0), at("D", 11, 0)}).point("X", 5, 0).EXPECT(5, 1, 1, 0, 1);
  // A branch of the inner pipe, which has a place on the outer one.
  run()
      .pipe("inside", {at("B", 10, 0), at("M", 4, 0)})
      .pipe("branch", {at("M", 4, 0), at("C", 4, 5)})
      .EXPECT(4, 1, 0, 0, 1);
  // On one circle, in the same and in the opposite sense.
  const std::vector<RoutePoint> bend = {at("A", 0, 0), at("", 5, 0, 0, 2), at("B", 5, 5)};
  const Line outer = Line().pipe("outer", bend);
  Line(outer).pipe("inner", bend).EXPECT(4 + 2, 1, 0, 0, 1);
  Line(outer).pipe("inner", {bend[2], bend[1], bend[0]}).EXPECT(4 + 2, 1, 0, 0, 1);
  const double s = 2. * std::sqrt(0.5); // the middle of the bend, where a branch begins
  Line(outer).pipe("branch", {at("", 3 + s, 2 - s), at("", 9, -4)}).EXPECT(6, 1, 1, 0, 0);
}

} // namespace

int main() {
  tees_and_crosses();
  overlaps();
  return check::report();
}
