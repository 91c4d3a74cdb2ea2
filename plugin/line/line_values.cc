// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/line_values.h>

#include <frictionbeam/fe_friction_beam.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/hp/mapping_collection.h>

#include <algorithm>
#include <optional>

namespace frictionbeam {

using namespace dealii;

namespace {

bool is_friction(const FE_Line *const line) {
  return dynamic_cast<const FE_FrictionBeam *>(line) != nullptr;
}

hp::QCollection<1> quadratures_of(const hp::FECollection<1, 3> &fes, const unsigned int n_points) {
  hp::QCollection<1> quadratures;
  for (unsigned int i = 0; i < fes.size(); ++i)
    quadratures.push_back(line_quadrature(fes[i], n_points));
  return quadratures;
}

const hp::MappingCollection<1, 3> &straight_mapping() {
  static const hp::MappingCollection<1, 3> mapping{MappingQ1<1, 3>()};
  return mapping;
}

} // namespace

Quadrature<1> line_quadrature(const FiniteElement<1, 3> &fe, const unsigned int n_points) {
  const FE_Line *const line = line_part(fe).element;
  if (line == nullptr || is_friction(line))
    return QGauss<1>(1);
  const unsigned int n = n_points == 0 ? 2 : n_points;
  return QGauss<1>(dynamic_cast<const FE_ArcBeam *>(line) != nullptr ? std::max(n, 12u) : n);
}

LineValues::LineValues(const hp::FECollection<1, 3> &fes, const unsigned int n_points)
    : LineValues(fes, quadratures_of(fes, n_points)) {}

LineValues::LineValues(const hp::FECollection<1, 3> &fes, const Quadrature<1> &quadrature)
    : LineValues(fes, hp::QCollection<1>(quadrature)) {}

LineValues::LineValues(const hp::FECollection<1, 3> &fes, const hp::QCollection<1> &quadratures)
    : hp_values(straight_mapping(), fes, quadratures,
                update_values | update_gradients | update_JxW_values) {
  for (unsigned int i = 0; i < fes.size(); ++i)
    parts.push_back(line_part(fes[i]));
}

LineValues::LineValues(const LineValues &other)
    : LineValues(other.hp_values.get_fe_collection(), other.hp_values.get_quadrature_collection()) {
}

LawKind LineValues::kind() const {
  return is_friction(part->element) ? LawKind::support : LawKind::section;
}

Point<3> LineValues::point_at(const double xi) const {
  return arc ? arc->point(arc->angle() * xi) : begin + xi * (end - begin);
}

LocalAxes LineValues::local_axes(const double xi) const {
  return LocalAxes(arc ? arc->tangent(arc->angle() * xi) : end - begin);
}

void LineValues::reinit(const LineCellIterator &cell) {
  hp_values.reinit(cell);
  fe_values = &hp_values.get_present_fe_values();
  part = &parts[cell->active_fe_index()];
  begin = cell->vertex(0);
  end = cell->vertex(1);
  chord = begin.distance(end);
  arc.reset();
  if (!has_line())
    return;
  if (const auto *const element = dynamic_cast<const FE_ArcBeam *>(part->element))
    arc = std::make_unique<ArcBeam>(element->arc(begin, end, cell->material_id()));

  const unsigned int n = n_dofs(), first = part->first_component;
  axes_at.clear();
  strains.assign(n_points() * n, GeneralizedStrain());
  motions.assign(n_points() * n, Tensor<1, 6>());
  for (unsigned int q = 0; q < n_points(); ++q) {
    axes_at.push_back(local_axes(xi(q)));
    std::optional<ArcPoint> on_arc;
    if (arc)
      on_arc.emplace(*arc, xi(q));
    for (const unsigned int i : part->dofs) {
      strains[n * q + i] = arc ? arc_strain(*fe_values, *on_arc, i, q, first)
                               : generalized_strain(*fe_values, axes_at[q], i, q, first);
      for (unsigned int c = 0; c < 6; ++c)
        motions[n * q + i][c] = fe_values->shape_value_component(i, q, first + c);
    }
  }
}

} // namespace frictionbeam
