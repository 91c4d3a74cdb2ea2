// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Keeps some of a transient step's instants of output in Results::instants, for the page to play
 * and for its histories: at even distances among those that were put out, at most 120, fewer of a
 * long line, so that their stations stay within what a page can hold. Where more come, every other
 * one is dropped. The end of a step is in Results::frames.
 */
class KeptInstants {
public:
  KeptInstants(const Scene &scene, Results &results);

  /// To be called with every frame that is put out, in order.
  void add(const Frame &frame);
  void transfer(Archive &archive);

private:
  std::size_t most_of(const Frame &frame) const;

  const Scene &scene;
  Results &results;
  std::size_t n_steps = 0;                           ///< that are transient
  std::size_t first = 0;                             ///< of the step, in Results::instants
  std::size_t n_seen = 0, every = 1;                 ///< of the step's instants
  unsigned int step = static_cast<unsigned int>(-1); ///< at hand
};

} // namespace frictionbeam
