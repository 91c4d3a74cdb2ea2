// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// What `frictionbeam spectrum` and `frictionbeam record` are asked for. 0 or empty: chosen.
struct SpectrumOptions {
  std::string file;    ///< a record; of `record`, a spectrum
  std::string folder;  ///< where the results go; empty: output/ and the file's name
  std::string unit;    ///< of accelerations without a header; empty: m/s2
  std::vector<double> damping; ///< ratios; empty: 0.05
  double first = 0., last = 0.; ///< frequencies [Hz]
  unsigned int n_frequencies = 200;

  // of `record`
  double duration = 20., rise = 3., fall = 7., step = 0.; ///< [s]
  unsigned int seed = 1;
  bool over_period = false; ///< the file's first column, without a header
  std::string interpolation = "log-log";
};

/**
 * `frictionbeam spectrum RECORD.csv`: the response spectra of a record for each damping, as
 * spectrum_DAMPING.csv, which a Spectrum reads by its File, and spectrum.html.
 * @return 0; throws UserError
 */
int spectrum_command(const SpectrumOptions &options);

/**
 * `frictionbeam record SPECTRUM.csv`: a record whose spectrum comes near that one (match_record()),
 * as record.csv, which histories and a Spectrum's Record read, with the ground's velocity and
 * displacement in record_motion.csv, its spectrum beside the target in record_spectrum.csv, and all
 * in record.html.
 * @return 0, or 2 if it does not fit; throws UserError
 */
int record_command(const SpectrumOptions &options);

} // namespace frictionbeam
