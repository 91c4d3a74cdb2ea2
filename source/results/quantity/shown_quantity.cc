// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/shown_quantity.h"

#include <cmath>

namespace frictionbeam {

std::string unit_of(const Quantity &quantity) {
  const std::string unit = quantity.kind().unit;
  if (quantity.wants_time)
    return "s";
  if (quantity.over == Quantity::Over::integral)
    return unit == "-" ? "s" : unit + " s";
  if (quantity.over == Quantity::Over::rate)
    return unit == "J" ? "W" : unit == "N s" ? "N" : unit + "/s";
  return unit;
}

QuantityResult shown(const Scene &scene, const Quantity &quantity, const double value) {
  const bool relative =
      quantity.is(QuantityKind::Of::exact) && scene.exact && scene.exact->largest > 0.;
  const std::string unit = relative ? "-" : unit_of(quantity);
  const double factor = scene.units.factor(unit);
  QuantityResult result{
      quantity.name,      quantity.unit.empty() ? scene.units.name(unit) : quantity.unit,
      quantity.source,    value / factor,
      quantity.reference, {}};
  if (quantity.reference) {
    const double difference = std::abs(result.value - *quantity.reference);
    result.error =
        *quantity.reference != 0. ? difference / std::abs(*quantity.reference) : difference;
  }
  result.limit = quantity.limit;
  result.in_si = quantity.unit.empty() ? factor : 0.;
  return result;
}

} // namespace frictionbeam
