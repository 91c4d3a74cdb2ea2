// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/fe_line.h>
#include <frictionbeam/generalized_strain.h>

#include <deal.II/lac/full_matrix.h>

#include <map>

namespace frictionbeam {

/// Section of an arc and where its centre lies.
struct ArcData {
  dealii::Point<3> centre;
  double EA = 0., GA = 0.; ///< [N]; GA = 0: no shear flexibility
  double GJ = 0., EI = 0.; ///< [N m2]; EI already divided by the bend's flexibility factor
};

/**
 * A circular arc of less than 180 degrees as a beam of constant section, with its exact
 * flexibility: stretching, shear, torsion and bending in both directions.
 *
 * Forces and motions of a section are carried to the arc's centre as if by a rigid arm. There, in
 * axes that turn with the section (tangent t, inward normal n, axis b), the flexibility of a slice
 * is one constant matrix A, and the flexibility up to the angle psi is
 *   F(psi) = R integral_0^psi Q(phi) A Q(phi)^T dphi,  Q = rotation about b,
 * in closed form. With T_0, T_1 the arms of the two ends and S = F(alpha)^-1, the 12 x 12 stiffness
 * is G^T S G, G = (-T_0, T_1), and the motion at psi under given end motions is
 * T_0 d_0 + F(psi) S (T_1 d_1 - T_0 d_0).
 *
 * The classical statement with the flexibility of one end is in J. S. Przemieniecki, Theory of
 * Matrix Structural Analysis, 1968, and, for pipe bends, in ASME B31.3 programs since the 1960s.
 */
class ArcBeam {
public:
  using Vector3 = dealii::Tensor<1, 3>;
  using Matrix = dealii::FullMatrix<double>;

  /// @param begin, end points of one circle about data.centre, less than 180 degrees apart.
  ArcBeam(const dealii::Point<3> &begin, const dealii::Point<3> &end, const ArcData &data);

  double angle() const { return alpha; }
  double radius() const { return R; }
  double length() const { return R * alpha; }

  Vector3 tangent(const double psi) const;  ///< unit, psi [rad] from the beginning
  Vector3 inward(const double psi) const;   ///< unit, towards the centre
  Vector3 axis() const { return frame[2]; } ///< unit, tangent x inward
  dealii::Point<3> point(const double psi) const;

  /// 12 x 12, global axes: displacements and rotations of the beginning, then of the end.
  Matrix stiffness() const;

  /// Displacement and rotation at @p psi, and their derivatives along the arc, for a unit motion of
  /// each of the twelve degrees of freedom (columns), global axes: two 6 x 12 matrices.
  void shapes(const double psi, Matrix &value, Matrix &derivative) const;

  /// Motion at @p psi of the arc clamped at both ends under a force per length [N/m] in global
  /// axes, a free axial strain and a free change of curvature about axis() [1/m].
  dealii::Tensor<1, 6> clamped_motion(const double psi, const Vector3 &line_force,
                                      const double axial_strain, const double curvature) const;

private:
  Matrix flexibility(const double psi) const; ///< 6 x 6 at the centre, in frame; rotations times R
  Matrix arm(const double psi) const;         ///< motions at psi, global axes, to the centre
  /// Motion at the centre back to one where the inward normal is @p n, global axes.
  dealii::Tensor<1, 6> at_section(const dealii::Tensor<1, 6> &motion, const Vector3 &n) const;

  dealii::Point<3> centre;
  double R, alpha;
  std::array<Vector3, 3> frame;           ///< t, n, b of the beginning
  std::array<double, 6> compliance;       ///< of a section, rotations times R
  std::array<std::array<double, 6>, 6> A; ///< of a slice, at the centre
  Matrix S;                               ///< inverse of flexibility(alpha)
  Matrix begin_arm, end_arm;              ///< arm(0), arm(alpha)
};

/**
 * ArcBeam as a finite element on the straight cell between its ends: an exact bend in one cell,
 * with six degrees of freedom per node (ux, uy, uz, rx, ry, rz in global axes).
 *
 * A cell of deal.II in 1D is straight. The arc's centre and section come from the cell's material
 * id, one for each arc; both vertices must lie on its circle, and an arc is not refined. The
 * quadrature point xi of the cell stands for the point of the arc at the angle alpha xi, so that an
 * integral along the arc is the sum over JxW times arc length over chord. Values are exact; for
 * strains use arc_strain(), not generalized_strain(), which knows straight cells only. The
 * stiffness that they give by quadrature is that of ArcBeam::stiffness().
 */
class FE_ArcBeam final : public FE_Line {
public:
  /// @param arcs by material id.
  explicit FE_ArcBeam(const std::map<unsigned int, ArcData> &arcs);

  std::string get_name() const override;
  std::unique_ptr<dealii::FiniteElement<1, 3>> clone() const override;

  /// The arc of a cell between two vertices. @throws dealii::ExcMessage if the material id has none
  ArcBeam arc(const dealii::Point<3> &begin, const dealii::Point<3> &end,
              const dealii::types::material_id material_id) const;

private:
  void evaluate(const CellGeometry &cell, const double xi,
                std::vector<ShapeFunction> &shapes) const override;
  void evaluate_all(const CellGeometry &cell, const std::vector<dealii::Point<1>> &points,
                    const TakeShapes &take) const override;

  std::map<unsigned int, ArcData> arcs;
};

/// What the strains of all functions at a point of an arc are made with.
struct ArcPoint {
  LocalAxes axes;             ///< of the arc's tangent
  dealii::Tensor<1, 3> along; ///< gradients on the cell times this: derivatives along the arc

  /// @param xi part of the way along the arc
  ArcPoint(const ArcBeam &arc, const double xi);
};

/**
 * Generalized strain of shape function @p i of FE_ArcBeam at quadrature point @p q, in the local
 * axes of the arc's tangent there (see LocalAxes). Needs update_values and update_gradients.
 * @param point of the arc of the cell that @p fe_values is on, where the quadrature point stands
 * @param first_component as of generalized_strain()
 */
GeneralizedStrain arc_strain(const dealii::FEValuesBase<1, 3> &fe_values, const ArcPoint &point,
                             const unsigned int i, const unsigned int q,
                             const unsigned int first_component = 0);

} // namespace frictionbeam
