// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/difference.h"

#include <vector>

namespace frictionbeam::accuracy {

/**
 * Errors of quantities, estimated from answers at levels of refinement, each level twice as fine.
 *
 * If a quantity's error is C 2^(-p l) at level l, the differences of three answers give p, and the
 * last of them, d between levels l - b and l, the error of the finest: d/(2^(p b) - 1). p is kept
 * within bounds, quantity by quantity, and from four answers on no more than 1 unless the last two
 * orders agree that it is: with a high one a long way is soon taken for gone. With one difference
 * only it is taken for 1. A difference may be small by chance: it is taken for no less than what
 * the one before leaves at order 3 (the second one at order 2), unless the two answers are the same
 * but for rounding.
 *
 * Where the order jumps by more than 0.75 from one pair of differences to the next, as it does
 * where instants of slip and stick fall now here, now there between instants, the error is C_l h
 * with a C_l that is anything up to some bound. From then on the estimate is no less than what the
 * largest of all differences would have become at order 1, and no level is left out. Histories of
 * friction, whose directions depend on where increments end, are of order 1 at best: of those the
 * estimate is never less than half of that, and no level is left out either.
 */
class Convergence {
public:
  /// What is known of the order beforehand: nothing; that it does not jump; that it is 1 at best.
  enum class Order { unknown, regular, first_at_best };

  explicit Convergence(const Order kind = Order::unknown) : kind(kind) {}

  /// @param differences of all quantities between the answers at levels @p coarse and @p fine
  void add(const unsigned int coarse, const unsigned int fine,
           const std::vector<Difference> &differences);

  /// Of the finest answer, of all quantities; nan before there is a difference.
  double estimate() const;
  /// Whether the orders are more than a guess.
  bool knows_orders() const { return n >= 2; }
  /// How many levels finer the answer has to be for the estimate to be @p tolerance, at least one;
  /// one as long as the orders are not known.
  unsigned int levels_to(const double tolerance) const;

private:
  struct Sequence {
    double last = 0., scale = 1.; ///< difference, relative to the scale
    double measured = 1., order = 1., estimate = 0.;
    double envelope = 0.; ///< of the differences, each halved from level to level
    bool irregular = false;
  };
  Order kind;
  std::vector<Sequence> quantities;
  unsigned int n = 0;                          ///< differences so far that tell something new
  unsigned int last_coarse = 0, last_fine = 0; ///< levels of the last one
};

} // namespace frictionbeam::accuracy
