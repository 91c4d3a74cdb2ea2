// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_arc_beam.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace frictionbeam {

using namespace dealii;

namespace {

Tensor<1, 3> rotation(const Tensor<1, 6> &motion) {
  return Tensor<1, 3>({motion[3], motion[4], motion[5]});
}

Tensor<1, 6> join(const Tensor<1, 3> &a, const Tensor<1, 3> &b) {
  return Tensor<1, 6>({a[0], a[1], a[2], b[0], b[1], b[2]});
}

Tensor<1, 6> times(const FullMatrix<double> &matrix, const Tensor<1, 6> &x) {
  Tensor<1, 6> result;
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      result[i] += matrix(i, j) * x[j];
  return result;
}

} // namespace

ArcBeam::ArcBeam(const Point<3> &begin, const Point<3> &end, const ArcData &data)
    : centre(data.centre), R(data.centre.distance(begin)), A{}, S(6, 6) {
  const Tensor<1, 3> to_begin = begin - centre, to_end = end - centre;
  AssertThrow(std::abs(to_end.norm() - R) <= 1e-6 * R,
              ExcMessage("The two ends of an arc do not lie on one circle about its centre."));
  const Tensor<1, 3> normal = cross_product_3d(to_begin, to_end);
  alpha = std::atan2(normal.norm(), to_begin * to_end);
  AssertThrow(alpha > 1e-6 && alpha < numbers::PI - 1e-6,
              ExcMessage("An arc is longer than 0 and shorter than 180 degrees."));
  frame[2] = normal / normal.norm();
  frame[1] = -1. / R * to_begin;
  frame[0] = cross_product_3d(frame[1], frame[2]);

  compliance = {{1. / data.EA, 0., 0., R * R / data.GJ, R * R / data.EI, R * R / data.EI}};
  if (data.GA > 0.)
    compliance[1] = compliance[2] = 1. / data.GA;
  // Section forces (F, M/R) of a wrench (P, Q/R) at the centre, both in t, n, b: F = P,
  // M_t = Q_t + R P_b, M_n = Q_n, M_b = Q_b - R P_t.
  double H[6][6] = {};
  for (unsigned int i = 0; i < 6; ++i)
    H[i][i] = 1.;
  H[3][2] = 1.;
  H[5][0] = -1.;
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      for (unsigned int k = 0; k < 6; ++k)
        A[i][j] += H[k][i] * compliance[k] * H[k][j];
  // In units of the radius and of the axial stiffness, so that pivots compare like with like.
  FullMatrix<double> F = flexibility(alpha);
  const double scale = F.frobenius_norm();
  F *= 1. / scale;
  S.invert(F);
  S *= 1. / scale;
  S.symmetrize();
  begin_arm = arm(0.);
  end_arm = arm(alpha);
}

Tensor<1, 3> ArcBeam::tangent(const double psi) const {
  return std::cos(psi) * frame[0] + std::sin(psi) * frame[1];
}

Tensor<1, 3> ArcBeam::inward(const double psi) const {
  return std::cos(psi) * frame[1] - std::sin(psi) * frame[0];
}

Point<3> ArcBeam::point(const double psi) const { return centre - R * inward(psi); }

ArcBeam::Matrix ArcBeam::flexibility(const double psi) const {
  const double c = std::sin(psi), s = 1. - std::cos(psi), sc = std::sin(psi) * std::sin(psi) / 2.,
               cc = psi / 2. + std::sin(2. * psi) / 4., ss = psi / 2. - std::sin(2. * psi) / 4.;
  Matrix F(6, 6);
  for (unsigned int row = 0; row < 6; row += 3)
    for (unsigned int column = 0; column < 6; column += 3) {
      const auto B = [&](const unsigned int i, const unsigned int j) {
        return A[row + i][column + j];
      };
      const auto f = [&](const unsigned int i, const unsigned int j) -> double & {
        return F(row + i, column + j);
      };
      f(0, 0) = cc * B(0, 0) - sc * (B(0, 1) + B(1, 0)) + ss * B(1, 1);
      f(0, 1) = cc * B(0, 1) + sc * (B(0, 0) - B(1, 1)) - ss * B(1, 0);
      f(1, 0) = cc * B(1, 0) + sc * (B(0, 0) - B(1, 1)) - ss * B(0, 1);
      f(1, 1) = ss * B(0, 0) + sc * (B(0, 1) + B(1, 0)) + cc * B(1, 1);
      f(0, 2) = c * B(0, 2) - s * B(1, 2);
      f(1, 2) = s * B(0, 2) + c * B(1, 2);
      f(2, 0) = c * B(2, 0) - s * B(2, 1);
      f(2, 1) = s * B(2, 0) + c * B(2, 1);
      f(2, 2) = psi * B(2, 2);
    }
  F *= R;
  return F;
}

ArcBeam::Matrix ArcBeam::arm(const double psi) const {
  // At the centre: u + theta x (c - p) = u + R theta x n, and R theta; in the frame's components.
  Matrix T(6, 6);
  const Tensor<1, 3> n = inward(psi);
  for (unsigned int d = 0; d < 3; ++d) {
    Tensor<1, 3> unit;
    unit[d] = 1.;
    const Tensor<1, 3> moved = R * cross_product_3d(unit, n);
    for (unsigned int i = 0; i < 3; ++i) {
      T(i, d) = frame[i][d];
      T(i, 3 + d) = frame[i] * moved;
      T(3 + i, 3 + d) = R * frame[i][d];
    }
  }
  return T;
}

Tensor<1, 6> ArcBeam::at_section(const Tensor<1, 6> &motion, const Vector3 &n) const {
  Tensor<1, 3> moved, turned;
  for (unsigned int i = 0; i < 3; ++i) {
    moved += motion[i] * frame[i];
    turned += motion[3 + i] * frame[i];
  }
  return join(moved - cross_product_3d(turned, n), turned / R);
}

ArcBeam::Matrix ArcBeam::stiffness() const {
  Matrix G(6, 12), SG(6, 12), K(12, 12);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j) {
      G(i, j) = -begin_arm(i, j);
      G(i, 6 + j) = end_arm(i, j);
    }
  S.mmult(SG, G);
  G.Tmmult(K, SG);
  return K;
}

void ArcBeam::shapes(const double psi, Matrix &value, Matrix &derivative) const {
  value.reinit(6, 12);
  derivative.reinit(6, 12);
  const Matrix F = flexibility(psi);
  const std::array<Tensor<1, 3>, 3> axes = {{tangent(psi), inward(psi), axis()}};
  for (unsigned int j = 0; j < 12; ++j) {
    Tensor<1, 6> at_begin, difference;
    for (unsigned int i = 0; i < 6; ++i) {
      at_begin[i] = j < 6 ? begin_arm(i, j) : 0.;
      difference[i] = j < 6 ? -begin_arm(i, j) : end_arm(i, j - 6);
    }
    const Tensor<1, 6> wrench = times(S, difference);
    const Tensor<1, 6> motion = at_section(at_begin + times(F, wrench), axes[1]);
    // Section forces in t, n, b and what they strain.
    Tensor<1, 3> P, Q;
    for (unsigned int i = 0; i < 3; ++i) {
      P += wrench[i] * frame[i];
      Q += wrench[3 + i] * frame[i];
    }
    Q += cross_product_3d(axes[1], P); // in units of R
    Tensor<1, 3> stretch, bend;
    for (unsigned int k = 0; k < 3; ++k) {
      stretch += compliance[k] * (P * axes[k]) * axes[k];
      bend += compliance[3 + k] / R * (Q * axes[k]) * axes[k];
    }
    const Tensor<1, 6> rate = join(cross_product_3d(rotation(motion), axes[0]) + stretch, bend);
    for (unsigned int i = 0; i < 6; ++i) {
      value(i, j) = motion[i];
      derivative(i, j) = rate[i];
    }
  }
}

Tensor<1, 6> ArcBeam::clamped_motion(const double psi, const Vector3 &line_force,
                                     const double axial_strain, const double curvature) const {
  // Motion at the centre of the arc clamped at its beginning, with no wrench at psi = 0, up to an
  // angle: what the loads and free strains give by themselves.
  static const QGauss<1> quadrature(12); // finding its points takes long
  const auto from_loads = [&](const double angle) {
    Tensor<1, 6> motion;
    for (unsigned int q = 0; q < quadrature.size(); ++q) {
      const double phi = angle * quadrature.point(q)[0];
      const std::array<Tensor<1, 3>, 3> axes = {{tangent(phi), inward(phi), axis()}};
      // Wrench about the centre of the loads before phi, taken off: integral of the arm p - c.
      const Vector3 arms = -R * (std::sin(phi) * frame[1] - (1. - std::cos(phi)) * frame[0]);
      const Vector3 force = -R * phi * line_force;
      Vector3 moment = -cross_product_3d(arms, line_force); // in units of R
      moment += cross_product_3d(axes[1], force);
      Vector3 stretch = axial_strain * axes[0], bend = R * curvature * axes[2];
      for (unsigned int k = 0; k < 3; ++k) {
        stretch += compliance[k] * (force * axes[k]) * axes[k];
        bend += compliance[3 + k] * (moment * axes[k]) * axes[k];
      }
      const Vector3 moved = stretch + cross_product_3d(bend, axes[1]);
      const double weight = R * angle * quadrature.weight(q);
      for (unsigned int i = 0; i < 3; ++i) {
        motion[i] += weight * (frame[i] * moved);
        motion[3 + i] += weight * (frame[i] * bend);
      }
    }
    return motion;
  };
  const Tensor<1, 6> wrench = times(S, from_loads(alpha));
  return at_section(from_loads(psi) - times(flexibility(psi), wrench), inward(psi));
}

FE_ArcBeam::FE_ArcBeam(const std::map<unsigned int, ArcData> &arcs) : FE_Line(6), arcs(arcs) {}

std::string FE_ArcBeam::get_name() const {
  std::ostringstream name;
  name.precision(std::numeric_limits<double>::max_digits10);
  name << "FE_ArcBeam<1,3>(1";
  for (const auto &[material_id, arc] : arcs)
    name << "; material " << material_id << ": centre " << arc.centre << ", EA " << arc.EA
         << ", GA " << arc.GA << ", GJ " << arc.GJ << ", EI " << arc.EI;
  name << ')';
  return name.str();
}

std::unique_ptr<FiniteElement<1, 3>> FE_ArcBeam::clone() const {
  return std::make_unique<FE_ArcBeam>(*this);
}

ArcBeam FE_ArcBeam::arc(const Point<3> &begin, const Point<3> &end,
                        const types::material_id material_id) const {
  const auto data = arcs.find(material_id);
  AssertThrow(data != arcs.end(), ExcMessage("FE_ArcBeam knows no arc of material id " +
                                             std::to_string(material_id) + "."));
  return ArcBeam(begin, end, data->second);
}

void FE_ArcBeam::evaluate(const CellGeometry &cell, const double xi,
                          std::vector<ShapeFunction> &shapes) const {
  evaluate_all(cell, {Point<1>(xi)},
               [&](const unsigned int, const std::vector<ShapeFunction> &at) { shapes = at; });
}

void FE_ArcBeam::evaluate_all(const CellGeometry &cell, const std::vector<Point<1>> &points,
                              const TakeShapes &take) const {
  const ArcBeam arc = this->arc(cell.begin, cell.end, cell.material_id);
  FullMatrix<double> value, derivative;
  std::vector<ShapeFunction> shapes(12);
  for (unsigned int q = 0; q < points.size(); ++q) {
    arc.shapes(arc.angle() * points[q][0], value, derivative);
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int c = 0; c < 6; ++c) {
        shapes[i].value[c] = value(c, i);
        shapes[i].derivative[c] = derivative(c, i) * arc.length() / cell.length;
      }
    take(q, shapes);
  }
}

ArcPoint::ArcPoint(const ArcBeam &arc, const double xi) : axes(arc.tangent(arc.angle() * xi)) {
  const Tensor<1, 3> chord = arc.point(arc.angle()) - arc.point(0.);
  along = chord / arc.length();
}

GeneralizedStrain arc_strain(const FEValuesBase<1, 3> &fe_values, const ArcPoint &point,
                             const unsigned int i, const unsigned int q,
                             const unsigned int first_component) {
  const unsigned int first = first_component;
  Tensor<1, 3> turn, du, dtheta;
  for (unsigned int c = 0; c < 3; ++c) {
    turn[c] = fe_values.shape_value_component(i, q, first + 3 + c);
    du[c] = fe_values.shape_grad_component(i, q, first + c) * point.along;
    dtheta[c] = fe_values.shape_grad_component(i, q, first + 3 + c) * point.along;
  }
  return generalized_strain(point.axes, turn, du, dtheta);
}

} // namespace frictionbeam
