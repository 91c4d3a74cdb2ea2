// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace frictionbeam {

/// Weights of values at @p places in the value at @p x of the polynomial through all of them.
/// @tparam Places an array or vector of numbers, each once
template <typename Places>
Places lagrange_weights(const Places &places, const double x) {
  Places weights = places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights[i] = 1.;
    for (std::size_t j = 0; j < places.size(); ++j)
      if (j != i)
        weights[i] *= (x - places[j]) / (places[i] - places[j]);
  }
  return weights;
}

} // namespace frictionbeam
