// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/corotational_beam.h"
#include "model/cell/line_cells.h"

namespace frictionbeam {

/**
 * Cells that move and turn by any amount while their strains stay small (CorotationalBeam). Weight,
 * line force and wind keep their directions; forces that follow turn with their point; thermal
 * strain and pressure act in the cell's frame. Contacts and what is held keep their directions in
 * space.
 *
 * A cell is straight or an arc: the linear element in its frame is whatever it is, and the frame
 * follows its chord. Inertia is the same in every frame, and exact in rigid motions of straight
 * cells: that of translations which are linear along each cell's chord, and half of each cell's
 * rotary inertia at either end as a body that turns with the vertex.
 */
class CorotationalCells final : public LineCells {
public:
  CorotationalCells(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                    const ReducedSpace &space, const LinearPart &linear);

  bool is_linear() const override { return false; }
  bool turns_far() const override { return true; }

  Pose at_rest() const override;
  Pose moved(const Pose &from, const Vector &change) const override;
  Pose stepped(const Pose &from, const Vector &change) const override;
  Vector change(const Pose &from, const Pose &to) const override;
  Pose halfway(const Pose &from, const Pose &to) const override;

  /// Of translations.
  const SparseMatrix &mass() const override { return M; }
  /// Turning bodies over a step by the midpoint rule with exact angular momentum and energy (J. C.
  /// Simo, K. K. Wong, IJNME 31 (1991) 19-52, doi:10.1002/nme.1620310103).
  void add_rotary(const Pose &from, const Pose &to, const Vector &change, const Vector &spin_before,
                  const double step, Vector &forces, SparseMatrix *matrix) const override;
  void set_spins(const Pose &from, const Pose &to, const Vector &change, const Vector &spin_before,
                 const double step, Vector &velocity) const override;
  void add_rotary_at(const Pose &pose, const Turning &turning, Vector &forces,
                     SparseMatrix *matrix) const override;
  void add_rotary_mass(const Pose &pose, SparseMatrix &matrix) const override;
  void keep_inert(const Pose &pose, const Vector &mean, Vector &rates) const override;
  Vector momenta(const Pose &pose, const Vector &velocity) const override;

  CellState state_of(const unsigned int cell, const PipeElement &element, const Pose &pose,
                     const std::vector<double> &factors) const override;
  Vector12 motions_of_cell(const unsigned int cell, const Pose &pose,
                           const Vector &motion) const override;
  /// Without rotary inertia.
  Matrix12 mass_of(const unsigned int cell, PipeElement &element) const override;
  Motion nodal_load(const unsigned int load, const unsigned int vertex,
                    const Pose &pose) const override;
  Unbent unbent(const Pose &pose) const override;

private:
  struct CellForces {
    unsigned int load;
    CorotationalBeam::Vector7 free; ///< of free strains
    Eigen::Vector3d line_force;
  };
  struct Cell {
    CorotationalBeam beam;
    unsigned int vertices[2];
    std::vector<dealii::types::global_dof_index> dofs;
    Eigen::Matrix<double, 12, 3> line_loads; ///< at rest
    std::vector<CellForces> loads;
    double bending = 0.; ///< EI/length of its pipe, without joints [N m]
    double mass = 0.;    ///< [kg]
  };
  /// By the forces halfway, corrected along the change of the deformations.
  void answer(const unsigned int cell, const Step &step, const std::vector<double> &factors,
              CellAnswer &answer) const override;
  void add_modal_damping(const Step &step, Balance &balance) const override;
  double stored_in(const unsigned int cell, const Pose &pose) const override;
  CorotationalBeam::Ends ends(const Cell &cell, const Pose &pose) const;
  Eigen::Map<const Eigen::Quaterniond> turn(const Pose &pose, const unsigned int vertex) const {
    return Eigen::Map<const Eigen::Quaterniond>(pose.turns.data() + 4 * vertex);
  }
  bool turns(const unsigned int vertex) const;
  std::vector<dealii::types::global_dof_index> rotations_of(const unsigned int vertex) const;
  Vector12 on_line(const Cell &cell, const Eigen::Matrix3d &axes,
                   const std::vector<double> &factors, CorotationalBeam::Vector7 &free) const;
  void add_mass();
  /// Modes of the line at rest, as forces on the cells' deformations.
  void find_damped_modes();

  std::vector<Cell> cells; ///< as the pipe cells of the discretization
  SparseMatrix M;
  std::vector<Eigen::Matrix3d> vertex_inertia; ///< at rest, in global axes [kg m2]
  /// Projectors on the directions that they have, about which spins are states of their own.
  std::vector<Eigen::Matrix3d> inert;
  /// Of Modal damping: forces of each mode on the deformations of cells, seven
  /// rows each, and on springs, six each; and damping 2 zeta / w^3 of the mode.
  /// Without entries if there is none.
  Eigen::MatrixXd mode_forces;
  Vector mode_damping;
};

} // namespace frictionbeam
