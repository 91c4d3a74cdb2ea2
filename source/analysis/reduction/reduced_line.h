// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/reduction/line_parts.h"
#include "model/cell/linear_cells.h"

namespace frictionbeam {

/**
 * The line on few unknowns, as a Model of its own that every integrator takes: the kept unknowns of
 * LineParts, and for each part q_i = Psi q_b + X eta with the lowest fixed-interface modes and
 * static shapes as columns of X. Static shapes are what the modes leave out of K_ii^-1 f, f each
 * load, the forces of inertia M_ii Psi + M_ib of a border that is accelerated (R. R. Craig and C.
 * J. Hale, J. Guid. Control Dyn. 11 (1988) 562-567, have such Krylov vectors instead of modes), and
 * of the initial displacements and velocities. They and the constraint modes Psi make statics
 * exact, let a motion begin exactly as the line is, and take over what the modes left out do when
 * they follow slowly. Modes and static shapes are orthogonal in K and M. The unknowns eta come
 * first, then the kept ones.
 *
 * Its degrees of freedom are those of contacts, of monitored points and at restraints alone; states
 * of contacts are those of the line. doc/dynamics.md, "Reduction to contact nodes and modes", says
 * why.
 */
class ReducedLine {
public:
  /**
   * @param start where the motion begins
   * @param loads that act in it or before it
   */
  ReducedLine(const Model &line, const LineParts &parts, const LineParts::Choice &modes,
              const LineState &start, const std::vector<bool> &loads);

  const Model &model() const { return *reduced; }
  unsigned int n_static_shapes() const { return n_shapes; }
  /// Degrees of freedom of the reduced model that belong to monitored points, by point: -1 if held.
  const std::vector<std::array<int, 6>> &monitored() const { return monitored_dofs; }

  /// A state of the line on the reduced unknowns.
  LineState reduce(const LineState &state) const;
  /**
   * A state of the line from a reduced one: contacts, what monitored points do, and what the forces
   * of restraints and springs come from.
   * @param everything all unknowns; then dofs are left to the caller
   */
  void expand(const LineState &state, const bool everything, LineState &full) const;

private:
  struct Basis {
    Eigen::MatrixXd shapes; ///< inside the part: border's motions, then modes and static shapes
    Vector stiffness, mass; ///< of modes and static shapes
    unsigned int first = 0; ///< place of these among the reduced unknowns
  };
  struct Assembly;

  /// Modes and static shapes of part @p p, as columns.
  void make_basis(const unsigned int p, const unsigned int n_modes, const LineState &start,
                  const std::vector<bool> &loads);
  /// Which unknowns are kept, and where they stand.
  void make_places();
  /// Which degrees of freedom the reduced model has.
  void make_dofs();
  LinearPart::Matrices make_matrices() const;
  void add_loads(LinearPart::Matrices &matrices) const;
  Vector reduce_forces(const Vector &forces) const;
  /// What an unknown of the line depends on.
  std::vector<ReducedSpace::Term> terms(const int unknown) const;
  Vector all_unknowns(const Vector &reduced_unknowns) const;

  const Model &line;
  const LineParts &parts;
  std::vector<Basis> bases;
  unsigned int n_eta = 0, n = 0, n_shapes = 0;
  std::vector<int> dof_places, unknown_places; ///< of the line's; -1 of those that are gone
  std::vector<unsigned int> dofs;              ///< of the line, by place
  std::vector<std::array<int, 6>> monitored_dofs;
  std::vector<std::pair<int, std::vector<ReducedSpace::Term>>> monitored_unknowns;
  std::unique_ptr<const ReducedSpace> space;
  std::unique_ptr<const Contacts> contacts;
  std::unique_ptr<const LinearPart> linear;
  std::unique_ptr<const LinearCells> cells;
  std::unique_ptr<const Model> reduced;
};

} // namespace frictionbeam
