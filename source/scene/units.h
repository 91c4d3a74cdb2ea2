// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

namespace frictionbeam {

/**
 * The units that a parameter file is written in and its results are shown in; inside, all is SI.
 *
 * Made from words such as `in lb s F`: a length, a force, and where they differ from what follows
 * from these two, a mass, a stress and a temperature. Mass is force times s2 over length, stress is
 * force over length squared. Angles and times have no choice.
 */
class UnitSystem {
public:
  /// SI.
  UnitSystem() = default;

  /// The system that @p words name ("si", "mm N", "in lb s psi F"); empty if one is not known or
  /// two stand for the same.
  static std::optional<UnitSystem> parse(const std::string &words);
  /// Every word there is, for messages.
  static std::string known_words();

  bool is_si() const { return given.empty(); }

  /// Whether numbers in @p si_unit are converted: not if it has brackets or words that no system of
  /// units knows, such as W. Those stay in SI units.
  bool converts(const std::string &si_unit) const { return known_factor(si_unit).has_value(); }
  /// How many of @p si_unit (such as "N/m", "kg/m3", "degC", "N/m^0.2") one of the user's units is.
  double factor(const std::string &si_unit) const;
  /// The user's unit for @p si_unit.
  std::string name(const std::string &si_unit) const;
  /// A temperature of the user's in degrees Celsius.
  double celsius(const double temperature) const;

private:
  struct Unit {
    std::string name;
    double factor;
  };
  /// Empty where it has words that are not known.
  std::optional<double> known_factor(const std::string &si_unit) const;
  /// Unit of one base word of SI: m, N, kg, Pa, K, J; none: as it is.
  std::optional<Unit> base(const std::string &word) const;

  std::map<char, Unit> given; ///< by dimension: l, f, m, p, t
};

} // namespace frictionbeam
