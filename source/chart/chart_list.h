// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace frictionbeam::chart {

/// One curve of a work-precision chart: a way to solve the case, made finer from run to run.
struct Curve {
  std::string name;                  ///< one word, for the advice
  std::string label;                 ///< in the key
  std::string case_file;             ///< path of a parameter file
  std::vector<std::string> settings; ///< "Section/Entry = value"
  std::vector<std::string> varied;   ///< entries that change along the curve, "Section/Entry"
  std::vector<std::vector<std::string>> values; ///< of them, for each run, coarsest first
  std::string command; ///< another program instead; {value} stands for the value
};

/**
 * What `frictionbeam chart` is to do: a case, how its error is measured, and the curves. Read from
 * a file in the format of parameter files, as strictly; `frictionbeam chart --print-parameters`
 * writes all entries with their meaning.
 */
struct ChartList {
  std::string name;   ///< of the file, without folder and ending
  std::string folder; ///< of the file
  std::string title;
  std::string prose; ///< the comment at the top of the file
  std::string advice;
  std::vector<std::string> settings;   ///< of all runs
  std::vector<std::string> quantities; ///< empty: all that have a reference
  std::map<std::string, double> references;
  std::vector<std::string> reference_run; ///< settings of the run that gives the references
  bool has_reference_run = false;
  double floor = 0.01;
  /// Of a run: mesh, set-up and solution; from start to end of the process; of the processor.
  enum class Time { solution, process, processor } time = Time::solution;
  unsigned int n_runs = 3;
  double time_limit = 60.; ///< [s]
  std::vector<Curve> curves;
};

/// @throws UserError with the place, what was read, what is allowed and what to try.
ChartList read_chart_list(const std::string &file);

/// Every entry of a list with unit, bounds and meaning.
void print_chart_parameters(std::ostream &out);

} // namespace frictionbeam::chart
