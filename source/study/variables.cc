// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/variables.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam::study {

namespace {

using Shape = Variation::Shape;

/// Beyond this probability no value is ever drawn, so that none has to be allowed.
constexpr double never = 1e-9;
/// Probability of a value between the outermost ones, which is no whole number but by chance.
constexpr double anywhere = 0.3819660113;

/// The factor of all entries, if it is one.
std::optional<double> factor_of_all(const std::vector<VariedEntry> &entries) {
  const bool is_one = std::all_of(entries.begin(), entries.end(), [&](const VariedEntry &entry) {
    return entry.factor == entries.front().factor;
  });
  return is_one ? std::optional<double>(entries.front().factor) : std::nullopt;
}

std::function<double(double)> quantiles_of(const Variation &variation, const Sampling &sampling) {
  if (variation.shape == Shape::list)
    return {};
  Distribution distribution;
  distribution.kind = variation.shape == Shape::uniform  ? Distribution::Kind::uniform
                      : variation.shape == Shape::normal ? Distribution::Kind::normal
                                                         : Distribution::Kind::log_normal;
  distribution.mean = variation.mean;
  distribution.deviation = variation.deviation;
  distribution.from = variation.from;
  distribution.to = variation.to;
  return sampling.quantiles(distribution);
}

} // namespace

Variables::Variables(const Scene &scene, const ParameterFile &file, const LawLibrary &laws,
                     const PlacesOfSupports &places, const Sampling &sampling)
    : variations(scene.study.variations) {
  const VariedEntries entries(scene, file, laws, places);
  std::set<std::string> taken;
  for (unsigned int v = 0; v < variations.size(); ++v) {
    quantiles.push_back(quantiles_of(variations[v], sampling));
    Variable common{variations[v].name, {}, {}, v};
    for (const std::string &path : variations[v].entries) {
      for (const VariedEntry &entry : entries.of(variations[v], path)) {
        if (!taken.insert(entry.path).second)
          refuse_variation(variations[v], entry.path + ", a second time",
                           "each entry in one section Vary", "removing it from one of the two");
        common.entries.push_back(entry);
      }
    }
    if (!variations[v].independent) {
      common.of_all = factor_of_all(common.entries);
      if (!common.of_all)
        common.name += " (factor)";
      list.push_back(common);
      continue;
    }
    for (const VariedEntry &entry : common.entries)
      list.push_back(
          {common.entries.size() == 1 ? common.name : entry.path, {entry}, entry.factor, v});
  }
  frictionless = entries.without_friction();
}

double Variables::quantile(const unsigned int v, const double u) const {
  const Variation &variation = variations[v];
  if (u <= 0. && std::isfinite(variation.from))
    return variation.from;
  if (u >= 1. && std::isfinite(variation.to))
    return variation.to;
  double value = quantiles[v](std::clamp(u, never, 1. - never));
  if (variation.shape == Shape::uniform) // 0.3, and not 0.30000000000000004, between 0.1 and 0.5
    to_number(rounded_number(value, 15), value);
  return value;
}

namespace {
/// The place in a list of @p n that a probability stands for.
std::size_t place_in_list(const std::size_t n, const double u) {
  constexpr double rounding = 1e-9; // of thirds, which levels of Morris' design are
  return std::min(n - 1, static_cast<std::size_t>(std::max(0., u * n + rounding)));
}
} // namespace

double Variables::value(const std::size_t i, const double u) const {
  const Variation &of = variation(i);
  const double scale = list[i].of_all.value_or(1.);
  if (of.shape != Shape::list)
    return quantile(list[i].variation, u) * scale;
  const std::size_t place = place_in_list(of.values.size(), u);
  double number = 0.;
  const bool are_numbers =
      std::all_of(of.values.begin(), of.values.end(),
                  [&](const std::string &value) { return to_number(value, number); });
  to_number(of.values[place], number);
  return are_numbers ? number * scale : static_cast<double>(place);
}

std::string Variables::text(const std::size_t i, const double u) const {
  const Variation &of = variation(i);
  return of.shape == Shape::list && !of.is_factor ? of.values[place_in_list(of.values.size(), u)]
                                                  : exact_number(value(i, u));
}

std::vector<std::string> Variables::settings(const std::vector<double> &values,
                                             const std::vector<std::string> &texts) const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (const VariedEntry &entry : list[i].entries)
      result.push_back(entry.path + " = " +
                       (list[i].of_all ? texts[i] : exact_number(values[i] * entry.factor)));
  return result;
}

std::vector<std::string> Variables::settings_of(const unsigned int v, const double u) const {
  std::vector<double> values;
  std::vector<std::string> texts, result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    values.push_back(value(i, u));
    texts.push_back(text(i, u));
  }
  const std::vector<std::string> all = settings(values, texts);
  auto setting = all.begin();
  for (const Variable &variable : list) {
    if (variable.variation == v)
      result.insert(result.end(), setting, setting + variable.entries.size());
    setting += variable.entries.size();
  }
  return result;
}

std::vector<double> levels_of(const Variation &variation) {
  const std::size_t n_values = variation.values.size();
  const std::size_t n = n_values > 0 ? n_values : variation.levels;
  std::vector<double> levels;
  for (std::size_t k = 0; k < n; ++k)
    levels.push_back(n_values == 0 && variation.shape == Shape::uniform
                         ? static_cast<double>(k) / (n - 1)
                         : (k + 0.5) / n);
  return levels;
}

namespace {
/// Probabilities of values that stand for all that a method draws.
std::vector<double> tried(const Variation &variation, const StudyMethod method) {
  if (variation.shape == Shape::list || method == StudyMethod::factorial)
    return levels_of(variation);
  if (method == StudyMethod::morris)
    return {0., 1. / 3., 2. / 3., 1.};
  return {0., 1., anywhere};
}
} // namespace

void Variables::check(const Read &read, const StudyMethod method) const {
  for (unsigned int v = 0; v < variations.size(); ++v)
    for (const double u : tried(variations[v], method)) {
      try {
        read(settings_of(v, u));
      } catch (const UserError &error) {
        throw UserError(variations[v].origin + ": a value of it is not allowed (" +
                        in_words(variations[v]) + ")\n" + error.what() +
                        (u == anywhere ? "; whole numbers and other words go into a list, as in "
                                         "Values = 1, 2, 3"
                                       : ""));
      }
    }
}

std::string in_words(const Variation &variation) {
  const std::string of = variation.is_factor ? "factor, " : "";
  if (variation.shape == Shape::list)
    return of + "one of " + join(variation.values);
  const auto number = [](const double value) { return rounded_number(value, 6); };
  if (variation.shape == Shape::uniform)
    return of + "uniform from " + number(variation.from) + " to " + number(variation.to);
  std::string text = of + row_of(variation_shapes, variation.shape).word + ", mean " +
                     number(variation.mean) + ", deviation " + number(variation.deviation);
  if (std::isfinite(variation.from))
    text += ", not below " + number(variation.from);
  if (std::isfinite(variation.to))
    text += ", not above " + number(variation.to);
  return text;
}

} // namespace frictionbeam::study
