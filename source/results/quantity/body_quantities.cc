// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/algebra/dense_algebra.h"
#include "base/user_error.h"
#include "results/body_results.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/quantity/along_line.h"
#include "results/text.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

using Kind = ContinuumQuantity::Kind;

/// Displacement component at a point of the body.
template <int dim>
double at_point(const ContinuumBody<dim> &body, const ContinuumState &state,
                const ContinuumQuantity &quantity) {
  const auto point = body.mesh.points.find(quantity.where);
  if (point == body.mesh.points.end())
    throw UserError("The quantity " + quantity.name + " is at the point '" + quantity.where +
                    "', which the mesh does not have.");
  const Point<dim> &p = point->second;
  const MappingQ1<dim> mapping;
  double value = 0.;
  unsigned int n = 0;
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || n > 0 || cell->center().distance(p) > 0.51 * cell->diameter())
      continue;
    Point<dim> unit;
    try {
      unit = mapping.transform_real_to_unit_cell(cell, p);
    } catch (const typename Mapping<dim>::ExcTransformationFailed &) {
      continue; // far outside of a distorted cell
    }
    if (!GeometryInfo<dim>::is_inside_unit_cell(unit, 1e-9))
      continue;
    std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (body.fe.system_to_component_index(i).first == quantity.component)
        value += state.displacement(dofs[i]) * body.fe.shape_value(i, unit);
    n = 1;
  }
  const unsigned int found = Utilities::MPI::sum(n, body.communicator);
  if (found == 0)
    throw UserError("The quantity " + quantity.name + " is at the point '" + quantity.where +
                    "', which is not in the body.");
  return Utilities::MPI::sum(value, body.communicator) / found;
}

template <int dim>
double mean_over(const ContinuumBody<dim> &body, const ContinuumState &state,
                 const ContinuumQuantity &quantity) {
  const types::boundary_id id = body.mesh.part(quantity.where);
  const QGauss<dim - 1> rule(body.fe.degree + 1);
  FEFaceValues<dim> values(body.fe, rule, update_values | update_JxW_values);
  std::vector<Tensor<1, dim>> u(rule.size());
  double integral = 0., area = 0.;
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id) {
          values.reinit(cell, f);
          values[FEValuesExtractors::Vector(0)].get_function_values(state.displacement, u);
          for (unsigned int q = 0; q < rule.size(); ++q) {
            integral += u[q][quantity.component] * values.JxW(q);
            area += values.JxW(q);
          }
        }
  return Utilities::MPI::sum(integral, body.communicator) /
         Utilities::MPI::sum(area, body.communicator);
}

/// A rule on the part of a face with x below the given one, which cuts it. On a line it is exact;
/// on a face of a solid, points of a fine rule are counted or not.
template <int dim>
Quadrature<dim - 1> rule_below(const double x, const double x_first, const double x_last,
                               const unsigned int degree) {
  const QGauss<dim - 1> rule(degree + 1);
  if (dim == 3)
    return QIterated<dim - 1>(QGauss<1>(2), 64);
  const double s = (x - x_first) / (x_last - x_first); // where the line is cut
  const double begin = x_last > x_first ? 0. : s, size = x_last > x_first ? s : 1. - s;
  std::vector<Point<dim - 1>> points;
  std::vector<double> weights;
  for (unsigned int q = 0; q < rule.size(); ++q) {
    Point<dim - 1> p;
    p[0] = begin + size * rule.point(q)[0];
    points.push_back(p);
    weights.push_back(size * rule.weight(q));
  }
  return Quadrature<dim - 1>(points, weights);
}

/// Whether the body is held along x below the section, so that the forces beyond it are known.
/// @throws UserError if it is held on both sides, or has no such section
template <int dim>
bool is_held_below(const ContinuumBody<dim> &body, const ContinuumQuantity &quantity) {
  const double x = quantity.x;
  const std::string what =
      "The quantity " + quantity.name + " is a force at x = " + rounded_number(x) + " m";
  const auto &vertices = body.mesh.vertices;
  const auto [first, last] =
      std::minmax_element(vertices.begin(), vertices.end(),
                          [](const Point<dim> &a, const Point<dim> &b) { return a[0] < b[0]; });
  if (x < (*first)[0] || x > (*last)[0])
    throw UserError(what + ", where the body has no section. It reaches from " +
                    rounded_number((*first)[0]) + " to " + rounded_number((*last)[0]) + " m.");
  bool below = false, above = false;
  const auto hold_at = [&](const double place) {
    below = below || place < x;
    above = above || place > x;
  };
  for (const ContinuumHold &hold : body.continuum.holds) {
    if (!hold.fixed[0])
      continue;
    if (const auto point = body.mesh.points.find(hold.part); point != body.mesh.points.end()) {
      hold_at(point->second[0]);
      continue;
    }
    const types::boundary_id id = body.mesh.part(hold.part);
    for (const auto &face : body.mesh.faces)
      if (face.part == id)
        for (const unsigned int v : face.vertices)
          hold_at(vertices[v][0]);
  }
  if (below && above)
    throw UserError(what + ", and the body is held along x on both sides of it. Ask for it where "
                           "one side is free.");
  return below;
}

/// Forces along x on boundary faces of a body: loads, and friction as nodal tractions.
template <int dim>
class ForceOnFaces {
public:
  ForceOnFaces(const ContinuumBody<dim> &body, const ContinuumState &state)
      : body(body), factor(state.factor), traction(nodal_tractions(body, state)) {
    traction.update_ghost_values();
  }

  const UpdateFlags flags =
      update_values | update_JxW_values | update_normal_vectors | update_quadrature_points;

  /// Add the force [N] on a face at its quadrature points up to x = @p end to @p force.
  void add(const FEFaceValues<dim> &values, const types::boundary_id id, const double end,
           double &force) const {
    std::vector<Tensor<1, dim>> friction(values.n_quadrature_points);
    if (body.surface_of(id) >= 0)
      values[FEValuesExtractors::Vector(0)].get_function_values(traction, friction);
    for (const unsigned int q : values.quadrature_point_indices())
      if (values.quadrature_point(q)[0] <= end)
        force += (factor * body.traction(id, values.normal_vector(q))[0] + friction[q][0]) *
                 values.JxW(q) * body.thickness();
  }

private:
  const ContinuumBody<dim> &body;
  const double factor; ///< of the loads
  ContinuumVector traction;
};

/// Compression across the section at x, from the forces along x on the boundary on that side of it
/// which nothing holds.
template <int dim>
double axial_force(const ContinuumBody<dim> &body, const ContinuumState &state,
                   const ContinuumQuantity &quantity) {
  const bool held_below = is_held_below(body, quantity);
  const double x = quantity.x;
  const ForceOnFaces<dim> forces(body, state);
  FEFaceValues<dim> whole(body.fe, QGauss<dim - 1>(body.fe.degree + 1), forces.flags);
  double below = 0., all = 0.;
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices()) {
        const auto face = cell->face(f);
        if (!face->at_boundary() ||
            (body.surface_of(face->boundary_id()) < 0 && !body.is_loaded(face->boundary_id())))
          continue;
        double low = 1e300, high = -1e300;
        for (const unsigned int v : face->vertex_indices()) {
          low = std::min(low, face->vertex(v)[0]);
          high = std::max(high, face->vertex(v)[0]);
        }
        if (held_below) {
          whole.reinit(cell, f);
          forces.add(whole, face->boundary_id(), 1e300, all);
        }
        if (low > x || (low == x && high > x))
          continue;
        if (high <= x) {
          whole.reinit(cell, f);
          forces.add(whole, face->boundary_id(), x, below);
        } else {
          FEFaceValues<dim> cut(
              body.fe, rule_below<dim>(x, face->vertex(0)[0], face->vertex(1)[0], body.fe.degree),
              forces.flags);
          cut.reinit(cell, f);
          forces.add(cut, face->boundary_id(), x, below);
        }
      }
  return Utilities::MPI::sum(below - all, body.communicator);
}

/// Where the zone of nodes @p in_zone that begins with the first one ends, of their coordinates
/// @p at in rising order, with @p size going to zero there as distance^(3/2): where a parabola
/// through its power 2/3 at four nodes meets zero. The last node of the zone is left out, which
/// feels that the next one does not move.
template <typename InZone, typename Size>
double end_of_zone(const std::vector<ContactRow> &rows, const std::vector<double> &at,
                   const InZone &in_zone, const Size &size) {
  constexpr unsigned int n_fit = 4;
  std::size_t n = 0;
  while (n < rows.size() && in_zone(rows[n]))
    ++n;
  if (n == 0)
    return rows.empty() ? 0. : at[0];
  if (n == rows.size())
    return at.back();
  const double last = at[n - 1], next = at[n];
  if (n < n_fit + 1)
    return 0.5 * (last + next);
  const double scale = last - at[n - 1 - n_fit];
  Eigen::Matrix<double, n_fit, 3> powers;
  Eigen::Matrix<double, n_fit, 1> values;
  for (unsigned int i = 0; i < n_fit; ++i) {
    const ContactRow &row = rows[n - 1 - n_fit + i];
    const double x = (at[n - 1 - n_fit + i] - last) / scale;
    powers.row(i) << 1., x, x * x;
    values[i] = std::pow(std::abs(size(row)), 2. / 3.);
  }
  const Eigen::Vector3d c = LeastSquares(powers).solve(values);
  // Near the last node: 0 = c0 + c1 x + c2 x^2, with c1 < 0.
  const double discriminant = c[1] * c[1] - 4. * c[0] * c[2];
  const double root =
      discriminant >= 0. && c[1] < 0. ? 2. * c[0] / (-c[1] + std::sqrt(discriminant)) : 1e300;
  const double end = last + scale * root, slack = 2. * (next - last);
  return end > last - slack && end < next + slack ? end : 0.5 * (last + next);
}

double of_rows(const std::vector<ContactRow> &all, const ContinuumScene &scene,
               const ContinuumQuantity &quantity, const bool is_plane) {
  std::vector<ContactRow> rows;
  for (const ContactRow &row : all)
    if (scene.contacts[row.surface].part == quantity.where)
      rows.push_back(row);
  const unsigned int axis = long_axis(rows);
  std::stable_sort(rows.begin(), rows.end(), [axis](const ContactRow &a, const ContactRow &b) {
    return a.position[axis] < b.position[axis];
  });
  std::vector<double> coordinates;
  for (const ContactRow &row : rows)
    coordinates.push_back(row.position[axis]);
  const auto is_open = [](const ContactRow &row) { return row.status == ContactStatus::open; };
  const auto is_loose = [](const ContactRow &row) { return row.status != ContactStatus::stick; };
  const auto slip = [](const ContactRow &row) { return std::hypot(row.slip1, row.slip2); };
  const auto gap = [](const ContactRow &row) { return row.gap; };
  double sum = 0.;
  switch (quantity.kind) {
  case Kind::slip_length: // nodes across a surface have no order, along its edge they have
    return rows.empty() ? 0.
           : is_plane   ? end_of_zone(rows, along_line(rows), is_loose, slip)
                        : end_of_zone(rows, coordinates, is_loose, slip) - coordinates[0];
  case Kind::slip_end:
    return end_of_zone(rows, coordinates, is_loose, slip);
  case Kind::open_end:
    return end_of_zone(rows, coordinates, is_open, gap);
  case Kind::sum_normal:
    for (const ContactRow &row : rows)
      sum += row.area * row.pressure;
    return sum;
  default: {
    double across = 0.;
    for (const ContactRow &row : rows) {
      sum += row.area * row.traction1;
      across += row.area * row.traction2;
    }
    return std::hypot(sum, across);
  }
  }
}

} // namespace

template <int dim>
double evaluate_quantity(const ContinuumBody<dim> &body, const ContinuumState &state,
                         const std::vector<ContactRow> &rows, const ContinuumQuantity &quantity) {
  switch (quantity.kind) {
  case Kind::displacement:
    return at_point(body, state, quantity);
  case Kind::mean_displacement:
    return mean_over(body, state, quantity);
  case Kind::axial_force:
    return axial_force(body, state, quantity);
  default:
    return of_rows(rows, body.continuum, quantity, dim == 2);
  }
}

std::string unit_of(const ContinuumQuantity &quantity) {
  return row_of(body_quantity_kinds, quantity.kind).unit;
}

std::string convergence_table(const Scene &scene, const std::vector<ContinuumLevel> &levels) {
  const auto column = [&](const auto &value) {
    std::vector<std::string> cells;
    for (const ContinuumLevel &level : levels)
      cells.push_back(value(level));
    return cells;
  };
  HtmlTable table;
  table.right("Cells", column([](const auto &level) { return std::to_string(level.cells); }))
      .right("Unknowns", column([](const auto &level) { return std::to_string(level.unknowns); }))
      .right("Contact nodes",
             column([](const auto &level) { return std::to_string(level.contacts); }))
      .right("Iterations",
             column([](const auto &level) { return std::to_string(level.iterations); }))
      .right("Estimate", column([](const auto &level) {
               return level.estimate ? rounded_number(*level.estimate, 2) : "\u2013";
             }))
      .right("Seconds", column([](const auto &level) { return rounded_number(level.seconds, 2); }));
  for (unsigned int i = 0; i < scene.continuum->quantities.size(); ++i) {
    const ContinuumQuantity &quantity = scene.continuum->quantities[i];
    table.right(quantity.name + " [" + unit_of(quantity) + "]",
                column([&](const auto &level) { return rounded_number(level.quantities[i], 6); }));
  }
  return table.str() +
         html_note("Meshes of the refinement, one below the other. Estimate: of the error in the "
                   "energy norm, relative. Seconds: since the start.");
}

void write_convergence_csv(const Scene &scene, const std::vector<ContinuumLevel> &levels,
                           const std::string &folder) {
  std::string text = "cells,unknowns,contacts,iterations,estimate,seconds";
  for (const ContinuumQuantity &quantity : scene.continuum->quantities)
    text += "," + quantity.name;
  for (const ContinuumLevel &level : levels) {
    text += "\n" + std::to_string(level.cells) + "," + std::to_string(level.unknowns) + "," +
            std::to_string(level.contacts) + "," + std::to_string(level.iterations) + "," +
            (level.estimate ? exact_number(*level.estimate) : "") + "," +
            exact_number(level.seconds);
    for (const double value : level.quantities)
      text += "," + exact_number(value);
  }
  write_file(folder + "/convergence.csv", text + "\n");
}

template double evaluate_quantity<2>(const ContinuumBody<2> &, const ContinuumState &,
                                     const std::vector<ContactRow> &, const ContinuumQuantity &);
template double evaluate_quantity<3>(const ContinuumBody<3> &, const ContinuumState &,
                                     const std::vector<ContactRow> &, const ContinuumQuantity &);

} // namespace frictionbeam
