// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <random>

/// Numbers drawn by a seed, the same on every machine.
class Random {
public:
  explicit Random(const unsigned int seed) : engine(seed * 7919u + 13u) {}
  double number(const double low, const double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) / 9007199254740992.;
  }
  int whole(const int low, const int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned long>(high - low + 1));
  }
  bool chance(const double p) { return number(0., 1.) < p; }

private:
  std::mt19937_64 engine;
};
