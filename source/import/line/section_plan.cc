// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/section_plan.h"

#include "base/number_text.h"
#include "base/unit_constants.h"
#include "base/user_error.h"
#include "scene/file/parameter_file.h"
#include "scene/part/pipe_library.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace frictionbeam::import {

namespace {

constexpr double same_length = 1e-9; ///< [m]
constexpr double least_wall = 1e-6;  ///< of any pipe [m]

/// "NPS 1-1/2" of 1.5.
std::string nps_of(const double inches) {
  const double whole = std::floor(inches + 1e-6), part = inches - whole;
  std::string text = whole > 0. ? exact_number(whole) : "";
  for (const auto &[value, words] :
       {std::make_pair(0.25, "1/4"), std::make_pair(0.5, "1/2"), std::make_pair(0.75, "3/4")})
    if (std::abs(part - value) < 1e-6)
      return "NPS " + (text.empty() ? words : text + "-" + words);
  return std::abs(part) < 1e-6 ? "NPS " + text : "";
}

const char *const known_schedules[] = {"5",   "10",  "20",  "30",  "40",  "60", "80",
                                       "100", "120", "140", "160", "STD", "XS", "XXS"};

/// The known schedule that @p word is, "40" of "40" and "S40"; empty if none.
std::string known_schedule(std::string word) {
  if (word.size() > 1 && word[0] == 'S' && std::isdigit(static_cast<unsigned char>(word[1])) != 0)
    word.erase(0, 1);
  return std::find(std::begin(known_schedules), std::end(known_schedules), word) !=
                 std::end(known_schedules)
             ? word
             : "";
}

/// Schedules that a description names, in its order: of both ends in "SCH 40 X SCH 80" and
/// "SCH 40X80", known or not. XS and STD stand for themselves where SCH names none.
std::vector<std::string> schedules_of(const std::string &description) {
  std::string text = capitals(description);
  std::replace_if(
      text.begin(), text.end(),
      [](const char c) {
        return c == ',' || c == ';' || c == '.' || c == '=' || c == ':' || c == '/';
      },
      ' ');
  std::vector<std::string> named, alone;
  bool expected = false;                      // after SCH
  std::vector<std::string> *behind = nullptr; // the list of the word before
  bool other = false;                         // after that and X
  for (std::string word : split(tidy(text), ' ')) {
    bool is_named = expected;
    for (const char *const key : {"SCHEDULE", "SCH"})
      if (word.rfind(key, 0) == 0) {
        word.erase(0, std::string(key).size());
        word.erase(0, std::min(word.size(), word.find_first_not_of('-')));
        is_named = true;
        break;
      }
    expected = is_named && word.empty();
    if (word.empty())
      continue;
    if (behind != nullptr && word == "X") {
      other = true;
      continue;
    }
    const bool is_number = std::isdigit(static_cast<unsigned char>(word[0])) != 0,
               stands_alone = word == "STD" || word == "XS" || word == "XXS";
    behind = is_named                                                ? &named
             : other && (is_number || !known_schedule(word).empty()) ? behind
             : stands_alone                                          ? &alone
                                                                     : nullptr;
    other = false;
    if (behind == nullptr)
      continue;
    const std::vector<std::string> parts = known_schedule(word).empty() && is_number
                                               ? split(word, 'X')
                                               : std::vector<std::string>{word};
    behind->insert(behind->end(), parts.begin(), parts.end());
  }
  return named.empty() ? alone : named;
}

/// The wall that a description names, "WT=6mm" [m]; 0 if none.
double wall_of(const std::string &description) {
  const std::string text = capitals(description);
  const std::size_t at = text.find("WT");
  if (at == std::string::npos ||
      (at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0))
    return 0.;
  const std::size_t begin = text.find_first_not_of(" .=:", at + 2);
  if (begin == std::string::npos)
    return 0.;
  std::size_t end = text.find_first_not_of("0123456789.", begin);
  end = end == std::string::npos ? text.size() : end;
  end = text.find_first_not_of(' ', end);
  if (end == std::string::npos)
    return 0.; // without a unit
  const std::size_t stop = text.find_first_of(" ,;", end);
  return parse_length(text.substr(begin, stop == std::string::npos ? stop : stop - begin))
      .value_or(0.);
}

/// Names of metals, as beginnings of words of the file.
struct GradeWord {
  const char *word, *grade;
};
constexpr GradeWord grade_words[] = {
    {"A312", "austenitic steel"},   {"A403", "austenitic steel"},   {"A358", "austenitic steel"},
    {"304", "austenitic steel"},    {"316", "austenitic steel"},    {"321", "austenitic steel"},
    {"347", "austenitic steel"},    {"TP304", "austenitic steel"},  {"TP316", "austenitic steel"},
    {"F304", "austenitic steel"},   {"F316", "austenitic steel"},   {"WP304", "austenitic steel"},
    {"WP316", "austenitic steel"},  {"1.4301", "austenitic steel"}, {"1.4306", "austenitic steel"},
    {"1.4307", "austenitic steel"}, {"1.4401", "austenitic steel"}, {"1.4404", "austenitic steel"},
    {"1.4571", "austenitic steel"}, {"SS", "austenitic steel"},     {"A106", "carbon steel"},
    {"A53", "carbon steel"},        {"A105", "carbon steel"},       {"A234", "carbon steel"},
    {"A333", "carbon steel"},       {"A350", "carbon steel"},       {"A216", "carbon steel"},
    {"A420", "carbon steel"},       {"5L", "carbon steel"},         {"P235GH", "carbon steel"},
    {"P265GH", "carbon steel"},     {"P250GH", "carbon steel"},     {"CS", "carbon steel"},
    {"CARBON", "carbon steel"}};

} // namespace

std::string grade_of(const std::string &name) {
  std::string text = capitals(name);
  std::replace_if(
      text.begin(), text.end(),
      [](const char c) { return c == ',' || c == ';' || c == '-' || c == '/' || c == '('; }, ' ');
  for (const GradeWord &row : grade_words)
    for (std::string word : split(text, ' ')) {
      if (word.size() > 2 && word.compare(0, 2, "SA") == 0)
        word.erase(0, 1); // SA106 of ASME
      const std::string known = row.word;
      if (word == known || (known.size() > 2 && word.size() <= known.size() + 2 &&
                            word.compare(0, known.size(), known) == 0))
        return row.grade;
    }
  return "";
}

bool PlannedSection::is_like(const PlannedSection &other) const {
  return size == other.size && schedule == other.schedule &&
         std::abs(outer_diameter - other.outer_diameter) < same_length &&
         std::abs(wall - other.wall) < same_length &&
         std::abs(corrosion - other.corrosion) < same_length &&
         std::abs(insulation - other.insulation) < same_length &&
         std::abs(insulation_density - other.insulation_density) < 1e-6 &&
         std::abs(contents - other.contents) < 1e-6;
}

SectionPlanner::SectionPlanner(const PcfFile &file, const PcfLine &line,
                               const SectionOptions &options, LinePlan &plan, Notes &notes)
    : file(file), line(line), options(options), plan(plan), notes(notes) {
  read_wall_option();
  find_walls_of_bores();
}

void SectionPlanner::read_wall_option() {
  for (const std::string &one : split(options.wall, ',')) {
    const std::vector<std::string> words = split(one, ' ');
    double bore = 0.;
    const bool by_bore = words.size() >= 2 && to_number(words[0], bore) && bore > 0. &&
                         parse_length(one.substr(one.find(' ') + 1)).has_value();
    const std::optional<double> wall =
        by_bore ? parse_length(one.substr(one.find(' ') + 1)) : parse_length(one);
    if (!wall)
      throw UserError("--wall: a thickness with its unit\n  read:    " + one +
                      "\n  allowed: a number > 0 with mm or in, or such by bore, 'bore wall unit', "
                      "between commas\n  try:     --wall \"7.11 mm\" or --wall \"150 7.11 mm, 80 "
                      "5.49 mm\"");
    given_walls[by_bore ? bore : 0.] = *wall;
  }
}

std::string SectionPlanner::nominal(const double bore) const {
  const std::string name = line.bores_in_inches ? nps_of(bore) : "DN " + exact_number(bore);
  return find_pipe_size(name, "STD", false) ? name : "";
}

SectionPlanner::Wall SectionPlanner::own_wall(const PcfComponent &component, const double bore,
                                              const bool second) {
  Wall wall;
  wall.value =
      component.properties.number(second ? Property::second_wall : Property::wall).value_or(0.);
  if (!wall.is_known() && !second)
    wall.value = wall_of(component.description);
  const std::vector<std::string> schedules = schedules_of(component.description);
  const std::size_t place = second ? 1 : 0;
  if (wall.is_known() || schedules.size() <= place)
    return wall;
  const std::string &missing = schedules[place];
  if (const std::string known = known_schedule(missing);
      !known.empty() && find_pipe_size(nominal(bore), known, false))
    wall.schedule = known;
  if (!wall.is_known() && said["schedule " + missing + " of " + exact_number(bore)]++ == 0)
    notes.not_understood.push_back({component.line, component.keyword + ": schedule " + missing +
                                                        " of bore " + exact_number(bore) +
                                                        " is not known; --wall can say it"});
  return wall;
}

SectionPlanner::Wall SectionPlanner::option_wall(const double bore) const {
  Wall wall;
  for (const double of : {bore, 0.})
    if (const auto given = given_walls.find(of); given != given_walls.end() && !wall.is_known())
      wall.value = given->second;
  if (!wall.is_known() && find_pipe_size(nominal(bore), options.schedule, false))
    wall.schedule = options.schedule;
  return wall;
}

void SectionPlanner::find_walls_of_bores() {
  std::map<double, const PcfComponent *> without;
  for (const PcfComponent &component : line.components) {
    if (component.shape != Shape::pipe && component.shape != Shape::bend)
      continue;
    const double bore = component.bore(0);
    Wall wall = own_wall(component, bore, false);
    if (!wall.is_known())
      wall = option_wall(bore);
    if (!wall.is_known())
      without.emplace(bore, &component);
    else if (const auto [known, is_new] = pipe_walls.emplace(bore, wall);
             !is_new &&
             (known->second.schedule != wall.schedule ||
              std::abs(known->second.value - wall.value) > same_length) &&
             said["walls of bore " + exact_number(bore)]++ == 0)
      notes.assumed.push_back({component.line, "pipes of bore " + exact_number(bore) +
                                                   " have several walls: fittings that do not say "
                                                   "theirs have that of the first"});
  }
  std::string bores;
  unsigned int line_number = 0;
  for (const auto &[bore, component] : without)
    if (pipe_walls.count(bore) == 0) {
      bores += (bores.empty() ? "" : ", ") + exact_number(bore) + " (line " +
               std::to_string(component->line) + ")";
      line_number = line_number == 0 ? component->line : std::min(line_number, component->line);
    }
  if (!bores.empty())
    file.fail(
        line_number,
        "pipes without a wall thickness, of bore " + bores +
            (options.schedule.empty() ? "" : "; --schedule has none for them"),
        "a wall by an attribute that --attributes knows, by SCH or WT in the item's "
        "description, or by --wall or --schedule",
        "--attributes caesar, --wall \"7.11 mm\", --wall \"150 7.11 mm, 80 5.49 mm\" by bore, "
        "or --schedule 40");
}

std::size_t SectionPlanner::section(const PcfComponent &component, const double bore,
                                    const bool second) {
  PlannedSection section;
  const std::string name = nominal(bore);
  section.nominal = name.empty() ? "bore " + exact_number(bore) : name;
  Wall wall = own_wall(component, bore, second);
  if (!wall.is_known())
    wall = option_wall(bore);
  if (const auto found = pipe_walls.find(bore); !wall.is_known() && found != pipe_walls.end())
    wall = found->second;
  if (!wall.is_known() && second) {
    wall = own_wall(component, bore, false);
    if (wall.is_known())
      notes.assumed.push_back({component.line, component.keyword + ": its end of bore " +
                                                   exact_number(bore) +
                                                   " has the wall of its first end"});
  }
  if (!wall.is_known())
    file.fail(component.line,
              component.keyword + " of bore " + exact_number(bore) +
                  " without a wall thickness, and no pipe of that bore",
              "a wall by an attribute that --attributes knows, or by --wall or --schedule",
              "--wall \"" + exact_number(bore) + " 7.11 mm\"");
  const std::optional<double> given = component.properties.number(
      second ? Property::second_outer_diameter : Property::outer_diameter);
  if (given && *given > 0.)
    section.outer_diameter = *given;
  else if (!name.empty())
    section.outer_diameter = find_pipe_size(name, "STD", options.in_inches)->outer_diameter;
  else {
    section.outer_diameter = bore * (line.bores_in_inches ? inch : 1e-3);
    if (said["bore " + exact_number(bore)]++ == 0)
      notes.assumed.push_back({component.line, "bore " + exact_number(bore) +
                                                   " is no nominal size of ASME B36.10M: taken as "
                                                   "the outer diameter"});
  }
  if (!wall.schedule.empty() && !name.empty() && !(given && *given > 0.)) {
    section.size = name;
    section.schedule = wall.schedule;
    section.wall = find_pipe_size(name, wall.schedule, options.in_inches)->wall;
  } else
    section.wall = wall.schedule.empty()
                       ? wall.value
                       : find_pipe_size(name, wall.schedule, options.in_inches)->wall;
  if (section.wall > section.outer_diameter / 2. || section.wall < least_wall)
    file.fail(component.line,
              component.keyword + ": wall " + rounded_number(1e3 * section.wall) +
                  " mm of outer diameter " + rounded_number(1e3 * section.outer_diameter) + " mm",
              "a bore > 0, and a wall from 0.001 mm to half the outer diameter",
              "the right unit in --attributes or --wall, and of UNITS-BORE");
  const auto number = [&](const Property property) {
    return component.properties.number(property).value_or(0.);
  };
  section.corrosion = number(Property::corrosion_allowance);
  section.insulation = number(Property::insulation);
  section.insulation_density = number(Property::insulation_density);
  section.contents = number(Property::contents);
  for (std::size_t i = 0; i < plan.sections.size(); ++i)
    if (plan.sections[i].is_like(section))
      return i;
  section.name = names.take(name.empty() ? "pipe" : name);
  plan.sections.push_back(section);
  return plan.sections.size() - 1;
}

std::size_t SectionPlanner::material(const PcfComponent &component) {
  std::string of = component.properties.material;
  std::string grade = grade_of(of);
  for (const std::string &other : {component.description, component.item})
    if (grade.empty()) {
      grade = grade_of(other);
      of = of.empty() && !grade.empty() ? other : of;
    }
  if (grade.empty()) {
    grade = options.material.empty() ? "carbon steel" : options.material;
    const std::string called = of.empty() ? "no material is said" : "material '" + of + "'";
    if (options.material.empty() && said[called]++ == 0)
      notes.assumed.push_back({component.line, called + ": carbon steel is taken (--material for "
                                                        "another)"});
  }
  for (std::size_t i = 0; i < plan.materials.size(); ++i)
    if (plan.materials[i].grade == grade) {
      std::string &known = plan.materials[i].of;
      if (!of.empty() && (", " + known + ",").find(", " + of + ",") == std::string::npos &&
          known.size() < 200)
        known += (known.empty() ? "" : ", ") + of;
      return i;
    }
  std::string name = grade;
  std::replace(name.begin(), name.end(), ' ', '_');
  plan.materials.push_back({name, grade, of});
  return plan.materials.size() - 1;
}

} // namespace frictionbeam::import
