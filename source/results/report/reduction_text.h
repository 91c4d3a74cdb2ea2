// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"

namespace frictionbeam {

/// How a transient step was reduced, or why it was not, in plain words.
std::string describe_reduction(const std::string &step, const ReductionAccount &account);

} // namespace frictionbeam
