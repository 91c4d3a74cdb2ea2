// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/pcf/properties.h"

#include "base/unit_constants.h"
#include "base/user_error.h"
#include "import/pcf/pcf_file.h"
#include "scene/file/parameter_file.h"
#include "scene/file/table_rows.h"

#include <cstdlib>
#include <fstream>

namespace frictionbeam::import {

namespace {

enum class Dimension { length, mass, density, temperature, pressure, force, stiffness, text };

struct PropertyWord {
  const char *word;
  Property property;
  Dimension dimension;
};
constexpr PropertyWord property_words[] = {
    {"outer_diameter", Property::outer_diameter, Dimension::length},
    {"wall", Property::wall, Dimension::length},
    {"second_outer_diameter", Property::second_outer_diameter, Dimension::length},
    {"second_wall", Property::second_wall, Dimension::length},
    {"corrosion_allowance", Property::corrosion_allowance, Dimension::length},
    {"insulation", Property::insulation, Dimension::length},
    {"insulation_density", Property::insulation_density, Dimension::density},
    {"contents", Property::contents, Dimension::density},
    {"temperature", Property::temperature, Dimension::temperature},
    {"pressure", Property::pressure, Dimension::pressure},
    {"weight", Property::weight, Dimension::mass},
    {"spring_rate", Property::spring_rate, Dimension::stiffness},
    {"cold_load", Property::cold_load, Dimension::force},
    {"hot_load", Property::hot_load, Dimension::force},
    {"material", Property::material, Dimension::text},
    {"none", Property::none, Dimension::text}};

const PropertyWord &word_of(const Property property) {
  for (const PropertyWord &row : property_words)
    if (row.property == property)
      return row;
  return property_words[0]; // not reached: every property has a row
}

struct UnitWord {
  const char *word;
  Dimension dimension;
  double factor, offset = 0.; ///< SI is factor times (value + offset)
};
constexpr double pound_force = pound * standard_gravity, psi = pound_force / (inch * inch);
constexpr UnitWord unit_words[] = {
    {"MM", Dimension::length, 1e-3},
    {"CM", Dimension::length, 1e-2},
    {"M", Dimension::length, 1.},
    {"IN", Dimension::length, inch},
    {"INCH", Dimension::length, inch},
    {"FT", Dimension::length, 12. * inch},
    {"KG", Dimension::mass, 1.},
    {"KGS", Dimension::mass, 1.},
    {"LB", Dimension::mass, pound},
    {"LBS", Dimension::mass, pound},
    {"KG/M3", Dimension::density, 1.},
    {"G/CM3", Dimension::density, 1e3},
    {"LB/FT3", Dimension::density, pound / (1728. * inch * inch * inch)},
    {"LB/IN3", Dimension::density, pound / (inch * inch * inch)},
    {"C", Dimension::temperature, 1.},
    {"DEGC", Dimension::temperature, 1.},
    {"F", Dimension::temperature, 5. / 9., -32.},
    {"DEGF", Dimension::temperature, 5. / 9., -32.},
    {"K", Dimension::temperature, 1., -273.15},
    {"PA", Dimension::pressure, 1.},
    {"KPA", Dimension::pressure, 1e3},
    {"MPA", Dimension::pressure, 1e6},
    {"BAR", Dimension::pressure, 1e5},
    {"BARG", Dimension::pressure, 1e5},
    {"PSI", Dimension::pressure, psi},
    {"PSIG", Dimension::pressure, psi},
    {"N", Dimension::force, 1.},
    {"KN", Dimension::force, 1e3},
    {"DAN", Dimension::force, 10.},
    {"KGF", Dimension::force, standard_gravity},
    {"LBF", Dimension::force, pound_force},
    {"LB", Dimension::force, pound_force},
    {"N/M", Dimension::stiffness, 1.},
    {"N/MM", Dimension::stiffness, 1e3},
    {"KN/M", Dimension::stiffness, 1e3},
    {"DAN/MM", Dimension::stiffness, 1e4},
    {"KGF/MM", Dimension::stiffness, 1e3 * standard_gravity},
    {"LBF/IN", Dimension::stiffness, pound_force / inch},
    {"LB/IN", Dimension::stiffness, pound_force / inch}};

const UnitWord *find_unit(const std::string &word, const Dimension dimension) {
  for (const UnitWord &unit : unit_words)
    if (unit.dimension == dimension && word == unit.word)
      return &unit;
  return nullptr;
}

std::string units_of(const Dimension dimension) {
  std::vector<std::string> words;
  for (const UnitWord &unit : unit_words)
    if (unit.dimension == dimension)
      words.emplace_back(unit.word);
  return join(words);
}

/// A number and the word behind it, in capitals; false if it begins with no number.
bool number_and_unit(const std::string &text, double &value, std::string &unit) {
  char *end = nullptr;
  value = std::strtod(text.c_str(), &end);
  const std::size_t n = end - text.c_str();
  double checked;
  unit = capitals(tidy(text.substr(n)));
  return n > 0 && to_number(text.substr(0, n), checked);
}

/// Attributes by number as CAESAR II's import reads them; values have their units with them.
const char *const of_caesar[] = {
    "COMPONENT-ATTRIBUTE1 pressure",   "COMPONENT-ATTRIBUTE2 temperature",
    "COMPONENT-ATTRIBUTE3 material",   "COMPONENT-ATTRIBUTE4 wall",
    "COMPONENT-ATTRIBUTE5 insulation", "COMPONENT-ATTRIBUTE6 insulation_density",
    "COMPONENT-ATTRIBUTE8 weight",     "COMPONENT-ATTRIBUTE7 corrosion_allowance",
    "COMPONENT-ATTRIBUTE9 contents",   "COMPONENT-ATTRIBUTE10 none",
    "PIPELINE-TEMP temperature"};
/// As CAEPIPE's export writes them (its manual, "Component Identifiers").
const char *const of_caepipe[] = {"COMPONENT-ATTRIBUTE1 outer_diameter MM",
                                  "COMPONENT-ATTRIBUTE2 wall MM",
                                  "COMPONENT-ATTRIBUTE3 corrosion_allowance MM",
                                  "COMPONENT-ATTRIBUTE4 none",
                                  "COMPONENT-ATTRIBUTE5 insulation_density KG/M3",
                                  "COMPONENT-ATTRIBUTE6 insulation MM",
                                  "COMPONENT-ATTRIBUTE7 temperature C",
                                  "COMPONENT-ATTRIBUTE8 pressure BAR",
                                  "COMPONENT-ATTRIBUTE9 second_outer_diameter MM",
                                  "COMPONENT-ATTRIBUTE10 second_wall MM",
                                  "PIPELINE-TEMP temperature C",
                                  "ATTRIBUTE1 pressure BAR"};
const char *const of_caepipe_in_inches[] = {"COMPONENT-ATTRIBUTE1 outer_diameter IN",
                                            "COMPONENT-ATTRIBUTE2 wall IN",
                                            "COMPONENT-ATTRIBUTE3 corrosion_allowance IN",
                                            "COMPONENT-ATTRIBUTE4 none",
                                            "COMPONENT-ATTRIBUTE5 insulation_density LB/IN3",
                                            "COMPONENT-ATTRIBUTE6 insulation IN",
                                            "COMPONENT-ATTRIBUTE7 temperature F",
                                            "COMPONENT-ATTRIBUTE8 pressure PSI",
                                            "COMPONENT-ATTRIBUTE9 second_outer_diameter IN",
                                            "COMPONENT-ATTRIBUTE10 second_wall IN",
                                            "PIPELINE-TEMP temperature F",
                                            "ATTRIBUTE1 pressure PSI"};

} // namespace

void Properties::complete(const Properties &others) {
  numbers.insert(others.numbers.begin(), others.numbers.end());
  if (material.empty())
    material = others.material;
}

std::optional<double> parse_length(const std::string &text) {
  double value;
  std::string unit;
  if (!number_and_unit(text, value, unit))
    return {};
  const UnitWord *const found = find_unit(unit, Dimension::length);
  return found == nullptr || value <= 0. ? std::nullopt
                                         : std::optional<double>(value * found->factor);
}

AttributeTable::AttributeTable(const std::string &choice, const bool in_inches) {
  add("MATERIAL material", "");
  if (choice == "caesar")
    for (const char *const row : of_caesar)
      add(row, choice);
  else if (choice == "caepipe")
    for (const char *const row : in_inches ? of_caepipe_in_inches : of_caepipe)
      add(row, choice);
  else if (choice != "none") {
    if (!std::ifstream(choice))
      throw UserError("--attributes: the file '" + choice +
                      "' cannot be read.\n  allowed: none, caesar, caepipe, or the path of a file "
                      "with rows 'KEY property unit'\n  try:     --attributes caesar");
    for (const TableRow &row : read_table_rows(choice))
      add(row.text, choice + ":" + std::to_string(row.line));
  }
}

void AttributeTable::add(const std::string &line, const std::string &place) {
  const std::vector<std::string> words = fields_of_row(line);
  std::vector<std::string> known;
  for (const PropertyWord &row : property_words) {
    known.emplace_back(row.word);
    if (words.size() < 2 || words.size() > 3 || words[1] != row.word)
      continue;
    const std::string unit = words.size() == 3 ? capitals(words[2]) : "";
    if (!unit.empty() && find_unit(unit, row.dimension) == nullptr)
      throw UserError(place + "\n  read:    unit " + words[2] + " of " + row.word +
                      "\n  allowed: " + units_of(row.dimension) + "\n  try:     one of these");
    rows[capitals(words[0])] = {row.property, unit};
    return;
  }
  throw UserError(place + "\n  read:    " + tidy(line) +
                  "\n  allowed: rows 'KEY property unit', the unit where values have none; "
                  "properties: " +
                  join(known) + "\n  try:     COMPONENT-ATTRIBUTE4 wall mm");
}

const AttributeTable::Row *AttributeTable::find(const std::string &key) const {
  const auto row = rows.find(key);
  return row == rows.end() ? nullptr : &row->second;
}

std::string AttributeTable::read(const Row &row, const std::string &text, Properties &properties) {
  if (row.property == Property::none || text.empty())
    return "";
  if (row.property == Property::material) {
    properties.material = text;
    return "";
  }
  double value;
  std::string word;
  if (!number_and_unit(text, value, word))
    return "is no number";
  const Dimension dimension = word_of(row.property).dimension;
  const UnitWord *const unit = find_unit(word.empty() ? row.unit : word, dimension);
  if (unit == nullptr)
    return word.empty() ? "has no unit: give it in the table of --attributes"
                        : "has a unit that is none of " + units_of(dimension);
  value = unit->factor * (value + unit->offset);
  if (value < (dimension == Dimension::temperature ? -273.15 : 0.))
    return "is too small a number";
  properties.numbers[row.property] = value;
  return "";
}

} // namespace frictionbeam::import
