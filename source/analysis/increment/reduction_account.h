// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"

#include <optional>
#include <string>
#include <vector>

namespace frictionbeam {

/// How a transient step was reduced to contact nodes and modes.
struct ReductionAccount {
  /// A run that only asked how many modes are enough.
  struct Trial {
    unsigned int n_modes = 0;
    double seconds = 0.;
    std::optional<double> forces, motions; ///< change since the trial before, relative
    bool converged = false;

    void transfer(Archive &archive) { archive(n_modes, seconds, forces, motions, converged); }
  };

  bool is_reduced = false; ///< if not, remark says why
  unsigned int n_line = 0, n_reduced = 0, n_kept = 0, n_modes = 0,
               n_static_shapes = 0; ///< unknowns
  unsigned int n_left_out = 0;      ///< modes of the line with its kept nodes held
  double highest_frequency = 0., next_frequency = 0.; ///< of those taken and left out [Hz]; 0: none
  std::optional<double> demanded, estimate;           ///< error, relative, of Modes = auto
  std::vector<Trial> trials;
  std::string remark;

  void transfer(Archive &archive) {
    archive(is_reduced, n_line, n_reduced, n_kept, n_modes, n_static_shapes, n_left_out,
            highest_frequency, next_frequency, demanded, estimate, trials, remark);
  }
};

} // namespace frictionbeam
