// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/collapse.h"

#include "base/number_text.h"
#include "model/mechanism.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// A pipe's cell in a mechanism.
struct Hinge {
  unsigned int cell;
  double power; ///< dissipated on the motion [J]
  double part;  ///< of the way along the cell
};

Vector loads_at(const Model &model, const LineState &at, const std::vector<double> &factors) {
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(at), factors, balance);
  return balance.loads;
}

/// What contacts dissipate at their present forces.
double contact_power(const Model &model, const LineState &at, const Vector &motion) {
  double power = 0.;
  const Vector moved = at.dofs + motion;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    power +=
        contact.weight * at.contact_stress[i].dot(contact.strain(moved) - contact.strain(at.dofs));
  }
  return power;
}

/// Of an elastic pipe, the work of its present forces: it takes next to no part in a mechanism.
PipeSections::Flow flow_of(const Model &model, const unsigned int index, const LineState &at,
                           const Vector &motion) {
  const LineCells &cells = model.cells;
  const Pose pose = pose_of(at);
  PipeElement element(model.discretization);
  const auto cell = model.discretization.pipe_cell(index);
  element.reinit(cell);
  const LineCells::CellState state = cells.state_of(index, element, pose, at.load_factors);
  if (cells.pipe_sections().has(index))
    return cells.pipe_sections().plastic_flow(
        index, state.motions, cells.motions_of_cell(index, pose, motion),
        cells.surroundings(index, at.load_factors), at.sections);
  const LineCells::Vector12 &ends = state.ends;
  std::vector<dealii::types::global_dof_index> dofs(12);
  cell->get_dof_indices(dofs);
  double work = 0.;
  for (unsigned int i = 0; i < 12; ++i)
    work += ends[i] * motion[dofs[i]];
  return {std::abs(work)};
}

/// Whether a cell shows the same hinge as the one before it: next to each other on one pipe, and
/// not each with its own at its far end.
bool is_one_hinge(const Model &model, const Hinge &before, const Hinge &next) {
  const PipeCell &first = model.discretization.pipe_cells()[before.cell],
                 &second = model.discretization.pipe_cells()[next.cell];
  const auto along = [](const PipeCell &cell, const double part) {
    return cell.reversed ? 1. - part : part;
  };
  return first.pipe == second.pipe && first.position + 1 == second.position &&
         !(along(first, before.part) < 0.5 && along(second, next.part) > 0.5);
}

/// Where most is dissipated: cells side by side are one hinge.
std::string words_of(const Model &model, const std::vector<Hinge> &hinges, const LineState &at,
                     const double power) {
  constexpr double least_share = 0.02;
  constexpr std::size_t most_named = 6;
  std::vector<Hinge> named;
  const Hinge *last = nullptr; // that takes part
  for (const Hinge &hinge : hinges) {
    if (!(hinge.power > least_share * power))
      continue;
    if (last == nullptr || !is_one_hinge(model, *last, hinge))
      named.push_back(hinge);
    else if (hinge.power > named.back().power)
      named.back() = hinge;
    last = &hinge;
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(named.size(), most_named); ++i)
    text += (i == 0 ? "" : ", ") + place_in_words(model, named[i].cell, named[i].part);
  if (named.size() > most_named)
    text += " and " + std::to_string(named.size() - most_named) + " more";
  std::vector<unsigned int> slipping(model.scene.supports.size(), 0); // places of a support
  for (unsigned int i = 0; i < at.contact_status.size(); ++i)
    if (at.contact_status[i] == ContactStatus::slip)
      ++slipping[model.contacts[i].support];
  std::string supports;
  for (unsigned int i = 0; i < slipping.size(); ++i)
    if (slipping[i] > 0)
      supports += (supports.empty() ? "" : ", ") + model.scene.supports[i].name +
                  (slipping[i] > 1 ? " (" + std::to_string(slipping[i]) + " places)" : "");
  return "hinges: " + (text.empty() ? "none" : text) +
         (supports.empty() ? "" : "; supports that slip: " + supports);
}

} // namespace

std::optional<Collapse> find_collapse(const Model &model, const LineState &at, const Vector &motion,
                                      const std::vector<double> &begin,
                                      const std::vector<double> &end) {
  const Vector first = loads_at(model, at, begin), last = loads_at(model, at, end);
  double by_first = first.dot(motion), gain = (last - first).dot(motion);
  std::vector<Hinge> hinges;
  double power = contact_power(model, at, motion), of_pipes = 0.;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const PipeSections::Flow flow = flow_of(model, i, at, motion);
    hinges.push_back({i, flow.power, flow.part});
    const PipeSections::Surroundings at_first = model.cells.surroundings(i, begin),
                                     at_last = model.cells.surroundings(i, end);
    by_first += at_first.line_force.dot(flow.interior) + at_first.pressure * flow.bore;
    gain += (at_last.line_force - at_first.line_force).dot(flow.interior) +
            (at_last.pressure - at_first.pressure) * flow.bore;
    of_pipes += hinges.back().power;
  }
  power += of_pipes;
  if (!(gain > 0.))
    return {};
  return Collapse{(power - by_first) / gain, words_of(model, hinges, at, of_pipes)};
}

} // namespace frictionbeam
