// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/run_results.h"
#include "study/sampling.h"
#include "study/variables.h"

#include <optional>

namespace frictionbeam::study {

enum class Outcome { pending, converged, failed, no_equilibrium, refused, error };

inline constexpr Word<Outcome> outcomes[] = {
    {"pending", Outcome::pending, "not run yet"},
    {"converged", Outcome::converged},
    {"failed", Outcome::failed, "the solver did not come to the end of the load sequence"},
    {"no_equilibrium", Outcome::no_equilibrium, "the supports cannot hold the line"},
    {"refused", Outcome::refused, "the values do not make a case"},
    {"error", Outcome::error, "a mistake of the program itself"}};

/// One run of a study.
struct Run {
  Outcome outcome = Outcome::pending;
  std::string reason;          ///< why it has no answer
  std::vector<double> numbers; ///< beside StudyResults::names; empty if it has no answer
};

/// A study's runs, in the order of its design, whatever was run when and where.
struct StudyResults {
  StudySettings settings;
  std::vector<std::string> variables;          ///< their names
  std::vector<std::string> described;          ///< how each varies, in words
  std::vector<double> ranges;                  ///< of Morris' design: how far each goes
  Points design;                               ///< points of the unit cube, by run
  Points values;                               ///< by run, by variable
  std::vector<std::vector<std::string>> texts; ///< the same, as they stand in the file
  std::vector<ResultName> names;
  std::vector<double> nominal; ///< of the case with its entries as they stand
  std::vector<Run> runs;
  std::vector<std::string> remarks;
  UnitSystem units;
  double seconds = 0.;
  unsigned int n_processes = 1, n_threads = 1;
  std::size_t n_resumed = 0; ///< runs of an earlier study that was killed

  std::size_t count(const Outcome outcome) const;
  /// Finite numbers of the runs that have an answer, of one name. @param only the first so many
  /// runs
  std::vector<double> column(const std::size_t name, const std::size_t n_runs) const;
  std::vector<double> column(const std::size_t name) const { return column(name, runs.size()); }
};

} // namespace frictionbeam::study
