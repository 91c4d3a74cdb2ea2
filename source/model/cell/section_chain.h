// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace frictionbeam {

/**
 * Sections along a pipe cell whose stresses are in equilibrium with the forces at its ends and the
 * load between, whatever they yield:
 *   sigma_q = b_q beta + sigma_load,q,   sum_q w_q b_q^T (e_q + e_free,q) = G u,
 * beta the force and moment on the second end, u the motions of both, G u those of the second end
 * seen from the first (E. Spacone, F. C. Filippou, F. F. Taucer, Earthquake Eng. Struct. Dyn. 25
 * (1996) 711-725; A. Neuenhofer, F. C. Filippou, J. Struct. Eng. 123 (1997) 958-966,
 * doi:10.1061/(ASCE)0733-9445(1997)123:7(958)). Moments between the ends are right for any
 * yielding, and so are limit loads whose hinges are at sections. The points are those of Gauss and
 * Lobatto: the first and the last stand at the ends.
 */
class SectionChain {
public:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector12 = Eigen::Matrix<double, 12, 1>;
  using Matrix12 = Eigen::Matrix<double, 12, 12>;

  struct Point {
    Matrix6 b;                               ///< stress by force and moment on the second end
    Eigen::Matrix<double, 6, 3> load_stress; ///< by a unit load per length, global axes
    double length;                           ///< w [m]
    Matrix6 elastic; ///< stiffness; a component without any, of all points, is rigid
  };

  SectionChain(std::vector<Point> points, const Eigen::Matrix<double, 6, 12> &G);

  /// Stress and tangent of a section by its strain; false if there is none.
  using Law = std::function<bool(const unsigned int point, const Vector6 &strain, Vector6 &stress,
                                 Matrix6 &tangent)>;
  struct Solution {
    std::vector<Vector6> strain; ///< in: to begin with
    Vector12 forces;             ///< G^T beta, on the ends
    Matrix12 stiffness;          ///< derivative by the motions
    bool solved = false;
    /// Whether the strains, which each section has answered, are those of the motions at least.
    bool compatible = false;
  };
  /**
   * @param free strains of each point @param load per length in global axes [N/m]
   */
  void solve(const Law &law, const Vector12 &motions, const std::vector<Vector6> &free,
             const Eigen::Vector3d &load, Solution &solution) const;

  /// If sections answer elastically, from rest.
  void solve_elastically(const Vector12 &motions, const std::vector<Vector6> &free,
                         const Eigen::Vector3d &load, Solution &solution) const;
  /// What G^T beta changes by if sections answer elastically to changes of motions, free strains
  /// and load.
  Vector12 elastic_change(const Vector12 &motions, const std::vector<Vector6> &free,
                          const Eigen::Vector3d &load) const;
  const Matrix12 &elastic_stiffness() const { return K; }

  unsigned int size() const { return points.size(); }
  const Point &operator[](const unsigned int i) const { return points[i]; }

private:
  struct Linear; // the linearized equations
  /// A point in their units.
  struct Scaled {
    Matrix6 b;
    Matrix6 soft;        ///< compliance of an elastic section; 0: rigid
    Matrix6 flexibility; ///< of an elastic section, for beta
  };
  /// A stiffness in their units, with as much more as lets sections share that all flow; 1 on the
  /// diagonal of rigid components.
  Matrix6 in_units(const Matrix6 &stiffness) const;

  std::vector<Point> points;
  std::vector<Scaled> scaled;
  Eigen::Matrix<double, 6, 12> G;
  Vector6 scale;                   ///< square roots of the stiffnesses; 0: rigid
  Vector6 beta_scale;              ///< of unit elastic motion
  std::vector<Matrix6> compliance; ///< of the sections, elastic
  Matrix6 of_motion;               ///< beta by the motion of the second end from the first, elastic
  Eigen::Matrix<double, 6, 3> by_load; ///< that motion by a unit load, at no beta
  Matrix12 K;
};

} // namespace frictionbeam
