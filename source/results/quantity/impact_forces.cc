// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/impact_forces.h"

#include "analysis/increment/contact_watch.h"
#include "base/user_error.h"
#include "results/quantity/point_forces.h"

#include <algorithm>

namespace frictionbeam {

bool is_extreme_of_force(const Quantity &quantity, const SupportInfo &support) {
  const std::vector<std::string> of_support = {"fn", "ft1", "ft2", "fx", "fy", "fz"},
                                 of_all = {"sum_normal", "sum_friction"};
  const auto is_one_of = [&](const std::vector<std::string> &words) {
    return std::count(words.begin(), words.end(), quantity.what) > 0;
  };
  const bool is_extreme =
      quantity.over == Quantity::Over::maximum ||
      (quantity.over == Quantity::Over::minimum && !quantity.absolute && quantity.what != "fn");
  return is_extreme &&
         ((is_part_of(support, quantity.where) && is_one_of(of_support)) || is_one_of(of_all));
}

std::string remark_on_impact(const Quantity &quantity) {
  const std::string reason =
      "is the largest force of a rigid support that was struck. In an impact on a rigid stop it is "
      "infinite for no time: what is found depends on the time step and is no answer.";
  if (quantity.reference)
    throw UserError("Quantity " + quantity.name + " " + reason + "\n  read:    " + quantity.what +
                    " with a reference\n  allowed: a reference for what exists\n  try:     "
                    "'impulse at " +
                    (quantity.where.empty() ? "SUPPORT" : quantity.where) +
                    "', or an Axial rigidity for the support");
  return "Quantity " + quantity.name + " " + reason + " Take 'impulse at " +
         (quantity.where.empty() ? "SUPPORT" : quantity.where) +
         "', or give the support an Axial rigidity.";
}

void Collector::watch_impacts(const bool transient, const LineState &state) {
  if (transient && previous_status.size() == state.contact_status.size())
    for (const unsigned int i : closed_in(previous_status, previous_time, state.events)) {
      if (!is_rigid_stop(model, model.contacts[i]))
        continue;
      for (unsigned int q = 0; q < pending.size(); ++q)
        if (const Quantity &quantity = model.scene.quantities[q];
            state.time >= quantity.from && previous_time <= quantity.to &&
            is_extreme_of_force(quantity, results.supports[i]))
          pending[q].struck = true;
    }
  previous_status = state.contact_status;
}

} // namespace frictionbeam
