// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

namespace frictionbeam::generated {

/**
 * Random numbers that are the same on every machine, which those of the standard's distributions
 * need not be: splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014). Do not draw two in one
 * expression: the order would be the compiler's choice.
 */
class RandomNumbers {
public:
  explicit RandomNumbers(const std::uint64_t seed) : state(seed) {}

  /// Evenly from @p low to @p high.
  double uniform(const double low, const double high) {
    return low + (high - low) * (next() >> 11) * 0x1p-53;
  }

  /// One of 0 .. n-1; n is small, so that the remainder's bias does not matter.
  unsigned int below(const unsigned int n) { return next() % n; }

  /// True in one case out of @p n.
  bool one_in(const unsigned int n) { return below(n) == 0; }

  template <typename T, std::size_t n>
  const T &one_of(const std::array<T, n> &choices) {
    return choices[below(n)];
  }

private:
  std::uint64_t next() {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state;
};

} // namespace frictionbeam::generated
