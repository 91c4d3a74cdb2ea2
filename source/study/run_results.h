// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::study {

/// What one number of a run's results is.
struct ResultName {
  enum class Of {
    quantity, ///< as named, in its own unit
    force,    ///< of a support or restraint, the largest size over all steps [N]
    nozzle,   ///< largest part that is used of what a nozzle limit allows
    stress,   ///< the same of a stress case
    normal,   ///< of a support at a step's end [N]
    friction, ///< size, likewise [N]
    status,   ///< likewise; a ContactStatus as a number
    reaction  ///< of a restraint at a step's end, one component [N, N m]
  };
  Of of = Of::quantity;
  std::string name; ///< of the quantity, support, limit or case
  std::string step; ///< where it is of one
  std::string unit;
  unsigned int component = 0; ///< of a reaction: fx, fy, fz, mx, my, mz

  bool operator==(const ResultName &other) const {
    return of == other.of && name == other.name && step == other.step &&
           component == other.component;
  }
  /// Whether it is one for the whole run, and not one of many for each step.
  bool is_of_the_run() const { return of < Of::normal; }
  bool is_a_word() const { return of == Of::status; }
};

/// As the heading of a column: "quantity used", "force west.1", "normal west.1, step hot".
std::string column_name(const ResultName &name);

/// What a run's results say, in an order that equal scenes have in common.
std::vector<ResultName> names_of(const Results &results);
bool has_names(const Results &results, const std::vector<ResultName> &names);
/// The numbers to these names.
std::vector<double> numbers_of(const Results &results);

} // namespace frictionbeam::study
