// SPDX-License-Identifier: LGPL-2.1-or-later
// Convergence shall find the error of sequences C 2^(-p l), whatever the levels, and be careful
// with others.
#include "accuracy/convergence.h"
#include "check.h"

#include <cmath>

namespace {

using frictionbeam::accuracy::Convergence;
using Level = unsigned int;

double error(const double order, const Level level) { return std::pow(2., -order * level); }

/// Add the difference of two answers whose errors fall at an order.
void add(Convergence &convergence, const double order, const Level coarse, const Level fine) {
  convergence.add(coarse, fine, {{error(order, coarse) - error(order, fine), "u", 1.}});
}

void known_orders() {
  for (const double order : {0.5, 1., 1.5, 2.}) {
    Convergence by_one;
    add(by_one, order, 0, 1);
    CHECK(!by_one.knows_orders());
    CHECK_NEAR(by_one.estimate(), 1. - error(order, 1), 1e-12); // order 1 is assumed
    add(by_one, order, 1, 2);
    CHECK(by_one.knows_orders());
    CHECK_NEAR(by_one.estimate(), error(order, 2), 1e-6);
    add(by_one, order, 2, 5);
    CHECK_NEAR(by_one.estimate(), error(order, 5), 1e-6);

    Convergence apart; // the last level of each, as if others had been refined in between
    add(apart, order, 0, 1);
    add(apart, order, 2, 3);
    CHECK_NEAR(apart.estimate(), error(order, 3), 1e-6);
    add(apart, order, 2, 3); // the same level again tells nothing of the order
    CHECK_NEAR(apart.estimate(), error(order, 3), 1e-6);
  }
}

void levels() {
  Convergence convergence;
  CHECK(std::isnan(convergence.estimate()));
  add(convergence, 1., 0, 1);
  CHECK(convergence.levels_to(1e-3) == 1);
  add(convergence, 1., 1, 2); // estimate 0.25
  CHECK(convergence.levels_to(0.2) == 1);
  CHECK(convergence.levels_to(0.1) == 2);
  CHECK(convergence.levels_to(1e-6) == 2); // and see
}

void careful() {
  Convergence high; // order 1, then by chance 2: one witness is not enough, order 1 is taken on
  high.add(0, 1, {{1., "u", 1.}});
  high.add(1, 2, {{0.5, "u", 1.}});
  high.add(2, 3, {{0.125, "u", 1.}});
  CHECK_NEAR(high.estimate(), 0.25, 1e-6);
  CHECK(high.levels_to(1e-6) == 1); // of what is irregular no level is left out

  // Displacement of stick and slip by moreau_jean, random line 12 of random_accuracy.py, at steps
  // of a 64th, ... of the motion: the error after the sixth difference, 0.0037, is not that
  // difference.
  Convergence stick_slip;
  const double u[] = {0.8, 0.31, 0.17, 7.3e-4, 0.058, 2.2e-3};
  for (unsigned int l = 0; l < 6; ++l)
    stick_slip.add(l, l + 1, {{u[l], "u", 1.}});
  CHECK(stick_slip.estimate() > 0.014);

  Convergence chance; // a small difference is no proof
  chance.add(0, 1, {{1., "u", 1.}});
  chance.add(1, 2, {{1e-6, "u", 1.}});
  CHECK(chance.estimate() > 0.01);

  Convergence same; // but for rounding
  same.add(0, 1, {{1e-13, "u", 1.}});
  same.add(1, 2, {{1e-13, "u", 1.}});
  CHECK(same.estimate() == 0.);

  Convergence scaled; // the value that differences are relative to may shrink
  scaled.add(0, 1, {{0.5, "u", 2.}});
  scaled.add(1, 2, {{0.5, "u", 1.}});
  CHECK_NEAR(scaled.estimate(), 0.5, 1e-6);

  Convergence worst; // of all quantities
  worst.add(0, 1, {{0.1, "u", 1.}, {std::nan(""), "v", 1.}});
  CHECK(std::isnan(worst.estimate()));
}

} // namespace

int main() {
  known_orders();
  levels();
  careful();
  return check::report();
}
