// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/fe_line.h>

namespace frictionbeam {

/**
 * Straight shear-flexible beam with two nodes and six degrees of freedom per node
 * (ux, uy, uz, rx, ry, rz in global axes, rotations in radians).
 *
 * Axial displacement and twist are linear; deflection and rotation of the section are the
 * interdependent cubic and quadratic functions that satisfy the homogeneous equations of the
 * Timoshenko beam, with Phi = 12 E I / (kappa G A l^2):
 *   w(x)   = sum of cubic functions, w' - theta constant along the cell,
 *   K      = exact for end loads, so one cell serves a straight run of any length.
 * Two Gauss points integrate the stiffness of generalized_strain() exactly, four the consistent
 * mass. Only sections with equal moments of inertia about both axes (pipes) are covered: the
 * functions need the tangent and Phi, no orientation.
 *
 * Phi of a cell comes from its material id, so one element serves every section of a line.
 *
 * Source: J. S. Przemieniecki, Theory of Matrix Structural Analysis, 1968, section 5.6 (stiffness
 * and functions); Y. Luo, Advances in Theoretical and Applied Mechanics 1 (2008) 23-47.
 */
class FE_TimoshenkoBeam final : public FE_Line {
public:
  /// @param shear_flexibility 12 E I / (kappa G A) [m^2] for each material id; ids beyond the end
  /// have none (Euler-Bernoulli).
  explicit FE_TimoshenkoBeam(const std::vector<double> &shear_flexibility = {});

  /// Tells elements of different shear flexibility apart.
  std::string get_name() const override;
  std::unique_ptr<dealii::FiniteElement<1, 3>> clone() const override;

private:
  void evaluate(const CellGeometry &cell, const double xi,
                std::vector<ShapeFunction> &shapes) const override;

  std::vector<double> shear_flexibility;
};

} // namespace frictionbeam
