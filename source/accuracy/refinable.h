// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/convergence.h"
#include "results/results.h"
#include "scene/file/parameter_file.h"
#include "scene/scene.h"

#include <functional>

namespace frictionbeam::accuracy {

/// One thing that can be made finer: from level to level twice as fine.
struct Refinable {
  std::string name;                                                           ///< for the user
  std::function<std::vector<std::string>(const unsigned int level)> settings; ///< as of --set
  bool coarsest_may_be_exact = false; ///< as one increment is, where friction only grows
  bool depends_on_next = false;       ///< of the list: both are refined together
  /// Of its errors: 1 at best where friction has a history, regular where no slip or contact can be
  /// met here or there, as by cells.
  Convergence::Order order = Convergence::Order::unknown;
  /// What of an answer no difference from coarser ones shows, relative; null: nothing.
  std::function<double(const Scene &, const Results &)> hidden;
  /// Coarser levels may agree for what they all step over, unless increments are known to be exact.
  unsigned int level_of_proof = 0;

  double hidden_in(const Scene &scene, const Results &results) const {
    return hidden ? hidden(scene, results) : 0.;
  }
  /// Whether it means something that an answer agrees with coarser ones to an estimate.
  bool proves(const unsigned int level, const double estimate, const Results &results) const {
    return level >= level_of_proof || estimate > rounding || results.known.increments.error == 0.;
  }
  /// Whether the coarsest level is as good as one that agrees so with that before it.
  bool coarsest_will_do(const unsigned int level_before, const double estimate) const {
    return coarsest_may_be_exact && (level_before == 0 || estimate <= rounding);
  }

  static constexpr double rounding = 1e-9; ///< of answers that agree
};

/**
 * What of a line scene the program may choose, in the order of choice: increments of static steps
 * with friction, time step, cell length where beds or masses are spread over cells or displacements
 * are large, supports and elements of generated scenes. Empty: the answer depends on none.
 */
std::vector<Refinable> refinables(const Scene &scene, const ParameterFile &file);

/// The line of a scene that is a continuum as well, in two forms.
struct LineForms {
  std::vector<std::string> best, ///< settings with which it follows the continuum most closely
      without_last_correction;   ///< the same but for the smallest of its corrections
};

/**
 * Of the slab, the only such scene: with the Poisson squeeze, and with and without the shear lag
 * (SlabLine), on elements half as long as the slab is high, or shorter. What the lag changes bounds
 * what is left in every case of doc/accuracy.md, which is less than two thirds of it.
 */
LineForms line_forms(const Scene &scene, const ParameterFile &file);

/// Settings of a continuum: refined adaptively until the errors of its quantities are estimated to
/// be no more than @p demanded, from a coarse mesh of a generated body, on elements of degree 2,
/// and 3 where less than 1e-3 is demanded; the cells that hold 0.7 of the squared estimate are
/// refined, the least that kept what was demanded in all cases of doc/accuracy.md.
std::vector<std::string> continuum_settings(const Scene &scene, const double demanded);

/// Settings that cost nothing and are exact: bends as arcs.
std::vector<std::string> exact_settings(const Scene &scene);

} // namespace frictionbeam::accuracy
