// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/mesh_routes.h"

#include "base/user_error.h"
#include "mesh/gmsh/drawn_routes.h"
#include "scene/in_units.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The vertices inside a piece, which divide its arc length evenly.
std::vector<Point3> points_inside(const RoutePiece &piece) {
  std::vector<Point3> result;
  for (int i = 1; i < piece.n_cells; ++i)
    result.push_back(piece.segment->point(piece.s(i) - piece.segment->start));
  return result;
}

/// Say what lies between the vertices of a piece of a pipe, which has been divided.
void add_cells(const RoutePiece &piece, MeshedPipe &pipe) {
  const PipePath::Segment &segment = *piece.segment;
  for (int i = 0; i < piece.n_cells; ++i) {
    const unsigned int cell = pipe.bend_radius.size();
    if (piece.bends())
      pipe.bend_axis[cell] = cross_product_3d(segment.first_tangent, segment.inward);
    if (piece.is_arc)
      pipe.arc_centre[cell] = segment.centre;
    pipe.bend_radius.push_back(segment.radius);
    pipe.s.push_back(piece.s(i + 1));
  }
}

/// Puts vertices into a mesh in the order in which pipes reach them.
class RouteMesher {
public:
  /// @param inner vertices of each pipe's pieces, or null for those that divide them evenly
  RouteMesher(const RoutePlan &plan, const DrawnRoutes *const inner, LineMesh &mesh)
      : plan(plan), inner(inner), mesh(mesh),
        vertex_of_node(plan.junctions().n_nodes(), numbers::invalid_unsigned_int) {}

  void add_pipe(const unsigned int p) {
    MeshedPipe &pipe = mesh.pipes.emplace_back();
    const std::vector<RoutePiece> &pieces = plan.pieces(p);
    pipe.vertices = {vertex_at(p, 0.)};
    pipe.s = {0.};
    for (unsigned int i = 0; i < pieces.size(); ++i) {
      for (const Point3 &point : inner ? inner->inside(p, i) : points_inside(pieces[i]))
        pipe.vertices.push_back(new_vertex(point));
      pipe.vertices.push_back(vertex_at(p, pieces[i].end));
      add_cells(pieces[i], pipe);
    }
  }

private:
  unsigned int new_vertex(const Point3 &point) {
    mesh.vertices.push_back(point);
    return mesh.vertices.size() - 1;
  }

  /// At a break of a pipe; pipes have the nodes of junctions in common, and no others.
  unsigned int vertex_at(const unsigned int pipe, const double s) {
    const std::optional<unsigned int> node = plan.junctions().node(pipe, s);
    if (!node)
      return new_vertex(plan.path(pipe).point(s));
    unsigned int &vertex = vertex_of_node[*node];
    if (vertex == numbers::invalid_unsigned_int)
      vertex = new_vertex(plan.path(pipe).point(s));
    return vertex;
  }

  const RoutePlan &plan;
  const DrawnRoutes *const inner;
  LineMesh &mesh;
  std::vector<unsigned int> vertex_of_node;
};

void find_points(const Scene &scene, const RoutePlan &plan, LineMesh &mesh) {
  const auto vertex_at = [&](const unsigned int p, const double s) {
    const auto &list = mesh.pipes[p].s;
    return mesh.pipes[p]
        .vertices[std::lower_bound(list.begin(), list.end(), s - plan.tolerance()) - list.begin()];
  };
  for (unsigned int p = 0; p < plan.n_pipes(); ++p)
    for (const auto &named : plan.path(p).route_points()) {
      if (named.name.empty())
        continue;
      const unsigned int v = vertex_at(p, named.s);
      const auto [entry, is_new] = mesh.points.emplace(named.name, v);
      if (!is_new && entry->second != v)
        throw UserError(
            "The point '" + named.name + "' of pipe '" + scene.pipes[p].name +
            "' stands for another place already: the name of a bend's corner is that "
            "of the middle of the bend, " +
            in_units(scene.units, mesh.vertices[v].distance(mesh.vertices[entry->second]), "m") +
            " away. Give the two places two names.");
    }
  for (const NamedPoint &point : scene.points)
    if (const auto place = plan.junctions().place(point.name))
      mesh.points[point.name] = vertex_at(place->pipe, place->s);
}

} // namespace

namespace {
LineMesh mesh_plan(const Scene &scene, const RoutePlan &plan, const DrawnRoutes *const drawn) {
  LineMesh mesh;
  RouteMesher mesher(plan, drawn, mesh);
  for (unsigned int p = 0; p < plan.n_pipes(); ++p)
    mesher.add_pipe(p);
  find_points(scene, plan, mesh);
  mesh.remarks = plan.junctions().remarks();
  return mesh;
}
} // namespace

LineMesh mesh_plan(const Scene &scene, const RoutePlan &plan) {
  return mesh_plan(scene, plan, nullptr);
}

LineMesh mesh_routes(const Scene &scene) {
  if (scene.pipes.empty())
    return {};
  const RoutePlan plan(scene);
  if (scene.mesh.mesher != Mesher::gmsh)
    return mesh_plan(scene, plan);
  const DrawnRoutes drawn(scene.name, plan);
  return mesh_plan(scene, plan, &drawn);
}

} // namespace frictionbeam
