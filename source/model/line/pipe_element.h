// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/discretization.h"
#include <frictionbeam/generalized_strain.h>

#include <Eigen/Core>

namespace frictionbeam {

/// Local axes of a straight cell in the direction of deal.II's, in columns.
Eigen::Matrix3d local_axes(const Discretization::Cell &cell);

/**
 * Matrices and vectors of one pipe cell, integrated through FEValues. Degrees of freedom stand in
 * the order of deal.II's cell: 6 at vertex 0, 6 at vertex 1, global axes. Straight cells and arcs;
 * straight ones without joints take the matrices of the first one like them, turned.
 *
 * Joints of flexibility F at the ends stand in series with the cell: if the nodes move by u, its
 * ends move by (1 + F K)^-1 u, so that K becomes K (1 + F K)^-1 and loads are carried by the
 * transposed (doc/theory.md, "Joints").
 */
class PipeElement {
public:
  using Matrix12 = CellMatrices::Matrix12;
  using Vector12 = CellMatrices::Vector12;

  explicit PipeElement(const Discretization &discretization);
  /// Integrated at other points, each cell by itself, for what is asked of points.
  PipeElement(const Discretization &discretization, const dealii::Quadrature<1> &straight,
              const dealii::Quadrature<1> &curved);

  /// Take a cell; the functions below then speak of it.
  void reinit(const Discretization::Cell &cell);
  /// The same for what is asked of points alone, of an element with points of its own.
  void reinit_points(const Discretization::Cell &cell);

  /// Integral of B^T D B, exact with two Gauss points (twelve for an arc).
  const Matrix12 &stiffness() const;
  /// Forces of a unit force per length in each global direction (columns) [N per N/m].
  Eigen::Matrix<double, 12, 3> unit_line_loads() const;
  /// Nodal forces that a unit axial strain, if it were free, would need.
  Vector12 unit_axial_strain() const;
  /// Nodal forces that a unit change of curvature about an arc's axis, if it were free, would need.
  Vector12 unit_curvature() const;
  /// Nodal forces that a unit pressure in the cell's joints, if they were free, would need.
  Vector12 unit_thrust() const;
  /// Motions of the cell's ends beyond its joints, which yield to the forces on them and to
  /// pressure, if the nodes have the motions @p nodes and put the forces @p ends on the cell.
  Vector12 inside(const Vector12 &nodes, const Vector12 &ends, const double pressure) const {
    return jointed ? Vector12(nodes - joint_flexibility * ends + pressure * pushed) : nodes;
  }
  /// Consistent mass with rotary inertia, exact with four Gauss points (twelve for an arc).
  Matrix12 mass(const Discretization::Cell &cell);

  /// Where stiffness() is integrated, of an element with points of its own.
  unsigned int n_points() const { return strains.size(); }
  /// Generalized strains there by the motions of the cell's ends, joints left out.
  Eigen::Matrix<double, 6, 12> strain_matrix(const unsigned int point) const;
  /// Length that the point stands for [m].
  double length_at(const unsigned int point) const;
  /// Strains of a unit change of curvature about a bend's axis; zero in a straight pipe.
  Eigen::Matrix<double, 6, 1> curvature_strain(const unsigned int point) const;
  /// Part of the way along the cell.
  double place_of(const unsigned int point) const {
    return values->get_quadrature().point(point)[0];
  }
  bool has_joints() const { return jointed; }

  const Profile &profile() const { return *section; }
  /// The cell as an exact arc; empty for a straight one.
  const std::optional<ArcBeam> &arc() const { return bend; }

private:
  PipeElement(const Discretization &discretization, const dealii::Quadrature<1> &straight,
              const dealii::Quadrature<1> &curved, const bool takes_like);
  /// Section and arc.
  void begin(const Discretization::Cell &cell);
  /// Shape functions and strains at the points.
  void evaluate(const Discretization::Cell &cell);
  void take_like(const Discretization::Cell &cell);
  /// Whose matrices a cell takes: an arc's are its own.
  Discretization::Cell like_cell(const Discretization::Cell &cell) const;
  CellMatrices integrate() const; ///< but the mass, global axes
  Matrix12 integrate_mass(const Discretization::Cell &cell);
  void add_joints(const Discretization::Cell &cell, const CellJoints &joints);
  /// Forces of a unit free curvature of a straight piece of a bend, one couple at either end.
  void bend_piece();

  const Discretization &discretization;
  dealii::FEValues<1, 3> straight_values, straight_mass_values;
  std::unique_ptr<dealii::FEValues<1, 3>> arc_values; ///< if the line has arcs
  dealii::FEValues<1, 3> *values = nullptr;           ///< of the cell evaluated last

  const bool takes_like;
  CellMatrices *like = nullptr; ///< those that the cell takes, local axes
  CellMatrices not_kept;        ///< the same where no more are kept
  Eigen::Matrix3d cell_axes;    ///< of the cell, in columns, by which they are turned

  const Profile *section = nullptr;
  CellMatrices plain; ///< of the cell, global axes
  bool jointed = false;
  Matrix12 joint_flexibility; ///< F
  Matrix12 beyond;            ///< (1 + F K)^-1
  Matrix12 jointed_stiffness; ///< K (1 + F K)^-1
  Vector12 pushed;            ///< free motion of the cell's ends per pressure
  std::optional<ArcBeam> bend;
  Vector3 chord, bend_axis; ///< of a straight piece of a bend, in the cell's direction; or 0
  double stretch = 1.;      ///< length over chord
  std::vector<std::array<GeneralizedStrain, 12>> strains; ///< by quadrature point, function
};

} // namespace frictionbeam
