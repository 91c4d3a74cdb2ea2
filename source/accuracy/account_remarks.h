// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::accuracy {

/// Settings as they follow --set, one after the other.
std::string settings_in_words(const std::vector<std::string> &settings);

struct AccountInWords {
  const AccuracyAccount &account;
  double margin; ///< by which the estimate has to be below what is demanded
  bool model_was_chosen;
  const std::string &missed;              ///< event that may have been stepped over
  const std::vector<std::string> &judged; ///< bends and supports, a line each
};

/// What the cells of walls that the file names, and that were not refined, leave: an estimate that
/// was not reached, or something left out.
void include_walls(const bool are_refined, KnownError &cells, AccuracyAccount &account);

/// What was chosen, how well the quantities are known and what is not, as remarks.
void add_remarks(const AccountInWords &of, Results &results);

} // namespace frictionbeam::accuracy
