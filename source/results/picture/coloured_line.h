// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * The line in isometric view as one SVG element, coloured by a number at each station: a mode by
 * its displacement, stresses by their utilization, sections by what they have yielded. Grey where
 * the number is none (NaN).
 */
struct ColouredLine {
  std::string title, legend;  ///< the legend says what the colours are
  std::vector<double> values; ///< at each station of the frame, >= 0
  double largest = 1.;        ///< of the colour scale
  double scale = 0.;          ///< of displacements, drawn if not 0, beside the line as built

  struct Ring {
    std::size_t station; ///< of the frame
    std::string tooltip;
  };
  std::vector<Ring> rings;  ///< around places of note
  std::string ring_meaning; ///< for the legend
};
std::string draw_coloured_line(const Scene &scene, const Results &results, const Frame &frame,
                               const ColouredLine &what);

} // namespace frictionbeam
