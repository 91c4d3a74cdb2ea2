// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Something that the model's pipes can be coloured by, besides their displacement.
struct ModelField {
  std::string key;           ///< by which the page knows it
  std::string name, si_unit; ///< unit %: a part of 1
  bool is_signed;
  /// At each station of a frame, nan where it is not known; empty: not known in this frame.
  /// @param is_instant whether the frame is within a step
  std::vector<double> (*values)(const Scene &scene, const Results &results, const Frame &frame,
                                const bool is_instant);
};

const std::vector<ModelField> &model_fields();

} // namespace frictionbeam
