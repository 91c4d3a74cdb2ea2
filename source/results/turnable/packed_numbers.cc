// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/turnable/packed_numbers.h"
#include "results/text.h"

#include <cmath>
#include <cstdlib>

namespace frictionbeam {

using Json = nlohmann::ordered_json;

namespace {
constexpr double levels = 20000.;
} // namespace

Json rounded(const double value, const unsigned int digits) {
  return std::isfinite(value) ? Json(std::strtod(rounded_number(value, digits).c_str(), nullptr))
                              : Json();
}

Json packed(const std::vector<double> &values) {
  Largest largest;
  for (const double value : values)
    largest(value);
  const double step = std::strtod(rounded_number(largest.value() / levels, 7).c_str(), nullptr);
  Json differences = Json::array();
  long before = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      differences.push_back(nullptr);
      continue;
    }
    const long level = step > 0. ? std::lround(value / step) : 0;
    differences.push_back(level - before);
    before = level;
  }
  return {{"f", step}, {"d", differences}};
}

} // namespace frictionbeam
