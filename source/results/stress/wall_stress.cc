// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/wall_stress.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace frictionbeam {

Section section_at(const Scene &scene, const Station &station) {
  const Pipe &pipe = scene.pipes[station.pipe];
  const Section &section = scene.sections[pipe.section];
  return pipe.end_section ? between(section, scene.sections[*pipe.end_section], station.part)
                          : section;
}

namespace {

constexpr unsigned int n_angles = 16; ///< round the wall, at which peaks are sought first
constexpr double between_angles = 2. * M_PI / n_angles;

struct Angle {
  double cosine, sine;
};

std::array<Angle, n_angles> make_directions() {
  std::array<Angle, n_angles> directions;
  for (unsigned int i = 0; i < n_angles; ++i)
    directions[i] = {std::cos(i * between_angles), std::sin(i * between_angles)};
  constexpr unsigned int quarter = n_angles / 4; // to the last digit
  directions[quarter].cosine = directions[2 * quarter].sine = directions[3 * quarter].cosine = 0.;
  return directions;
}

/// The largest value of a function of the Angle, with waves no shorter than half of the round.
template <typename Function>
double largest_round(const Function &value_at) {
  constexpr int bits = 24; // of an angle: its value has twice as many
  static const std::array<Angle, n_angles> directions = make_directions();
  std::array<double, n_angles> values;
  std::transform(directions.begin(), directions.end(), values.begin(), value_at);
  double largest = *std::max_element(values.begin(), values.end());
  for (unsigned int i = 0; i < n_angles; ++i) {
    const double before = values[(i + n_angles - 1) % n_angles], after = values[(i + 1) % n_angles];
    if (values[i] < before || values[i] < after || before == after)
      continue; // on a slope, or the peak itself
    const auto peak = boost::math::tools::brent_find_minima(
        [&](const double angle) {
          return -value_at({std::cos(angle), std::sin(angle)});
        },
        (i - 1.) * between_angles, (i + 1.) * between_angles, bits);
    largest = std::max(largest, -peak.second);
  }
  return largest;
}

} // namespace

WallStress wall_stress(const Section &section, const Motion &force, const double pressure) {
  const auto [N, Vy, Vz, Mx, My, Mz] = force;
  const double outer = section.outer_radius, inner = section.outer_radius - section.wall,
               ring = outer * outer - inner * inner,
               along = N / section.area + pressure * inner * inner / ring;
  // Unit vector from the centre, in y and z, to where bending stretches most, from which angles
  // count. Where nothing bends, that across which the shear is largest.
  double y = -Mz, z = My, size = std::hypot(y, z);
  if (size == 0.) {
    y = Vy;
    z = Vz;
    size = std::hypot(y, z);
  }
  if (size == 0.) {
    y = 1.;
    size = 1.;
  }
  y /= size;
  z /= size;
  WallStress result{-1e300, 1e300, 0., 0.};
  for (const double radius : {outer, inner}) {
    const bool is_inside = radius == inner;
    const double round = pressure *
                         (is_inside ? outer * outer + inner * inner : 2. * inner * inner) / ring,
                 through = is_inside ? -pressure : 0.;
    const double by_bending = radius * (My * z - Mz * y) / section.inertia,
                 by_torsion = Mx * radius / section.torsion_constant,
                 shear_cosine = 2. * (Vz * y - Vy * z) / section.area,
                 shear_sine = -2. * (Vz * z + Vy * y) / section.area;
    const auto axial = [&](const Angle &at) { return along + by_bending * at.cosine; };
    const auto shear = [&](const Angle &at) {
      return by_torsion + shear_cosine * at.cosine + shear_sine * at.sine;
    };
    // Half of what the two principal stresses in the wall differ by
    const auto half = [&](const Angle &at) {
      const double apart = (axial(at) - round) / 2., tau = shear(at);
      return std::sqrt(apart * apart + tau * tau);
    };
    const double most = largest_round(
                     [&](const Angle &at) { return (axial(at) + round) / 2. + half(at); }),
                 least = -largest_round(
                     [&](const Angle &at) { return half(at) - (axial(at) + round) / 2.; });
    result.most = std::max({result.most, most, through});
    result.least = std::min({result.least, least, through});
    result.tresca =
        std::max({result.tresca, 2. * largest_round(half), most - through, through - least});
    result.von_mises =
        std::max(result.von_mises, std::sqrt(largest_round([&](const Angle &at) {
                   const double x = axial(at), tau = shear(at);
                   return ((x - round) * (x - round) + (round - through) * (round - through) +
                           (through - x) * (through - x)) /
                              2. +
                          3. * tau * tau;
                 })));
  }
  return result;
}

std::optional<WallStress> elastic_wall_stress(const Scene &scene, const Station &station) {
  const Pipe &pipe = scene.pipes[station.pipe];
  const Section &section = scene.sections[pipe.section];
  if (pipe.rigid || section.wall == 0. || (section.is_inelastic() && !scene.keeps_elastic))
    return {};
  return wall_stress(section_at(scene, station), station.force, station.pressure);
}

} // namespace frictionbeam
