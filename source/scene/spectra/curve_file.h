// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/spectra/acceleration_record.h"

#include <string>
#include <utility>
#include <vector>

namespace frictionbeam {

/// @file
/// Spectra and records as text: two numbers a line, as rows of tables (table_rows.h). A first line
/// that says what they are, 'frequency [Hz], acceleration [g]', 'period [s], acceleration [m/s2]'
/// or 'time [s], acceleration [in/s2]', is taken at its word.

/// How numbers are to be understood that no header explains.
struct CurveForm {
  bool over_period = false;                    ///< not over the frequency
  double unit = 1.;                            ///< of accelerations [m/s2]
  std::string unit_name = "";                  ///< likewise, as it is written
  bool axis_given = false, unit_given = false; ///< by the user: then no header may say otherwise
};

/// Acceleration units by name, "g, m/s2, ..."; 0 if it is none of them [m/s2].
double acceleration_unit(const std::string &name);
std::string acceleration_units();

/// Points of a spectrum as they are written, with a word for each where it stands.
struct WrittenCurve {
  std::vector<std::pair<double, double>> points; ///< frequency or period, acceleration
  std::vector<std::string> places;               ///< "spectrum.csv:12", or the point itself
};

/**
 * Frequencies [Hz], rising, and accelerations [m/s2]; a period of 0 is an infinite frequency.
 * @throws UserError, beginning with @p where, if there is none, the first column does not rise, a
 * number is negative or the same twice
 */
std::vector<std::pair<double, double>> to_curve(const WrittenCurve &written, const CurveForm &form,
                                                const std::string &where);

/// @throws UserError likewise @param form in: without a header; out: as the file has it
std::vector<std::pair<double, double>> read_curve_file(const std::string &path, CurveForm &form,
                                                       const std::string &where);

/// Likewise, of a record with instants that rise.
AccelerationRecord read_record_file(const std::string &path, CurveForm &form,
                                    const std::string &where);

} // namespace frictionbeam
