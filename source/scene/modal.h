// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/spectra/acceleration_record.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * What a scene says of modes, response spectra and combinations of cases. Plain data in SI units.
 */
namespace frictionbeam {

struct ModalSettings {
  unsigned int n_modes = 0;   ///< 0: no modes
  bool lumped = false;        ///< half of each cell's mass at either end, no rotary inertia
  std::string step;           ///< its end decides which supports hold; empty: the last one
  bool friction_holds = true; ///< a sticking support holds sideways; else friction is off
};

/// One response spectrum: the pseudo-acceleration of an oscillator over its frequency.
struct Spectrum {
  /// Straight between two points of a curve: on log-log axes, over the frequency, over the period.
  enum class Interpolation { logarithmic, in_frequency, in_period };

  std::string name;
  std::array<double, 3> factor{{1., 1., 1.}};   ///< of the curve in x, y, z; 0: not excited
  std::vector<std::pair<double, double>> curve; ///< frequency [Hz], acceleration [m/s2], rising
  std::vector<std::string> supports;            ///< group that moves; empty: all together
  /// Whose spectrum this is; then #curve is its last point alone, the largest acceleration, and
  /// each mode has an oscillator of its own. Null: the curve is given.
  std::shared_ptr<const AccelerationRecord> record;
  double damping = 0.05; ///< of the record's oscillators, ratio

  /// Acceleration at @p frequency [Hz]; beyond its ends the curve is level.
  double at(const double frequency, const Interpolation interpolation) const;
  /// Zero-period acceleration, that of the last point [m/s2].
  double at_zero_period() const { return curve.back().second; }
};

/// Name of the case that the spectra make.
inline constexpr char spectrum_case[] = "spectrum";

struct SpectrumSettings {
  /// How modes are combined; formulas and sources in results/spectrum/modal_combination.h.
  enum class Modes {
    srss,
    cqc,
    absolute,
    grouping,
    ten_percent,
    double_sum,
    signed_double_sum
  } modes = Modes::srss;
  enum class Sum { srss, absolute } directions = Sum::srss, groups = Sum::absolute;
  bool directions_first = false; ///< combined in each mode, before the modes are
  Spectrum::Interpolation interpolation = Spectrum::Interpolation::logarithmic;
  double damping = 0.05;     ///< ratio, of CQC and double sums
  double duration = 0.;      ///< of the earthquake, of double sums [s]
  bool missing_mass = false; ///< what the modes leave out, by its static response
  /// Which part of a mode's response is in phase with the ground.
  enum class Rigid { none, lindley_yow, gupta } rigid = Rigid::none;
  std::array<double, 2> rigid_frequencies{}; ///< of Gupta: from none to all of it [Hz]
  bool write_modes = false;                  ///< all numbers of each mode as CSV

  bool needs_signs() const { return modes == Modes::cqc || modes == Modes::signed_double_sum; }
  bool is_double_sum() const {
    return modes == Modes::double_sum || modes == Modes::signed_double_sum;
  }
};

/// A case made of others afterwards, component by component.
struct Combination {
  enum class Kind { sum, range, envelope, srss, absolute, maximum, minimum } kind = Kind::sum;
  std::string name;
  std::vector<std::pair<std::string, double>> cases; ///< name of a step or case before, factor
};

} // namespace frictionbeam
