// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/sensitivity.h"

/// @file Charts and the table of sensitivities for the report of a study, as HTML; empty where
/// there is nothing to show.
namespace frictionbeam::study {

/// Of each quantity that varies, which part of the runs stays below a value.
std::string distribution_charts(const StudyResults &study);

/// Of quantities, nozzles, stresses, and the supports whose forces vary most: what each variable
/// does, the strongest first.
std::string sensitivity_tables(const StudyResults &study, const std::vector<Sensitivity> &effects);

/// Of each quantity, its value in all runs against the variable that matters most.
std::string dependence_charts(const StudyResults &study, const std::vector<Sensitivity> &effects);

/// Of each quantity, its quantiles by the first runs, ever more of them.
std::string convergence_charts(const StudyResults &study);

} // namespace frictionbeam::study
