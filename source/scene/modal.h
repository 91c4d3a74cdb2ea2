// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
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

/// One response spectrum: the acceleration of an oscillator over its frequency.
struct Spectrum {
  std::string name;
  std::array<double, 3> factor{{1., 1., 1.}};   ///< of the curve in x, y, z; 0: not excited
  std::vector<std::pair<double, double>> curve; ///< frequency [Hz], acceleration [m/s2], rising
  std::vector<std::string> supports;            ///< group that moves; empty: all together

  /// Acceleration at @p frequency [Hz]; beyond its ends the curve is level.
  double at(const double frequency, const bool logarithmic) const;
};

/// Name of the case that the spectra make.
inline constexpr char spectrum_case[] = "spectrum";

struct SpectrumSettings {
  enum class Modes { srss, cqc, absolute } modes = Modes::srss;
  enum class Sum { srss, absolute } directions = Sum::srss, groups = Sum::absolute;
  bool logarithmic = true;   ///< interpolation on log-log axes, else linear
  double damping = 0.05;     ///< ratio, of CQC
  bool missing_mass = false; ///< what the modes leave out, by its static response
};

/// A case made of others afterwards, component by component.
struct Combination {
  enum class Kind { sum, range, envelope, srss, absolute } kind = Kind::sum;
  std::string name;
  std::vector<std::pair<std::string, double>> cases; ///< name of a step or case before, factor
};

} // namespace frictionbeam
