// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/reduction_text.h"
#include "results/text.h"

namespace frictionbeam {

std::string describe_reduction(const std::string &step, const ReductionAccount &account) {
  const std::string beginning = "Step " + step + ": ";
  if (!account.is_reduced)
    return beginning + account.remark + ".";
  std::string text =
      beginning + "reduced from " + std::to_string(account.n_line) + " unknowns to " +
      std::to_string(account.n_reduced) + ": " + std::to_string(account.n_kept) +
      " of contact nodes, " + std::to_string(account.n_modes) + " modes" +
      (account.n_modes > 0 ? " up to " + rounded_number(account.highest_frequency, 3) + " Hz"
                           : "") +
      ", " + std::to_string(account.n_static_shapes) + " static shapes; left out are " +
      std::to_string(account.n_left_out) + " modes" +
      (account.n_left_out > 0 ? " from " + rounded_number(account.next_frequency, 3) + " Hz on"
                              : "");
  if (account.estimate)
    text += ". Contact forces and monitored motions are estimated to be within " +
            rounded_number(*account.estimate, 2) + " of those of the whole line, " +
            rounded_number(*account.demanded, 2) + " is demanded";
  return text + ".";
}

} // namespace frictionbeam
