// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/tied_section.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double in_plane = 1e-6, of_outer_radius = 1.01;

/// What the displacements of a section's nodes add to the motions that are held.
class SectionMotions {
public:
  SectionMotions(const MappingQ<3> &mapping, const DoFHandler<3> &dof_handler,
                 const TiedSection &section)
      : dof_handler(dof_handler), section(section),
        values(mapping, dof_handler.get_fe(), QGauss<2>(dof_handler.get_fe().degree + 2),
               update_values | update_quadrature_points | update_JxW_values),
        nodes(mapping, dof_handler.get_fe(),
              Quadrature<3>(dof_handler.get_fe().base_element(0).get_unit_support_points()),
              update_quadrature_points) {
    read(&SectionMotions::add_area);
    read(&SectionMotions::add_motions);
  }

  using Row = std::map<types::global_dof_index, double>;
  std::vector<Row> rows;                   ///< of each motion held
  std::set<types::global_dof_index> inner; ///< dofs of nodes inside of the outer surface

private:
  using Cell = typename DoFHandler<3>::active_cell_iterator;
  void read(void (SectionMotions::*const add)(const Cell &));
  void add_area(const Cell &cell);
  void add_motions(const Cell &cell);
  bool has(const Point<3> &place) const {
    const Tensor<1, 3> arm = place - section.centre;
    return std::abs(arm * section.normal) < in_plane * section.radius &&
           arm.norm() < of_outer_radius * section.radius;
  }

  const DoFHandler<3> &dof_handler;
  const TiedSection &section;
  FEFaceValues<3> values;
  FEValues<3> nodes;
  double area = 0., inertia = 0.; ///< of the mesh
};

void SectionMotions::read(void (SectionMotions::*const add)(const Cell &)) {
  rows.resize(section.held.size());
  std::set<unsigned int> done; // both cells have the face between them
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      bool lies_there = true;
      for (const unsigned int v : cell->face(f)->vertex_indices())
        lies_there = lies_there && has(cell->face(f)->vertex(v));
      if (!lies_there || !done.insert(cell->face_index(f)).second)
        continue;
      values.reinit(cell, f);
      (this->*add)(cell);
    }
}

void SectionMotions::add_area(const Cell &) {
  for (const unsigned int q : values.quadrature_point_indices()) {
    area += values.JxW(q);
    inertia += 0.5 * values.JxW(q) * (values.quadrature_point(q) - section.centre).norm_square();
  }
}

void SectionMotions::add_motions(const Cell &cell) {
  const FiniteElement<3> &fe = dof_handler.get_fe();
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  nodes.reinit(cell);
  for (unsigned int i = 0; i < dofs.size(); ++i) {
    const auto [component, node] = fe.system_to_component_index(i);
    const Point<3> &place = nodes.quadrature_point(node);
    if (!has(place))
      continue;
    constexpr double inside = 1. - 1e-3; // of the outer radius
    if ((place - section.centre).norm() < inside * section.radius)
      inner.insert(dofs[i]);
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Tensor<1, 3> arm = values.quadrature_point(q) - section.centre, &t = section.normal;
      const double weight = values.JxW(q) * values.shape_value(i, q);
      for (std::size_t h = 0; h < rows.size(); ++h) {
        const auto &held = section.held[h];
        const Tensor<1, 3> way({held[0], held[1], held[2]}), turn({held[3], held[4], held[5]});
        const Tensor<1, 3> share = way / area + (turn * cross_product_3d(arm, t) / inertia) * t +
                                   (0.5 * (turn * t) / inertia) * cross_product_3d(t, arm);
        rows[h][dofs[i]] += weight * share[component];
      }
    }
  }
}

/// What is a sum of other unknowns already is replaced by them.
void put_in_constraints(const AffineConstraints<double> &constraints, SectionMotions::Row &row) {
  SectionMotions::Row free;
  for (const auto &[dof, share] : row)
    if (!constraints.is_constrained(dof))
      free[dof] += share;
    else if (const auto *const entries = constraints.get_constraint_entries(dof))
      for (const auto &[other, factor] : *entries)
        free[other] += share * factor;
  row = free;
}

void tie_section(const ContinuumBody<3> &body, const TiedSection &section,
                 AffineConstraints<double> &constraints) {
  SectionMotions motions(body.mapping, body.dof_handler, section);
  std::vector<SectionMotions::Row> &rows = motions.rows;
  std::vector<types::global_dof_index> pivots(rows.size(), numbers::invalid_dof_index);
  std::vector<double> sizes; // with which what is left of a row is compared
  for (SectionMotions::Row &row : rows) {
    double largest = 0.;
    for (const auto &[dof, share] : row)
      largest = std::max(largest, std::abs(share));
    sizes.push_back(largest);
    put_in_constraints(constraints, row);
  }
  for (std::size_t h = 0; h < rows.size(); ++h) { // Gauss and Jordan's elimination
    double free = 0.;
    for (const auto &[dof, share] : rows[h]) {
      if (motions.inner.count(dof) == 0 ||
          std::abs(share) <= (1. + 1e-9) * free) // of equal ones the first, whatever rounding says
        continue;
      free = std::abs(share);
      pivots[h] = dof;
    }
    constexpr double held_already = 1e-6;
    if (free <= held_already * sizes[h]) {
      rows[h].clear();
      pivots[h] = numbers::invalid_dof_index;
      continue;
    }
    const double pivot = rows[h].at(pivots[h]);
    for (auto &[dof, share] : rows[h])
      share /= pivot;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      const auto found = rows[other].find(pivots[h]);
      if (other == h || found == rows[other].end())
        continue;
      const double factor = found->second;
      for (const auto &[dof, share] : rows[h])
        rows[other][dof] -= factor * share;
      rows[other].erase(pivots[h]);
    }
  }
  for (std::size_t h = 0; h < rows.size(); ++h) {
    if (pivots[h] == numbers::invalid_dof_index)
      continue;
    constraints.add_line(pivots[h]);
    for (const auto &[dof, share] : rows[h])
      if (dof != pivots[h])
        constraints.add_entry(pivots[h], dof, -share);
  }
}

} // namespace

void tie_sections(const std::vector<TiedSection> &sections, ContinuumBody<3> &body) {
  AffineConstraints<double> constraints;
  constraints.reinit(body.relevant);
  for (const auto &line : body.constraints.get_lines()) {
    constraints.add_line(line.index);
    constraints.add_entries(line.index, line.entries);
  }
  for (const TiedSection &section : sections)
    tie_section(body, section, constraints);
  constraints.close();
  body.constraints.copy_from(constraints);
}

} // namespace frictionbeam
