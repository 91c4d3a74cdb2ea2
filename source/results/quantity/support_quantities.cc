// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/support_quantities.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam {

namespace {

/// Each support stands for the length to midway between it and its neighbours, the first that does
/// not slip for as much of it as its share of the friction per length of the last that does.
double slip_length(const std::vector<SupportInfo> &infos, const std::vector<SupportState> &states) {
  const std::size_t n = infos.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  const auto x = [&](const std::size_t place) { return infos[order[place]].position[0]; };
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return infos[a].position[0] < infos[b].position[0];
  });
  std::size_t m = 0; // place of the first that does not slip
  while (m < n && states[order[m]].status == ContactStatus::slip)
    ++m;
  if (m == 0 || m == n)
    return m == 0 ? 0. : x(n - 1) - x(0);
  // A support stands for the length to midway between it and its neighbours.
  const auto end_of = [&](const std::size_t place) {
    return place + 1 < n ? 0.5 * (x(place) + x(place + 1)) : x(place);
  };
  const auto friction = [&](const std::size_t place) { // per length
    const SupportState &state = states[order[place]];
    const double length = end_of(place) - (place > 0 ? end_of(place - 1) : x(0));
    return length > 0. ? std::hypot(state.ft1, state.ft2) / length : 0.;
  };
  const double bound = friction(m - 1);
  const double part = bound > 0. ? std::min(1., friction(m) / bound) : 0.;
  return end_of(m - 1) + part * (end_of(m) - end_of(m - 1)) - x(0);
}

} // namespace

double support_value(const SupportState &support, const std::string &what) {
  return what == "fn"      ? support.fn
         : what == "ft1"   ? support.ft1
         : what == "ft2"   ? support.ft2
         : what == "gap"   ? support.gap
         : what == "slip1" ? support.slip1
         : what == "slip2" ? support.slip2
         : what == "mt"    ? support.mt
         : what == "wear"  ? support.wear
         : what == "work"  ? support.work_friction
                           : support.impulse;
}

double value_of_supports(const std::vector<SupportInfo> &infos,
                         const std::vector<SupportState> &states, const std::string &what) {
  if (what == "slip_length")
    return slip_length(infos, states);
  double sum = 0.;
  for (const SupportState &support : states)
    sum += what == "sum_normal"     ? std::abs(support.fn)
           : what == "sum_friction" ? std::hypot(support.ft1, support.ft2)
           : what == "n_stick"      ? support.status == ContactStatus::stick
           : what == "n_slip"       ? support.status == ContactStatus::slip
                                    : support.status == ContactStatus::open;
  return sum;
}

} // namespace frictionbeam
