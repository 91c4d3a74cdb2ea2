// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// @file
/// The tables of the report, as HTML.

/// Quantities with their references and errors.
std::string quantity_table(const Results &results);

/// Each step at a glance: loads, largest displacement, states of the supports, sums of forces.
std::string step_table(const Scene &scene, const Results &results,
                       const std::vector<const Frame *> &frames);

/// The supports, a tab for each of at most six frames. Of very many supports, those with the
/// largest forces.
std::string support_tables(const Results &results, const std::vector<const Frame *> &frames);

/// The supports' states through the sequence: a row each, a column for the end of each step.
std::string state_table(const Results &results);

/// Forces and moments of restraints and springs on the pipes, a tab for each of at most six frames.
std::string reaction_tables(const Results &results, const std::vector<const Frame *> &frames);

/// What the solver did, how far the result can be trusted and what it cost.
std::string solver_tables(const Results &results);

/// What the program chose for the accuracy that was demanded, and its runs.
std::string accuracy_section(const AccuracyAccount &account);

} // namespace frictionbeam
