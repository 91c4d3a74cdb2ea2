// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "results/results.h"

#include <memory>

namespace frictionbeam {

/**
 * Gathers the envelopes of transient steps: at every instant that the analysis reports, not only at
 * those of output, the least and largest values of support forces, reactions, section forces and
 * displacements, the stresses of the code's formulas and the use of nozzles. The start of a step is
 * the first of its instants. Whatever is not linear in the forces (sizes, stresses, ratios) is
 * evaluated at each instant, and not made of extremes of different ones.
 */
class Envelope {
public:
  /// @param results that know their supports, restraints and points; the envelopes go there
  Envelope(const Model &model, Results &results);
  ~Envelope();

  /// To be called after every increment of the analysis. @param line_is_known of a reduced line,
  /// whether the state is that of the whole line
  void observe(const unsigned int step, const unsigned int increment,
               const unsigned int n_increments, const LineState &state,
               const bool line_is_known = true);

  /// Whether a step's answer depends on the whole line at every instant: stresses and combinations.
  /// Elsewhere the section forces of a reduced line are looked at where they are known anyway;
  /// supports and reactions at every instant.
  bool needs_line(const unsigned int step) const;

  /// What was gathered so far, with the envelopes.
  void transfer(Archive &archive);

private:
  struct Tools;
  struct Stresses;

  void begin(const unsigned int step, const LineState &state);
  /// Make what evaluates states of a step.
  void prepare(const unsigned int step);
  void include(const LineState &state, const bool line_is_known);
  void include_supports(const LineState &state);
  void include_line(const LineState &state);
  void include_reactions(const double time, const std::vector<Motion> &reactions);
  void include_displacements(const LineState &state);
  /// @param forces six of each of the stations from @p first on
  void include_forces(const double time, const unsigned int first, const double *const forces,
                      const unsigned int n_stations);
  /// Whether a rigid contact closed in the time step.
  bool strikes(const LineState &state, const unsigned int i) const;
  /// Whether its force at this instant is then the impulse over the length of the time step:
  /// `event` keeps them apart.
  bool is_impulse(const LineState &state, const unsigned int i) const;

  const Model &model;
  Results &results;
  std::unique_ptr<Tools> tools;       ///< what makes numbers of states; null before the first step
  std::unique_ptr<Stresses> stresses; ///< of the step at hand
  std::vector<ContactStatus> previous_status;
  std::vector<double> previous_impulse;
};

} // namespace frictionbeam
