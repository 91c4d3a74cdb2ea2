// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * A number that depends on time: an expression in t or a table, linear between its instants. What
 * is not given is the constant 1. Its time counts from where HistoryOrigins says.
 */
struct TimeFunction {
  enum class Clock {
    step, ///< from the beginning of the steps in which it acts
    run   ///< from the beginning of the run
  };

  std::string text;                           ///< as given; empty: the constant
  std::function<double(const double)> course; ///< null: the constant
  std::vector<double> breaks; ///< ascending instants at which it or its derivative may jump [s]
  Clock clock = Clock::step;
  /// First instant of a table, before which it is zero; an expression has none [s].
  double begins = -std::numeric_limits<double>::infinity();

  bool is_given() const { return static_cast<bool>(course); }
  /// @throws UserError if the expression has no finite value then
  double operator()(const double time) const;
  /// At a jump, to rounding and within @p reach, its value before or after it.
  double before(const double time, const double reach = 0.) const;
  double after(const double time, const double reach = 0.) const;
};

/// Words of the clocks, whose meanings stand with the entries.
inline constexpr Word<TimeFunction::Clock> clocks[] = {{"step", TimeFunction::Clock::step},
                                                       {"run", TimeFunction::Clock::run}};

class ParameterReader;

/// The form of such an entry, in words.
extern const char *const time_function_form;

/**
 * "sin(2*pi*t)", "table 0 0, 0.1 1, 0.1 0" (an instant twice is a jump), or "file NAME" with two
 * columns, from the parameter file's folder. Zero before a table's beginning and its last value
 * after its end.
 * @param unit of its values, in SI units
 * @throws UserError
 */
TimeFunction parse_time_function(const ParameterReader &in, const std::string &entry,
                                 const std::string &text, const double unit = 1.);

} // namespace frictionbeam
