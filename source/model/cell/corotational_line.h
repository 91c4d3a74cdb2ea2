// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/corotational_beam.h"
#include "model/line/linear_part.h"

namespace frictionbeam {

/// Where a line is that moves and turns by any amount.
struct Pose {
  /// Of all degrees of freedom: translations [m] and rotation vectors [rad], the latter to be read
  /// only: of those that mean the same rotation, the one that a steady motion leads to.
  Vector dofs;
  Vector turns; ///< rotation of each vertex of the line, a quaternion (x, y, z, w)
};

/**
 * A scene's pipes in corotational kinematics (CorotationalBeam), with its springs and loads: what
 * takes the place of the constant stiffness of LinearPart. Weight, line force and wind keep their
 * directions; forces that follow turn with their point; thermal strain and pressure act in the
 * cell's frame. Contacts and what is held keep their directions in space.
 *
 * A cell is straight or an arc: the linear element in its frame is whatever it is, and the frame
 * follows its chord. Inertia is the same in every frame, and exact in rigid motions of straight
 * cells: that of translations which are linear along each cell's chord, and half of each cell's
 * rotary inertia at either end as a body that turns with the vertex.
 */
class CorotationalLine {
public:
  CorotationalLine(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                   const ReducedSpace &space, const LinearPart &linear);

  Pose at_rest() const;
  /// Moved by translations and rotation vectors of all degrees of freedom.
  Pose moved(const Pose &from, const Vector &change) const;
  /// Moved by a time step: translations and Cayley vectors.
  Pose stepped(const Pose &from, const Vector &change) const;
  /// Translations and rotation vectors from one pose to another, for turns of less than pi.
  Vector change(const Pose &from, const Pose &to) const;
  /// Half of the way, likewise.
  Pose halfway(const Pose &from, const Pose &to) const;

  struct Balance {
    Vector loads, internal; ///< forces on all degrees of freedom, loads without free strains
    Vector forces;          ///< loads less internal, on the unknowns
    SparseMatrix stiffness; ///< less their derivative
    double largest = 0.;    ///< force or moment of a cell or load on a vertex
    double free_work = 0.;  ///< of free strains from the first to the last pose [J]
  };
  /**
   * Forces at a pose, or those of a time step: the mean of the cells' forces at both its ends,
   * acting on the pose halfway, corrected so that their work is the change of the stored energy.
   * Their resultant is zero. The stiffness is then twice the derivative by the step's change.
   * @param factors of the loads, mean ones of a step
   */
  void evaluate(const Pose &from, const Pose &half, const Pose &to,
                const std::vector<double> &factors, Balance &balance) const;
  void evaluate(const Pose &at, const std::vector<double> &factors, Balance &balance) const {
    evaluate(at, at, at, factors, balance);
  }

  /// Elastic energy of pipes and springs [J].
  double stored_energy(const Pose &pose) const;

  /// Of translations, on the unknowns, in the stiffness's pattern; without entries in statics.
  const SparseMatrix &mass() const { return M; }
  /**
   * Turning bodies over a step by the midpoint rule with exact angular momentum and energy (J. C.
   * Simo, K. K. Wong, IJNME 31 (1991) 19-52, doi:10.1002/nme.1620310103).
   * @param change Cayley vectors among all degrees of freedom
   * @param spin_before angular velocities among them [rad/s]
   * @param forces -= 2/h times the change of angular momentum, on the unknowns
   * @param matrix += its derivative by the change
   */
  void add_rotary(const Pose &from, const Pose &to, const Vector &change, const Vector &spin_before,
                  const double step, Vector &forces, SparseMatrix &matrix) const;
  /// Angular velocities at a step's end, in place of the entries of @p velocity that are spins.
  void set_spins(const Pose &from, const Pose &to, const Vector &change, const Vector &spin_before,
                 const double step, Vector &velocity) const;
  /// Kinetic energy [J] of velocities of all degrees of freedom.
  double kinetic_energy(const Pose &pose, const Vector &velocity) const;
  /// Linear (3) and angular momentum about the origin (3).
  Motion momentum(const Pose &pose, const Vector &velocity) const;

  /// What results are made of: a cell in its frame, with the forces on its ends.
  struct CellState {
    CorotationalBeam::Deformed deformed;
    CorotationalBeam::Vector12 ends;    ///< forces on them, global axes
    CorotationalBeam::Vector12 motions; ///< of the linear element, in the axes at rest
    Eigen::Matrix3d turn;               ///< of the frame
  };
  CellState cell(const unsigned int pipe_cell, const Pose &pose,
                 const std::vector<double> &factors) const;
  /// A load's force and moment on a vertex, turned with it if it follows.
  Motion nodal_load(const unsigned int load, const unsigned int vertex, const Pose &pose) const;

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
    double mass = 0.; ///< [kg]
  };
  CorotationalBeam::Ends ends(const Cell &cell, const Pose &pose) const;
  Eigen::Map<const Eigen::Quaterniond> turn(const Pose &pose, const unsigned int vertex) const {
    return Eigen::Map<const Eigen::Quaterniond>(pose.turns.data() + 4 * vertex);
  }
  Eigen::Vector3d part(const Vector &dofs, const unsigned int vertex,
                       const unsigned int first) const;
  void add_part(const Eigen::Vector3d &value, const unsigned int vertex, const unsigned int first,
                Vector &dofs) const;
  bool turns(const unsigned int vertex) const;
  CorotationalBeam::Vector12 on_line(const Cell &cell, const Eigen::Matrix3d &axes,
                                     const std::vector<double> &factors,
                                     CorotationalBeam::Vector7 &free) const;
  void add_springs(const Pose &from, const Pose &to, Balance &balance) const;
  void add_nodal_loads(const Pose &half, const std::vector<double> &factors,
                       Balance &balance) const;
  void add_local(const Eigen::Ref<const Eigen::MatrixXd> &local,
                 const std::vector<dealii::types::global_dof_index> &dofs,
                 SparseMatrix &matrix) const;
  void add_mass();

  const Scene &scene;
  const LineMesh &mesh;
  const Discretization &discretization;
  const ReducedSpace &space;
  const LinearPart &linear;
  const unsigned int n_vertices;
  std::vector<Cell> cells; ///< as the pipe cells of the discretization
  SparseMatrix pattern, M;
  std::vector<double> point_mass;              ///< of each vertex [kg]
  std::vector<Eigen::Matrix3d> vertex_inertia; ///< at rest, in global axes [kg m2]
};

} // namespace frictionbeam
