// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/report_result.h"

#include "model/cell/line_cells.h"
#include "model/model.h"

#include <algorithm>

namespace frictionbeam {

bool add_result(const EquilibriumResult &result, StepReport &report) {
  report.iterations += result.iterations;
  report.factorizations += result.factorizations;
  report.back_substitutions += result.back_substitutions;
  if (!result.converged) {
    report.remark = result.remark;
    report.no_equilibrium = result.no_equilibrium;
    return false;
  }
  report.residual = std::max(report.residual, result.residual);
  if (result.check)
    report.contact.include(*result.check);
  return true;
}

void check_sections(const Model &model, const LineState &state, StepReport &report) {
  report.sections.include(model.cells.check_sections(state.sections, state.load_factors));
}

} // namespace frictionbeam
