// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support_quantities.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam {

double support_value(const SupportState &support, const std::string &what) {
  return what == "fn"      ? support.fn
         : what == "ft1"   ? support.ft1
         : what == "ft2"   ? support.ft2
         : what == "gap"   ? support.gap
         : what == "slip1" ? support.slip1
         : what == "slip2" ? support.slip2
         : what == "wear"  ? support.wear
         : what == "work"  ? support.work_friction
                           : support.impulse;
}

double sum_over_supports(const std::vector<SupportState> &supports, const std::string &what) {
  double sum = 0.;
  for (const SupportState &support : supports)
    sum += what == "sum_normal"     ? std::abs(support.fn)
           : what == "sum_friction" ? std::hypot(support.ft1, support.ft2)
           : what == "n_stick"      ? support.status == ContactStatus::stick
           : what == "n_slip"       ? support.status == ContactStatus::slip
                                    : support.status == ContactStatus::open;
  return sum;
}

double slip_length(const std::vector<SupportInfo> &infos, const std::vector<SupportState> &states) {
  std::vector<unsigned int> order(infos.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
    return infos[a].position[0] < infos[b].position[0];
  });
  const auto stuck = std::find_if(order.begin(), order.end(), [&](const unsigned int i) {
    return states[i].status != ContactStatus::slip;
  });
  if (stuck == order.begin())
    return 0.;
  const double last = infos[*(stuck - 1)].position[0],
               next = stuck == order.end() ? last : infos[*stuck].position[0];
  return 0.5 * (last + next) - infos[order.front()].position[0];
}

} // namespace frictionbeam
