// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/body.h"
#include "base/numbers.h"
#include "base/user_error.h"
#include "model/body/held_section.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

LameConstants lame_constants(const ContinuumScene &scene, const types::material_id material) {
  const bool is_one = scene.materials.empty();
  const double E = is_one ? scene.youngs_modulus : scene.materials[material].youngs_modulus,
               nu = is_one ? scene.poissons_ratio : scene.materials[material].poissons_ratio;
  LameConstants lame;
  lame.mu = E / (2. * (1. + nu));
  lame.lambda = scene.dimension == 2 && !scene.plane_strain ? E * nu / (1. - nu * nu)
                                                            : E * nu / ((1. + nu) * (1. - 2. * nu));
  return lame;
}

namespace {

template <int dim>
std::unique_ptr<Triangulation<dim>> make_triangulation(const bool is_parallel,
                                                       const MPI_Comm communicator) {
  const auto smoothing = Triangulation<dim>::limit_level_difference_at_vertices;
  if (is_parallel)
    return std::make_unique<parallel::distributed::Triangulation<dim>>(communicator, smoothing);
  return std::make_unique<Triangulation<dim>>(smoothing);
}

/// Give the faces on the boundary the ids of their parts.
template <int dim>
void name_faces(const ContinuumMesh<dim> &mesh, Triangulation<dim> &triangulation) {
  std::map<std::vector<unsigned int>, types::boundary_id> ids;
  for (const auto &face : mesh.faces)
    ids[face.vertices] = face.part;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary()) {
        std::vector<unsigned int> vertices;
        for (const unsigned int v : face->vertex_indices())
          vertices.push_back(face->vertex_index(v));
        std::sort(vertices.begin(), vertices.end());
        const auto found = ids.find(vertices);
        if (found != ids.end())
          face->set_boundary_id(found->second);
      }
}

} // namespace

template <int dim>
ContinuumBody<dim>::ContinuumBody(const Scene &scene, const ContinuumMesh<dim> &mesh)
    : scene(scene), continuum(*scene.continuum), mesh(mesh),
      is_parallel(Utilities::MPI::job_supports_mpi()),
      communicator(is_parallel ? MPI_COMM_WORLD : MPI_COMM_SELF),
      triangulation(make_triangulation<dim>(is_parallel, communicator)),
      mapping(mesh.geometry_degree), fe(FE_Q<dim>(scene.continuum_settings.degree), dim),
      dof_handler(*triangulation), surfaces(mesh.parts.size() + 1, -1) {
  for (unsigned int i = 0; i < continuum.contacts.size(); ++i)
    surfaces[mesh.part(continuum.contacts[i].part)] = i;
  for (const ContinuumTraction &load : continuum.tractions)
    mesh.part(load.part);
  triangulation->create_triangulation(mesh.vertices, mesh.cells, SubCellData());
  name_faces(mesh, *triangulation);
  for (unsigned int i = 0; i < mesh.manifolds.size(); ++i)
    triangulation->set_manifold(i, *mesh.manifolds[i]);
  if (!mesh.manifolds.empty())
    for (const auto &cell : triangulation->active_cell_iterators())
      cell->set_all_manifold_ids(cell->manifold_id());
}

template <int dim>
void ContinuumBody<dim>::distribute_dofs() {
  dof_handler.distribute_dofs(fe);
  owned = dof_handler.locally_owned_dofs();
  relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
}

template <int dim>
void ContinuumBody<dim>::remember_flagged_cells() {
  std::vector<bool> flags;
  triangulation->save_refine_flags(flags);
  refinements.emplace_back(flags.begin(), flags.end());
}

template <int dim>
void ContinuumBody<dim>::transfer(Archive &archive) {
  archive(refinements);
  if (!archive.reads())
    return;
  for (const std::vector<char> &flags : refinements) {
    triangulation->load_refine_flags(std::vector<bool>(flags.begin(), flags.end()));
    triangulation->execute_coarsening_and_refinement();
  }
  distribute();
}

template <int dim>
void ContinuumBody<dim>::constrain() {
  constrain(dof_handler, constraints);
  find_contact_nodes();
}

template <int dim>
void ContinuumBody<dim>::constrain(const DoFHandler<dim> &of,
                                   AffineConstraints<double> &constraints) const {
  constraints.clear();
  constraints.reinit(DoFTools::extract_locally_relevant_dofs(of));
  DoFTools::make_hanging_node_constraints(of, constraints);
  for (const ContinuumHold &part : continuum.holds)
    hold(part, of, constraints);
  if constexpr (dim == 3)
    for (const HeldSection &section : continuum.sections)
      hold_section(mapping, of, section, constraints);
  constraints.close();
}

template <int dim>
void ContinuumBody<dim>::hold(const ContinuumHold &part, const DoFHandler<dim> &of,
                              AffineConstraints<double> &constraints) const {
  const auto point = mesh.points.find(part.part);
  if (point == mesh.points.end()) {
    ComponentMask mask(dim, false);
    for (unsigned int d = 0; d < dim; ++d)
      mask.set(d, part.fixed[d]);
    DoFTools::make_zero_boundary_constraints(of, mesh.part(part.part), constraints, mask);
    return;
  }
  for (const auto &cell : of.active_cell_iterators())
    if (!cell->is_artificial())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->vertex(v).distance(point->second) < 1e-6 * cell->diameter())
          for (unsigned int d = 0; d < dim; ++d)
            if (part.fixed[d])
              constraints.add_line(cell->vertex_dof_index(v, d));
}

template <int dim>
int ContinuumBody<dim>::surface_of(const types::boundary_id id) const {
  return id < surfaces.size() ? surfaces[id] : -1;
}

template <int dim>
bool ContinuumBody<dim>::is_loaded(const types::boundary_id id) const {
  return std::any_of(continuum.tractions.begin(), continuum.tractions.end(),
                     [&](const ContinuumTraction &load) { return mesh.part(load.part) == id; });
}

template <int dim>
Tensor<1, dim> ContinuumBody<dim>::traction(const types::boundary_id id,
                                            const Tensor<1, dim> &normal) const {
  Tensor<1, dim> sum;
  for (const ContinuumTraction &load : continuum.tractions)
    if (mesh.part(load.part) == id) {
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += load.vector[d];
      sum -= load.pressure * normal;
    }
  return sum;
}

template <int dim>
void ContinuumBody<dim>::reinit(ContinuumVector &vector) const {
  if (is_parallel)
    vector.reinit(owned, relevant, communicator);
  else
    vector.reinit(dof_handler.n_dofs());
}

template <int dim>
ContinuumVector ContinuumBody<dim>::traction_forces() const {
  ContinuumVector forces;
  reinit(forces);
  const QGauss<dim - 1> quadrature(fe.degree + 1);
  FEFaceValues<dim> values(mapping, fe, quadrature,
                           update_values | update_normal_vectors | update_JxW_values);
  Vector<double> local(fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || !is_loaded(cell->face(f)->boundary_id()))
          continue;
        values.reinit(cell, f);
        local = 0.;
        for (const unsigned int q : values.quadrature_point_indices()) {
          const Tensor<1, dim> t = values.JxW(q) * thickness() *
                                   traction(cell->face(f)->boundary_id(), values.normal_vector(q));
          for (unsigned int i = 0; i < local.size(); ++i)
            local[i] += t[fe.system_to_component_index(i).first] * values.shape_value(i, q);
        }
        cell->get_dof_indices(dofs);
        constraints.distribute_local_to_global(local, dofs, forces);
      }
  forces.compress(VectorOperation::add);
  return forces;
}

template <int dim>
void ContinuumBody<dim>::add_area(const Vector<double> &local,
                                  const std::vector<types::global_dof_index> &dofs,
                                  ContinuumVector &area) const {
  for (unsigned int k = 0; k < local.size(); ++k) {
    if (local[k] == 0.)
      continue;
    const auto *const entries = constraints.get_constraint_entries(dofs[k]);
    if (entries == nullptr || entries->empty())
      area(dofs[k]) += local[k];
    else
      for (const auto &[dof, factor] : *entries)
        area(dof) += factor * local[k];
  }
}

namespace {

/// Axes n, t1, t2 of a contact node; t1 is along the first axis that does not lie near n.
template <int dim>
std::array<Tensor<1, dim>, dim> axes_along(const Tensor<1, dim> &n) {
  std::array<Tensor<1, dim>, dim> axes;
  axes[0] = n;
  const unsigned int axis = std::abs(n[0]) > 0.9 ? 1 : 0;
  Tensor<1, dim> t;
  t[axis] = 1.;
  t -= (t * n) * n;
  axes[1] = t / t.norm();
  if constexpr (dim == 3)
    axes[2] = cross_product_3d(n, axes[1]);
  return axes;
}

/// The point of a face's quadrature that is nearest to @p place.
template <int dim>
unsigned int nearest_point(const Point<dim> &place, const FEFaceValues<dim> &values) {
  unsigned int nearest = 0;
  for (const unsigned int q : values.quadrature_point_indices())
    if (place.distance(values.quadrature_point(q)) <
        place.distance(values.quadrature_point(nearest)))
      nearest = q;
  return nearest;
}

} // namespace

template <int dim>
void ContinuumBody<dim>::add_faces(std::vector<ContactArea> &areas) const {
  // The formula's points are the face's nodes (doc/continuum.md, "Friction at nodes").
  const QGaussLobatto<dim - 1> quadrature(fe.degree + 1);
  FEFaceValues<dim> values(mapping, fe, quadrature,
                           update_quadrature_points | update_normal_vectors | update_JxW_values);
  const std::vector<Point<dim>> &unit_points = fe.get_unit_support_points();
  Vector<double> local(fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->is_artificial() || !cell->at_boundary())
      continue;
    for (const unsigned int f : cell->face_indices()) {
      const int surface =
          cell->face(f)->at_boundary() ? surface_of(cell->face(f)->boundary_id()) : -1;
      if (surface < 0)
        continue;
      values.reinit(cell, f);
      cell->get_dof_indices(dofs);
      local = 0.;
      for (unsigned int i = 0; i < fe.n_dofs_per_face(f); ++i) {
        const unsigned int k = fe.face_to_cell_index(i, f),
                           component = fe.system_to_component_index(k).first;
        const Point<dim> place = mapping.transform_unit_to_real_cell(cell, unit_points[k]);
        const unsigned int q = nearest_point(place, values);
        local[k] = values.JxW(q) * thickness() * values.normal_vector(q)[component];
        if (component > 0 || !owned.is_element(dofs[k]))
          continue;
        ContinuumContactNode<dim> &node = areas[surface].nodes[dofs[k]];
        node.position = place;
        node.surface = surface;
        for (unsigned int d = 0; d < dim; ++d)
          node.dofs[d] =
              dofs[fe.component_to_system_index(d, fe.system_to_component_index(k).second)];
      }
      if (cell->is_locally_owned())
        add_area(local, dofs, areas[surface].normals);
    }
  }
}

template <int dim>
void ContinuumBody<dim>::find_contact_nodes() {
  std::vector<ContactArea> areas(continuum.contacts.size());
  for (ContactArea &area : areas)
    reinit(area.normals);
  add_faces(areas);
  nodes.clear();
  for (ContactArea &area : areas) {
    area.normals.compress(VectorOperation::add);
    const unsigned int begin = nodes.size();
    for (auto &[first_dof, node] : area.nodes) {
      Tensor<1, dim> normal;
      for (unsigned int d = 0; d < dim; ++d)
        normal[d] = area.normals(node.dofs[d]);
      node.weight = normal.norm();
      if (node.weight == 0.)
        continue; // a hanging node
      node.frame = axes_along<dim>(normal / node.weight);
      if constexpr (dim == 3)
        if (const auto &patch = continuum.contacts[node.surface].patch) {
          if (!patch->has(node.position))
            continue;
          node.frame = patch->axes;
        }
      bool held = false; // what holds the node along its normal carries its force
      for (unsigned int d = 0; d < dim; ++d)
        held |=
            std::abs(node.frame[0][d]) > no_direction && constraints.is_constrained(node.dofs[d]);
      if (!held)
        nodes.push_back(node);
    }
    std::sort(nodes.begin() + begin, nodes.end(), [](const auto &a, const auto &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.position[d] != b.position[d])
          return a.position[d] < b.position[d];
      return false;
    });
  }
}

template class ContinuumBody<2>;
template class ContinuumBody<3>;

} // namespace frictionbeam
