// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <iomanip>
#include <iostream>

/// Checks for tests: a failed one prints what was found and makes report() return 1.
namespace check {

inline int n_checks = 0, n_failures = 0;

inline bool count(const bool passed, const char *file, const int line) {
  ++n_checks;
  if (passed)
    return true;
  // A loop that fails in every turn need not fill the log.
  if (++n_failures > 50)
    return true;
  std::cerr << file << ':' << line << ": ";
  return false;
}

inline void truth(const bool condition, const char *text, const char *file, const int line) {
  if (!count(condition, file, line))
    std::cerr << "not true: " << text << '\n';
}

/// Within @p tolerance times the reference, or times 1 if the reference is 0.
inline void near(const double value, const double reference, const double tolerance,
                 const char *text, const char *file, const int line) {
  const double scale = reference == 0. ? 1. : std::abs(reference);
  if (!count(std::abs(value - reference) <= tolerance * scale, file, line))
    std::cerr << std::setprecision(17) << text << " = " << value << ", expected " << reference
              << " within " << tolerance * scale << '\n';
}

/// The exit status of the test.
inline int report() {
  std::cout << n_checks - n_failures << " of " << n_checks << " checks passed\n";
  return n_checks > 0 && n_failures == 0 ? 0 : 1;
}

} // namespace check

#define CHECK(condition) check::truth(condition, #condition, __FILE__, __LINE__)
#define CHECK_NEAR(value, reference, tolerance)                                                    \
  check::near(value, reference, tolerance, #value, __FILE__, __LINE__)
