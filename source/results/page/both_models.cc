// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/page/both_models.h"
#include "results/page/html.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Of two models, or the first of them (@p of_both empty): the larger, if either is known.
void include_known(const KnownError &one, const std::string &model, KnownError &of_both) {
  const bool is_first = of_both.reason.empty();
  if (is_first)
    of_both.error = one.error;
  else if (of_both.error)
    of_both.error = one.error ? std::optional(std::max(*of_both.error, *one.error)) : std::nullopt;
  of_both.reason +=
      (is_first ? "" : "; ") + model + ": " +
      (one.error && *one.error > 0. ? rounded_number(100. * *one.error, 2) + " %, " : "") +
      one.reason;
}

} // namespace

void include_model(Results &both, const Results &results, const std::string &model) {
  const std::string prefix = model + "/";
  for (QuantityResult quantity : results.quantities) {
    quantity.name = prefix + quantity.name;
    both.quantities.push_back(quantity);
  }
  for (StepReport step : results.steps) {
    step.step = prefix + step.step;
    both.steps.push_back(step);
  }
  for (Check check : results.certificate) {
    check.name = prefix + check.name;
    both.certificate.push_back(check);
  }
  for (Verdict verdict : results.verdicts) {
    verdict.of = prefix + verdict.of;
    both.verdicts.push_back(verdict);
  }
  for (const std::string &doubt : results.doubts)
    both.doubts.push_back(model + ": " + doubt);
  for (const std::string &remark : results.remarks)
    both.remarks.push_back(model + ": " + remark);
  include_known(results.known.increments, model, both.known.increments);
  include_known(results.known.time_step, model, both.known.time_step);
  include_known(results.known.cells, model, both.known.cells);
  both.method += (both.method.empty() ? "" : "; ") + model + ": " + results.method;
  if (results.status != RunStatus::converged)
    both.status = results.status;
  both.cost.add_work(results.cost);
  both.cost.unknowns += results.cost.unknowns;
  both.cost.cells += results.cost.cells;
  both.cost.contacts += results.cost.contacts;
}

std::string side_by_side(const Results &both, const std::string &other,
                         const std::map<std::string, double> &rounding) {
  const auto is_rounding = [&](const double value, const std::string &unit) {
    const auto of_unit = rounding.find(unit);
    return of_unit != rounding.end() && std::abs(value) <= of_unit->second;
  };
  std::vector<std::string> names;
  for (const QuantityResult &quantity : both.quantities) {
    const std::string name = quantity.name.substr(quantity.name.find('/') + 1);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  const auto find = [&](const std::string &model, const std::string &name) {
    const auto found = std::find_if(
        both.quantities.begin(), both.quantities.end(),
        [&](const QuantityResult &quantity) { return quantity.name == model + "/" + name; });
    return found == both.quantities.end() ? nullptr : &*found;
  };
  const auto column = [&](const std::string &model) {
    std::vector<std::string> cells;
    for (const std::string &name : names) {
      const QuantityResult *const one = find(model, name);
      cells.push_back(
          one == nullptr ? dash
                         : rounded_number(is_rounding(one->value, one->unit) ? 0. : one->value, 6) +
                               " " + one->unit);
    }
    return cells;
  };
  std::vector<std::string> difference;
  for (const std::string &name : names) {
    const QuantityResult *const line = find("line", name), *const solid = find(other, name);
    if (line == nullptr || solid == nullptr || line->unit != solid->unit) {
      difference.push_back(dash);
      continue;
    }
    const double size = std::max(std::abs(line->value), std::abs(solid->value)),
                 change = solid->value - line->value;
    difference.push_back(size == 0. || is_rounding(size, line->unit) ? dash
                         : is_rounding(change, line->unit)
                             ? "0 %"
                             : rounded_number(100. * change / size, 2) + " %");
  }
  return HtmlTable()
             .text("Quantity", names)
             .right("Line", column("line"))
             .right(other == "solid" ? "Solid" : "Continuum", column(other))
             .right("Difference", difference)
             .str() +
         html_note("Differences relative to the larger one. The folders line and " + other +
                   " have the report of each.");
}

} // namespace frictionbeam
