// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/derived_cases.h"
#include "base/numbers.h"
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

namespace {

/// Correlation of two modes of equal damping in the complete quadratic combination.
double correlation(const double a, const double b, const double damping) {
  const double r = std::min(a, b) / std::max(std::max(a, b), not_zero), z = damping * damping;
  return 8. * z * (1. + r) * std::pow(r, 1.5) /
         (std::pow(1. - r * r, 2) + 4. * z * r * (1. + r) * (1. + r));
}

/// Modes of one frequency are one eigenspace, of which any basis is as good as another. [first,
/// last)
std::vector<std::pair<unsigned int, unsigned int>> eigenspaces(const std::vector<Mode> &modes) {
  constexpr double as_good_as_equal = 1e-5; // relative; nothing but a symmetry brings them so near
  std::vector<std::pair<unsigned int, unsigned int>> result;
  for (unsigned int k = 0; k < modes.size(); ++k)
    if (k > 0 &&
        modes[k].frequency - modes[k - 1].frequency <= as_good_as_equal * modes[k].frequency)
      result.back().second = k + 1;
    else
      result.emplace_back(k, k + 1);
  return result;
}

/// Response in one direction, squared sums of modes and missing mass. Modes of one frequency
/// vibrate as one: what they do is added with its sign before anything is squared, so that it does
/// not depend on which of the eigenspace's bases was found.
class DirectionResponse {
public:
  DirectionResponse(const Model &model, const ModalAnalysis &analysis,
                    const std::vector<Vector> &shapes, FrameBuilder &builder)
      : model(model), settings(model.scene.response), analysis(analysis), shapes(shapes),
        builder(builder), spaces(eigenspaces(analysis.modes())) {}

  Vector operator()(const unsigned int d) {
    const auto &modes = analysis.modes();
    const unsigned int n = shapes.empty() ? 0 : shapes.front().size();
    std::vector<Vector> responses(spaces.size(), Vector::Zero(n)); // of each eigenspace
    Vector missing = Vector::Zero(n);
    for (const Spectrum &spectrum : model.scene.spectra) {
      if (spectrum.factor[d] == 0.)
        continue;
      const Vector inertia = analysis.inertia(analysis.support_motion(d, spectrum.supports));
      Vector left = inertia;
      for (unsigned int space = 0; space < spaces.size(); ++space) {
        Vector share = Vector::Zero(n);
        for (unsigned int k = spaces[space].first; k < spaces[space].second; ++k) {
          const double gamma = modes[k].unknowns.dot(inertia);
          const double square = std::pow(2. * dealii::numbers::PI * modes[k].frequency, 2);
          share += spectrum.factor[d] * gamma *
                   spectrum.at(modes[k].frequency, settings.logarithmic) / square * shapes[k];
          left -= gamma * analysis.momentum(k);
        }
        add(share, shapes[spaces[space].first], responses[space]);
      }
      if (settings.missing_mass) {
        const Frame rest = builder.make(analysis.displaced(analysis.solve(left)));
        const Vector response =
            spectrum.factor[d] * spectrum.curve.back().second * numbers_of(rest);
        if (settings.groups == SpectrumSettings::Sum::absolute)
          missing += response.cwiseAbs();
        else
          missing = (missing.cwiseAbs2() + response.cwiseAbs2()).cwiseSqrt();
      }
    }
    const Vector combined = over_modes(responses);
    return (combined.cwiseAbs2() + missing.cwiseAbs2()).cwiseSqrt();
  }

private:
  /// Groups are added by sizes; the signs are then those of the mode's shape.
  void add(const Vector &share, const Vector &shape, Vector &sum) const {
    const auto spectra = std::count_if(model.scene.spectra.begin(), model.scene.spectra.end(),
                                       [](const Spectrum &s) { return !s.supports.empty(); });
    if (spectra == 0) {
      sum += share; // keeps its sign, for the complete quadratic combination
      return;
    }
    const Vector size = settings.groups == SpectrumSettings::Sum::absolute
                            ? Vector(sum.cwiseAbs() + share.cwiseAbs())
                            : Vector((sum.cwiseAbs2() + share.cwiseAbs2()).cwiseSqrt());
    sum = (shape.array() < 0.).select(-size, size);
  }

  Vector over_modes(const std::vector<Vector> &responses) const {
    using Modes = SpectrumSettings::Modes;
    Vector sum = Vector::Zero(shapes.empty() ? 0 : shapes.front().size());
    if (settings.modes == Modes::absolute) {
      for (const Vector &response : responses)
        sum += response.cwiseAbs();
      return sum;
    }
    const auto &modes = analysis.modes();
    for (unsigned int i = 0; i < responses.size(); ++i)
      for (unsigned int j = settings.modes == Modes::srss ? i : 0;
           j < (settings.modes == Modes::srss ? i + 1 : responses.size()); ++j) {
        const double rho = i == j ? 1.
                                  : correlation(modes[spaces[i].first].frequency,
                                                modes[spaces[j].first].frequency, settings.damping);
        sum += rho * responses[i].cwiseProduct(responses[j]);
      }
    return sum.cwiseMax(0.).cwiseSqrt();
  }

  const Model &model;
  const SpectrumSettings &settings;
  const ModalAnalysis &analysis;
  const std::vector<Vector> &shapes; ///< numbers of the frames of the modes
  FrameBuilder &builder;
  const std::vector<std::pair<unsigned int, unsigned int>> spaces;
};

} // namespace

void add_modes(const Model &model, const ModalAnalysis &analysis, Results &results) {
  FrameBuilder builder(model, true);
  std::array<Vector, 3> inertia;
  for (unsigned int d = 0; d < 3; ++d) {
    inertia[d] = analysis.inertia(analysis.support_motion(d, {}));
    results.total_mass[d] = analysis.total_mass(d);
  }
  results.modal_method = analysis.method();
  for (const Mode &mode : analysis.modes()) {
    ModeResult result;
    result.frequency = mode.frequency;
    result.residual = mode.residual;
    for (unsigned int d = 0; d < 3; ++d) {
      result.participation[d] = mode.unknowns.dot(inertia[d]);
      result.effective_mass[d] = result.participation[d] * result.participation[d];
    }
    result.shape = builder.make(analysis.displaced(mode.unknowns));
    const double largest = largest_motion(result.shape);
    if (largest > 0.)
      for_each_number(result.shape, [&](double &value) { value /= largest; });
    results.modes.push_back(result);
  }
}

namespace {
/// What is made of states has none of its own.
void become_case(Frame &frame, const bool is_amplitude) {
  frame.is_amplitude = is_amplitude;
  for (SupportState &support : frame.supports)
    support.status = ContactStatus::none;
}
} // namespace

Frame spectrum_response(const Model &model, const ModalAnalysis &analysis) {
  FrameBuilder builder(model, true);
  std::vector<Vector> shapes;
  for (const Mode &mode : analysis.modes())
    shapes.push_back(numbers_of(builder.make(analysis.displaced(mode.unknowns))));
  Frame frame = builder.make(analysis.displaced(Vector::Zero(model.space.n_unknowns())));
  Vector sum = Vector::Zero(numbers_of(frame).size());
  const bool squares = model.scene.response.directions == SpectrumSettings::Sum::srss;
  DirectionResponse response(model, analysis, shapes, builder);
  for (unsigned int d = 0; d < 3; ++d) {
    const Vector one = response(d);
    if (one.size() > 0)
      sum += squares ? Vector(one.cwiseAbs2()) : one;
  }
  if (squares)
    sum = sum.cwiseSqrt().eval();
  frame.name = spectrum_case;
  become_case(frame, true);
  frame.step = model.scene.steps.size();
  return with_numbers(frame, sum);
}

Frame with_other_sign(const Frame &frame) { return with_numbers(frame, -numbers_of(frame)); }

void widen(Frame &least, Frame &largest, const Frame &frame) {
  const Vector numbers = numbers_of(frame);
  least = with_numbers(std::move(least), numbers_of(least).cwiseMin(numbers));
  largest = with_numbers(std::move(largest), numbers_of(largest).cwiseMax(numbers));
}

Frame combine(const Combination &combination, const std::vector<CaseRange> &cases,
              CombinationRange *const range) {
  using Kind = Combination::Kind;
  AssertDimension(cases.size(), combination.cases.size());
  std::vector<Vector> low, high, size; // of the parts, with their factors
  for (unsigned int i = 0; i < cases.size(); ++i) {
    const double factor = combination.cases[i].second;
    const Vector one = factor * numbers_of(*cases[i].least),
                 other = factor * numbers_of(*cases[i].largest);
    low.push_back(one.cwiseMin(other));
    high.push_back(one.cwiseMax(other));
    size.push_back(low.back().cwiseAbs().cwiseMax(high.back().cwiseAbs()));
  }
  Vector least = low.front(), most = high.front(), sum = size.front();
  const bool is_sum = combination.kind == Kind::sum, is_srss = combination.kind == Kind::srss;
  if (is_srss)
    sum = sum.cwiseAbs2();
  for (unsigned int i = 1; i < cases.size(); ++i) {
    least = is_sum ? Vector(least + low[i]) : Vector(least.cwiseMin(low[i]));
    most = is_sum ? Vector(most + high[i]) : Vector(most.cwiseMax(high[i]));
    sum += is_srss ? Vector(size[i].cwiseAbs2()) : size[i];
  }
  if (is_srss)
    sum = sum.cwiseSqrt().eval();
  if (combination.kind == Kind::range || is_srss || combination.kind == Kind::absolute) {
    most = combination.kind == Kind::range ? Vector(most - least) : sum;
    least = -most; // a size, of either sign
  }
  const Vector larger = (least.cwiseAbs().array() > most.cwiseAbs().array()).select(least, most);
  Frame frame = *cases.back().least;
  frame.sections.clear(); // what flows does not add up
  frame.end_of_step = true;
  become_case(frame,
              combination.kind == Kind::range || combination.kind == Kind::absolute || is_srss);
  if (range != nullptr) {
    range->least = with_numbers(frame, least);
    range->largest = with_numbers(frame, most);
  }
  return with_numbers(frame, larger);
}

} // namespace frictionbeam
