// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

namespace frictionbeam::contact {

/// Tells when a limit of time has passed, from its construction on, by the clock on the wall.
class Clock {
public:
  /// @param limit [s]
  explicit Clock(const double limit) : limit(limit) {}

  bool is_over() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return passed.count() >= limit;
  }

private:
  const double limit;
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

} // namespace frictionbeam::contact
