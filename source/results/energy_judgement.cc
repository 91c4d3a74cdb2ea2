// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/energy_judgement.h"

#include "results/text.h"

#include <algorithm>

namespace frictionbeam {

namespace {
constexpr double remark_above = 1e-6, failed_above = 1e-2;
} // namespace

double least_turnover(const std::vector<StepReport> &steps) {
  double largest = 0.;
  for (const StepReport &step : steps)
    largest = std::max(largest, step.energy.turnover);
  return 1e-6 * largest;
}

void judge_energy(const Scene &scene, Results &results) {
  if (scene.kinematics == Kinematics::corotational)
    return;
  for (unsigned int i = 0; i < results.steps.size(); ++i) {
    StepReport &step = results.steps[i];
    const double turnover = std::max(step.energy.turnover, least_turnover(results.steps)),
                 left_over = std::abs(step.energy.left_over());
    if (scene.steps[i].transient || !(left_over > remark_above * turnover))
      continue;
    const std::string account = "the account of energy leaves over " +
                                rounded_number(100. * left_over / turnover, 2) +
                                " % of its turnover";
    if (left_over <= failed_above * turnover) {
      results.remarks.push_back("Step " + step.step + ": " + account +
                                ": its numbers are known to about that.");
      continue;
    }
    step.remark += (step.remark.empty() ? "" : "; ") + account;
    step.converged = false;
    if (results.status == RunStatus::converged)
      results.status = RunStatus::failed;
  }
}

} // namespace frictionbeam
