// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/convergence.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::accuracy {

namespace {

constexpr double lowest_order = 0.5, highest_order = 2., order_of_chance = 3.,
                 order_of_first_chance = 2., largest_change_of_order = 0.75;
constexpr double rounding = 1e-11;
constexpr double longest_jump = 2.;
/// Part of the envelope: with it none of 360 answers of 80 static and 65 moving random lines at
/// 1e-2 to 1e-3 is off (prm/benchmark/random_accuracy.py), without it nine are.
constexpr double part_of_envelope = 0.5;

/// Levels of the coarser and of the finer answer.
struct Pair {
  unsigned int coarse, fine;
};

/// Difference of one pair divided by that of another.
double ratio(const double order, const Pair &now, const Pair &before) {
  const auto difference = [order](const Pair &pair) {
    return std::pow(2., -order * pair.coarse) - std::pow(2., -order * pair.fine);
  };
  return difference(now) / difference(before);
}

/// The order that gives this ratio, within the bounds.
double order_of(const double wanted, const Pair &now, const Pair &before) {
  double low = lowest_order, high = highest_order; // the ratio falls with the order
  for (unsigned int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio(middle, now, before) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

void Convergence::add(const unsigned int coarse, const unsigned int fine,
                      const std::vector<Difference> &differences) {
  const Pair now{coarse, fine}, last{last_coarse, last_fine};
  const bool is_finer = n > 0 && fine > last_fine; // else something besides has changed
  if (n == 0 || is_finer)
    ++n;
  quantities.resize(differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    Sequence &quantity = quantities[i];
    double d = differences[i].value <= rounding ? 0. : differences[i].value;
    const double rescaled = quantity.scale / differences[i].scale,
                 before = quantity.last * rescaled,
                 shrink = n > 1 && is_finer ? std::pow(2., -1. * (fine - last_fine)) : 0.;
    if (is_finer && before > 0. && d > 0.) {
      const double measured = order_of(d / before, now, last);
      quantity.order = n > 2 ? std::min(measured, std::max(1., quantity.measured)) : measured;
      if (kind == Order::first_at_best)
        quantity.order = std::min(quantity.order, 1.);
      if (kind != Order::regular && n > 2 &&
          std::abs(measured - quantity.measured) > largest_change_of_order)
        quantity.irregular = true;
      quantity.measured = measured;
      d = std::max(d, before * ratio(n > 2 ? order_of_chance : order_of_first_chance, now, last));
    }
    quantity.envelope = std::max(d, (is_finer ? shrink : 1.) * quantity.envelope * rescaled);
    quantity.last = d;
    quantity.scale = differences[i].scale;
    quantity.estimate = d / (std::pow(2., quantity.order * (fine - coarse)) - 1.);
    if (quantity.irregular)
      quantity.order = 1.;
    const double part = quantity.irregular             ? 1.
                        : kind == Order::first_at_best ? part_of_envelope
                                                       : 0.;
    quantity.estimate = std::max(quantity.estimate, part * quantity.envelope /
                                                        (std::pow(2., 1. * (fine - coarse)) - 1.));
    if (kind != Order::regular)
      quantity.estimate = std::max(quantity.estimate, differences[i].least);
  }
  last_coarse = coarse;
  last_fine = fine;
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
      if (quantity.estimate > tolerance) {
        if (quantity.irregular || kind == Order::first_at_best)
          return 1; // and see
        levels =
            std::max(levels, std::ceil(std::log2(quantity.estimate / tolerance) / quantity.order));
      }
  return static_cast<unsigned int>(std::min(levels, longest_jump));
}

} // namespace frictionbeam::accuracy
