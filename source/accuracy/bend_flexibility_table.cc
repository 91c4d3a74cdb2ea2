// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/bend_flexibility_table.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frictionbeam::accuracy {

namespace {

constexpr double right_angle = dealii::numbers::PI_2;
constexpr std::array<double, 4> h_measured = {0.1, 0.2, 0.5, 1.};
constexpr std::array<double, 3> radii = {3., 6., 10.};
constexpr std::array<double, 2> tangents = {1., 4.};
constexpr double least_angle = right_angle / 4.;
constexpr std::array<double, 2> angles_measured = {right_angle / 2., right_angle};

/// k in the plane with tangents of 1 and 4 diameters, and across it.
struct Measured {
  std::array<double, 2> in_plane, across;
};
/// By angle (90 and 45 degrees), R/r and h: prm/benchmark/bend_flexibility.py.
constexpr Measured table[2][3][4] = {{{{{13.09, 15.07}, {14.05, 13.95}},
                                       {{6.86, 7.29}, {6.76, 6.70}},
                                       {{2.75, 2.77}, {2.58, 2.57}},
                                       {{1.54, 1.54}, {1.45, 1.45}}},
                                      {{{13.58, 15.47}, {15.83, 15.23}},
                                       {{7.00, 7.57}, {7.49, 7.35}},
                                       {{2.84, 2.89}, {2.84, 2.81}},
                                       {{1.57, 1.57}, {1.55, 1.54}}},
                                      {{{13.88, 15.45}, {16.44, 15.62}},
                                       {{7.05, 7.64}, {7.75, 7.60}},
                                       {{2.87, 2.94}, {2.94, 2.91}},
                                       {{1.58, 1.59}, {1.58, 1.58}}}},
                                     {{{{9.07, 13.37}, {8.63, 10.70}},
                                       {{5.14, 6.10}, {4.61, 5.00}},
                                       {{2.26, 2.31}, {1.99, 2.00}},
                                       {{1.40, 1.40}, {1.26, 1.26}}},
                                      {{{10.25, 14.33}, {11.78, 12.15}},
                                       {{5.50, 6.80}, {5.65, 5.82}},
                                       {{2.46, 2.58}, {2.33, 2.32}},
                                       {{1.48, 1.49}, {1.41, 1.41}}},
                                      {{{11.66, 14.52}, {14.79, 13.29}},
                                       {{5.88, 7.12}, {6.59, 6.40}},
                                       {{2.57, 2.73}, {2.55, 2.52}},
                                       {{1.52, 1.53}, {1.48, 1.47}}}}};

/// Where a value stands among measured ones: the interval, and how far in it (0 to 1).
struct Interval {
  unsigned int below = 0;
  double part = 0.;
  template <typename Value>
  double operator()(const Value &value) const {
    return (1. - part) * value(below) + part * value(below + 1);
  }
};

/// By logarithms, level beyond.
template <std::size_t n>
Interval place_of(const double value, const std::array<double, n> &measured) {
  Interval place;
  while (place.below + 2 < n && measured[place.below + 1] < value)
    ++place.below;
  const double low = measured[place.below], high = measured[place.below + 1];
  place.part = std::clamp(std::log(value / low) / std::log(high / low), 0., 1.);
  return place;
}

/// Part that the table may be off: within it, and where it is continued.
double off(const BendShape &bend) {
  constexpr double within = 0.04, thinner = 0.06, shorter = 0.15;
  const double slack = 1. + 1e-6;
  return bend.angle * slack < angles_measured[0] || bend.angle > slack * angles_measured[1]
             ? shorter
         : bend.h < h_measured.front() || bend.radius_ratio < 2. ? thinner
                                                                 : within;
}

} // namespace

BendRatios ratios_of_walls(const BendShape &bend) {
  const Interval h = place_of(bend.h, h_measured), radius = place_of(bend.radius_ratio, radii);
  const Interval tangent{
      0, std::clamp((bend.tangent - tangents[0]) / (tangents[1] - tangents[0]), 0., 1.)};
  const Interval angle{0, right_angle / std::clamp(bend.angle, least_angle, right_angle) - 1.};
  const auto ratio = [&](const auto &of) {
    return angle([&](const unsigned int a) {
      return radius([&](const unsigned int R) {
        return h([&](const unsigned int i) {
          return tangent([&](const unsigned int t) { return of(table[a][R][i])[t]; }) *
                 h_measured[i] / 1.65;
        });
      });
    });
  };
  return {ratio([](const Measured &one) { return one.in_plane; }),
          ratio([](const Measured &one) { return one.across; }), off(bend)};
}

double added_by_cut(const double lengths, const double angle) {
  constexpr double of_shorter = 0.6;
  constexpr std::array<double, 5> cut = {0., 0.3, 0.6, 1.2, longest_cut},
                                  added = {0.5, 0.049, 0.026, 0.013, 0.0013};
  std::size_t i = 1;
  while (i + 1 < cut.size() && cut[i] < lengths)
    ++i;
  const double part = std::clamp((lengths - cut[i - 1]) / (cut[i] - cut[i - 1]), 0., 1.);
  return added[i - 1] * std::pow(added[i] / added[i - 1], part) *
         std::pow(right_angle / angle, of_shorter);
}

} // namespace frictionbeam::accuracy
