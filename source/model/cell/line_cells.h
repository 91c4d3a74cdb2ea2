// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/pipe_sections.h"
#include "model/line/linear_part.h"
#include "model/line/pipe_element.h"

#include <memory>

namespace frictionbeam {

/// Where a line is.
struct Pose {
  /// Of all degrees of freedom: translations [m] and rotation vectors [rad]. Where points turn by
  /// any angle the latter are to be read only: of those that mean the same rotation, the one that a
  /// steady motion leads to.
  Vector dofs;
  /// Rotation of each vertex of the line, a quaternion (x, y, z, w); empty where turns are small.
  Vector turns;
  /// States of the sections that have a law of their own (PipeSections), those that the increment
  /// began with until it is committed; null where there are none. Not owned.
  const Vector *sections = nullptr;
};

/// Where a cell's frame has gone, in which the cell is the linear element.
struct CellFrame {
  Eigen::Matrix3d turn;        ///< from rest
  Eigen::Vector3d first;       ///< vertex at rest [m]
  Eigen::Vector3d first_moved; ///< its translation [m]
  Eigen::Vector3d own;         ///< its translation in the frame [m]
};

/**
 * What a line's pipe cells, with its springs and the loads on them, answer at a pose: forces,
 * tangent, energies, inertia and what results are made of. Contacts are not in it. Analyses take
 * any cells; those of which is_linear() is true may be asked LinearPart alone.
 *
 * Rates of rotations are spins, angular velocities in global axes.
 */
class LineCells {
public:
  using Vector12 = PipeElement::Vector12;
  using Matrix12 = PipeElement::Matrix12;

  LineCells(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
            const ReducedSpace &space, const LinearPart &linear);
  virtual ~LineCells() = default;

  /// Whether forces are linear in the motion, so that states may be superposed.
  virtual bool is_linear() const = 0;
  /// Whether points turn by any angle, and arms and loads that follow with them.
  virtual bool turns_far() const = 0;

  virtual Pose at_rest() const = 0;
  /// Moved by translations and rotation vectors of all degrees of freedom.
  virtual Pose moved(const Pose &from, const Vector &change) const = 0;
  /// Moved by a time step: translations and Cayley vectors.
  virtual Pose stepped(const Pose &from, const Vector &change) const = 0;
  /// Translations and rotation vectors from one pose to another, for turns of less than pi.
  virtual Vector change(const Pose &from, const Pose &to) const = 0;
  /// Half of the way, likewise.
  virtual Pose halfway(const Pose &from, const Pose &to) const = 0;

  struct Balance {
    Vector loads, internal; ///< forces on all degrees of freedom, loads without free strains
    Vector forces;          ///< loads less internal, on the unknowns
    SparseMatrix stiffness; ///< less their derivative
    double largest = 0.;    ///< force or moment of a cell or load on a vertex
    double free = 0.;       ///< the same of free strains, which a line may follow without any force
    double free_work = 0.;  ///< of free strains from the first to the last pose [J]
    double damping = 0.;    ///< lost to viscous forces, which are internal ones [J]
    Vector sections;        ///< states of sections with a law, at the end of what is integrated
    const char *failure = nullptr; ///< why a cell has no answer; null: each has
    double section_error =
        0.; ///< what the increment's length leaves in a section's stress, a share
    /// Of cells that turn, a column each, where a time step begins: what they need of it.
    Eigen::Matrix<double, 8, Eigen::Dynamic> at_start;
  };
  /// A motion from one pose to another.
  struct Step {
    const Pose &from, &half, &to;
    const Vector &change; ///< of all degrees of freedom, turns as Cayley vectors
    double duration = 0.; ///< [s]; 0: of a static increment, without viscous forces
    /// Of sections with a law: the end, and how long they creep on the way [s].
    PipeSections::Clock clock = {};
    /// Of the loads at the end, where those at hand are mean ones; null: they are the same.
    const std::vector<double> *factors_at_end = nullptr;
    /// Of a static increment, whose forces are those at its end alone: where it began. Sections go
    /// there from it.
    const Pose *began = nullptr;
    bool is_trial = false;          ///< whether sections answer elastically to the increment
    bool without_stiffness = false; ///< leave Balance::stiffness as it is
    /// Whether the balance is the answer at another pose of this very increment: sections look for
    /// theirs from there, and the start is the same.
    bool is_near_last = false;
  };
  /**
   * Forces at a pose, or those of a time step: the mean of the cells' forces at both its ends,
   * acting on the pose halfway, so that their work is the change of the stored energy. Their
   * resultant is zero. The stiffness is then twice the derivative by the step's change. Viscous
   * forces of a step are those of dashpots, of Stiffness damping by the rates of strains, so that
   * nothing rigid is damped, and of Modal damping.
   * @param factors of the loads, mean ones of a step
   */
  void evaluate(const Step &step, const std::vector<double> &factors, Balance &balance) const;
  void evaluate(const Pose &at, const std::vector<double> &factors, Balance &balance) const {
    evaluate({at, at, at, at.dofs}, factors, balance);
  }
  /// Motions of a cell's ends, in its axes at rest, that a small motion of all degrees of freedom
  /// from a pose makes.
  virtual Vector12 motions_of_cell(const unsigned int cell, const Pose &pose,
                                   const Vector &motion) const = 0;
  /// Free strains and what else the law of a cell's sections is given.
  PipeSections::Surroundings surroundings(const unsigned int cell,
                                          const std::vector<double> &factors) const;
  /// How well sections obey their laws in a state, at factors of the loads.
  PipeSections::Check check_sections(const Vector &states,
                                     const std::vector<double> &factors) const;
  /// Sections with a law of their own.
  const PipeSections &pipe_sections() const { return sections; }
  /// Elastic energy of pipes and springs [J].
  double stored_energy(const Pose &pose) const;

  /// Of the unknowns, in the stiffness's pattern, without what add_rotary() adds; without entries
  /// in statics.
  virtual const SparseMatrix &mass() const = 0;
  /**
   * Inertia that is not constant, over a step, with its Mass damping.
   * @param change Cayley vectors among all degrees of freedom
   * @param spin_before angular velocities among them [rad/s]
   * @param forces -= 2/h times the change of angular momentum and what damping takes of it, on the
   * unknowns
   * @param matrix += its derivative by the change; null: not asked for
   */
  virtual void add_rotary(const Pose &from, const Pose &to, const Vector &change,
                          const Vector &spin_before, const double step, Vector &forces,
                          SparseMatrix *matrix) const = 0;
  /// Angular velocities at a step's end, in place of the entries of @p velocity that are spins.
  virtual void set_spins(const Pose &from, const Pose &to, const Vector &change,
                         const Vector &spin_before, const double step, Vector &velocity) const = 0;
  /// How vertices turn at an instant within a step; vectors of all degrees of freedom.
  struct Turning {
    const Vector &spin, &acceleration;           ///< angular [rad/s], [rad/s2]
    const Vector &turned;                        ///< rotation vectors since the step's start
    double spin_per_turn, acceleration_per_turn; ///< derivatives by these [1/s], [1/s2]
    double damping;                              ///< Mass damping [1/s]
  };
  /**
   * Inertia that is not constant, at an instant: forces -= J A + w x J w + damping J w on the
   * unknowns, J that of the vertices as they have turned.
   * @param matrix += its derivative by spins of the pose; null: not asked for
   */
  virtual void add_rotary_at(const Pose &, const Turning &, Vector &, SparseMatrix *) const {}
  /// Add J, with 1 in directions that have none.
  virtual void add_rotary_mass(const Pose &, SparseMatrix &) const {}
  /// Put @p mean in place of @p rates of rotations in directions without inertia, of all degrees
  /// of freedom.
  virtual void keep_inert(const Pose &, const Vector &, Vector &) const {}
  /// Momenta that belong to velocities, of all degrees of freedom.
  virtual Vector momenta(const Pose &pose, const Vector &velocity) const = 0;
  /// Velocities of all degrees of freedom from those of the unknowns and the rates of the loads'
  /// factors, which impose motions; without rates those stand still.
  Vector velocities(const Vector &velocity, const std::vector<double> &rates) const;
  /// Kinetic energy of the same [J].
  virtual double kinetic_energy(const Pose &pose, const Vector &velocity,
                                const std::vector<double> &rates) const;
  /// Linear (3) and angular momentum about the origin (3).
  Motion momentum(const Pose &pose, const Vector &velocity) const;
  /// Forces on the unknowns per second derivative in time of the factor of a
  /// load that imposes motions: inertia -M_ub u_b.
  virtual Vector inertia(const unsigned int load) const;

  /// What results are made of: a cell with the forces on its ends.
  struct CellState {
    Vector12 ends;                  ///< forces on them, global axes
    Vector12 motions;               ///< of the linear element's ends, in the axes at rest
    std::optional<CellFrame> frame; ///< that it is linear in; none: where it is at rest
  };
  /// @param element that speaks of this cell
  virtual CellState state_of(const unsigned int cell, const PipeElement &element, const Pose &pose,
                             const std::vector<double> &factors) const = 0;
  /// Consistent mass of a cell, as inertia puts it on restraints.
  virtual Matrix12 mass_of(const unsigned int cell, PipeElement &element) const = 0;
  /// A load's force and moment on a vertex, turned with it if it follows.
  virtual Motion nodal_load(const unsigned int load, const unsigned int vertex,
                            const Pose &pose) const;
  /// Sum of loads on a pipe cell, in global axes.
  CellLoad load_on(const PipeCell &cell, const Profile &profile, const Vector3 &chord,
                   const std::vector<double> &factors) const;
  /// Of cells, whose length is that of their chords.
  struct Unbent {
    double length = 0.; ///< by which they are longer than the curves they stand for, in sum [m]
    double bow = 0.;    ///< by which a curve is off its chord in the middle, the largest [m]
  };
  virtual Unbent unbent(const Pose &) const { return {}; }

protected:
  /// A cell's share of a Balance.
  struct CellAnswer {
    std::vector<dealii::types::global_dof_index> dofs;
    Vector12 internal, loads, free; ///< the last: forces that free strains would need, held
    Matrix12 stiffness;
    double free_work = 0., damping = 0., section_error = 0.;
    const char *failure = nullptr;
    Vector *sections = nullptr; ///< states at the end, where there are any
    double *at_start = nullptr; ///< of Balance, in a time step
  };
  virtual void answer(const unsigned int cell, const Step &step, const std::vector<double> &factors,
                      CellAnswer &answer) const = 0;
  /// Viscous forces that tie cells together.
  virtual void add_modal_damping(const Step &, Balance &) const {}
  /// Elastic energy of a pipe cell [J].
  virtual double stored_in(const unsigned int cell, const Pose &pose) const = 0;

  double extension(const Spring &spring, const unsigned int c, const Vector &dofs) const;
  Eigen::Vector3d part(const Vector &dofs, const unsigned int vertex,
                       const unsigned int first) const;
  void add_part(const Eigen::Vector3d &value, const unsigned int vertex, const unsigned int first,
                Vector &dofs) const;
  /// Sections of a cell over a step, between motions of its ends in the axes at rest, or between
  /// the states of a step that has been taken. The answer gets what does not depend on axes.
  /// @param turn of the cell from rest
  void integrate_sections(const unsigned int cell, const Vector12 &before, const Vector12 &after,
                          const Step &step, const std::vector<double> &factors, CellAnswer &answer,
                          PipeSections::Answer &inelastic,
                          const Eigen::Matrix3d &turn = Eigen::Matrix3d::Identity()) const;

  const Scene &scene;
  const LineMesh &mesh;
  const Discretization &discretization;
  const ReducedSpace &space;
  const LinearPart &linear;
  const PipeSections sections;
  const Vector sections_at_rest;
  const unsigned int n_vertices;
  std::vector<double> point_mass; ///< of each vertex [kg]

private:
  /// An entry of a cell's stiffness, column by column, and what it adds to the line's.
  struct Entry {
    std::ptrdiff_t place; ///< among its values
    int local;
    double weight;
  };
  /// Kept for each cell when first needed: nonlinear lines are assembled again and again.
  mutable std::vector<std::vector<Entry>> places_in_stiffness;
  void add_stiffness(const unsigned int cell, const CellAnswer &answer, SparseMatrix &matrix) const;
  void add_springs(const Step &step, Balance &balance) const;
  /// Elastic and viscous force of a spring or dashpot in one direction.
  void add_spring(const Spring &spring, const unsigned int c, const Step &step,
                  Balance &balance) const;
  void add_nodal_loads(const Step &step, const std::vector<double> &factors,
                       Balance &balance) const;
};

/// The cells of a scene's Kinematics.
std::unique_ptr<const LineCells> make_line_cells(const Scene &scene, const LineMesh &mesh,
                                                 const Discretization &discretization,
                                                 const ReducedSpace &space,
                                                 const LinearPart &linear);

} // namespace frictionbeam
