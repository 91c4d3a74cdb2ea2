// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/mesh_file.h"
#include "mesh/gmsh/bend_of_file.h"
#include "mesh/gmsh/own_mesh.h"
#include "mesh/gmsh/session.h"
#include "mesh/gmsh/vertices.h"
#include "mesh/mesh_routes.h"
#include "mesh/point_set.h"

#include "base/user_error.h"
#include "scene/doubt/route_doubts.h"
#include "scene/in_units.h"

#include <gmsh.h>

#include <algorithm>
#include <unordered_map>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Physical groups of one dimension by name; gmsh leaves all but one of a name without any.
std::multimap<std::string, int> physical_groups(const int dim) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim);
  std::multimap<std::string, int> names;
  for (const auto &[d, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(d, tag, name);
    names.emplace(name, tag);
  }
  return names;
}

std::string list(const std::multimap<std::string, int> &names) {
  std::string text;
  for (const auto &entry : names)
    if (!entry.first.empty())
      text += (text.empty() ? "" : ", ") + entry.first;
  return text.empty() ? "none" : text;
}

using Edge = std::array<std::size_t, 2>;

/// Order the cells of one pipe into a chain that runs as its first cell does.
std::vector<std::size_t> chain(const std::vector<Edge> &edges, const std::string &pipe,
                               const std::string &file) {
  std::unordered_map<std::size_t, std::vector<std::size_t>> neighbours;
  for (const Edge &edge : edges)
    for (const unsigned int i : {0, 1}) {
      std::vector<std::size_t> &of_node = neighbours[edge[i]];
      if (std::count(of_node.begin(), of_node.end(), edge[1 - i]) > 0)
        throw UserError("The physical curve '" + pipe + "' of '" + file +
                        "' has one cell twice, between its nodes " + std::to_string(edge[0]) +
                        " and " + std::to_string(edge[1]) + ". Take one of them out.");
      of_node.push_back(edge[1 - i]);
    }
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
/// @throws UserError where two nodes are one place
std::vector<PipePath::Segment> runs_of(const Scene &scene, const Pipe &pipe,
                                       const std::vector<Point3> &nodes) {
  std::vector<PipePath::Segment> runs;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    PipePath::Segment run;
    run.start = runs.empty() ? 0. : runs.back().start + runs.back().length;
    run.begin = nodes[i];
    run.end = nodes[i + 1];
    run.length = run.begin.distance(run.end);
    if (run.length == 0.)
      throw UserError("The physical curve '" + pipe.name + "' of '" + scene.mesh.file +
                      "' has a cell of no length at " + in_units(scene.units, run.begin) +
                      ". Make one node of its two (Coherence Mesh; in gmsh).");
    run.first_tangent = (run.end - run.begin) / run.length;
    runs.push_back(run);
  }
  return runs;
}

/// An arc that is meant as a bend is straight pieces if it is not said to be one.
void remark_on_arc(const Scene &scene, const Pipe &pipe, const std::vector<Point3> &nodes,
                   std::vector<std::string> &remarks) {
  constexpr double of_bends = 40.; // outer radii: longer ones bend as straight pipes do
  if (const auto arc = arc_among(nodes, of_bends * scene.sections[pipe.section].outer_radius))
    remarks.push_back(
        "Pipe " + pipe.name + ": its cells from " + in_units(scene.units, arc->begin) +
        " on are chords of an arc of radius " + in_units(scene.units, arc->radius, "m") +
        ", without a Bend radius: they bend as straight pipes do, and no stress code sees a bend. "
        "Give the arc a physical curve and a Pipe of its own, with its Bend radius.");
}

/// The lines of a mesh file: the scene's pipes by its nodes.
class FileLine {
public:
  explicit FileLine(const Scene &scene)
      : scene(scene), file(scene.mesh.file), vertex_of(scene.units.factor("m"), nodes) {
    read_curves();
    read_points();
  }

  /// The axes of the pipes. Their nodes are points of their routes.
  std::vector<PipePath> paths() const {
    std::vector<PipePath> result;
    for (unsigned int p = 0; p < in_pipe.size(); ++p) {
      const Pipe &pipe = scene.pipes[p];
      std::vector<Point3> points = points_of(p);
      std::vector<PipePath::Segment> segments =
          pipe.bend_radius > 0. ? arcs_of_bend(scene, pipe, points) : runs_of(scene, pipe, points);
      std::vector<PipePath::RoutePlace> places;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double s = i < segments.size() ? segments[i].start
                                             : segments.back().start + segments.back().length;
        const auto [first, last] = names.equal_range(in_pipe[p][i]);
        for (auto name = first; name != last; ++name)
          places.push_back({name->second, s});
        if (first == last)
          places.push_back({"", s});
      }
      result.emplace_back(std::move(segments), std::move(places));
    }
    return result;
  }

  /// @param tolerance within which two places are one [m]
  std::vector<std::string> remarks(const double tolerance) const {
    std::vector<std::string> texts = of_groups;
    for (unsigned int p = 0; p < in_pipe.size(); ++p)
      if (scene.pipes[p].bend_radius == 0.)
        remark_on_arc(scene, scene.pipes[p], points_of(p), texts);
    Scene drawn = scene; // as if its routes went from node to node
    drawn.doubts.clear();
    for (unsigned int p = 0; p < in_pipe.size(); ++p)
      for (const Point3 &point : points_of(p))
        drawn.pipes[p].route.push_back({"", point, 0.});
    doubt_routes(drawn);
    texts.insert(texts.end(), drawn.doubts.begin(), drawn.doubts.end());
    remark_on_twins(tolerance, texts);
    return texts;
  }

  /// @throws UserError where a Point of the scene has the name of another place of the file
  void check_points(const double tolerance) const {
    for (const NamedPoint &point : scene.points)
      for (const auto &[node, name] : names)
        if (name == point.name && !(nodes[node].distance(point.position) <= tolerance))
          throw UserError("Point " + point.name + "/Position\n  read:    " +
                          in_units(scene.units, point.position) + ", and a physical point '" +
                          name + "' of '" + file + "' at " + in_units(scene.units, nodes[node]) +
                          "\n  allowed: one place for a name\n  try:     another name for one of "
                          "the two");
  }

private:
  std::vector<Point3> points_of(const unsigned int pipe) const {
    std::vector<Point3> points;
    for (const unsigned int node : in_pipe[pipe])
      points.push_back(nodes[node]);
    return points;
  }

  void read_curves() {
    const auto curves = physical_groups(1);
    for (const Pipe &pipe : scene.pipes) {
      const auto curve = curves.find(pipe.name);
      if (curve == curves.end())
        throw UserError("The file '" + file + "' has no physical curve called '" + pipe.name +
                        "', as one of the pipes is. It has: " + list(curves) + ".");
      std::vector<unsigned int> &places = in_pipe.emplace_back();
      for (const std::size_t tag : chain(edges_of(curve->second, pipe.name, file), pipe.name, file))
        places.push_back(vertex_of(tag));
    }
    for (const auto &[name, tag] : curves)
      if (std::none_of(scene.pipes.begin(), scene.pipes.end(),
                       [&, name = name](const Pipe &pipe) { return pipe.name == name; }))
        of_groups.push_back((name.empty()
                                 ? "A physical curve without a name (tag " + std::to_string(tag) +
                                       "; of two of one name, gmsh leaves one without)"
                                 : "The physical curve '" + name + "'") +
                            " of '" + file + "' is no Pipe of the parameter file, and left out.");
  }

  void read_points() {
    for (const auto &[name, group] : physical_groups(0)) {
      if (name.empty())
        continue;
      std::vector<std::size_t> tags;
      std::vector<double> coordinates;
      gmsh::model::mesh::getNodesForPhysicalGroup(0, group, tags, coordinates);
      if (tags.size() != 1 || !vertex_of.has(tags[0]))
        throw UserError("The physical point '" + name + "' of '" + file +
                        "' is no node of a pipe. Split the curve there, so that the point is the "
                        "end of a curve.");
      names.emplace(vertex_of(tags[0]), name);
    }
  }

  /// Nodes at one place are joined, as points of routes are.
  void remark_on_twins(const double tolerance, std::vector<std::string> &texts) const {
    constexpr unsigned int most_named = 10;
    const std::vector<std::size_t> twins = repeated_points(nodes, tolerance);
    for (std::size_t i = 0; i < std::min<std::size_t>(twins.size(), most_named); ++i)
      texts.push_back("Joined: two nodes of '" + file + "' at " +
                      in_units(scene.units, nodes[twins[i]]) +
                      ". To keep what meets there apart, draw it a little apart.");
    if (twins.size() > most_named)
      texts.push_back("Joined: two nodes of '" + file + "' at " +
                      std::to_string(twins.size() - most_named) + " more places.");
  }

  const Scene &scene;
  const std::string &file;
  std::vector<Point3> nodes; ///< that pipes have
  GmshVertices vertex_of;
  std::vector<std::vector<unsigned int>> in_pipe; ///< nodes, beside Scene::pipes
  std::multimap<unsigned int, std::string> names; ///< of nodes: physical points
  std::vector<std::string> of_groups;             ///< remarks
};

} // namespace

LineMesh mesh_file(const Scene &scene) {
  const GmshSession session;
  open_own_mesh(scene, 1);
  const FileLine line(scene);
  const RoutePlan plan(scene, line.paths());
  double n_cells = 0.;
  for (unsigned int p = 0; p < plan.n_pipes(); ++p)
    for (const RoutePiece &piece : plan.pieces(p))
      n_cells += piece.n_cells;
  refuse_too_many_cells(scene, n_cells);
  line.check_points(plan.tolerance());
  LineMesh mesh = mesh_plan(scene, plan);
  const std::vector<std::string> remarks = line.remarks(plan.tolerance());
  mesh.remarks.insert(mesh.remarks.end(), remarks.begin(), remarks.end());
  return mesh;
}

} // namespace frictionbeam
