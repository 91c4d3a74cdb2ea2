// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"
#include "model/line/solid_part.h"

#include <unordered_map>

namespace frictionbeam {

/**
 * What is linear in a scene, assembled once: stiffness and mass of pipes, springs and point masses
 * on the free unknowns, and for each load (at factor 1) its forces and its imposed motions.
 */
class LinearPart {
public:
  /// @param parts in place of the cells that they have
  LinearPart(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
             const ReducedSpace &space, const Contacts &contacts, const bool with_mass,
             std::vector<SolidPart> parts = {});

  /// Of the motions b_l that loads impose, by pairs of loads: b_k^T A b_l; without entries if no
  /// load imposes any.
  struct Products {
    Eigen::MatrixXd stiffness, mass, damping;
  };

  /// Of a model whose matrices come from elsewhere; damping may be without entries.
  struct Matrices {
    SparseMatrix stiffness, mass, damping;
    std::vector<Vector> forces;        ///< by load
    std::vector<Vector> inertia, drag; ///< likewise
    std::vector<bool> moves_mass;      ///< likewise, LinearPart::accelerates()
    std::vector<std::vector<std::pair<unsigned int, double>>> imposed; ///< likewise
    Products products;
  };
  explicit LinearPart(Matrices matrices);

  /// Symmetric, with the pattern of the contacts' tangents in it, and of those of cells that turn
  /// or yield.
  const SparseMatrix &stiffness() const { return K; }
  /// Empty if not asked for.
  const SparseMatrix &mass() const { return M; }
  /// Viscous damping; without entries if there is none or no mass was asked for.
  const SparseMatrix &damping() const { return C; }

  /// Forces of load @p l on the unknowns, those of its imposed motions included.
  const Vector &forces(const unsigned int l) const { return load_forces[l]; }
  /// Whether load @p l imposes motions on nodes whose cells have mass or damping.
  bool accelerates(const unsigned int l) const { return moves_mass[l]; }
  /// Forces on the unknowns per second and first derivative in time of the factor of such a load:
  /// inertia -M_ub u_b and Rayleigh damping of the motions that it imposes.
  const Vector &inertia(const unsigned int l) const { return load_inertia[l]; }
  const Vector &drag(const unsigned int l) const { return load_drag[l]; }
  /// Motions that load @p l imposes on all degrees of freedom, as (dof, value) pairs.
  const std::vector<std::pair<unsigned int, double>> &imposed(const unsigned int l) const {
    return imposed_motions[l];
  }
  /// Rate of a degree of freedom, from those of the unknowns and of the loads' factors, where loads
  /// that impose motions have any.
  double rate(const dealii::types::global_dof_index dof, const ReducedSpace &space,
              const Vector &unknowns, const std::vector<double> &factors) const;
  const Products &imposed_products() const { return products; }
  /// What stored energy has besides q^T K q / 2, at factors x of the loads: -sum x_l f_l . q +
  /// x^T b^T K b x / 2 over the loads that impose motions.
  double stored_by_imposed(const std::vector<double> &factors, const Vector &unknowns) const;
  /// What kinetic energy has besides v^T M v / 2, likewise of the factors' rates.
  double kinetic_by_imposed(const std::vector<double> &rates, const Vector &velocity) const;
  /// Forces and moments that load @p l puts on vertices by itself (point loads, weight of masses).
  const std::map<unsigned int, Motion> &nodal(const unsigned int l) const { return nodal_loads[l]; }
  /// Of the pipes, and whether pressure stiffens one of them, which stiffness() leaves out.
  const std::vector<SolidPart> &parts() const { return solid_parts; }
  bool has_pressed_parts() const;
  /// The solid part that a pipe cell belongs to; null: none.
  const SolidPart *solid_part(const PipeCell &cell) const;

private:
  void find_imposed_motions(const Scene &scene, const LineMesh &mesh,
                            const Discretization &discretization, const ReducedSpace &space,
                            const bool with_mass);
  void sort_imposed_motions();
  /// What a matrix on a few degrees of freedom is to motions that loads impose there: @p forces on
  /// the unknowns and products.
  void add_imposed(const Eigen::Ref<const Eigen::MatrixXd> &local,
                   const std::vector<dealii::types::global_dof_index> &dofs,
                   const ReducedSpace &space, std::vector<Vector> &forces,
                   Eigen::MatrixXd &products_of_motions) const;
  void find_nodal_loads(const Scene &scene, const LineMesh &mesh,
                        const Discretization &discretization, const ReducedSpace &space);
  void add_pipes(const Scene &scene, const Discretization &discretization,
                 const ReducedSpace &space, const bool with_mass, MatrixEntries &of_stiffness,
                 MatrixEntries &of_mass);
  void add_solid_parts(const Discretization &discretization, const ReducedSpace &space,
                       MatrixEntries &of_stiffness);
  void add_springs(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                   const ReducedSpace &space, const bool with_mass, MatrixEntries &of_stiffness);
  void add_point_masses(const Scene &scene, const LineMesh &mesh,
                        const Discretization &discretization, const ReducedSpace &space,
                        MatrixEntries &of_mass);
  void make_damping(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                    const ReducedSpace &space);

  SparseMatrix K, M, C;
  std::vector<Vector> load_forces, load_inertia, load_drag;
  std::vector<bool> moves_mass; ///< by load; inertia is a vector of no entries where all is imposed
  std::vector<std::vector<std::pair<unsigned int, double>>> imposed_motions;
  /// The same by degree of freedom: loads and values.
  std::unordered_map<dealii::types::global_dof_index, std::vector<std::pair<unsigned int, double>>>
      imposed_at;
  Products products;
  std::vector<std::map<unsigned int, Motion>> nodal_loads;
  std::vector<SolidPart> solid_parts;
};

/// Force per length and axial strain that a load puts on a cell of @p pipe with @p profile.
struct CellLoad {
  Vector3 line_force;
  double axial_strain = 0.;
  double curvature = 0.; ///< about a bend's axis [1/m]
  double pressure = 0.;  ///< that pushes the sides of its joints apart [Pa]
};
/// @param chord of the cell, for wind
CellLoad cell_load(const Load &load, const std::string &pipe, const Profile &profile,
                   const Vector3 &chord);

} // namespace frictionbeam
