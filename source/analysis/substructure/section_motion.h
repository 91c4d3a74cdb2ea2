// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"
#include "model/body/body.h"

#include <Eigen/Core>

namespace frictionbeam {

/**
 * The motion of a section of a wall as a beam has it, and forces on it as a beam puts them there:
 * the tractions of Saint-Venant's solutions for a thin wall, n/A + (m x arm . t)/I along the axis
 * t, 2 v . e/A + m_t r/(2 I) along the circumference e (Timoshenko and Goodier, Theory of
 * Elasticity, ch. 12), and as the motion the means of the displacement that these do work on.
 * Neither says anything of how the section warps, widens and ovalises: a distributing coupling.
 *
 * Column c (three forces or translations, three moments or rotations about the middle, global axes)
 * is W_c: forces W f have the resultant f, and W^T u is the motion of a rigid u, both to rounding.
 */
class SectionMotion {
public:
  SectionMotion(const PipeWall &wall, const ContinuumBody<3> &body, const unsigned int ring);

  using Vector6 = Eigen::Matrix<double, 6, 1>;
  void add_forces(const Vector6 &forces, ContinuumVector &to) const;
  Vector6 motion(const ContinuumVector &displacement) const;
  /// Forces in balance: a unit force as a pressure on a patch of the wall, inwards, less the same
  /// on this section and less what of it acts along the radius, spread evenly round the pipe. They
  /// do work on how the patch moves into the wall beside the section and beside what the wall
  /// widens by, as it does by heat and pressure.
  ContinuumVector pressure(const PipeWall &wall, const ContinuumBody<3> &body,
                           const unsigned int patch) const;

private:
  Point3 centre;
  Vector3 tangent;
  std::array<ContinuumVector, 6> columns;
};

/// Displacement of all nodes of a body by a small rigid motion about a point.
ContinuumVector rigid_displacement(const ContinuumBody<3> &body, const Point3 &about,
                                   const SectionMotion::Vector6 &motion);

} // namespace frictionbeam
