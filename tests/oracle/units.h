// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <map>
#include <sstream>
#include <string>

namespace oracle {

/// What one unit of a file is in SI, from the words of its entry 'Units'.
struct Units {
  double length = 1., force = 1., mass = 1., stress = 1.;
  bool fahrenheit = false;

  explicit Units(const std::string &words) {
    const double inch = 0.0254, pound = 0.45359237, lbf = pound * 9.80665;
    const std::map<std::string, double> lengths = {
        {"m", 1.}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", inch}, {"ft", 12. * inch}};
    const std::map<std::string, double> forces = {
        {"N", 1.}, {"kN", 1e3}, {"lb", lbf}, {"kip", 1e3 * lbf}, {"kgf", 9.80665}};
    const std::map<std::string, double> masses = {
        {"kg", 1.}, {"t", 1e3}, {"lbm", pound}, {"slug", lbf / (12. * inch)}};
    const std::map<std::string, double> stresses = {{"Pa", 1.},
                                                    {"kPa", 1e3},
                                                    {"MPa", 1e6},
                                                    {"bar", 1e5},
                                                    {"psi", lbf / (inch * inch)},
                                                    {"ksi", 1e3 * lbf / (inch * inch)}};
    std::istringstream in(words);
    bool mass_given = words == "si", stress_given = mass_given;
    for (std::string word; in >> word;) {
      if (lengths.count(word))
        length = lengths.at(word);
      if (forces.count(word))
        force = forces.at(word);
      if (masses.count(word))
        mass = masses.at(word);
      if (stresses.count(word))
        stress = stresses.at(word);
      mass_given = mass_given || masses.count(word) > 0;
      stress_given = stress_given || stresses.count(word) > 0;
      fahrenheit = fahrenheit || word == "F";
    }
    const bool metric = length == 1. && force == 1.; // kg and Pa, as in SI
    if (!mass_given && !metric)
      mass = force / length; // times s2
    if (!stress_given && !metric)
      stress = force / (length * length);
  }

  double temperature(const double celsius) const {
    return fahrenheit ? celsius * 9. / 5. + 32. : celsius;
  }
  double per_degree(const double per_kelvin) const {
    return fahrenheit ? per_kelvin * 5. / 9. : per_kelvin;
  }
};

} // namespace oracle
