// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/inelastic/section_states.h"

#include "model/cell/line_cells.h"

#include <algorithm>

namespace frictionbeam {

namespace {

double yield_strain_of(const BoundLaw &law, const double temperature) {
  const double stretched[n_section_strains] = {1.};
  LawIncrement increment;
  increment.temperature = temperature;
  const double bound = law.elastic_bound(stretched, 1., increment);
  return std::isfinite(bound) && bound > 0. ? 1. / bound : proof_strain;
}

/// Strains or forces of the same section along the other direction: x and y turn round, z does not,
/// and forces act on the other face.
Motion turned_round(Motion values) {
  for (const unsigned int c : {2u, 5u})
    values[c] = -values[c];
  return values;
}

} // namespace

std::vector<SectionState> sections_of_cell(const Model &model, const unsigned int index,
                                           const LineState &state) {
  const PipeSections &sections = model.cells.pipe_sections();
  std::vector<SectionState> result;
  if (!sections.has(index))
    return result;
  const PipeCell &cell = model.discretization.pipe_cells()[index];
  const std::vector<double> &s = model.mesh.pipes[cell.pipe].s;
  const Profile &profile =
      model.discretization.profiles()[model.discretization.pipe_cell(index)->material_id()];
  const PipeSections::Surroundings around = model.cells.surroundings(index, state.load_factors);
  const double yield_strain = yield_strain_of(profile.law, around.temperature);
  for (const PipeSections::Report &report : sections.reports(index, around, state.sections)) {
    SectionState section;
    section.pipe = cell.pipe;
    const double part = cell.reversed ? 1. - report.part : report.part;
    section.s = (1. - part) * s[cell.position] + part * s[cell.position + 1];
    section.length = report.length;
    std::copy_n(report.strain.data(), 6, section.strain.begin());
    std::copy_n(report.stress.data(), 6, section.force.begin());
    if (cell.reversed) {
      section.strain = turned_round(section.strain);
      section.force = turned_round(section.force);
    }
    section.utilization = report.state.utilization;
    section.plastic_strain = report.state.plastic_strain;
    section.creep_strain = report.state.creep_strain;
    section.dissipated = report.dissipated;
    section.yield_strain = yield_strain;
    result.push_back(section);
  }
  if (cell.reversed)
    std::reverse(result.begin(), result.end());
  return result;
}

std::vector<SectionState> sections_of_line(const Model &model, const LineState &state) {
  std::vector<SectionState> result;
  if (!model.cells.pipe_sections().any())
    return result;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const std::vector<SectionState> own = sections_of_cell(model, i, state);
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

} // namespace frictionbeam
