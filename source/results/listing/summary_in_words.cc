// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/listing/summary_in_words.h"

#include "results/how_well_known.h"
#include "results/remarks.h"
#include "results/text.h"
#include "results/verdicts.h"

namespace frictionbeam {

void print_summary(std::ostream &out, const Scene &scene, const Results &results) {
  for (const std::string &remark : all_remarks(scene, results))
    out << "Note: " << remark << '\n';
  for (const StepReport &step : results.steps) {
    out << "Step " << step.step << ": " << (step.converged ? "converged" : "NOT converged") << ", "
        << step.increments << " increments, " << step.iterations << " iterations, "
        << step.factorizations << " factorizations";
    if (step.halvings > 0)
      out << ", cut " << step.halvings << " times";
    if (!step.converged)
      out << "; " << step.remark;
    out << '\n';
  }
  if (results.status == RunStatus::converged)
    out << "Known to: load increments " << in_words(results.known.increments) << ", time step "
        << in_words(results.known.time_step) << ", cells " << in_words(results.known.cells) << '\n';
  if (const std::string failures = failures_in_words(results.verdicts); !failures.empty())
    out << failures << '\n';
  for (const QuantityResult &quantity : results.quantities) {
    out << quantity.name << " = " << quantity.value << ' ' << quantity.unit;
    if (quantity.error)
      out << " (reference " << *quantity.reference << ", error " << *quantity.error << ')';
    out << '\n';
  }
}

std::string where_it_stopped(const Results &results) {
  for (const StepReport &step : results.steps)
    if (!step.converged)
      return " It stopped in step '" + step.step + "'" +
             (step.remark.empty() ? "."
                                  : ": " + step.remark + (step.remark.back() == '.' ? "" : "."));
  return "";
}

std::string why_unsolved(const Results &results, const std::string &folder) {
  const std::string where = where_it_stopped(results);
  std::string text =
      "Status " + status_word(results.status) + "." +
      (where.empty() ? " Every step came to its end, but not to what was asked." : where);
  if (!results.frames.empty())
    text += " The last good state is that of time " +
            rounded_number(results.frames.back().time, 6) + " s.";
  return text + " What was reached is in " + folder + ": report.html, summary.json.";
}

} // namespace frictionbeam
