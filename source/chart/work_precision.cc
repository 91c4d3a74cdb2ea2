// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart/work_precision.h"

#include "base/user_error.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace frictionbeam::chart {

namespace {

std::size_t curve_named(const ChartList &list, const std::string &name) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < list.curves.size(); ++c) {
    if (list.curves[c].name == name)
      return c;
    names.push_back(list.curves[c].name);
  }
  throw UserError(list.name + ": entry 'Advice'\n  read:    the curve '" + name +
                  "'\n  allowed: " + join(names) + "\n  try:     one of these");
}

/// What stands for the words between two braces.
std::string figure(const ChartList &list, const std::vector<Measurement> &measurements,
                   const std::string &text) {
  const std::vector<std::string> words = split(text, ' ');
  double accuracy = 0.;
  const auto time = [&](const std::string &curve) {
    const auto found = cheapest(measurements, accuracy, curve_named(list, curve));
    return found ? std::optional<double>(measurements[*found].median()) : std::nullopt;
  };
  const std::size_t n = words.size();
  if (n == 2 && words[0] == "error") {
    const std::size_t curve = curve_named(list, words[1]);
    double least = std::numeric_limits<double>::infinity();
    for (const Measurement &one : measurements)
      if (one.curve == curve && one.solved())
        least = std::min(least, one.error);
    return std::isfinite(least) ? rounded_number(least, 2) : "(no answer)";
  }
  if (n >= 2 && to_number(words[n - 1], accuracy)) {
    if (n == 2 && words[0] == "best") {
      const auto found = cheapest(measurements, accuracy);
      return found ? name_of(list, measurements[*found]) + " (" +
                         readable_time(measurements[*found].median()) + ")"
                   : "(none)";
    }
    if (n == 3 && words[0] == "time") {
      const auto seconds = time(words[1]);
      return seconds ? readable_time(*seconds) : "(not reached)";
    }
    if (n == 4 && words[0] == "ratio") {
      const auto one = time(words[1]), other = time(words[2]);
      return one && other ? rounded_number(*one / *other, 2) : "(not reached)";
    }
  }
  throw UserError(list.name + ": entry 'Advice'\n  read:    {" + text +
                  "}\n  allowed: {best 1e-3}, {error CURVE}, {time CURVE 1e-3}, {ratio CURVE OTHER "
                  "1e-3}\n  try:     one of these");
}

} // namespace

std::vector<std::size_t> efficient_front(const std::vector<Measurement> &measurements) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < measurements.size(); ++i)
    if (measurements[i].solved())
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return measurements[a].median() < measurements[b].median();
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || measurements[i].error < 0.99 * measurements[front.back()].error)
      front.push_back(i);
  return front;
}

std::optional<std::size_t> cheapest(const std::vector<Measurement> &measurements,
                                    const double accuracy, const std::optional<std::size_t> curve) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < measurements.size(); ++i)
    if (measurements[i].solved() && measurements[i].error <= accuracy &&
        (!curve || measurements[i].curve == *curve) &&
        (!best || measurements[i].median() < measurements[*best].median()))
      best = i;
  return best;
}

std::string name_of(const ChartList &list, const Measurement &measurement) {
  const Curve &curve = list.curves[measurement.curve];
  std::string name = curve.label;
  const std::vector<std::string> words = split(measurement.setting, ' ');
  for (std::size_t i = 0; i < words.size(); ++i)
    name += ", " + (i < curve.varied.size() ? curve.varied[i] + " = " : "") + words[i];
  return name;
}

std::string filled_advice(const ChartList &list, const std::vector<Measurement> &measurements) {
  std::string text = list.advice;
  for (std::size_t open; (open = text.find('{')) != std::string::npos;) {
    const std::size_t close = text.find('}', open);
    const std::string words =
        text.substr(open + 1, close == std::string::npos ? close : close - open - 1);
    text.replace(open, words.size() + 2, figure(list, measurements, words));
  }
  return text;
}

std::string readable_time(const double seconds) {
  if (!std::isfinite(seconds))
    return "-";
  return seconds < 1e-3   ? rounded_number(1e6 * seconds, 2) + " us"
         : seconds < 1.   ? rounded_number(1e3 * seconds, seconds < 0.1 ? 2 : 3) + " ms"
         : seconds < 300. ? rounded_number(seconds, seconds < 10. ? 2 : 3) + " s"
                          : rounded_number(seconds / 60., 3) + " min";
}

} // namespace frictionbeam::chart
