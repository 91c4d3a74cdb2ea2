// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/support_quantities.h"

#include "results/quantity/along_line.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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
  struct Row {
    Point3 position;
    const SupportState *state;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < infos.size(); ++i)
    rows.push_back({infos[i].position, &states[i]});
  const unsigned int axis = long_axis(rows);
  std::stable_sort(rows.begin(), rows.end(), [axis](const Row &a, const Row &b) {
    return a.position[axis] < b.position[axis];
  });
  const std::size_t n = rows.size();
  const std::vector<double> x = along_line(rows);
  std::size_t m = 0; // place of the first that does not slip
  while (m < n && rows[m].state->status == ContactStatus::slip)
    ++m;
  if (m == 0 || m == n)
    return m == 0 ? 0. : x[n - 1];
  // A support stands for the length to midway between it and its neighbours.
  const auto end_of = [&](const std::size_t place) {
    return place + 1 < n ? 0.5 * (x[place] + x[place + 1]) : x[place];
  };
  const auto friction = [&](const std::size_t place) { // per length
    const SupportState &state = *rows[place].state;
    const double length = end_of(place) - (place > 0 ? end_of(place - 1) : 0.);
    return length > 0. ? std::hypot(state.ft1, state.ft2) / length : 0.;
  };
  const double bound = friction(m - 1);
  const double part = bound > 0. ? std::min(1., friction(m) / bound) : 0.;
  return end_of(m - 1) + part * (end_of(m) - end_of(m - 1));
}

} // namespace

double value_of_supports(const std::vector<SupportInfo> &infos,
                         const std::vector<SupportState> &states, const QuantityKind &kind) {
  enum Component : unsigned int { normal, friction, sticking, slipping, open, zone };
  const auto component = static_cast<Component>(kind.component); // in the order of quantity_kinds
  if (component == zone)
    return slip_length(infos, states);
  Assert(component != normal && component != friction, dealii::ExcInternalError()); // in Frame
  unsigned int sum = 0;
  for (const SupportState &support : states)
    sum += support.status == (component == sticking   ? ContactStatus::stick
                              : component == slipping ? ContactStatus::slip
                                                      : ContactStatus::open);
  return sum;
}

} // namespace frictionbeam
