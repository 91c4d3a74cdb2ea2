// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/rotation.h"

#include <Eigen/Core>

namespace frictionbeam {

/**
 * A two-node beam cell, straight or an arc, that moves and turns by any amount, while its strains
 * stay small: a frame E goes along with its ends, and in that frame the cell is the linear element.
 * E has its first axis along the chord, about which the two ends are twisted by opposite angles:
 * those by which the shortest turn of the axis leaves them short of where they are, whatever the
 * other two axes at rest (q_x, q_w of E^T R E_0: 2 atan(q_x/q_w)). What the ends do relative to E
 * are seven deformations d = (l - l0, rotation vectors of E^T R_1 E_0 and of E^T R_2 E_0), with
 * forces K_7 d less those of free strains. By virtual work the forces on the ends are B^T s, B the
 * derivative of d by translations and spins of the ends (J.-M. Battini, C. Pacoste, CMAME 191
 * (2002) 1755-1789, doi:10.1016/S0045-7825(01)00352-8; C. Nour-Omid, C. C. Rankin, CMAME 93 (1991)
 * 353-384, doi:10.1016/0045-7825(91)90248-5). See doc/theory.md, "Large displacements".
 *
 * Vectors of 12 are translations and spins, or forces and moments, of the first and the second end,
 * in global axes.
 */
class CorotationalBeam {
public:
  using Vector7 = Eigen::Matrix<double, 7, 1>;
  using Vector12 = Eigen::Matrix<double, 12, 1>;
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  using Matrix7_12 = Eigen::Matrix<double, 7, 12>;
  /// By the translation of the second end relative to the first, and the spins of both.
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  using Matrix7_9 = Eigen::Matrix<double, 7, 9>;

  /// What the ends have done: translations relative to each other and rotations.
  struct Ends {
    Eigen::Vector3d relative; ///< translation of the second less that of the first [m]
    Eigen::Quaterniond turn[2];
  };
  /// The cell in its frame.
  struct Deformed {
    Eigen::Matrix3d axes;             ///< E, in columns
    Eigen::Vector3d chord;            ///< [m]
    double length = 0.;               ///< of the chord [m]
    Vector7 d;                        ///< [m, rad]
    Eigen::Vector3d twist_by_spin[2]; ///< in E: of the ends
  };

  /**
   * @param chord from the first to the second end at rest [m]
   * @param axes of the frame at rest, in columns, the first one along the chord
   * @param stiffness of the linear element, in global axes
   */
  CorotationalBeam(const Eigen::Vector3d &chord, const Eigen::Matrix3d &axes,
                   const Matrix12 &stiffness);

  Deformed deform(const Ends &ends) const;

  const Eigen::Matrix<double, 7, 7> &stiffness() const { return K; } ///< s = K d
  double length_at_rest() const { return chord.norm(); }
  const Eigen::Matrix3d &axes_at_rest() const { return rest; }
  /// Forces on the deformations that forces on the ends of the linear element are.
  Vector7 on_deformations(const Vector12 &forces) const { return motions.transpose() * forces; }
  /// The same of a stiffness of the ends.
  Eigen::Matrix<double, 7, 7> stiffness_on_deformations(const Matrix12 &stiffness) const {
    return motions.transpose() * stiffness * motions;
  }
  /// Motions of the linear element's ends that are these deformations, in the axes at rest.
  Vector12 motions_of(const Vector7 &d) const { return motions * d; }

  /**
   * B = derivative of d by translations and spins of the ends.
   * @param length by which the axial row is scaled: chord/length; the chord's own for the
   *   derivative, the mean of those before and after for the difference over a time step
   */
  Matrix7_12 derivative(const Deformed &at, const double length) const;
  Matrix7_9 derivative_by_relative(const Deformed &at, const double length) const;
  /// B^T s, without making B.
  Vector12 on_ends(const Deformed &at, const double length, const Vector7 &s) const;
  /// B motion, likewise.
  Vector7 of_motion(const Deformed &at, const double length, const Vector12 &motion) const;
  /// Change of B^T s with translations and spins at constant s, without the small terms of a frame
  /// that twists against its ends.
  Matrix9 geometric_stiffness(const Deformed &at, const Vector7 &s) const;
  /// A stiffness of the ends.
  static Matrix12 of_ends(const Matrix9 &by_relative);

private:
  using Matrix3_9 = Eigen::Matrix<double, 3, 9>;
  Matrix3_9 frame_spin(const Deformed &at) const; ///< G^T, all in E

  const Eigen::Vector3d chord;
  const Eigen::Matrix3d rest;
  const Eigen::Quaterniond rest_turn;
  Eigen::Matrix<double, 12, 7> motions;
  Eigen::Matrix<double, 7, 7> K;
};

} // namespace frictionbeam
