// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/sensitivity.h"

namespace frictionbeam::study {

/// Write `report.html` of a study: what came of the runs, spread of all results, which variable
/// matters for what, how the quantiles settle, and the runs without an answer.
/// @param nominal results of the case as it stands, for its picture
void write_study_report(const StudyResults &study, const std::vector<Sensitivity> &effects,
                        const Scene &scene, const Results &nominal, const std::string &folder);

} // namespace frictionbeam::study
