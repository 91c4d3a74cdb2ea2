// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace frictionbeam::import {

/// What an attribute of a component may say, in SI units inside.
enum class Property {
  outer_diameter,        ///< [m]
  wall,                  ///< [m]
  second_outer_diameter, ///< of a reducer's second end, of a tee's branch [m]
  second_wall,           ///< likewise [m]
  corrosion_allowance,   ///< [m]
  insulation,            ///< thickness [m]
  insulation_density,    ///< [kg/m3]
  contents,              ///< density of what fills the pipe [kg/m3]
  temperature,           ///< of operation [degC]
  pressure,              ///< inside, above the one outside [Pa]
  weight,                ///< of the whole component [kg]
  spring_rate,           ///< of a support [N/m]
  cold_load,
  hot_load, ///< likewise [N]
  material, ///< a name
  none      ///< known, and without effect here
};

/// What has been read of a component's attributes.
struct Properties {
  std::map<Property, double> numbers;
  std::string material;

  std::optional<double> number(const Property property) const {
    const auto found = numbers.find(property);
    return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
  }
  /// Take over from @p others what is not given.
  void complete(const Properties &others);
};

/**
 * Which attribute says what. The numbers of COMPONENT-ATTRIBUTEn have no meaning of their own:
 * every program and every project gives them its own. Rows `KEY property [unit]`, # begins a
 * comment; the unit holds where the value has none.
 */
class AttributeTable {
public:
  /// @param choice "none", "caesar", "caepipe", or the path of a file with such rows
  /// @param in_inches what the units of "caepipe" depend on
  /// @throws UserError for a file that cannot be read or a row that is not understood
  AttributeTable(const std::string &choice, const bool in_inches);

  struct Row {
    Property property;
    std::string unit; ///< empty: none
  };
  const Row *find(const std::string &key) const;

  /**
   * Read the value of an attribute into @p properties.
   * @return empty, or why it is not understood
   */
  static std::string read(const Row &row, const std::string &text, Properties &properties);

private:
  void add(const std::string &line, const std::string &place);

  std::map<std::string, Row> rows;
};

/// A length with its unit, "7.11 mm" or "0.28in"; empty if it is none.
std::optional<double> parse_length(const std::string &text);

} // namespace frictionbeam::import
