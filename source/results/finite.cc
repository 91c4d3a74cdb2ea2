// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/finite.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

template <typename Numbers>
bool finite(const Numbers &numbers) {
  return std::all_of(std::begin(numbers), std::end(numbers),
                     [](const double number) { return std::isfinite(number); });
}

bool finite(const SupportState &state) {
  return std::all_of(std::begin(support_numbers), std::end(support_numbers),
                     [&](const auto number) { return std::isfinite(state.*number); });
}

/// What of a frame is not finite.
std::string of_frame(const Frame &frame, const Results &results) {
  if (!std::isfinite(frame.time))
    return "an instant";
  for (const Station &station : frame.line)
    if (!finite(station.displacement) || !finite(station.force) || !std::isfinite(station.s))
      return "a displacement or section force";
  for (const SectionState &section : frame.sections)
    if (!finite(section.strain) || !finite(section.force))
      return "a strain or force of a section that yields or creeps";
  for (std::size_t i = 0; i < frame.supports.size(); ++i)
    if (!finite(frame.supports[i]))
      return "the state of support " + results.supports[i].name;
  for (std::size_t i = 0; i < frame.reactions.size(); ++i)
    if (!finite(frame.reactions[i]))
      return "the force of " + results.restraints[i].name;
  return "";
}

} // namespace

std::string first_not_finite(const Results &results) {
  for (const QuantityResult &quantity : results.quantities)
    if (!std::isfinite(quantity.value))
      return "the quantity " + quantity.name;
  for (const Frame &frame : results.frames)
    if (const std::string what = of_frame(frame, results); !what.empty())
      return what + " at time " + rounded_number(frame.time, 6);
  for (const History &history : results.histories)
    if (!std::all_of(history.displacement.begin(), history.displacement.end(),
                     [](const Motion &motion) { return finite(motion); }))
      return "the motion of " + history.point;
  for (const ModeResult &mode : results.modes)
    if (!std::isfinite(mode.frequency) || !finite(mode.participation) ||
        !finite(mode.effective_mass) || !of_frame(mode.shape, results).empty())
      return "a mode";
  for (const StressCase &stress : results.stresses)
    if (!finite(stress.stress) || !finite(stress.allowed))
      return "a stress of " + stress.name;
  for (const NozzleUse &nozzle : results.nozzles)
    if (!finite(nozzle.force) || !std::isfinite(nozzle.utilization))
      return "the utilization of " + nozzle.name;
  for (const Check &check : results.certificate)
    if (check.is_judged && !std::isfinite(check.value))
      return "the check '" + check.name + "'";
  return "";
}

void refuse_not_finite(Results &results) {
  const std::string what = first_not_finite(results);
  if (what.empty())
    return;
  const std::string remark = "Not a finite number: " + what +
                             ". The results are worth nothing; look for a value of the parameter "
                             "file that is far too large or too small.";
  results.remarks.push_back(remark);
  if (results.status != RunStatus::converged)
    return;
  results.status = RunStatus::failed;
  if (!results.steps.empty()) {
    results.steps.back().converged = false;
    results.steps.back().remark = remark;
  }
}

} // namespace frictionbeam
