// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh_file.h"
#include "mesh/own_mesh.h"

#include "mesh/gmsh_session.h"

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

} // namespace

LineMesh mesh_file(const Scene &scene) {
  const std::string &file = scene.mesh.file;
  const GmshSession session;
  open_own_mesh(scene, 1);
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, unused;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
  std::unordered_map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < tags.size(); ++i)
    place[tags[i]] = i;

  LineMesh mesh;
  std::unordered_map<std::size_t, unsigned int> vertex;
  const auto curves = physical_groups(1);
  for (const Pipe &pipe : scene.pipes) {
    const auto curve = curves.find(pipe.name);
    if (curve == curves.end())
      throw UserError("The file '" + file + "' has no physical curve called '" + pipe.name +
                      "', as one of the pipes is. It has: " + list(curves) + ".");
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(1, curve->second, entities);
    std::vector<Edge> edges;
    for (const int entity : entities) {
      std::vector<int> types;
      std::vector<std::vector<std::size_t>> elements, nodes;
      gmsh::model::mesh::getElements(types, elements, nodes, 1, entity);
      for (unsigned int t = 0; t < types.size(); ++t) {
        if (types[t] != 1)
          throw UserError("The file '" + file + "' has curved cells on '" + pipe.name +
                          "'. Mesh it with elements of order 1.");
        for (std::size_t i = 0; i < nodes[t].size(); i += 2)
          edges.push_back({nodes[t][i], nodes[t][i + 1]});
      }
    }
    if (edges.empty())
      throw UserError("The physical curve '" + pipe.name + "' of '" + file + "' has no cells.");
    MeshedPipe meshed;
    for (const std::size_t tag : chain(edges, pipe.name, file)) {
      const auto [entry, is_new] = vertex.try_emplace(tag, mesh.vertices.size());
      if (is_new) {
        const double *const x = &coordinates[3 * place.at(tag)];
        const double unit = scene.units.factor("m"); // the file is in the units of the input
        mesh.vertices.emplace_back(unit * x[0], unit * x[1], unit * x[2]);
      }
      const Point3 &here = mesh.vertices[entry->second];
      meshed.s.push_back(meshed.s.empty()
                             ? 0.
                             : meshed.s.back() +
                                   here.distance(mesh.vertices[meshed.vertices.back()]));
      meshed.vertices.push_back(entry->second);
    }
    meshed.bend_radius.assign(meshed.vertices.size() - 1, pipe.bend_radius);
    mesh.pipes.push_back(meshed);
  }

  for (const auto &[name, group] : physical_groups(0)) {
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getNodesForPhysicalGroup(0, group, nodes, coordinates);
    if (nodes.size() != 1 || vertex.count(nodes[0]) == 0)
      throw UserError("The physical point '" + name + "' of '" + file +
                      "' is no node of a pipe. Split the curve there, so that the point is the end "
                      "of a curve.");
    mesh.points[name] = vertex.at(nodes[0]);
  }
  for (const NamedPoint &point : scene.points)
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (mesh.vertices[v].distance(point.position) <= 1e-6)
        mesh.points[point.name] = v;
  return mesh;
}

} // namespace frictionbeam
