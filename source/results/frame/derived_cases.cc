// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/derived_cases.h"
#include "base/numbers.h"
#include "results/frame/cells_of_modes.h"
#include "results/frame/frame_builder.h"
#include "results/frame/frame_choice.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Call a function with every number of a frame that can be combined.
template <typename AnyFrame, typename Function>
void for_each_number(AnyFrame &frame, const Function &function) {
  for (auto &station : frame.line) {
    for (auto &value : station.displacement)
      function(value);
    for (auto &value : station.force)
      function(value);
  }
  for (auto &support : frame.supports)
    for (unsigned int i = 0; i < n_shown_support_numbers; ++i)
      function(support.*support_numbers[i]);
  for (auto &reaction : frame.reactions)
    for (auto &value : reaction)
      function(value);
  for (auto &support : frame.supports)
    for (auto &value : support.on_pipe)
      function(value);
  for (auto &sum : frame.together) {
    for (unsigned int i = 0; i < n_shown_support_numbers; ++i)
      function(sum.*support_numbers[i]);
    for (auto &value : sum.on_pipe)
      function(value);
  }
}

} // namespace

Vector numbers_of(const Frame &frame) {
  std::vector<double> list;
  for_each_number(frame, [&](const double value) { list.push_back(value); });
  return Eigen::Map<const Vector>(list.data(), list.size());
}

Frame with_numbers(Frame frame, const Vector &numbers) {
  Eigen::Index i = 0;
  for_each_number(frame, [&](double &value) { value = numbers[i++]; });
  AssertDimension(i, numbers.size());
  return frame;
}

void add_modes(const Model &model, const ModalAnalysis &analysis, Results &results) {
  FrameBuilder builder(model, true);
  std::array<Vector, 3> inertia;
  for (unsigned int d = 0; d < 3; ++d) {
    inertia[d] = analysis.inertia(analysis.support_motion(d, {}));
    results.total_mass[d] = analysis.total_mass(d);
  }
  results.modal_method = analysis.method();
  for (unsigned int k = 0; k < analysis.modes().size(); ++k) {
    const Mode &mode = analysis.modes()[k];
    ModeResult result;
    result.frequency = mode.frequency;
    result.residual = mode.residual;
    result.by_cells = frequency_error_of_cells(model, analysis.motion(k),
                                               2. * dealii::numbers::PI * mode.frequency);
    for (unsigned int d = 0; d < 3; ++d) {
      result.participation[d] = mode.unknowns.dot(inertia[d]);
      result.effective_mass[d] = result.participation[d] * result.participation[d];
    }
    const ModalAnalysis::Vibration vibration = analysis.of_mode(k);
    result.shape = builder.make(vibration.state, vibration.accelerations);
    const double largest = largest_motion(result.shape);
    if (largest > 0.)
      for_each_number(result.shape, [&](double &value) { value /= largest; });
    results.modes.push_back(result);
  }
}

void become_case(Frame &frame, const bool is_amplitude) {
  frame.is_amplitude = is_amplitude;
  for (SupportState &support : frame.supports)
    support.status = ContactStatus::none;
}

Frame with_other_sign(const Frame &frame) { return with_numbers(frame, -numbers_of(frame)); }

void widen(Frame &least, Frame &largest, const Frame &frame) {
  const Vector numbers = numbers_of(frame), smaller = numbers_of(least).cwiseMin(numbers),
               larger = numbers_of(largest).cwiseMax(numbers);
  least = with_numbers(std::move(least), smaller);
  largest = with_numbers(std::move(largest), larger);
}

std::vector<NumberBounds> bounds_of(const Combination &combination,
                                    const std::vector<CaseRange> &cases) {
  AssertDimension(cases.size(), combination.cases.size());
  std::vector<NumberBounds> bounds;
  for (unsigned int i = 0; i < cases.size(); ++i) {
    const double factor = combination.cases[i].second;
    const Vector one = factor * numbers_of(*cases[i].least),
                 other = factor * numbers_of(*cases[i].largest);
    bounds.push_back({one.cwiseMin(other), one.cwiseMax(other)});
  }
  return bounds;
}

Frame combine(const Combination &combination, const std::vector<CaseRange> &cases,
              CombinationRange *const range) {
  using Kind = Combination::Kind;
  const std::vector<NumberBounds> parts = bounds_of(combination, cases);
  const auto size = [](const NumberBounds &part) {
    return Vector(part.least.cwiseAbs().cwiseMax(part.largest.cwiseAbs()));
  };
  Vector least = parts.front().least, most = parts.front().largest, sum = size(parts.front());
  const bool is_sum = combination.kind == Kind::sum, is_srss = combination.kind == Kind::srss;
  if (is_srss)
    sum = sum.cwiseAbs2();
  for (unsigned int i = 1; i < parts.size(); ++i) {
    least = is_sum ? Vector(least + parts[i].least) : Vector(least.cwiseMin(parts[i].least));
    most = is_sum ? Vector(most + parts[i].largest) : Vector(most.cwiseMax(parts[i].largest));
    sum += is_srss ? Vector(size(parts[i]).cwiseAbs2()) : size(parts[i]);
  }
  if (is_srss)
    sum = sum.cwiseSqrt().eval();
  if (combination.kind == Kind::range || is_srss || combination.kind == Kind::absolute) {
    most = combination.kind == Kind::range ? Vector(most - least) : sum;
    least = -most; // a size, of either sign
  } else if (combination.kind == Kind::maximum)
    least = most;
  else if (combination.kind == Kind::minimum)
    most = least;
  const Vector larger = (least.cwiseAbs().array() > most.cwiseAbs().array()).select(least, most);
  Frame frame = *cases.back().least;
  frame.sections.clear(); // what flows does not add up
  frame.end_of_step = true;
  become_case(frame, !is_sum);
  if (range != nullptr) {
    range->least = with_numbers(frame, least);
    range->largest = with_numbers(frame, most);
  }
  return with_numbers(frame, larger);
}

} // namespace frictionbeam
