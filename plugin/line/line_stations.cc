// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/line_stations.h>

#include <deal.II/base/quadrature_lib.h>

namespace frictionbeam {

using namespace dealii;

SectionForces::SectionForces(const LineValues &values, const LineCellIterator &cell,
                             const LawPointData &points, const Tensor<1, 3> &line_force)
    : values(values), line_force(line_force) {
  const std::vector<LawPoint> &law_points = points.trial(cell);
  AssertThrow(law_points.size() == values.n_points(),
              ExcDimensionMismatch(law_points.size(), values.n_points()));
  if (values.kind() == LawKind::support) {
    of_support = law_points[0].stress;
    return;
  }
  const std::vector<unsigned int> &dofs = values.line_dofs();
  for (unsigned int q = 0; q < values.n_points(); ++q)
    for (unsigned int c = 0; c < 6; ++c) {
      const Tensor<1, 6> &motion = values.motion(dofs[c], q);
      const Tensor<1, 3> moved({motion[0], motion[1], motion[2]});
      const double share = values.strain(dofs[c], q) * law_points[q].stress - moved * line_force;
      (c < 3 ? force[c] : moment[c - 3]) += share * values.JxW(q);
    }
}

GeneralizedStress SectionForces::at(const double xi) const {
  if (values.kind() == LawKind::support)
    return of_support;
  // Force and moment of the part beyond, about the place: those of the first node and of the line
  // force before the place, turned round.
  const Point<3> place = values.point_at(xi);
  const double before = xi * values.length();
  const Tensor<1, 3> P = -force - before * line_force;
  Tensor<1, 3> M = -moment - cross_product_3d(values.point_at(0.) - place, force);
  const QGauss<1> quadrature(12);
  for (unsigned int q = 0; q < quadrature.size() && line_force.norm() > 0.; ++q)
    M -= before * quadrature.weight(q) *
         cross_product_3d(values.point_at(xi * quadrature.point(q)[0]) - place, line_force);
  const LocalAxes axes = values.local_axes(xi);
  return GeneralizedStress(
      {axes.x * P, axes.y * P, axes.z * P, axes.x * M, axes.y * M, axes.z * M});
}

namespace {

Quadrature<1> without_weights(const std::vector<double> &xi) {
  std::vector<Point<1>> places;
  for (const double place : xi)
    places.emplace_back(place);
  return Quadrature<1>(places, std::vector<double>(places.size(), 0.));
}

} // namespace

LineStations::LineStations(const DoFHandler<1, 3> &dof_handler, const LawPointData &points,
                           const LineIncrement &increment, const std::vector<double> &xi)
    : points(points), increment(increment),
      at_points(dof_handler.get_fe_collection(), points.n_points()),
      at_stations(dof_handler.get_fe_collection(), without_weights(xi)) {}

std::vector<LineStation> LineStations::on_cell(const LineCellIterator &cell,
                                               const std::vector<double> &dof_values) {
  at_points.reinit(cell);
  if (!at_points.has_line())
    return {};
  const SectionForces forces(at_points, cell, points,
                             increment.line_force ? increment.line_force(cell) : Tensor<1, 3>());
  at_stations.reinit(cell);
  std::vector<LineStation> stations(at_stations.n_points());
  for (unsigned int q = 0; q < stations.size(); ++q) {
    const double xi = at_stations.xi(q);
    LineStation &station = stations[q];
    station.s = xi * at_stations.length();
    station.point = at_stations.point_at(xi);
    for (const unsigned int i : at_stations.line_dofs()) {
      station.strain += dof_values[i] * at_stations.strain(i, q);
      for (unsigned int d = 0; d < 3; ++d) {
        station.displacement[d] += dof_values[i] * at_stations.motion(i, q)[d];
        station.rotation[d] += dof_values[i] * at_stations.motion(i, q)[3 + d];
      }
    }
    station.force = forces.at(xi);
  }
  return stations;
}

std::vector<LineStation> line_stations_cell(const LineCellIterator &cell,
                                            const std::vector<double> &dof_values,
                                            const LawPointData &points,
                                            const LineIncrement &increment,
                                            const std::vector<double> &xi) {
  return LineStations(cell->get_dof_handler(), points, increment, xi).on_cell(cell, dof_values);
}

} // namespace frictionbeam
