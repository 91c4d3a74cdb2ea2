// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/wall_quantities.h"

#include "base/user_error.h"
#include "model/cell/line_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

double number_of(const PipeSections::Report &report, const unsigned int component) {
  switch (component) {
  case 0:
    return report.state.plastic_strain;
  case 1:
    return report.state.creep_strain;
  case 2:
    return report.state.utilization;
  default:
    return report.strain[component - 3];
  }
}

} // namespace

double value_of_wall(const Model &model, const Quantity &quantity, const LineState &state) {
  const unsigned int component = quantity.kind().component;
  const PipeSections &sections = model.cells.pipe_sections();
  const bool is_of_line = quantity.where.empty();
  const unsigned int vertex = is_of_line ? 0 : model.mesh.points.at(quantity.where);
  double value = 0., nearest = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    if (!sections.has(i))
      continue;
    const auto cell = model.discretization.pipe_cell(i);
    const bool begins = cell->vertex_index(0) == vertex;
    if (!is_of_line && !begins && cell->vertex_index(1) != vertex)
      continue;
    const double length = (cell->vertex(1) - cell->vertex(0)).norm();
    for (const PipeSections::Report &report :
         sections.reports(i, model.cells.surroundings(i, state.load_factors), state.sections)) {
      const double number = number_of(report, component),
                   distance = length * (begins ? report.part : 1. - report.part);
      if (is_of_line ? number > value : distance < nearest) {
        value = number;
        nearest = distance;
      }
    }
  }
  if (!is_of_line && nearest == std::numeric_limits<double>::max())
    throw UserError("Quantity " + quantity.name + ": at the point '" + quantity.where +
                    "' no pipe has a section that yields or creeps.");
  return value;
}

std::vector<std::pair<unsigned int, double>> yielded_cells(const Model &model,
                                                           const LineState &state) {
  const PipeSections &sections = model.cells.pipe_sections();
  std::vector<std::pair<unsigned int, double>> result;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    if (!sections.has(i))
      continue;
    const PipeCell &cell = model.discretization.pipe_cells()[i];
    const std::vector<double> &s = model.mesh.pipes[cell.pipe].s;
    for (const PipeSections::Report &report :
         sections.reports(i, model.cells.surroundings(i, state.load_factors), state.sections))
      if (report.state.plastic_strain > 0.) {
        result.emplace_back(cell.pipe, (s[cell.position] + s[cell.position + 1]) / 2.);
        break;
      }
  }
  return result;
}

std::optional<double> value_of_step(const Quantity &quantity, const StepReport &step) {
  using Of = QuantityKind::Of;
  const unsigned int which = quantity.kind().component;
  if (!quantity.step.empty() && step.step != quantity.step)
    return {};
  if (quantity.is(Of::limit) && step.limit)
    return which == 0 ? step.limit->reached : step.limit->bound;
  if (quantity.is(Of::cycle) && step.cycle)
    return which == 0 ? step.cycle->growth : which == 1 ? step.cycle->flow : step.cycle->dissipated;
  return {};
}

} // namespace frictionbeam
