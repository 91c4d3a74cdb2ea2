// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/mesh_file.h"
#include "mesh/gmsh/bend_of_file.h"
#include "mesh/gmsh/own_mesh.h"
#include "mesh/gmsh/session.h"
#include "mesh/gmsh/vertices.h"
#include "mesh/mesh_routes.h"

#include "base/user_error.h"

#include <gmsh.h>

#include <algorithm>
#include <unordered_map>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Physical groups of one dimension by name.
std::map<std::string, int> physical_groups(const int dim) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim);
  std::map<std::string, int> names;
  for (const auto &[d, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(d, tag, name);
    if (!name.empty())
      names[name] = tag;
  }
  return names;
}

std::string list(const std::map<std::string, int> &names) {
  std::string text;
  for (const auto &entry : names)
    text += (text.empty() ? "" : ", ") + entry.first;
  return text.empty() ? "none" : text;
}

using Edge = std::array<std::size_t, 2>;

/// Order the cells of one pipe into a chain that runs as its first cell does.
std::vector<std::size_t> chain(const std::vector<Edge> &edges, const std::string &pipe,
                               const std::string &file) {
  std::unordered_map<std::size_t, std::vector<std::size_t>> neighbours;
  for (const Edge &edge : edges)
    for (const unsigned int i : {0, 1})
      neighbours[edge[i]].push_back(edge[1 - i]);
  std::size_t start = edges.front()[0]; // of a ring; otherwise the first free end
  bool ring = true;
  for (const Edge &edge : edges)
    for (const std::size_t node : edge) {
      if (neighbours[node].size() > 2)
        throw UserError("The physical curve '" + pipe + "' of '" + file +
                        "' has a branch. A pipe is one chain of cells: give each branch a physical "
                        "curve of its own.");
      if (ring && neighbours[node].size() == 1) {
        start = node;
        ring = false;
      }
    }
  std::vector<std::size_t> nodes{start, ring ? edges.front()[1] : neighbours[start][0]};
  while (nodes.back() != start && neighbours[nodes.back()].size() == 2) {
    const auto &next = neighbours[nodes.back()];
    nodes.push_back(next[0] != nodes[nodes.size() - 2] ? next[0] : next[1]);
  }
  if (nodes.size() != edges.size() + 1)
    throw UserError("The physical curve '" + pipe + "' of '" + file +
                    "' is not connected. Give each part a physical curve of its own.");
  const auto first = std::find(nodes.begin(), nodes.end(), edges.front()[0]);
  if (first + 1 == nodes.end() || *(first + 1) != edges.front()[1])
    std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

/// The straight cells of a physical curve.
/// @param pipe that has its name
std::vector<Edge> edges_of(const int curve, const std::string &pipe, const std::string &file) {
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(1, curve, entities);
  std::vector<Edge> edges;
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, 1, entity);
    for (unsigned int t = 0; t < types.size(); ++t) {
      if (types[t] != 1)
        throw UserError("The file '" + file + "' has curved cells on '" + pipe +
                        "'. Mesh it with elements of order 1.");
      for (std::size_t i = 0; i < nodes[t].size(); i += 2)
        edges.push_back({nodes[t][i], nodes[t][i + 1]});
    }
  }
  if (edges.empty())
    throw UserError("The physical curve '" + pipe + "' of '" + file + "' has no cells.");
  return edges;
}

/// The straight runs from node to node.
std::vector<PipePath::Segment> runs_of(const std::vector<Point3> &nodes) {
  std::vector<PipePath::Segment> runs;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    PipePath::Segment run;
    run.start = runs.empty() ? 0. : runs.back().start + runs.back().length;
    run.begin = nodes[i];
    run.end = nodes[i + 1];
    run.length = run.begin.distance(run.end);
    run.first_tangent = (run.end - run.begin) / run.length;
    runs.push_back(run);
  }
  return runs;
}

/// The pipe between nodes of the file, divided as the route between them would be.
/// @param nodes that the pipe has in the file, as places in @p vertices
MeshedPipe mesh_pipe(const Scene &scene, const Pipe &pipe, const std::vector<unsigned int> &nodes,
                     std::vector<Point3> &vertices) {
  std::vector<Point3> points;
  for (const unsigned int node : nodes)
    points.push_back(vertices[node]);
  const std::vector<PipePath::Segment> segments =
      pipe.bend_radius > 0. ? arcs_of_bend(scene, pipe, points) : runs_of(points);
  MeshedPipe meshed;
  meshed.vertices = {nodes.front()};
  meshed.s = {0.};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PipePath::Segment &segment = segments[i];
    RoutePiece piece{&segment, segment.start, segment.start + segment.length, 0};
    divide(scene, pipe, piece);
    refuse_too_many_cells(scene, 1. * vertices.size() + piece.n_cells);
    for (const Point3 &point : points_inside(piece)) {
      meshed.vertices.push_back(vertices.size());
      vertices.push_back(point);
    }
    meshed.vertices.push_back(nodes[i + 1]);
    vertices[nodes[i + 1]] = points[i + 1];
    add_cells(piece, meshed);
  }
  return meshed;
}

/// Put the names on vertices: of physical points, and of points that the scene places.
void name_points(const Scene &scene, GmshVertices &vertex_of, LineMesh &mesh) {
  for (const auto &[name, group] : physical_groups(0)) {
    std::vector<std::size_t> nodes;
    std::vector<double> coordinates;
    gmsh::model::mesh::getNodesForPhysicalGroup(0, group, nodes, coordinates);
    if (nodes.size() != 1 || !vertex_of.has(nodes[0]))
      throw UserError("The physical point '" + name + "' of '" + scene.mesh.file +
                      "' is no node of a pipe. Split the curve there, so that the point is the end "
                      "of a curve.");
    mesh.points[name] = vertex_of(nodes[0]);
  }
  for (const NamedPoint &point : scene.points)
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (mesh.vertices[v].distance(point.position) <= 1e-6)
        mesh.points[point.name] = v;
}

} // namespace

LineMesh mesh_file(const Scene &scene) {
  const std::string &file = scene.mesh.file;
  const GmshSession session;
  open_own_mesh(scene, 1);
  LineMesh mesh;
  GmshVertices vertex_of(scene.units.factor("m"),
                         mesh.vertices); // the file is in the input's units
  const auto curves = physical_groups(1);
  for (const Pipe &pipe : scene.pipes) {
    const auto curve = curves.find(pipe.name);
    if (curve == curves.end())
      throw UserError("The file '" + file + "' has no physical curve called '" + pipe.name +
                      "', as one of the pipes is. It has: " + list(curves) + ".");
    std::vector<unsigned int> nodes;
    for (const std::size_t tag : chain(edges_of(curve->second, pipe.name, file), pipe.name, file))
      nodes.push_back(vertex_of(tag));
    mesh.pipes.push_back(mesh_pipe(scene, pipe, nodes, mesh.vertices));
  }
  name_points(scene, vertex_of, mesh);
  return mesh;
}

} // namespace frictionbeam
