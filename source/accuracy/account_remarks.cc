// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/account_remarks.h"

#include "results/text.h"

#include <cmath>

namespace frictionbeam::accuracy {

std::string settings_in_words(const std::vector<std::string> &settings) {
  std::string text;
  for (const std::string &setting : settings)
    text += (text.empty() ? "" : "; ") + setting;
  return text;
}

void include_walls(const bool are_refined, KnownError &cells, AccuracyAccount &account) {
  cells.is_of_walls = cells.is_of_walls && !are_refined;
  if (!cells.is_of_walls)
    return;
  if (cells.error)
    account.estimate = std::max(account.estimate, *cells.error); // not known stays so
  if (cells.error && *cells.error <= account.demanded)
    return;
  account.left_out.push_back("walls of Solid/At are not refined, their cells are for Solid/Degree "
                             "and Cells around to choose: " +
                             cells.reason);
  account.reached = account.reached && !cells.error;
}

void add_remarks(const AccountInWords &of, Results &results) {
  const AccuracyAccount &account = of.account;
  const std::vector<std::string> &chosen = account.chosen;
  if (!of.missed.empty())
    results.remarks.push_back("Accuracy: " + of.missed +
                              " is nearer than the time step can tell, and was not seen.");
  results.remarks.push_back(
      account.reached
          ? "Accuracy: the quantities are estimated to be known to " +
                rounded_number(account.estimate, 2) + ", " + rounded_number(account.demanded, 2) +
                " is demanded" + (account.left_out.empty() ? "" : ", but for what is left out") +
                "; chosen: " +
                (chosen.empty() ? "nothing, since there is nothing to choose"
                                : settings_in_words(chosen)) +
                "."
          : "Accuracy: " + rounded_number(account.demanded, 2) +
                " is not reached; the estimate, which shall be below that by a factor of " +
                rounded_number(of.margin, 2) + ", is " +
                (std::isnan(account.estimate) ? "not known" : rounded_number(account.estimate, 2)) +
                (chosen.empty() ? "" : " with " + settings_in_words(chosen)) + ".");
  if (of.model_was_chosen)
    results.remarks.push_back("Model = auto: solved as a " + account.model + ", since " +
                              account.model_reason +
                              (account.line_error ? " (what the line leaves out is estimated as " +
                                                        rounded_number(*account.line_error, 2) + ")"
                                                  : "") +
                              ".");
  for (const std::string &part : of.judged)
    results.remarks.push_back(part);
  if (!account.left_out.empty())
    results.remarks.push_back("Accuracy, left out: " + settings_in_words(account.left_out) + ".");
}

} // namespace frictionbeam::accuracy
