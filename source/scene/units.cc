// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/units.h"

#include "base/unit_constants.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace frictionbeam {

namespace {

struct UnitWord {
  const char *name;
  char dimension;
  double factor; ///< SI units in one of it
};

constexpr double pound_force = pound * standard_gravity;

constexpr UnitWord words[] = {{"m", 'l', 1.},
                              {"mm", 'l', 1e-3},
                              {"cm", 'l', 1e-2},
                              {"in", 'l', inch},
                              {"ft", 'l', 12. * inch},
                              {"N", 'f', 1.},
                              {"kN", 'f', 1e3},
                              {"lb", 'f', pound_force},
                              {"kip", 'f', 1e3 * pound_force},
                              {"kgf", 'f', standard_gravity},
                              {"kg", 'm', 1.},
                              {"t", 'm', 1e3},
                              {"lbm", 'm', pound},
                              {"slug", 'm', pound_force / (12. * inch)},
                              {"Pa", 'p', 1.},
                              {"kPa", 'p', 1e3},
                              {"MPa", 'p', 1e6},
                              {"bar", 'p', 1e5},
                              {"psi", 'p', pound_force / (inch * inch)},
                              {"ksi", 'p', 1e3 * pound_force / (inch * inch)},
                              {"s", 's', 1.},
                              {"C", 't', 1.},
                              {"F", 't', 5. / 9.}};

struct Power {
  std::string base, exponent; ///< of "m3": m, 3; of "m^0.2": m, ^0.2; of "m": m, nothing
  double value() const {
    if (exponent.empty())
      return 1.;
    double number = 1.; // of a name: not known here
    to_number(exponent[0] == '^' ? exponent.substr(1) : exponent, number);
    return number;
  }
};

Power power(const std::string &word) {
  const auto end = word.find_first_of("^0123456789");
  if (end == std::string::npos || end == 0)
    return {word, ""};
  return {word.substr(0, end), word.substr(end)};
}

/// "N/m^(Plastic exponent)" as "N/m^".
std::string without_exponents_in_brackets(std::string unit) {
  for (auto begin = unit.find("^("); begin != std::string::npos; begin = unit.find("^("))
    unit.erase(begin + 1, unit.find(')', begin) - begin);
  return unit;
}

} // namespace

std::optional<UnitSystem> UnitSystem::parse(const std::string &text) {
  UnitSystem result;
  if (tidy(text) == "si")
    return result;
  bool any = false;
  std::string seen;
  for (const std::string &name : split(text, ' ')) {
    const UnitWord *found = nullptr;
    for (const UnitWord &word : words)
      if (name == word.name)
        found = &word;
    if (found == nullptr || seen.find(found->dimension) != std::string::npos)
      return {};
    seen += found->dimension;
    any = true;
    if (found->dimension != 's')
      result.given[found->dimension] = {name, found->factor};
  }
  // A length or force alone would leave mass and stress to guess.
  if (!any || (result.given.count('l') != result.given.count('f')))
    return {};
  return result;
}

std::string UnitSystem::known_words() {
  std::string text = "si";
  for (const UnitWord &word : words)
    text += std::string(", ") + word.name;
  return text;
}

std::optional<UnitSystem::Unit> UnitSystem::base(const std::string &word) const {
  const auto of = [&](const char dimension, const std::string &otherwise) {
    const auto found = given.find(dimension);
    return found == given.end() ? Unit{otherwise, 1.} : found->second;
  };
  const Unit l = of('l', "m"), f = of('f', "N");
  const bool metric = l.factor == 1. && f.factor == 1.;
  if (word == "m")
    return l;
  if (word == "N")
    return f;
  if (word == "J")
    return metric ? Unit{"J", 1.} : Unit{l.name + " " + f.name, l.factor * f.factor};
  if (word == "kg")
    return given.count('m') > 0 || metric ? of('m', "kg")
                                          : Unit{f.name + " s2/" + l.name, f.factor / l.factor};
  if (word == "Pa")
    return given.count('p') > 0 || metric
               ? of('p', "Pa")
               : Unit{f.name + "/" + l.name + "2", f.factor / (l.factor * l.factor)};
  if (word == "K" || word == "degC") {
    const auto found = given.find('t');
    if (found != given.end() && found->second.name == "F")
      return Unit{"degF", found->second.factor};
  }
  return {};
}

std::optional<double> UnitSystem::known_factor(const std::string &si_unit) const {
  constexpr const char *as_they_are[] = {"-",       "1",  "s", "h",    "g", "rad",
                                         "degrees", "Hz", "K", "degC", "%"};
  double result = 1.;
  bool below = false;
  for (const std::string &part : split(without_exponents_in_brackets(si_unit), '/')) {
    for (const std::string &word : split(part, ' ')) {
      const Power of_word = power(word);
      const auto is_it = [&](const char *const known) { return of_word.base == known; };
      if (const std::optional<Unit> unit = base(of_word.base))
        result *= std::pow(unit->factor, (below ? -1. : 1.) * of_word.value());
      else if (std::none_of(std::begin(as_they_are), std::end(as_they_are), is_it))
        return {};
    }
    below = true;
  }
  return result;
}

double UnitSystem::factor(const std::string &si_unit) const {
  return is_si() ? 1. : known_factor(si_unit).value_or(1.);
}

std::string UnitSystem::name(const std::string &si_unit) const {
  if (is_si() || !converts(si_unit))
    return si_unit;
  std::string result;
  bool below = false;
  for (const std::string &part : split(si_unit, '/')) {
    std::string piece;
    for (const std::string &word : split(part, ' ')) {
      const Power of_word = power(word);
      const std::optional<Unit> unit = base(of_word.base);
      std::string name = unit ? unit->name : of_word.base;
      if (unit && name.find_first_of(" /") != std::string::npos &&
          (below || !of_word.exponent.empty()))
        name = "(" + name + ")";
      piece += (piece.empty() ? "" : " ") + name + of_word.exponent;
    }
    result += (below ? "/" : "") + piece;
    below = true;
  }
  return result;
}

double UnitSystem::celsius(const double temperature) const {
  const auto found = given.find('t');
  return found != given.end() && found->second.name == "F" ? (temperature - 32.) * 5. / 9.
                                                           : temperature;
}

} // namespace frictionbeam
