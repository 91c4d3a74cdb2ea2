// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/variables.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "scene/support_pair.h"

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

[[noreturn]] void fail(const Variation &variation, const std::string &read,
                       const std::string &allowed, const std::string &hint) {
  throw UserError(variation.origin + "\n  read:    " + read + "\n  allowed: " + allowed +
                  "\n  try:     " + hint);
}

std::string heading_of(const std::string &path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? "" : tidy(path.substr(0, slash));
}

std::string entry_of(const std::string &path) {
  return tidy(path.substr(path.find('/') == std::string::npos ? 0 : path.find('/') + 1));
}

std::string joined(const std::string &heading, const std::string &entry) {
  return heading.empty() ? entry : heading + '/' + entry;
}

/// Entries that say which case this is and what is put out, not what it is like.
void refuse_what_cannot_vary(const Variation &variation, const std::string &path) {
  const std::set<std::string> sections = {"Output", "Study", "Quantities", "Exact"},
                              entries = {"Title",        "Scene",    "Model",
                                         "Units",        "Accuracy", "Law libraries",
                                         "Free motions", "Monitors", "Friction multipliers"};
  const std::string heading = heading_of(path);
  if (sections.count(heading) > 0 || heading.rfind("Vary ", 0) == 0 ||
      (heading.empty() && entries.count(path) > 0))
    fail(variation, path,
         "entries of the model: parts such as supports, loads and materials, 'Installation "
         "temperature', and the sections Mesh, Solver and Time",
         "another entry; --set changes this one for all runs");
}

/// A hanger is sized for the case as it stands, and is the same in all runs.
void refuse_sized_hanger(const Scene &scene, const Variation &variation, const std::string &path) {
  for (const Hanger &hanger : scene.hangers)
    if (heading_of(path) == "Hanger " + hanger.name && hanger.cold_load == 0. &&
        entry_of(path) != "Cold load")
      fail(variation, path,
           "Cold load and Stiffness of a hanger: this one is sized for the case as it stands, and "
           "is built once",
           "its Cold load and Stiffness set in the file; a run says what was chosen");
}

constexpr const char *friction = "Friction coefficient";

/// Finds what the paths of a study stand for.
class Entries {
public:
  Entries(const Scene &scene, const ParameterFile &file, const LawLibrary &laws,
          const PlacesOfSupports &places)
      : scene(scene), file(file), laws(laws), places(places) {}

  /// The entries that a path stands for, each place of a support on its own if that is asked for.
  std::vector<Variable::Entry> of(const Variation &variation, const std::string &path) const {
    const std::string entry = entry_of(path);
    std::vector<Variable::Entry> found;
    for (const std::string &heading : headings(variation, path)) {
      refuse_place_beyond(variation, heading, path);
      const unsigned int n = n_places(heading, entry);
      std::vector<std::string> parts;
      if (!variation.independent || n == 1)
        parts.push_back(heading);
      for (unsigned int place = 1; place <= n; ++place)
        if (const std::string one = heading + '.' + std::to_string(place);
            n > 1 && (variation.independent || is_given(one, entry)))
          parts.push_back(one);
      for (const std::string &part : parts)
        found.push_back({joined(part, entry),
                         variation.is_factor ? value_in_file(variation, part, entry) : 1.});
    }
    return found;
  }

  /// Supports without friction that a star has not taken.
  const std::set<std::string> &without_friction() const { return left_out; }

private:
  static bool is_friction(const std::string &entry) {
    return entry == friction || entry == "Dynamic friction coefficient";
  }

  /// Whether it has friction, at one of its places at least.
  bool slides(const FrictionSupport &support) const {
    const int i = parameter(support, friction);
    return support.parameters[i] > 0. ||
           std::any_of(support.parameters_at.begin(), support.parameters_at.end(),
                       [&](const auto &place) { return place.second[i] > 0.; });
  }

  /// All friction supports that have the entry, for a star: but for those without friction, as
  /// rods, where it is a coefficient of friction.
  std::vector<std::string> headings(const Variation &variation, const std::string &path) const {
    const std::string heading = heading_of(path);
    if (heading.find('*') == std::string::npos)
      return {heading};
    if (heading != "Support *")
      fail(variation, path, "a star for the name of a support: 'Support *'",
           "the sections one by one, with semicolons between them");
    std::vector<std::string> found;
    for (const FrictionSupport &support : scene.supports) {
      const std::string one = "Support " + part_name(support);
      if (is_friction(entry_of(path)) && has_parameter(support, friction) && !slides(support)) {
        left_out.insert(part_name(support));
        continue;
      }
      if (has_parameter(support, entry_of(path)) &&
          std::count(found.begin(), found.end(), one) == 0)
        found.push_back(one);
    }
    if (found.empty())
      fail(variation, path, "an entry of a support's law, and supports that have one",
           "'Support */Friction coefficient'");
    return found;
  }

  bool has_parameter(const FrictionSupport &support, const std::string &entry) const {
    return parameter(support, entry) < laws.find(support.law).n_parameters;
  }

  int parameter(const FrictionSupport &support, const std::string &entry) const {
    const LawDescription &law = laws.find(support.law);
    int i = 0;
    while (i < law.n_parameters && law.parameters[i].name != entry)
      ++i;
    return i;
  }

  const FrictionSupport *support_of(const std::string &heading) const {
    for (const FrictionSupport &support : scene.supports)
      if ("Support " + part_name(support) == heading)
        return &support;
    return nullptr;
  }

  /// One place of a support, as in "Support rests.3"; null: the heading is none.
  const FrictionSupport *support_of_place(const std::string &heading, unsigned int &place) const {
    const auto dot = heading.rfind('.');
    double number = 0.;
    if (dot == std::string::npos || support_of(heading) != nullptr ||
        !to_number(heading.substr(dot + 1), number) || !(number >= 1.))
      return nullptr;
    place = static_cast<unsigned int>(number) - 1;
    return support_of(heading.substr(0, dot));
  }

  void refuse_place_beyond(const Variation &variation, const std::string &heading,
                           const std::string &path) const {
    unsigned int place = 0;
    const FrictionSupport *const support = support_of_place(heading, place);
    const auto n = support == nullptr ? places.end() : places.find(part_name(*support));
    if (n != places.end() && place >= n->second)
      fail(variation, path, "places 1 to " + std::to_string(n->second) + " of this support",
           "a place that there is, or its section without a number for all of them");
  }

  bool is_given(const std::string &heading, const std::string &entry) const {
    const ParameterFile::Section *const section = file.find(heading);
    return section != nullptr && section->find(entry) != nullptr;
  }

  unsigned int n_places(const std::string &heading, const std::string &entry) const {
    const FrictionSupport *const support = support_of(heading);
    const auto n = support == nullptr ? places.end() : places.find(part_name(*support));
    return n == places.end() || !has_parameter(*support, entry) ? 1 : n->second;
  }

  /// In the file's units.
  double value_in_file(const Variation &variation, const std::string &heading,
                       const std::string &entry) const {
    const ParameterFile::Section *const section = file.find(heading);
    const ParameterFile::Entry *const given = section == nullptr ? nullptr : section->find(entry);
    double value = 0.;
    if (given != nullptr && to_number(given->value, value))
      return value;
    unsigned int place = 0;
    const FrictionSupport *support = support_of(heading);
    const bool is_whole = support != nullptr;
    if (!is_whole)
      support = support_of_place(heading, place);
    if (given == nullptr && support != nullptr && has_parameter(*support, entry)) {
      const int i = parameter(*support, entry);
      return (is_whole ? support->parameters : support->parameters_of(place))[i] /
             scene.units.factor(laws.find(support->law).parameters[i].unit);
    }
    fail(variation, joined(heading, entry) + " = " + (given == nullptr ? "nothing" : given->value),
         "with Meaning = factor, entries that are a number in the file",
         "Meaning = value, or the entry set in the file");
  }

  const Scene &scene;
  const ParameterFile &file;
  const LawLibrary &laws;
  const PlacesOfSupports &places;
  mutable std::set<std::string> left_out;
};

/// The factor of all entries, if it is one.
std::optional<double> factor_of_all(const std::vector<Variable::Entry> &entries) {
  const bool is_one =
      std::all_of(entries.begin(), entries.end(), [&](const Variable::Entry &entry) {
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
  const Entries entries(scene, file, laws, places);
  std::set<std::string> taken;
  for (unsigned int v = 0; v < variations.size(); ++v) {
    quantiles.push_back(quantiles_of(variations[v], sampling));
    Variable common{variations[v].name, {}, {}, v};
    for (const std::string &path : variations[v].entries) {
      refuse_what_cannot_vary(variations[v], path);
      refuse_sized_hanger(scene, variations[v], path);
      for (const Variable::Entry &entry : entries.of(variations[v], path)) {
        if (!taken.insert(entry.path).second)
          fail(variations[v], entry.path + ", a second time", "each entry in one section Vary",
               "removing it from one of the two");
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
    for (const Variable::Entry &entry : common.entries)
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
    for (const Variable::Entry &entry : list[i].entries)
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
