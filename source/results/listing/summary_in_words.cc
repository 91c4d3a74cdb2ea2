// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/listing/summary_in_words.h"

#include "results/how_well_known.h"
#include "results/remarks.h"
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

} // namespace frictionbeam
