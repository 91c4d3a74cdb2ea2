// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/resolution.h"
#include "model/line_state.h"
#include "model/model.h"

#include <optional>

namespace frictionbeam {

/// Gathers the Resolution of the steps of a sequence, state by state.
class FollowResolution {
public:
  /// @param model of the whole line, not a reduced one
  explicit FollowResolution(const Model &model);

  /// What follows is another step.
  void begin_step() { slips.clear(); }
  /// A static increment. It adds up over the steps of the sequence by how much slip has turned.
  void add_increment(const LineState &before, const LineState &after, Resolution &resolution);
  /// @param is_exact whether the integrator's answers do not depend on the time step
  void add_time_step(const LineState &before, const LineState &after, const bool is_exact,
                     Resolution &resolution) const;
  void transfer(Archive &archive);

private:
  void add_displacement(const LineState &state, Resolution &resolution) const;

  const Model &model;
  bool forces_lag;                        ///< whether a contact's law answers to rates
  std::vector<unsigned int> translations; ///< degrees of freedom
  std::vector<bool> is_translation;       ///< of each unknown
  std::vector<double> slip_turned;        ///< of each contact, so far [m]
  std::vector<std::optional<Eigen::Matrix2d>> compliances; ///< of contacts that have slipped [m/N]

  /// Of a contact in the present step.
  struct SlipOfStep {
    unsigned int n_increments = 0;
    double bent = 0.; ///< the last one, if its way may bend [m]
  };
  std::vector<SlipOfStep> slips;
};

} // namespace frictionbeam
