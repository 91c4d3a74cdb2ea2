// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/case_starts.h"

namespace frictionbeam::study {

CaseStarts::CaseStarts(const Model &model) : LinearStatics(model), line(model) {
  LinearStatics::transfer(unused);
}

bool CaseStarts::begin() {
  alone = is_case = false;
  line.begin();
  return !line.may_jam();
}

void CaseStarts::begin_case() {
  begin();
  is_case = true;
}

void CaseStarts::begin_alone() {
  alone = true;
  Archive fresh(unused.bytes());
  LinearStatics::transfer(fresh);
}

EquilibriumResult CaseStarts::solve(const LineState &from, const StaticIncrement &increment,
                                    LineState &to, ContactResponse &response) {
  if (alone)
    return LinearStatics::solve(from, increment, to, response);
  const Times times{from.time, increment.time};
  EquilibriumResult result;
  if (const auto found = of_case.find(times); found != of_case.end() && !is_case) {
    StaticIncrement near = increment;
    near.nearby = &found->second;
    result = line.solve(from, near, to, response);
  }
  if (!result.converged)
    result = line.solve(from, increment, to, response);
  if (result.converged && is_case)
    of_case[times] = line.last_solution();
  result.rounding_bars = !result.converged; // no halves: the run is made alone
  return result;
}

void CaseStarts::transfer(Archive &archive) {
  if (alone)
    LinearStatics::transfer(archive);
  else
    line.transfer(archive);
}

} // namespace frictionbeam::study
