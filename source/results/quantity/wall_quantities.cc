// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/wall_quantities.h"

#include "base/user_error.h"
#include "model/cell/line_cells.h"
#include "results/inelastic/section_states.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

double number_of(const SectionState &section, const unsigned int component) {
  switch (component) {
  case 0:
    return section.plastic_strain;
  case 1:
    return section.creep_strain;
  case 2:
    return section.utilization;
  default:
    return section.strain[component - 3];
  }
}

} // namespace

double value_of_wall(const Model &model, const Quantity &quantity, const LineState &state) {
  const unsigned int component = quantity.kind().component;
  const bool is_of_line = quantity.where.empty();
  const unsigned int vertex = is_of_line ? 0 : model.mesh.points.at(quantity.where);
  double value = 0., nearest = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const PipeCell &cell = model.discretization.pipe_cells()[i];
    const MeshedPipe &pipe = model.mesh.pipes[cell.pipe];
    const bool begins = pipe.vertices[cell.position] == vertex;
    if (!is_of_line && !begins && pipe.vertices[cell.position + 1] != vertex)
      continue;
    if ((!quantity.pipe.empty() && model.scene.pipes[cell.pipe].name != quantity.pipe) ||
        (quantity.side != Quantity::Side::any &&
         (quantity.side == Quantity::Side::after) != begins))
      continue;
    const double there = pipe.s[begins ? cell.position : cell.position + 1];
    for (const SectionState &section : sections_of_cell(model, i, state)) {
      const double number = number_of(section, component), distance = std::abs(section.s - there);
      if (is_of_line ? number > value || std::isnan(number) : distance < nearest) {
        value = number;
        nearest = distance;
      }
    }
  }
  if (!is_of_line && nearest == std::numeric_limits<double>::max())
    throw UserError("Quantity " + quantity.name + ": at the point '" + quantity.where +
                    "' no pipe has a section that yields or creeps" +
                    (quantity.side == Quantity::Side::any     ? "."
                     : quantity.side == Quantity::Side::after ? " behind it: try 'before'."
                                                              : " before it: try 'after'."));
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
    if (const double value = which == 0 ? step.limit->reached : step.limit->bound;
        std::isfinite(value)) // no bound may be known
      return value;
  if (quantity.is(Of::cycle) && step.cycle)
    return which == 0 ? step.cycle->growth : which == 1 ? step.cycle->flow : step.cycle->dissipated;
  return {};
}

std::string why_no_value(const Quantity &quantity, const std::vector<StepReport> &steps) {
  if (quantity.is(QuantityKind::Of::limit))
    for (const StepReport &step : steps)
      if (step.limit && (quantity.step.empty() || step.step == quantity.step))
        return " is not known: step " + step.step + " has come to no mechanism that gives a bound.";
  return " was not reached.";
}

} // namespace frictionbeam
