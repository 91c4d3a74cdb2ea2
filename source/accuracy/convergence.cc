// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convergence.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::accuracy {

namespace {

constexpr double lowest_order = 0.8, highest_order = 2., order_of_chance = 3.;
constexpr double rounding = 1e-11;
constexpr double longest_jump = 5.;

/// Difference over @p jump levels divided by the one before over @p jump_before levels.
double ratio(const double order, const unsigned int jump_before, const unsigned int jump) {
  const double left_before = std::pow(2., -order * jump_before), left = std::pow(2., -order * jump);
  return left_before * (1. - left) / (1. - left_before);
}

/// The order that gives this ratio, within the bounds.
double order_of(const double wanted, const unsigned int jump_before, const unsigned int jump) {
  double low = lowest_order, high = highest_order; // the ratio falls with the order
  for (unsigned int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio(middle, jump_before, jump) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

void Convergence::add(const unsigned int jump, const std::vector<double> &differences) {
  quantities.resize(differences.size());
  ++n;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    Sequence &quantity = quantities[i];
    double d = differences[i] <= rounding ? 0. : differences[i];
    if (n > 1 && quantity.last > 0. && d > 0.) {
      quantity.order = order_of(d / quantity.last, quantity.jump, jump);
      d = std::max(d, quantity.last * ratio(order_of_chance, quantity.jump, jump));
    }
    quantity.last = d;
    quantity.jump = jump;
    quantity.estimate = d / (std::pow(2., quantity.order * jump) - 1.);
  }
}

double Convergence::estimate() const {
  if (n == 0)
    return std::nan("");
  double largest = 0.;
  for (const Sequence &quantity : quantities)
    if (!(quantity.estimate <= largest)) // nan counts as the largest
      largest = quantity.estimate;
  return largest;
}

unsigned int Convergence::levels_to(const double tolerance) const {
  double levels = 1.;
  if (knows_orders())
    for (const Sequence &quantity : quantities)
      if (quantity.estimate > tolerance)
        levels =
            std::max(levels, std::ceil(std::log2(quantity.estimate / tolerance) / quantity.order));
  return static_cast<unsigned int>(std::min(levels, longest_jump));
}

} // namespace frictionbeam::accuracy
