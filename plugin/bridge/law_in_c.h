// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>
#include <frictionbeam/law_c.h>

#include <string>
#include <vector>

namespace frictionbeam {

/**
 * A law in C as one in C++. If the law has a state to begin with, one more internal variable, the
 * last, says whether it has begun: 0 at first, as the program gives it, then 1.
 */
class LawInC final : public LawBase {
public:
  /// @param law passed faults_of_law_in_c(), and outlives this.
  explicit LawInC(const frictionbeam_c_law &law);
  LawInC(const LawInC &) = delete;
  LawInC &operator=(const LawInC &) = delete;

  LawStatus integrate(const LawInput &input, LawOutput &output) const noexcept override;

  const LawDescription &description() const { return of_law; }
  bool is_of(const frictionbeam_c_law &other) const { return &law == &other; }

private:
  const frictionbeam_c_law &law;
  std::vector<LawParameter> parameters;
  LawDescription of_law;
};

/**
 * What makes a law in C impossible to describe in C++: null, another version, another size, its own
 * fault, no integrate(), figures that are not finite, a first state beside a closed form. All else
 * LawLibrary checks as of any law.
 * @return what was found, expected, and what to try; empty if nothing is wrong.
 */
std::string faults_of_law_in_c(const frictionbeam_c_law *law);

} // namespace frictionbeam
