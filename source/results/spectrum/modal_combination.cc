// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/spectrum/modal_combination.h"

#include "base/numbers.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using Numbers = Eigen::VectorXd;

constexpr double close = 1.1 * (1. + 1e-12); ///< ratio of frequencies, of RG 1.92 rev. 1

/// R^2 = sum of share(i, j) times the product of the responses of both.
template <typename Share>
Numbers quadratic(const std::vector<Numbers> &responses, const bool of_sizes, const Share &share) {
  Numbers sum = Numbers::Zero(responses.front().size());
  for (std::size_t i = 0; i < responses.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double part = i == j ? 1. : 2. * share(i, j);
      if (part == 0.)
        continue;
      const Numbers product = responses[i].cwiseProduct(responses[j]);
      sum += part * (of_sizes ? Numbers(product.cwiseAbs()) : product);
    }
  return sum.cwiseMax(0.).cwiseSqrt();
}

/// The place of the lowest mode of each one's group.
std::vector<std::size_t> groups_of(const std::vector<double> &frequencies) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < frequencies.size(); ++i)
    first.push_back(i > 0 && frequencies[i] <= close * frequencies[first.back()] ? first.back()
                                                                                   : i);
  return first;
}

} // namespace

double cqc_correlation(const double one, const double other, const double damping) {
  const double r = std::min(one, other) / std::max(std::max(one, other), not_zero),
               z = damping * damping;
  return 8. * z * (1. + r) * std::pow(r, 1.5) /
         (std::pow(1. - r * r, 2) + 4. * z * r * (1. + r) * (1. + r));
}

double double_sum_correlation(const double one, const double other, const double damping,
                              const double duration) {
  const double w = 2. * dealii::numbers::PI, damped = std::sqrt(1. - damping * damping);
  // z' w = z w + 2/t
  const double width = damping * w * (one + other) + 4. / duration,
               apart = w * damped * (one - other) / width;
  return 1. / (1. + apart * apart);
}

Numbers combine_modes(const std::vector<Numbers> &responses, const std::vector<double> &frequencies,
                      const SpectrumSettings &settings) {
  using Modes = SpectrumSettings::Modes;
  AssertDimension(responses.size(), frequencies.size());
  Assert(std::is_sorted(frequencies.begin(), frequencies.end()), dealii::ExcInternalError());
  if (responses.empty())
    return {};
  switch (settings.modes) {
  case Modes::absolute:
    return quadratic(responses, true, [](std::size_t, std::size_t) { return 1.; });
  case Modes::cqc:
    return quadratic(responses, false, [&](const std::size_t i, const std::size_t j) {
      return cqc_correlation(frequencies[i], frequencies[j], settings.damping);
    });
  case Modes::grouping: {
    const std::vector<std::size_t> group = groups_of(frequencies);
    return quadratic(responses, true, [&](const std::size_t i, const std::size_t j) {
      return group[i] == group[j] ? 1. : 0.;
    });
  }
  case Modes::ten_percent:
    return quadratic(responses, true, [&](const std::size_t i, const std::size_t j) {
      return frequencies[i] <= close * frequencies[j] ? 1. : 0.;
    });
  case Modes::double_sum:
  case Modes::signed_double_sum:
    return quadratic(responses, settings.modes == Modes::double_sum,
                     [&](const std::size_t i, const std::size_t j) {
                       return double_sum_correlation(frequencies[i], frequencies[j],
                                                     settings.damping, settings.duration);
                     });
  case Modes::srss:
    break;
  }
  return quadratic(responses, false, [](std::size_t, std::size_t) { return 0.; });
}

double rigid_share(const SpectrumSettings &settings, const double frequency,
                   const double acceleration, const double at_zero_period) {
  using Rigid = SpectrumSettings::Rigid;
  if (settings.rigid == Rigid::lindley_yow)
    return acceleration > at_zero_period ? at_zero_period / acceleration : 1.;
  if (settings.rigid == Rigid::none || frequency <= settings.rigid_frequencies[0])
    return 0.;
  return std::min(1., std::log(frequency / settings.rigid_frequencies[0]) /
                          std::log(settings.rigid_frequencies[1] / settings.rigid_frequencies[0]));
}

} // namespace frictionbeam
