// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/varied_entries.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "scene/part/parts.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::study {

void refuse_variation(const Variation &variation, const std::string &read,
                      const std::string &allowed, const std::string &hint) {
  throw UserError(variation.origin + "\n  read:    " + read + "\n  allowed: " + allowed +
                  "\n  try:     " + hint);
}

namespace {

constexpr const char *friction = "Friction coefficient";

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
    refuse_variation(
        variation, path,
        "entries of the model: parts such as supports, loads and materials, 'Installation "
        "temperature', and the sections Mesh, Solver and Time",
        "another entry; --set changes this one for all runs");
}

/// A hanger is sized for the case as it stands, and is the same in all runs.
void refuse_sized_hanger(const Scene &scene, const Variation &variation, const std::string &path) {
  for (const Hanger &hanger : scene.hangers)
    if (heading_of(path) == "Hanger " + hanger.name && hanger.cold_load == 0. &&
        entry_of(path) != "Cold load")
      refuse_variation(
          variation, path,
          "Cold load and Stiffness of a hanger: this one is sized for the case as it stands, and "
          "is built once",
          "its Cold load and Stiffness set in the file; a run says what was chosen");
}

} // namespace

std::vector<VariedEntry> VariedEntries::of(const Variation &variation,
                                           const std::string &path) const {
  refuse_what_cannot_vary(variation, path);
  refuse_sized_hanger(scene, variation, path);
  const std::string entry = entry_of(path);
  std::vector<VariedEntry> found;
  for (const std::string &heading : headings(variation, path)) {
    refuse_place_beyond(variation, heading, path);
    const unsigned int n = n_places(heading, entry);
    const bool is_split = variation.independent && n > 1;
    std::vector<std::string> parts;
    if (!is_split)
      parts.push_back(heading);
    for (unsigned int place = 1; place <= n; ++place)
      if (const std::string one = heading + '.' + std::to_string(place);
          is_split || (is_given(one, entry) && !varies_by_itself(one, entry)))
        parts.push_back(one);
    for (const std::string &part : parts)
      found.push_back(
          {joined(part, entry), variation.is_factor ? value_in_file(variation, part, entry) : 1.});
  }
  return found;
}

bool VariedEntries::is_friction(const std::string &entry) {
  return entry == friction || entry == "Dynamic friction coefficient";
}

bool VariedEntries::slides(const FrictionSupport &support) const {
  const int i = parameter(support, friction);
  return support.parameters[i] > 0. ||
         std::any_of(support.parameters_at.begin(), support.parameters_at.end(),
                     [&](const auto &place) { return place.second[i] > 0.; });
}

std::vector<std::string> VariedEntries::headings(const Variation &variation,
                                                 const std::string &path) const {
  const std::string heading = heading_of(path);
  if (heading.find('*') == std::string::npos)
    return {heading};
  if (heading != "Support *")
    refuse_variation(variation, path, "a star for the name of a support: 'Support *'",
                     "the sections one by one, with semicolons between them");
  std::vector<std::string> found;
  for (const FrictionSupport &support : scene.supports) {
    const std::string one = "Support " + part_name(support);
    if (is_friction(entry_of(path)) && has_parameter(support, friction) && !slides(support)) {
      left_out.insert(part_name(support));
      continue;
    }
    if (has_parameter(support, entry_of(path)) && std::count(found.begin(), found.end(), one) == 0)
      found.push_back(one);
  }
  if (found.empty())
    refuse_variation(variation, path, "an entry of a support's law, and supports that have one",
                     "'Support */Friction coefficient'");
  return found;
}

bool VariedEntries::has_parameter(const FrictionSupport &support, const std::string &entry) const {
  return parameter(support, entry) < laws.find(support.law).n_parameters;
}

int VariedEntries::parameter(const FrictionSupport &support, const std::string &entry) const {
  const LawDescription &law = laws.find(support.law);
  int i = 0;
  while (i < law.n_parameters && law.parameters[i].name != entry)
    ++i;
  return i;
}

const FrictionSupport *VariedEntries::support_of(const std::string &heading) const {
  for (const FrictionSupport &support : scene.supports)
    if ("Support " + part_name(support) == heading)
      return &support;
  return nullptr;
}

VariedEntries::Place VariedEntries::place_of(const std::string &heading) const {
  if (const FrictionSupport *const support = support_of(heading))
    return {support, 0};
  const auto [whole, number] = parts::repeated_support(heading);
  return {support_of(whole), number};
}

void VariedEntries::refuse_place_beyond(const Variation &variation, const std::string &heading,
                                        const std::string &path) const {
  const Place place = place_of(heading);
  const auto n = place.support == nullptr ? places.end() : places.find(part_name(*place.support));
  if (n != places.end() && place.number > n->second)
    refuse_variation(variation, path,
                     "places 1 to " + std::to_string(n->second) + " of this support",
                     "a place that there is, or its section without a number for all of them");
}

bool VariedEntries::varies_by_itself(const std::string &heading, const std::string &entry) const {
  for (const Variation &variation : scene.study.variations)
    for (const std::string &path : variation.entries)
      if (heading_of(path) == heading && entry_of(path) == entry)
        return true;
  return false;
}

bool VariedEntries::is_given(const std::string &heading, const std::string &entry) const {
  const ParameterFile::Section *const section = file.find(heading);
  return section != nullptr && section->find(entry) != nullptr;
}

unsigned int VariedEntries::n_places(const std::string &heading, const std::string &entry) const {
  const FrictionSupport *const support = support_of(heading);
  const auto n = support == nullptr ? places.end() : places.find(part_name(*support));
  return n == places.end() || !has_parameter(*support, entry) ? 1 : n->second;
}

double VariedEntries::value_in_file(const Variation &variation, const std::string &heading,
                                    const std::string &entry) const {
  const ParameterFile::Section *const section = file.find(heading);
  const ParameterFile::Entry *const given = section == nullptr ? nullptr : section->find(entry);
  double value = 0.;
  if (given != nullptr && to_number(given->value, value))
    return value;
  const auto [support, number] = place_of(heading);
  if (given == nullptr && support != nullptr && has_parameter(*support, entry)) {
    const int i = parameter(*support, entry);
    return (number == 0 ? support->parameters : support->parameters_of(number - 1))[i] /
           scene.units.factor(laws.find(support->law).parameters[i].unit);
  }
  refuse_variation(variation,
                   joined(heading, entry) + " = " + (given == nullptr ? "nothing" : given->value),
                   "with Meaning = factor, entries that are a number in the file",
                   "Meaning = value, or the entry set in the file");
}

} // namespace frictionbeam::study
