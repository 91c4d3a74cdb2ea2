// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/run_results.h"

#include "results/report/report_study.h"
#include "results/text.h"

#include <algorithm>

namespace frictionbeam::study {

namespace {

using Of = ResultName::Of;

constexpr const char *components[] = {"fx", "fy", "fz", "mx", "my", "mz"};

/// Call use(of, name, step, unit, component, number) for each.
template <typename Use>
void for_each_quantity(const Results &results, const Use &use) {
  for (const QuantityResult &quantity : results.quantities)
    use(Of::quantity, quantity.name, "", quantity.unit.c_str(), 0, quantity.value);
}

template <typename Use>
void for_each_force(const Results &results, const Use &use) {
  const std::vector<double> largest = largest_forces(results);
  const std::size_t n = results.supports.size();
  for (std::size_t i = 0; i < largest.size(); ++i)
    use(Of::force, i < n ? results.supports[i].name : results.restraints[i - n].name, "", "N", 0,
        largest[i]);
}

template <typename Use>
void for_each_use(const Results &results, const Use &use) {
  for (std::size_t i = 0; i < results.nozzles.size(); ++i) {
    const NozzleUse &first = results.nozzles[i];
    const auto is_same = [&](const NozzleUse &other) {
      return other.name == first.name && other.support == first.support;
    };
    if (std::any_of(results.nozzles.begin(), results.nozzles.begin() + i, is_same))
      continue;
    double largest = 0.;
    for (const NozzleUse &other : results.nozzles)
      if (is_same(other))
        largest = std::max(largest, other.utilization);
    use(Of::nozzle, first.name + " at " + first.support, "", "-", 0, largest);
  }
  for (const StressCase &one : results.stresses)
    use(Of::stress, one.kind + " " + one.name, "", "-", 0,
        one.stress.empty() ? 0. : one.stress[one.worst] / one.allowed[one.worst]);
}

template <typename Use>
void for_each_of_steps(const Results &results, const Use &use) {
  for (const Frame &frame : results.frames) {
    if (!frame.end_of_step)
      continue;
    for (std::size_t i = 0; i < frame.supports.size(); ++i) {
      const std::string &name = results.supports[i].name;
      const SupportState &state = frame.supports[i];
      use(Of::normal, name, frame.name, "N", 0, state.fn);
      use(Of::friction, name, frame.name, "N", 0, friction_force(state));
      use(Of::status, name, frame.name, "-", 0, static_cast<double>(state.status));
    }
    for (std::size_t i = 0; i < frame.reactions.size(); ++i)
      for (unsigned int c = 0; c < 6; ++c)
        use(Of::reaction, results.restraints[i].name, frame.name, c < 3 ? "N" : "N m", c,
            frame.reactions[i][c]);
  }
}

template <typename Use>
void for_each(const Results &results, const Use &use) {
  for_each_quantity(results, use);
  for_each_force(results, use);
  for_each_use(results, use);
  for_each_of_steps(results, use);
}

} // namespace

std::string column_name(const ResultName &name) {
  const std::string in_step = name.name + ", step " + name.step;
  switch (name.of) {
  case Of::quantity:
    return "quantity " + name.name;
  case Of::force:
    return "force " + name.name;
  case Of::nozzle:
    return "nozzle " + name.name;
  case Of::stress:
    return "stress " + name.name;
  case Of::normal:
    return "normal " + in_step;
  case Of::friction:
    return "friction " + in_step;
  case Of::status:
    return "status " + in_step;
  case Of::reaction:
    break;
  }
  return std::string(components[name.component]) + " " + in_step;
}

std::vector<ResultName> names_of(const Results &results) {
  std::vector<ResultName> names;
  for_each(results, [&](const Of of, const std::string &name, const std::string &step,
                        const char *const unit, const unsigned int component, const double) {
    names.push_back({of, name, step, unit, component});
  });
  return names;
}

bool has_names(const Results &results, const std::vector<ResultName> &names) {
  std::size_t n = 0;
  bool are_equal = true;
  for_each(results, [&](const Of of, const std::string &name, const std::string &step, const char *,
                        const unsigned int component, const double) {
    are_equal = are_equal && n < names.size() && names[n].of == of && names[n].name == name &&
                names[n].step == step && names[n].component == component;
    ++n;
  });
  return are_equal && n == names.size();
}

std::vector<double> numbers_of(const Results &results) {
  std::vector<double> numbers;
  for_each(results, [&](const Of, const std::string &, const std::string &, const char *,
                        const unsigned int, const double number) { numbers.push_back(number); });
  return numbers;
}

} // namespace frictionbeam::study
