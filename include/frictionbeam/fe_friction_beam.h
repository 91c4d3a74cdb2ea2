// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/fe_line.h>

namespace frictionbeam {

/**
 * The friction element of Millard, Prost and Ricard (SMiRT 7, 1983): two nodes, the first on the
 * pipe, the second on the ground; the element's axis is the normal of the sliding plane, l its
 * length [m]. Displacements vary linearly, so that
 *   eps = (u2 - u1)/l,  gamma_y = (v2 - v1)/l - psi_z,  gamma_z = (w2 - w1)/l + psi_y,
 *   chi = (psi_x2 - psi_x1)/l,
 * where the psi are present only as chosen:
 *  - Rotations::none: three degrees of freedom per vertex, psi = 0;
 *  - Rotations::averaged: psi interpolated between the ends; a force T puts T l/2 on either end;
 *  - Rotations::first_node: psi of the first vertex alone, contact at the pipe's outer surface when
 *    l is its radius; a force T puts T l on the pipe;
 *  - Rotations::second_node: the same for a cell that was turned, so that its second vertex is the
 *    pipe's (CellOrigin::reversed);
 *  - torsion: chi is resisted (psi_x enters).
 * With rotations or torsion there are six degrees of freedom per vertex, and the ground's rotations
 * are to be fixed by the caller (VertexDofs::constrain()). One Gauss point is exact.
 *
 * It is meant for dealii::hp::FECollection beside FE_TimoshenkoBeam: common degrees of freedom at a
 * shared vertex are identified.
 */
class FE_FrictionBeam final : public FE_Line {
public:
  enum class Rotations { none, averaged, first_node, second_node };

  explicit FE_FrictionBeam(const Rotations rotations = Rotations::none, const bool torsion = false);

  std::string get_name() const override;
  std::unique_ptr<dealii::FiniteElement<1, 3>> clone() const override;

private:
  void evaluate(const CellGeometry &cell, const double xi,
                std::vector<ShapeFunction> &shapes) const override;

  Rotations rotations;
  bool torsion;
};

} // namespace frictionbeam
