// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/wall_cells.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// error = factor eta^power
struct ErrorOfCells {
  double factor, power;
};
constexpr ErrorOfCells of_degree_2{0.044, 1.6}, of_degree_3{0.001, 1.9};
constexpr double two_pi = 2. * dealii::numbers::PI;
constexpr unsigned int fewest_cells = 8, most_cells = 200; // of Solid/Cells around

} // namespace

std::optional<double> flexibility_error(const unsigned int degree, const unsigned int n_around,
                                        const double r_over_t) {
  if (degree < 2)
    return {};
  const double eta = std::pow(two_pi / n_around, 2) * r_over_t;
  const ErrorOfCells &cells = degree == 2 ? of_degree_2 : of_degree_3; // 4 is better than 3
  return std::min(1., cells.factor * std::pow(eta, cells.power));
}

unsigned int cells_around_for(const double error, const double r_over_t) {
  const double eta = std::pow(error / of_degree_3.factor, 1. / of_degree_3.power),
               n = std::min<double>(most_cells, two_pi * std::sqrt(r_over_t / eta));
  return std::max<unsigned int>(fewest_cells, 4 * std::ceil(n / 4.));
}

} // namespace frictionbeam
