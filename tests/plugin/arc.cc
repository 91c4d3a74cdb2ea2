// FE_ArcBeam shall be the exact arc: its stiffness by quadrature is the closed one, rigid motions
// cost no force, Castigliano's flexibility of a quarter ring comes out to rounding, and straight
// pieces converge to it with the square of their length. References: closed forms, below, and
// FE_TimoshenkoBeam. SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_arc_beam.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include "../check.h"
#include "line_problem.h"

using namespace line_problem;
using namespace frictionbeam;

namespace {

const double EA = 300., GA = 70., GJ = 0.9, EI = 1.3, R = 2.;

/// A quarter ring about the origin in a plane of its own, from t to n.
struct Ring {
  Tensor<1, 3> u, v;
  Point<3> begin, end;
  ArcData data;

  explicit Ring(const double angle = numbers::PI / 2.) {
    u = Tensor<1, 3>({2. / 3, -1. / 3, 2. / 3});
    v = Tensor<1, 3>({2. / 3, 2. / 3, -1. / 3});
    begin = Point<3>(R * u);
    end = Point<3>(R * (std::cos(angle) * u + std::sin(angle) * v));
    data = {Point<3>(), EA, GA, GJ, EI};
  }
};

double largest(const FullMatrix<double> &matrix) { return matrix.linfty_norm(); }

FullMatrix<double> by_quadrature(const Ring &ring, const bool turned) {
  Triangulation<1, 3> triangulation;
  std::vector<Point<3>> vertices{ring.begin, ring.end};
  if (turned)
    std::swap(vertices[0], vertices[1]);
  create_line_triangulation(vertices, {{{{0, 1}}, 4}}, triangulation);
  const FE_ArcBeam fe({{4, ring.data}});
  const auto cell = triangulation.begin_active();
  const QGauss<1> quadrature(12);
  FEValues<1, 3> values(mapping, fe, quadrature,
                        update_values | update_gradients | update_JxW_values);
  values.reinit(cell);
  const ArcBeam arc(cell->vertex(0), cell->vertex(1), ring.data);
  const double stretch = arc.length() / (cell->vertex(1) - cell->vertex(0)).norm();
  const double D[6] = {EA, GA, GA, GJ, EI, EI};
  FullMatrix<double> K(12, 12);
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int j = 0; j < 12; ++j) {
        const auto a = arc_strain(values, {arc, quadrature.point(q)[0]}, i, q);
        const auto b = arc_strain(values, {arc, quadrature.point(q)[0]}, j, q);
        for (unsigned int s = 0; s < 6; ++s)
          K(i, j) += a[s] * D[s] * b[s] * stretch * values.JxW(q);
      }
  K.add(-1., arc.stiffness());
  return K;
}

void quadrature_and_rigid_motions() {
  for (const double angle : {0.05, 0.8, numbers::PI / 2., 2.9}) {
    const Ring ring(angle);
    const ArcBeam arc(ring.begin, ring.end, ring.data);
    const FullMatrix<double> K = arc.stiffness();
    for (const bool turned : {false, true})
      CHECK_NEAR(largest(by_quadrature(ring, turned)) / largest(K), 0., 1e-9);
    for (unsigned int motion = 0; motion < 6; ++motion) {
      Vector<double> x(12), f(12);
      for (unsigned int node = 0; node < 2; ++node) {
        Tensor<1, 3> unit;
        unit[motion % 3] = 1.;
        const Tensor<1, 3> moved =
            motion < 3 ? unit
                       : cross_product_3d(unit, Tensor<1, 3>(node == 0 ? ring.begin : ring.end));
        for (unsigned int d = 0; d < 3; ++d) {
          x[6 * node + d] = moved[d];
          x[6 * node + 3 + d] = motion < 3 ? 0. : unit[d];
        }
      }
      K.vmult(f, x);
      CHECK_NEAR(f.linfty_norm() / largest(K), 0., 1e-9);
    }
  }
}

/// Clamped at the beginning, a force across the plane at the end: R^3 (pi/4 (1/EI + 3/GJ) - 2/GJ)
/// and shear R pi/2 / GA; in the plane, along the radius of the end: pi R^3 / (4 EI) and pi R/4
/// (1/EA + 1/GA).
void castigliano() {
  const Ring ring;
  const ArcBeam arc(ring.begin, ring.end, ring.data);
  const FullMatrix<double> K = arc.stiffness();
  FullMatrix<double> free(6, 6);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      free(i, j) = K(6 + i, 6 + j);
  free.gauss_jordan();
  const auto flexibility = [&](const Tensor<1, 3> &direction) {
    double sum = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        sum += direction[i] * free(i, j) * direction[j];
    return sum;
  };
  const double pi = numbers::PI, R3 = R * R * R;
  CHECK_NEAR(flexibility(cross_product_3d(ring.u, ring.v)),
             R3 * (pi / 4. * (1. / EI + 3. / GJ) - 2. / GJ) + pi / 2. * R / GA, 1e-12);
  CHECK_NEAR(flexibility(ring.v), pi / 4. * R3 / EI + pi / 4. * R * (1. / EA + 1. / GA), 1e-12);
}

/// Tip motions of the ring cut into straight pieces.
double error_of_pieces(const unsigned int n) {
  const Ring ring;
  Triangulation<1, 3> triangulation;
  std::vector<Point<3>> vertices;
  std::vector<LineCell> cells;
  for (unsigned int i = 0; i <= n; ++i) {
    const double angle = numbers::PI / 2. * i / n;
    vertices.push_back(Point<3>(R * (std::cos(angle) * ring.u + std::sin(angle) * ring.v)));
    if (i > 0)
      cells.push_back({{{i - 1, i}}, 0});
  }
  create_line_triangulation(vertices, cells, triangulation);
  const Rigidities section({EA, GA, GA, GJ, EI, EI});
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  DoFHandler<1, 3> dofs(triangulation);
  dofs.distribute_dofs(fe);
  const VertexDofs vertex_dofs(dofs);
  Vector<double> load(dofs.n_dofs());
  const Tensor<1, 3> force({0.3, -0.8, 0.5});
  add_at(load, vertex_dofs, n, 0, force);
  const Vector<double> x = solve(assemble(dofs, {section}), load, clamp(vertex_dofs, 0));
  const ArcBeam arc(ring.begin, ring.end, ring.data);
  const FullMatrix<double> K = arc.stiffness();
  FullMatrix<double> free(6, 6);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      free(i, j) = K(6 + i, 6 + j);
  free.gauss_jordan();
  Tensor<1, 3> tip;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      tip[i] += free(i, j) * force[j];
  return (at(x, vertex_dofs, n, 0) - tip).norm() / tip.norm();
}

/// Clamped at both ends and heated, or loaded along its length: the middle moves as many pieces
/// say.
void clamped() {
  const Ring ring;
  const ArcBeam arc(ring.begin, ring.end, ring.data);
  const Tensor<1, 3> q({0.1, 0.4, -0.3});
  for (const double psi : {0., arc.angle()})
    CHECK_NEAR(arc.clamped_motion(psi, q, 0.01, 0.02).norm(), 0., 1e-12);
  // A free curvature that is that of the ring turned by itself: two halves meet in the middle.
  const ArcBeam first(ring.begin, arc.point(arc.angle() / 2.), ring.data),
      second(arc.point(arc.angle() / 2.), ring.end, ring.data);
  const Tensor<1, 6> middle = arc.clamped_motion(arc.angle() / 2., q, 0.01, 0.02);
  // The halves with this motion of the middle, clamped motions added, give the quarter points.
  FullMatrix<double> value, derivative;
  for (const bool later : {false, true}) {
    const ArcBeam &half = later ? second : first;
    half.shapes(half.angle() / 2., value, derivative);
    Tensor<1, 6> motion = half.clamped_motion(half.angle() / 2., q, 0.01, 0.02);
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        motion[i] += value(i, (later ? 0 : 6) + j) * middle[j];
    const Tensor<1, 6> whole =
        arc.clamped_motion(arc.angle() * (later ? 0.75 : 0.25), q, 0.01, 0.02);
    CHECK_NEAR((motion - whole).norm() / whole.norm(), 0., 1e-10);
  }
}

} // namespace

int arc(int, char **) {
  quadrature_and_rigid_motions();
  castigliano();
  clamped();
  const double coarse = error_of_pieces(8), fine = error_of_pieces(16);
  CHECK_NEAR(coarse / fine, 4., 0.02);
  return check::report();
}
