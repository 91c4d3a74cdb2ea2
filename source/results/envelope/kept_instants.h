// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * What a page holds of the motions of transient steps, in stations times instants of all of them: a
 * support counts as ten stations, the least and largest of six section forces with their instants
 * (24 numbers, of an instant there are some 7) as four instants.
 */
class MotionBudget {
public:
  MotionBudget(const Scene &scene, const std::size_t n_stations, const std::size_t n_supports);

  /// Whether there is room for the least and largest section forces at the stations.
  bool has_envelopes() const { return of_envelopes > 0; }
  /// Instants of each step, 0 or at least 2.
  std::size_t n_instants() const;

private:
  std::size_t of_instant, of_envelopes = 0, n_steps;
};

/**
 * Keeps some of a transient step's instants of output in Results::instants, for the page to play
 * and for its histories: at even distances among those that were put out, as many as MotionBudget
 * has. Where more come, every other one is dropped. The end of a step is in Results::frames.
 */
class KeptInstants {
public:
  KeptInstants(const Scene &scene, Results &results);

  /// To be called with every frame that is put out, in order.
  void add(const Frame &frame);
  void transfer(Archive &archive);

private:
  const Scene &scene;
  Results &results;
  std::size_t first = 0;                             ///< of the step, in Results::instants
  std::size_t n_seen = 0, every = 1;                 ///< of the step's instants
  unsigned int step = static_cast<unsigned int>(-1); ///< at hand
};

} // namespace frictionbeam
