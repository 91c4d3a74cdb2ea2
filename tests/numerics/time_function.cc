// SPDX-License-Identifier: LGPL-2.1-or-later
// Courses in time: a formula, a table that is linear between its instants, zero before and constant
// behind them, and a jump, which has a value before and one after it.
#include "../check.h"

#include "base/user_error.h"
#include "scene/file/parameter_reader.h"
#include "scene/time_function.h"

using namespace frictionbeam;

namespace {

TimeFunction course(const std::string &text, const double unit = 1.) {
  const ParameterReader in{ParameterFile()};
  return parse_time_function(in, "History", text, unit);
}

bool is_refused(const std::string &text) {
  try {
    course(text);
  } catch (const UserError &) {
    return true;
  }
  return false;
}

} // namespace

int time_function(int, char **) {
  CHECK(!course("").is_given());
  CHECK(course("")(3.) == 1.);
  CHECK_NEAR(course("sin(2*pi*t)")(0.125), std::sqrt(0.5), 1e-14);
  CHECK_NEAR(course("0.1*t", 1e-3)(5.), 5e-4, 1e-15); // values in mm

  const TimeFunction pulse = course("table 1 0, 2 4, 2 1, 3 1");
  CHECK(pulse(0.) == 0.);
  CHECK_NEAR(pulse(1.25), 1., 1e-14);
  CHECK_NEAR(pulse.before(2.), 4., 1e-12);
  CHECK(pulse.after(2.) == 1.);
  CHECK_NEAR(pulse.before(2. + 1e-13), 4., 1e-12); // the same instant to rounding
  CHECK_NEAR(pulse.before(1.5), pulse.after(1.5), 1e-15);
  CHECK(pulse(10.) == 1.);
  CHECK(pulse.begins == 1.);
  CHECK(pulse.breaks.size() == 3); // 1, 2, 3

  CHECK(is_refused("table 1 0, 0 4")); // back in time
  CHECK(is_refused("table 1"));
  CHECK(is_refused("sin(2*pi*t"));
  bool said = false;
  try {
    course("1/t")(0.);
  } catch (const UserError &) {
    said = true;
  }
  CHECK(said);
  return check::report();
}
