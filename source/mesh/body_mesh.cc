// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/own_mesh.h"
#include "mesh/gmsh/session.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "mesh/body_mesh.h"
#include "mesh/point_set.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gmsh.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace frictionbeam {

using namespace dealii;

namespace {

/// A box from the origin in equal cells, its sides the parts x0 x1 y0 y1 (z0 z1).
template <int dim>
void mesh_box(const ContinuumBox &box, ContinuumMesh<dim> &mesh) {
  Point<dim> far_corner;
  for (unsigned int d = 0; d < dim; ++d)
    far_corner[d] = box.size[d];
  Triangulation<dim> grid;
  GridGenerator::subdivided_hyper_rectangle(
      grid, std::vector<unsigned int>(box.cells.begin(), box.cells.begin() + dim), Point<dim>(),
      far_corner, true);
  const std::vector<std::string> sides = {"x0", "x1", "y0", "y1", "z0", "z1"};
  mesh.parts.assign(sides.begin(), sides.begin() + 2 * dim); // in the order of boundary ids
  mesh.vertices = grid.get_vertices();
  for (const auto &cell : grid.active_cell_iterators()) {
    CellData<dim> data(cell->n_vertices());
    for (const unsigned int v : cell->vertex_indices())
      data.vertices[v] = cell->vertex_index(v);
    mesh.cells.push_back(data);
    for (const auto &side : cell->face_iterators())
      if (side->at_boundary()) {
        typename ContinuumMesh<dim>::Face face;
        face.part = side->boundary_id() + 1;
        for (const unsigned int v : side->vertex_indices())
          face.vertices.push_back(side->vertex_index(v));
        std::sort(face.vertices.begin(), face.vertices.end());
        mesh.faces.push_back(face);
      }
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

/// Takes the mesh that gmsh has, with the names of its parts.
template <int dim>
class MeshOfGmsh {
public:
  explicit MeshOfGmsh(ContinuumMesh<dim> &mesh);
  void take_cells();
  void take_faces();  ///< of physical groups that have a name
  void take_points(); ///< likewise

private:
  Point<dim> position(const std::size_t tag) const;
  std::string places_of(const std::vector<unsigned int> &vertices) const;
  void remark_on_twins(); ///< vertices at one place
  /// The face with these vertices, of the part that was named last.
  void add_face(const std::size_t *const tags);

  static constexpr unsigned int n_vertices = 1 << dim, n_face_vertices = 1 << (dim - 1);
  ContinuumMesh<dim> &mesh;
  std::vector<double> x;                                    ///< of all nodes, 3 each
  std::unordered_map<std::size_t, std::size_t> place;       ///< of a node's tag in x
  std::unordered_map<std::size_t, unsigned int> vertex;     ///< of the mesh, by tag
  std::map<std::vector<unsigned int>, std::string> part_of; ///< a face's vertices
};

template <int dim>
MeshOfGmsh<dim>::MeshOfGmsh(ContinuumMesh<dim> &mesh) : mesh(mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> unused;
  gmsh::model::mesh::getNodes(tags, x, unused, -1, -1, false, false);
  for (std::size_t i = 0; i < tags.size(); ++i)
    place[tags[i]] = i;
}

template <int dim>
Point<dim> MeshOfGmsh<dim>::position(const std::size_t tag) const {
  constexpr double in_the_plane = 1e-9; // [m]
  Point<dim> p;
  if (dim == 2 && std::abs(x[3 * place.at(tag) + 2]) > in_the_plane)
    throw UserError("The mesh has nodes off the plane z = 0. Draw a plane body in that plane, or "
                    "set Continuum/Dimension = 3.");
  for (unsigned int d = 0; d < dim; ++d)
    p[d] = x[3 * place.at(tag) + d];
  return p;
}

template <int dim>
void MeshOfGmsh<dim>::take_cells() {
  constexpr std::array<unsigned int, 8> order = {{0, 1, 3, 2, 4, 5, 7, 6}}; // of gmsh's vertices
  const auto cells = element_nodes(dim, -1, dim == 2 ? 3 : 5, dim == 2 ? "surfaces" : "volumes");
  std::set<std::vector<unsigned int>> known;
  for (std::size_t i = 0; i < cells.size(); i += n_vertices) {
    CellData<dim> cell(n_vertices);
    for (unsigned int v = 0; v < n_vertices; ++v) {
      const auto [entry, is_new] = vertex.try_emplace(cells[i + v], mesh.vertices.size());
      if (is_new)
        mesh.vertices.push_back(position(cells[i + v]));
      cell.vertices[order[v]] = entry->second;
    }
    mesh.cells.push_back(cell);
    std::sort(cell.vertices.begin(), cell.vertices.end());
    if (!known.insert(cell.vertices).second)
      throw UserError("The mesh has one cell twice, between the nodes" + places_of(cell.vertices) +
                      ". Take one of them out.");
  }
  if (mesh.cells.empty())
    throw UserError("The mesh has no cells of dimension " + std::to_string(dim) + ".");
  remark_on_twins();
}

template <int dim>
std::string MeshOfGmsh<dim>::places_of(const std::vector<unsigned int> &vertices) const {
  std::string text;
  for (const unsigned int v : vertices) {
    text += " (";
    for (unsigned int d = 0; d < dim; ++d)
      text += (d > 0 ? ", " : "") + rounded_number(mesh.vertices[v][d]);
    text += ")";
  }
  return text;
}

template <int dim>
void MeshOfGmsh<dim>::remark_on_twins() {
  constexpr double same = 1e-7; // of the body's extent
  std::vector<Point3> points;
  for (const Point<dim> &vertex_of_mesh : mesh.vertices) {
    points.emplace_back();
    for (unsigned int d = 0; d < dim; ++d)
      points.back()[d] = vertex_of_mesh[d];
  }
  const BoundingBox<3> box(points);
  const auto &[low, high] = box.get_boundary_points();
  const std::vector<std::size_t> twins = repeated_points(points, same * low.distance(high));
  if (!twins.empty())
    mesh.remarks.push_back("The mesh has two vertices at one place, such as at" +
                           places_of({static_cast<unsigned int>(twins.front())}) + ", " +
                           std::to_string(twins.size()) +
                           " times: cells are not joined there, nor do they touch. If that is not "
                           "meant, make one node of the two (Coherence Mesh; in gmsh).");
}

template <int dim>
void MeshOfGmsh<dim>::add_face(const std::size_t *const tags) {
  const std::string &name = mesh.parts.back();
  typename ContinuumMesh<dim>::Face face;
  face.part = mesh.parts.size();
  for (unsigned int v = 0; v < n_face_vertices; ++v) {
    if (vertex.count(tags[v]) == 0)
      throw UserError("The part '" + name + "' of the mesh is not on its cells.");
    face.vertices.push_back(vertex.at(tags[v]));
  }
  std::sort(face.vertices.begin(), face.vertices.end());
  if (const auto found = part_of.emplace(face.vertices, name).first; found->second != name)
    throw UserError("The mesh has faces that belong to the parts '" + found->second + "' and '" +
                    name + "' both. Give each face of the boundary one physical group.");
  mesh.faces.push_back(face);
}

template <int dim>
void MeshOfGmsh<dim>::take_faces() {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dim - 1);
  for (const auto &[d, group] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(d, group, name);
    if (name.empty()) {
      mesh.remarks.push_back("A physical group of the boundary without a name (tag " +
                             std::to_string(group) +
                             "; of two of one name, gmsh leaves one without) is not used.");
      continue;
    }
    if (std::count(mesh.parts.begin(), mesh.parts.end(), name) > 0)
      throw UserError("The mesh has two parts of its boundary called '" + name +
                      "'. Give them two names, or all that is meant one tag.");
    mesh.parts.push_back(name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(d, group, entities);
    for (const int entity : entities) {
      const auto faces = element_nodes(d, entity, dim == 2 ? 1 : 3, "boundary");
      for (std::size_t i = 0; i < faces.size(); i += n_face_vertices)
        add_face(&faces[i]);
    }
  }
}

template <int dim>
void MeshOfGmsh<dim>::take_points() {
  gmsh::vectorpair groups;
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

/// Parts that are held, loaded or frictional are on the boundary.
/// @throws UserError where one has faces between two cells
template <int dim>
void check_parts(const Scene &scene, const ContinuumMesh<dim> &mesh) {
  std::set<std::string> used;
  for (const ContinuumHold &hold : scene.continuum->holds)
    used.insert(hold.part);
  for (const ContinuumTraction &traction : scene.continuum->tractions)
    used.insert(traction.part);
  for (const ContinuumContact &contact : scene.continuum->contacts)
    used.insert(contact.part);
  std::map<std::vector<unsigned int>, unsigned int> n_cells; // of the faces of those parts
  for (const auto &face : mesh.faces)
    if (used.count(mesh.parts[face.part - 1]) > 0)
      n_cells[face.vertices] = 0;
  for (const CellData<dim> &cell : mesh.cells)
    for (const unsigned int f : GeometryInfo<dim>::face_indices()) {
      std::vector<unsigned int> face;
      for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_face; ++v)
        face.push_back(cell.vertices[GeometryInfo<dim>::face_to_cell_vertices(f, v)]);
      std::sort(face.begin(), face.end());
      if (const auto found = n_cells.find(face); found != n_cells.end())
        ++found->second;
    }
  for (const auto &face : mesh.faces)
    if (const auto found = n_cells.find(face.vertices);
        found != n_cells.end() && found->second != 1)
      throw UserError("The part '" + mesh.parts[face.part - 1] +
                      "' of the mesh has faces inside of the body.\n  read:    a face between " +
                      std::to_string(found->second) +
                      " cells\n  allowed: parts of the boundary in Held, Loaded and Frictional\n"
                      "  try:     a physical group of faces of one cell each");
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
  if (scene.continuum->box)
    mesh_box(*scene.continuum->box, mesh);
  else {
    const GmshSession session;
    by_gmsh(scene.mesh.file, [&]() {
      open_own_mesh(scene, dim);
      MeshOfGmsh<dim> found(mesh);
      found.take_cells();
      found.take_faces();
      found.take_points();
    });
    GridTools::invert_cells_with_negative_measure(mesh.vertices, mesh.cells);
    GridTools::consistently_order_cells(mesh.cells);
    check_parts(scene, mesh);
  }
  for (const auto &[name, position] : scene.continuum->points) {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = position[d];
    mesh.points[name] = p;
  }
  return mesh;
}

template struct ContinuumMesh<2>;
template struct ContinuumMesh<3>;
template ContinuumMesh<2> build_continuum_mesh<2>(const Scene &);
template ContinuumMesh<3> build_continuum_mesh<3>(const Scene &);

} // namespace frictionbeam
