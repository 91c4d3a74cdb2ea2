// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/drawn_routes.h"

#include "mesh/gmsh/session.h"
#include "mesh/gmsh/vertices.h"

#include <gmsh.h>

namespace frictionbeam {

using namespace dealii;

namespace {

using Curves = std::vector<std::vector<int>>; ///< tags, by pipe and piece

/// Pipes have the nodes of junctions in common, and no others.
Curves draw(const RoutePlan &plan) {
  const auto add_point = [](const Point3 &p) {
    return gmsh::model::geo::addPoint(p[0], p[1], p[2]);
  };
  std::vector<int> tag_of_node(plan.junctions().n_nodes(), 0);
  const auto point_at = [&](const unsigned int pipe, const double s) {
    const std::optional<unsigned int> node = plan.junctions().node(pipe, s);
    if (!node)
      return add_point(plan.path(pipe).point(s));
    int &tag = tag_of_node[*node];
    if (tag == 0)
      tag = add_point(plan.path(pipe).point(s));
    return tag;
  };
  Curves curves(plan.n_pipes());
  for (unsigned int p = 0; p < plan.n_pipes(); ++p) {
    int last = point_at(p, 0.);
    for (const RoutePiece &piece : plan.pieces(p)) {
      const int first = last;
      last = point_at(p, piece.end);
      curves[p].push_back(piece.bends() ? gmsh::model::geo::addCircleArc(
                                              first, add_point(piece.segment->centre), last)
                                        : gmsh::model::geo::addLine(first, last));
    }
  }
  return curves;
}

/// The vertices inside a curve of @p n_cells cells.
std::vector<Point3> inside_of(const int curve, const int n_cells, GmshVertices &vertex_of,
                              const std::vector<Point3> &vertices) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 1, curve);
  AssertThrow(nodes.size() == 1 && nodes[0].size() == 2u * n_cells,
              ExcMessage("gmsh did not mesh a curve as it was told."));
  std::vector<Point3> result;
  for (int i = 1; i < n_cells; ++i) {
    AssertThrow(nodes[0][2 * i] == nodes[0][2 * i - 1],
                ExcMessage("gmsh did not list the cells of a curve in its direction."));
    result.push_back(vertices[vertex_of(nodes[0][2 * i])]);
  }
  return result;
}

} // namespace

DrawnRoutes::DrawnRoutes(const std::string &name, const RoutePlan &plan) : inner(plan.n_pipes()) {
  const GmshSession session;
  gmsh::model::add(name);
  const Curves curves = draw(plan);
  gmsh::model::geo::synchronize();
  for (unsigned int p = 0; p < plan.n_pipes(); ++p)
    for (unsigned int i = 0; i < curves[p].size(); ++i)
      gmsh::model::mesh::setTransfiniteCurve(curves[p][i], plan.pieces(p)[i].n_cells + 1);
  gmsh::model::mesh::generate(1);
  std::vector<Point3> vertices;
  GmshVertices vertex_of(1., vertices);
  for (unsigned int p = 0; p < plan.n_pipes(); ++p)
    for (unsigned int i = 0; i < curves[p].size(); ++i)
      inner[p].push_back(inside_of(curves[p][i], plan.pieces(p)[i].n_cells, vertex_of, vertices));
}

} // namespace frictionbeam
