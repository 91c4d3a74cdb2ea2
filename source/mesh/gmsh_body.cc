// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gmsh_session.h"

#include <frictionbeam/mesh/continuum_mesh.h>
#include <frictionbeam/scene/user_error.h>

#include <deal.II/grid/grid_tools.h>

#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <unordered_map>

namespace frictionbeam {

using namespace dealii;

namespace {

/// A box from the origin by extrusion, its sides physical groups x0 x1 y0 y1 (z0 z1).
void mesh_box(const ContinuumBox &box, const unsigned int dim) {
  namespace geo = gmsh::model::geo;
  gmsh::model::add("box");
  gmsh::vectorpair shape{{0, geo::addPoint(0., 0., 0.)}};
  for (unsigned int d = 0; d < dim; ++d) {
    gmsh::vectorpair extruded;
    std::array<double, 3> shift{};
    shift[d] = box.size[d];
    geo::extrude(shape, shift[0], shift[1], shift[2], extruded, {static_cast<int>(box.cells[d])},
                 {}, true);
    shape = {extruded[1]};
  }
  geo::synchronize();
  gmsh::vectorpair sides;
  gmsh::model::getEntities(sides, dim - 1);
  const char *const names[] = {"x0", "x1", "y0", "y1", "z0", "z1"};
  for (const auto &[d, tag] : sides) {
    std::array<double, 3> low, high;
    gmsh::model::getBoundingBox(d, tag, low[0], low[1], low[2], high[0], high[1], high[2]);
    for (unsigned int axis = 0; axis < dim; ++axis)
      if (high[axis] - low[axis] < 1e-3 * box.size[axis]) {
        const bool far = low[axis] > 0.5 * box.size[axis];
        const int group = gmsh::model::addPhysicalGroup(d, {tag});
        gmsh::model::setPhysicalName(d, group, names[2 * axis + far]);
      }
  }
  gmsh::model::mesh::generate(dim);
}

void open_file(const std::string &file, const unsigned int dim) {
  if (!std::filesystem::exists(file))
    throw UserError("Mesh/File: there is no file '" + file +
                    "'. Give its path from the folder of the parameter file.");
  gmsh::open(file);
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, unused;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
  if (tags.empty()) {
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", dim == 3 ? 2 : 1);
    gmsh::model::mesh::generate(dim);
  }
}

/// Nodes of all elements of one type and dimension, one after the other; refuses any other type.
std::vector<std::size_t> element_nodes(const int dim, const int entity, const int wanted,
                                       const std::string &what) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, dim, entity);
  std::vector<std::size_t> result;
  for (unsigned int t = 0; t < types.size(); ++t) {
    if (types[t] != wanted)
      throw UserError("The mesh has cells on its " + what +
                      " that are no quadrilaterals, or no hexahedra in 3D, of order 1. In a .geo "
                      "file, use 'Recombine Surface' and elements of order 1.");
    result.insert(result.end(), nodes[t].begin(), nodes[t].end());
  }
  return result;
}

template <int dim>
void take_mesh(ContinuumMesh<dim> &mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> x, unused;
  gmsh::model::mesh::getNodes(tags, x, unused, -1, -1, false, false);
  std::unordered_map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < tags.size(); ++i)
    place[tags[i]] = i;
  const auto position = [&](const std::size_t tag) {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = x[3 * place.at(tag) + d];
    return p;
  };

  constexpr unsigned int n_vertices = 1 << dim, n_face_vertices = 1 << (dim - 1);
  constexpr std::array<unsigned int, 8> order = {{0, 1, 3, 2, 4, 5, 7, 6}}; // of gmsh's vertices
  std::unordered_map<std::size_t, unsigned int> vertex;
  const auto cells = element_nodes(dim, -1, dim == 2 ? 3 : 5, dim == 2 ? "surfaces" : "volumes");
  for (std::size_t i = 0; i < cells.size(); i += n_vertices) {
    CellData<dim> cell(n_vertices);
    for (unsigned int v = 0; v < n_vertices; ++v) {
      const auto [entry, is_new] = vertex.try_emplace(cells[i + v], mesh.vertices.size());
      if (is_new)
        mesh.vertices.push_back(position(cells[i + v]));
      cell.vertices[order[v]] = entry->second;
    }
    mesh.cells.push_back(cell);
  }
  if (mesh.cells.empty())
    throw UserError("The mesh has no cells of dimension " + std::to_string(dim) + ".");

  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim - 1);
  for (const auto &[d, group] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(d, group, name);
    if (name.empty())
      continue;
    mesh.parts.push_back(name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(d, group, entities);
    for (const int entity : entities) {
      const auto faces = element_nodes(d, entity, dim == 2 ? 1 : 3, "boundary");
      for (std::size_t i = 0; i < faces.size(); i += n_face_vertices) {
        typename ContinuumMesh<dim>::Face face;
        face.part = mesh.parts.size();
        for (unsigned int v = 0; v < n_face_vertices; ++v) {
          if (vertex.count(faces[i + v]) == 0)
            throw UserError("The part '" + name + "' of the mesh is not on its cells.");
          face.vertices.push_back(vertex.at(faces[i + v]));
        }
        std::sort(face.vertices.begin(), face.vertices.end());
        mesh.faces.push_back(face);
      }
    }
  }
  gmsh::model::getPhysicalGroups(groups, 0);
  for (const auto &[d, group] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(d, group, name);
    std::vector<std::size_t> nodes;
    std::vector<double> coordinates;
    gmsh::model::mesh::getNodesForPhysicalGroup(0, group, nodes, coordinates);
    if (name.empty() || nodes.empty())
      continue;
    if (nodes.size() != 1 || vertex.count(nodes[0]) == 0)
      throw UserError("The physical point '" + name + "' of the mesh is no vertex of a cell.");
    mesh.points[name] = position(nodes[0]);
  }
}

} // namespace

template <int dim>
types::boundary_id ContinuumMesh<dim>::part(const std::string &name) const {
  const auto found = std::find(parts.begin(), parts.end(), name);
  if (found != parts.end())
    return found - parts.begin() + 1;
  std::string known;
  for (const std::string &other : parts)
    known += (known.empty() ? "" : ", ") + other;
  throw UserError("The body has no part of its boundary called '" + name +
                  "'. It has: " + (known.empty() ? "none" : known) + ".");
}

template <int dim>
ContinuumMesh<dim> build_continuum_mesh(const Scene &scene) {
  ContinuumMesh<dim> mesh;
  {
    const GmshSession session;
    if (scene.continuum->box)
      mesh_box(*scene.continuum->box, dim);
    else
      open_file(scene.mesh.file, dim);
    take_mesh(mesh);
  }
  for (const auto &[name, position] : scene.continuum->points) {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = position[d];
    mesh.points[name] = p;
  }
  GridTools::invert_cells_with_negative_measure(mesh.vertices, mesh.cells);
  GridTools::consistently_order_cells(mesh.cells);
  return mesh;
}

template struct ContinuumMesh<2>;
template struct ContinuumMesh<3>;
template ContinuumMesh<2> build_continuum_mesh<2>(const Scene &);
template ContinuumMesh<3> build_continuum_mesh<3>(const Scene &);

} // namespace frictionbeam
