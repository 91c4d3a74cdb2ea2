// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/sensitivity.h"

namespace frictionbeam::study {

/**
 * Write what a study has found into @p folder:
 * - `runs.csv`: run, outcome, the variables as they stand in the file, and the numbers that are one
 *   for a run; empty where there is no answer;
 * - `runs.h5`: all numbers of all runs, a data set for each under /results, with the variables'
 *   values under /variables and the outcomes under /outcome; nan where there is no answer;
 * - `spread.csv`: of each number: nominal, least, quantiles with their bounds, largest, mean,
 *   standard deviation, the run of the largest; of a support's status the parts of the runs;
 * - `sensitivities.csv`: what each variable does to each number that is one for a run;
 * - `failed.csv`: the runs without an answer, why, and their variables;
 * - `study.json`: all of that in short.
 * Tables are in the units of the case.
 */
void write_study_files(const StudyResults &study, const std::vector<Sensitivity> &effects,
                       const std::string &case_name, const std::string &folder);

} // namespace frictionbeam::study
