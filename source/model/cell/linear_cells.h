// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/line_cells.h"

namespace frictionbeam {

/// Cells in small displacements, straight or arcs, with joints: PipeElement where it is at rest. Of
/// a line on other unknowns than its own (ReducedLine) they answer for the whole alone: mass(),
/// inertia(), kinetic_energy().
class LinearCells final : public LineCells {
public:
  using LineCells::LineCells;

  bool is_linear() const override { return !sections.any(); }
  bool turns_far() const override { return false; }

  Pose at_rest() const override;
  Pose moved(const Pose &from, const Vector &change) const override;
  Pose stepped(const Pose &from, const Vector &change) const override {
    return moved(from, change);
  }
  Vector change(const Pose &from, const Pose &to) const override { return to.dofs - from.dofs; }
  Pose halfway(const Pose &from, const Pose &to) const override;

  /// Consistent, with rotary inertia.
  const SparseMatrix &mass() const override { return linear.mass(); }
  void add_rotary(const Pose &, const Pose &, const Vector &, const Vector &, const double,
                  Vector &, SparseMatrix *) const override {}
  void set_spins(const Pose &, const Pose &, const Vector &, const Vector &, const double,
                 Vector &) const override {}
  Vector momenta(const Pose &pose, const Vector &velocity) const override;
  double kinetic_energy(const Pose &, const Vector &velocity,
                        const std::vector<double> &rates) const override {
    return velocity.dot(linear.mass() * velocity) / 2. + linear.kinetic_by_imposed(rates, velocity);
  }
  Vector inertia(const unsigned int load) const override { return linear.inertia(load); }

  CellState state_of(const unsigned int cell, const PipeElement &element, const Pose &pose,
                     const std::vector<double> &factors) const override;
  Vector12 motions_of_cell(const unsigned int cell, const Pose &,
                           const Vector &motion) const override {
    return ends_of(cell, motion);
  }
  Matrix12 mass_of(const unsigned int cell, PipeElement &element) const override;

private:
  void answer(const unsigned int cell, const Step &step, const std::vector<double> &factors,
              CellAnswer &answer) const override;
  double stored_in(const unsigned int cell, const Pose &pose) const override;
  /// What a cell's element says of it.
  struct Element {
    std::vector<dealii::types::global_dof_index> dofs;
    const Profile *profile;
    Vector3 chord;
    Matrix12 stiffness, mass;
    Eigen::Matrix<double, 12, 3> line; ///< unit forces per length
    Vector12 axial, curvature, thrust; ///< unit free strains
  };
  /// Of all cells, made when first asked for: a line that yields asks again and again.
  const std::vector<Element> &elements() const;
  mutable std::vector<Element> kept_elements;
  Vector12 ends_in_solid(const SolidPart &part, const PipeCell &of, const Pose &pose,
                         const std::vector<double> &factors) const;
  /// Motions of a cell's ends, or whatever else belongs to its degrees of freedom.
  Vector12 ends_of(const unsigned int cell, const Vector &dofs) const;
};

} // namespace frictionbeam
