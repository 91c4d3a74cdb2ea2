// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/frame/derived_cases.h"

namespace frictionbeam {

/// Whether single cases give the numbers of such a combination, and not all together.
bool has_governing_cases(const Combination::Kind kind);

/// Which of its cases gave each number of a combination that has such; where several did, the
/// first. Of a case that is such a combination itself, those of that.
GoverningCases governing_cases(const Combination &combination, const std::vector<CaseRange> &cases,
                               const Results &results);

/// Those of a frame; null if it has none.
const GoverningCases *governing_of(const Results &results, const Frame &frame);

/// Tables of the report: which case gave what, of supports, restraints and named points; empty if
/// the frame has none.
std::string governing_support_table(const Results &results, const Frame &frame);
std::string governing_reaction_table(const Results &results, const Frame &frame);
std::string governing_point_table(const Results &results, const Frame &frame);

/// Write governing.csv, a row for each number, if there is any such combination.
void write_governing_cases(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
