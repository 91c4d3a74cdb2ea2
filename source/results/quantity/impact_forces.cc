// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/impact_forces.h"
#include "results/support/support_names.h"

#include "base/user_error.h"

#include <algorithm>

namespace frictionbeam {

namespace {

bool is_force_of(const Quantity &quantity, const SupportInfo &support) {
  using Of = QuantityKind::Of;
  const QuantityKind &kind = quantity.kind();
  return kind.unit == std::string("N") &&
         (kind.of == Of::supports ||
          (is_part_of(support, quantity.where) &&
           (kind.of == Of::support || kind.of == Of::holder || kind.of == Of::directed)));
}

std::string impulse_of(const Quantity &quantity) {
  return "'impulse at " + (quantity.where.empty() ? "SUPPORT" : quantity.where) + "'";
}

} // namespace

bool is_extreme_of_force(const Quantity &quantity, const SupportInfo &support) {
  const bool is_extreme =
      quantity.over == Quantity::Over::maximum ||
      (quantity.over == Quantity::Over::minimum && !quantity.absolute && !quantity.kind().is_size);
  return is_extreme && is_force_of(quantity, support);
}

bool is_integral_of_force(const Quantity &quantity, const SupportInfo &support) {
  return (quantity.over == Quantity::Over::integral || quantity.over == Quantity::Over::mean) &&
         is_force_of(quantity, support);
}

std::string remark_on_lost_impulse(const Quantity &quantity) {
  return "Quantity " + quantity.name + " is the force between impacts, as the integrator event " +
         "has them: of a rigid support that was struck, their impulses are not in it. " +
         impulse_of(quantity) + " is with them.";
}

std::string remark_on_velocity_jump(const Quantity &quantity, const Scene &scene,
                                    const std::vector<StepReport> &steps) {
  using Of = QuantityKind::Of;
  using Over = Quantity::Over;
  const QuantityKind &kind = quantity.kind();
  const bool is_force = kind.of == Of::holder ||
                        (kind.of == Of::directed &&
                         (kind.unit == std::string("N") || kind.unit == std::string("N m"))),
             is_integral = quantity.over == Over::integral || quantity.over == Over::mean,
             is_extreme = quantity.over == Over::maximum || quantity.over == Over::minimum;
  if (!is_force || !(is_integral || is_extreme))
    return "";
  for (const StepReport &step : steps)
    for (const unsigned int l : step.velocity_jumps)
      for (const Load::AtPoint &moved : scene.loads[l].at)
        if (moved.point == quantity.where)
          return "Quantity " + quantity.name + ": load " + scene.loads[l].name +
                 " changes the velocity of " + quantity.where + " at an instant in step " +
                 step.step + ". " +
                 (is_integral ? "The impulse of that is not in it; "
                              : "The force of that is infinite for no time and not in it; ") +
                 "a History whose slope does not jump has neither.";
  return "";
}

std::string remark_on_impact(const Quantity &quantity) {
  const std::string reason =
      "is the largest force of a rigid support that was struck. In an impact on a rigid stop it is "
      "infinite for no time: what is found depends on the time step and is no answer.";
  if (quantity.reference)
    throw UserError("Quantity " + quantity.name + " " + reason + "\n  read:    " + quantity.what +
                    " with a reference\n  allowed: a reference for what exists\n  try:     " +
                    impulse_of(quantity) + ", or an Axial rigidity for the support");
  return "Quantity " + quantity.name + " " + reason + " Take " + impulse_of(quantity) +
         ", or give the support an Axial rigidity.";
}

} // namespace frictionbeam
