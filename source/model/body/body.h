// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "base/processes.h"
#include "mesh/body_mesh.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <functional>
#include <map>
#include <memory>

namespace frictionbeam {

/// Distributed among processes; without MPI an ordinary vector.
using ContinuumVector = dealii::LinearAlgebra::distributed::Vector<double>;

/// A node of the mesh on a surface with friction.
template <int dim>
struct ContinuumContactNode {
  std::array<dealii::types::global_dof_index, dim> dofs;
  dealii::Point<dim> position;
  std::array<dealii::Tensor<1, dim>, dim> frame; ///< outward normal, t1 (along +x if it can), t2
  double weight = 0.;                            ///< area that the node stands for [m2]
  unsigned int surface = 0;                      ///< in ContinuumScene::contacts
};

/// Hooke's law of the body, in the plane: sigma = lambda tr(eps) I + 2 mu eps [Pa].
struct LameConstants {
  double lambda = 0., mu = 0.;
};
LameConstants lame_constants(const ContinuumScene &scene,
                             const dealii::types::material_id material = 0);

/**
 * A body of linear elastic material on continuous Lagrange elements with Gauss-Lobatto nodes, on a
 * mesh that can be refined, in serial or distributed among processes.
 *
 * Friction acts at the nodes: the integral over a surface is taken by the Gauss-Lobatto formula
 * with the nodes of the elements, which has positive weights and is exact to degree 2p-1, so that
 * each node carries traction times area and has a status of its own. Where hanging nodes lie on
 * such a surface (3D), their areas go to the nodes that they hang on.
 */
template <int dim>
class ContinuumBody {
public:
  ContinuumBody(const Scene &scene, const ContinuumMesh<dim> &mesh);

  /// Number the unknowns of the present mesh, and constrain them.
  void distribute() {
    distribute_dofs();
    constrain();
  }
  /// The two parts of that, for meshes on the way to another: the numbers alone; hanging nodes,
  /// held displacements and contact nodes.
  void distribute_dofs();
  void constrain();
  /// Hanging nodes and held displacements of a numbering of this mesh or a coarser one.
  void constrain(const dealii::DoFHandler<dim> &of,
                 dealii::AffineConstraints<double> &constraints) const;

  /// To be called before the flagged cells are refined, so that transfer() knows of them.
  void remember_flagged_cells();
  /// The mesh, as the flags of this process's cells, one refinement after the other. Reading
  /// refines the first mesh by them, and distributes: cells and unknowns have the same numbers.
  void transfer(Archive &archive);

  const Scene &scene;
  const ContinuumScene &continuum;
  const ContinuumMesh<dim> &mesh;
  const bool is_parallel;
  const MPI_Comm communicator;
  std::unique_ptr<dealii::Triangulation<dim>> triangulation;
  const dealii::MappingQ<dim> mapping; ///< of the geometry's degree
  const dealii::FESystem<dim> fe;
  dealii::DoFHandler<dim> dof_handler;
  dealii::AffineConstraints<double> constraints; ///< hanging nodes and held displacements
  dealii::IndexSet owned, relevant;
  std::vector<ContinuumContactNode<dim>> nodes; ///< of surfaces with friction, owned by this
                                                ///< process, by surface and then by x, y, z

  /// With entries of this process's own and room for its neighbours'.
  void reinit(ContinuumVector &vector) const;

  /// Forces of the tractions at load factor one, on the unconstrained dofs.
  ContinuumVector traction_forces() const;

  /// The contact surface that a boundary id belongs to, or -1.
  int surface_of(const dealii::types::boundary_id id) const;
  /// Whether a load acts on a boundary part.
  bool is_loaded(const dealii::types::boundary_id id) const;
  /// Traction of the loads on a boundary part at factor one.
  dealii::Tensor<1, dim> traction(const dealii::types::boundary_id id,
                                  const dealii::Tensor<1, dim> &normal) const;
  /// Thickness in 2D, one in 3D.
  double thickness() const { return dim == 2 ? continuum.thickness : 1.; }

private:
  void hold(const ContinuumHold &part, const dealii::DoFHandler<dim> &of,
            dealii::AffineConstraints<double> &constraints) const;
  /// What the faces of a surface with friction tell of its nodes.
  struct ContactArea {
    ContinuumVector normals; ///< area times outward normal of each node, on its dofs
    std::map<dealii::types::global_dof_index, ContinuumContactNode<dim>> nodes; ///< by first dof
  };
  void find_contact_nodes();
  void add_faces(std::vector<ContactArea> &areas) const;
  /// Add a cell's areas at its dofs: held ones keep their share, hanging ones pass it on.
  void add_area(const dealii::Vector<double> &local,
                const std::vector<dealii::types::global_dof_index> &dofs,
                ContinuumVector &area) const;

  std::vector<int> surfaces;                  ///< by boundary id
  std::vector<std::vector<char>> refinements; ///< of each, which cells were flagged
};

} // namespace frictionbeam
