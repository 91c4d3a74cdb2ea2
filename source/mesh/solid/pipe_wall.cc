// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/pipe_wall.h"

#include "base/user_error.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Integrals of r^(power - 2) over a circle of radius one whose arcs are polynomials through Gauss
/// and Lobatto's points, as those of a mapping of that degree.
double moment_of_circle(const unsigned int around, const unsigned int degree,
                        const unsigned int power) {
  const auto basis =
      Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(degree + 1).get_points());
  const QGaussLobatto<1> nodes(degree + 1);
  const QGauss<1> rule(power * degree / 2 + 2);
  const double arc = 2. * numbers::PI / around;
  double sum = 0.;
  std::vector<double> values(2);
  for (unsigned int q = 0; q < rule.size(); ++q) {
    Tensor<1, 2> x, dx;
    for (unsigned int i = 0; i < basis.size(); ++i) {
      const double angle = arc * nodes.point(i)[0];
      basis[i].value(rule.point(q)[0], values);
      const Tensor<1, 2> node({std::cos(angle), std::sin(angle)});
      x += values[0] * node;
      dx += values[1] * node;
    }
    sum += rule.weight(q) * std::pow(x.norm(), power - 2.) * (x[0] * dx[1] - x[1] * dx[0]) / power;
  }
  return around * sum;
}

} // namespace

double PipeWall::area() const {
  return moment_of_circle(around, mesh.geometry_degree, 2) * (outer * outer - inner * inner);
}

double PipeWall::bore_area() const {
  return moment_of_circle(around, mesh.geometry_degree, 2) * inner * inner;
}

double PipeWall::inertia() const {
  return 0.5 * moment_of_circle(around, mesh.geometry_degree, 4) *
         (std::pow(outer, 4) - std::pow(inner, 4));
}

const WallSegment &PipeWall::segment_at(const double s) const {
  for (const WallSegment &segment : segments)
    if (s < segment.start + segment.path.length)
      return segment;
  return segments.back();
}

double PipeWall::s_of(const LineMesh &line, const unsigned int vertex) const {
  for (unsigned int p = 0; p < line.pipes.size(); ++p)
    for (unsigned int i = 0; i < line.pipes[p].vertices.size(); ++i)
      if (line.pipes[p].vertices[i] == vertex)
        return pipe_start[p] + line.pipes[p].s[i];
  throw UserError("A point is on no pipe.\n  read:    a support or point off the pipes\n  allowed: "
                  "points of the pipes with Model = solid\n  try:     Model = line");
}

unsigned int PipeWall::ring_at(const unsigned int vertex) const {
  for (unsigned int r = 0; r < rings.size(); ++r)
    if (rings[r].vertex == vertex)
      return r;
  throw UserError("A point of the line is on no pipe of the solid.");
}

} // namespace frictionbeam
