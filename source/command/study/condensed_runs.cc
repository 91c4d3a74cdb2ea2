// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/condensed_runs.h"

namespace frictionbeam::study {

CondensedRuns::CondensedRuns(const Model &model) : LinearStatics(model), line(model) {
  LinearStatics::transfer(unused);
}

bool CondensedRuns::begin() {
  alone = false;
  line.begin();
  return !line.may_jam();
}

void CondensedRuns::begin_alone() {
  alone = true;
  Archive fresh(unused.bytes());
  LinearStatics::transfer(fresh);
}

EquilibriumResult CondensedRuns::solve(const LineState &from, const StaticIncrement &increment,
                                       LineState &to, ContactResponse &response) {
  if (alone)
    return LinearStatics::solve(from, increment, to, response);
  EquilibriumResult result = line.solve(from, increment, to, response);
  result.rounding_bars = !result.converged; // no halves: the run is made alone
  return result;
}

void CondensedRuns::transfer(Archive &archive) {
  if (alone)
    LinearStatics::transfer(archive);
  else
    line.transfer(archive);
}

} // namespace frictionbeam::study
