// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/support_quantities.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace frictionbeam {

namespace {

constexpr unsigned int n_quantities(const QuantityKind::Of of) {
  unsigned int n = 0;
  for (const QuantityKind &kind : quantity_kinds)
    n += kind.of == of ? 1 : 0;
  return n;
}
static_assert(n_quantities(QuantityKind::Of::support) == std::size(support_numbers),
              "each quantity of a support is one of its numbers");

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

double value_of_supports(const std::vector<SupportInfo> &infos,
                         const std::vector<SupportState> &states, const QuantityKind &kind) {
  enum Component : unsigned int { normal, friction, sticking, slipping, open, zone };
  const auto component = static_cast<Component>(kind.component); // in the order of quantity_kinds
  if (component == zone)
    return slip_length(infos, states);
  double sum = 0.;
  for (const SupportState &support : states)
    sum += component == normal     ? std::abs(support.fn)
           : component == friction ? std::hypot(support.ft1, support.ft2)
           : component == sticking ? support.status == ContactStatus::stick
           : component == slipping ? support.status == ContactStatus::slip
                                   : support.status == ContactStatus::open;
  return sum;
}

} // namespace frictionbeam
