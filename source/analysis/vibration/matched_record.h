// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/modal.h"

#include <functional>

namespace frictionbeam {

/// What a record that fits a spectrum shall be like.
struct MatchedRecordSettings {
  double duration = 20.;              ///< of all [s]
  double rise = 3., fall = 7.;        ///< of its beginning and end, the rest is strong [s]
  double step = 0.;                   ///< between instants [s]; 0: chosen
  double damping = 0.05;              ///< of the spectrum, ratio
  double first = 0., last = 0.;       ///< frequencies that shall fit [Hz]; 0: those of the curve
  Spectrum::Interpolation interpolation = Spectrum::Interpolation::logarithmic;
  unsigned int seed = 1;              ///< of the phases, the first that is tried
  unsigned int n_seeds = 8;           ///< that are tried until a record fits
  unsigned int n_frequencies = 200;   ///< that are compared
  unsigned int n_iterations = 25;     ///< at most, of each
};

/// The record, and its spectrum beside the one asked for.
struct MatchedRecord {
  AccelerationRecord record;
  std::vector<double> frequency, target, response; ///< [Hz, m/s2]
  double least = 0., largest = 0.;                 ///< of response over target
  unsigned int seed = 0, iterations = 0;

  /// Within what NUREG-0800, section 3.7.1 (revision 4), option 1, approach 2, asks of a spectrum:
  /// nowhere more than 10 % below and 30 % above the target.
  bool fits() const { return least >= 0.9 && largest <= 1.3; }
};

/**
 * An artificial record whose spectrum comes near a given one, by random phases (D. A. Gasparini, E.
 * H. Vanmarcke, "Simulated earthquake motions compatible with prescribed response spectra", MIT
 * R76-4 (1976)):
 *   a(t) = E(t) sum A_j cos(2 pi f_j t + p_j), f_j = j/duration,
 * with E = (t/rise)^2, 1, cos^2 over the fall. The A_j are multiplied by target over response at
 * f_j again and again, response being the exact spectrum of the record (acceleration_record.h). Two
 * smooth waves as long as the record take velocity and displacement of the ground to zero at its
 * end. The best of all iterations is given back, of the first seed whose best fits, or of all.
 * Equal settings give equal records.
 */
MatchedRecord match_record(const Spectrum &spectrum, const MatchedRecordSettings &settings);

/// Choose first, last and step where they are 0; the duration is then a multiple of the step.
void choose_free(const Spectrum &spectrum, MatchedRecordSettings &settings);

} // namespace frictionbeam
