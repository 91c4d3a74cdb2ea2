// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"
#include "analysis/increment/step_report.h"

namespace frictionbeam {

/// Add what one solve did to the report of its step. @return whether it converged.
bool add_result(const EquilibriumResult &result, StepReport &report);

/// Judge pipes that yield or creep at a state of the step.
void check_sections(const Model &model, const LineState &state, StepReport &report);

} // namespace frictionbeam
