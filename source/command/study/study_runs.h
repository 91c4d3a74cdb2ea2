// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "command/study/run_journal.h"
#include "command/study/study_solver.h"

namespace frictionbeam::study {

/**
 * Solve all runs of a study that are pending, by the study's threads, under mpirun by all
 * processes; afterwards the first process has all of them. Each is written to the journal when it
 * is done.
 * @throws Interrupted if a signal asked for the end; the runs that were done are in the journal
 */
void solve_runs(const StudyCase &of, const Variables &variables, RunJournal &journal,
                StudyResults &study);

} // namespace frictionbeam::study
