// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * The run's times at which the time of histories begins, as seen from one step of the sequence.
 *
 * `History time = run`: 0, the beginning of the run. `step`: the beginning of the first of the
 * steps that follow each other up to this one, all static or all transient, and in all of which the
 * load acts; a load that goes back to zero in this step keeps the time that it had. Motions of the
 * ground act in all steps. Each cycle of steps that repeat themselves is a beginning. Static steps
 * begin where the one before has ended, their Duration being their time. The step before is that of
 * the entry From; what others took in between, which the run's time counts on, counts for none of
 * these.
 */
struct HistoryOrigins {
  std::vector<double> loads; ///< beside Scene::loads [s]
  double ground = 0.;        ///< of motions of the ground with the clock `step` [s]
  double elsewhere = 0.; ///< of the run's time, what steps took that do not lead to this one [s]

  HistoryOrigins() = default;
  HistoryOrigins(const Scene &scene, const unsigned int step);

  double of_ground(const TimeFunction &motion) const {
    return motion.clock == TimeFunction::Clock::run ? elsewhere : ground;
  }
};

/// Whether a load, by its number, acts in a step: with a factor that is not 0.
bool acts(const LoadStep &step, const unsigned int load);

} // namespace frictionbeam
