// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "oval_ends.h"
#include "pipe_material.h"
#include "symmetric_system.h"

namespace frictionbeam::section {

enum OvalParameter {
  oval_modulus,
  oval_poisson_ratio,
  oval_diameter,
  oval_wall,
  oval_shear_rigidity,
  oval_bend_radius,
  oval_bend_length,
  oval_place,
  oval_highest_mode,
  oval_stations,
  oval_layers,
  n_oval_parameters
};

constexpr int highest_mode = 8, most_modes = highest_mode - 1, most_stations = 63, most_layers = 4,
              most_points = 2 * most_layers;
constexpr int n_point_states = 4; ///< plastic strains of a point, accumulated plastic strain

/// Of the elastic stiffness. Where nothing else decides how the wall flows, a tangent of so much
/// more does; the answer does not have it.
constexpr double least_stiffness = 1e-8;

/**
 * Where the parts of the state stand: amplitudes of the modes over r, cosines then sines; what the
 * ends' hold on the oval has given (2); the mean shear stress; each station's hoop strain and its
 * warping shear strain; each point's plastic strains.
 */
struct OvalLayout {
  int modes, stations, points; ///< modes 2 to modes + 1; points through the wall

  explicit OvalLayout(const double *p)
      : modes(p[oval_bend_radius] > 0. ? whole(p[oval_highest_mode]) - 1 : 0),
        stations(whole(p[oval_stations])), points(2 * whole(p[oval_layers])) {}

  int given() const { return 2 * modes; }
  int shear() const { return given() + 2; }
  int of_station(const int i) const { return shear() + 1 + 2 * i; }
  int of_point(const int i, const int j) const {
    return of_station(stations) + (i * points + j) * n_point_states;
  }
  int size() const { return of_point(stations, 0); }

private:
  static int whole(const double x) { return static_cast<int>(std::lround(x)); }
};

constexpr int most_oval_states =
    2 * most_modes + 3 + most_stations * (2 + most_points * n_point_states);

/// What strains a station of the wall: along the pipe at r = 0, its change outwards k, the hoop's
/// change of curvature by the modes, twist; and its own hoop strain e and shear strain g.
enum StationStrain { along, bending, oval, twisting, hoop_strain, warping, n_station_strains };
constexpr int n_given_strains = hoop_strain; ///< the others are the station's own

/**
 * Figures of a bend's wall at a temperature and under a pressure, and how it answers elastically.
 *
 * phi is counted from the outside of the bend, r the mean radius, z the depth from the middle of
 * the wall outwards. A ring that keeps its length moves by a cos(m phi) r outwards and
 * -a sin(m phi) r/m round (or sin, -cos), m = 2 to `modes` + 1. A point's strains are
 *
 *   along:  eps + (r + z) k + (r/R) sum a U_m,   k = kappa_z cos phi + kappa_y sin phi,
 *           U_m = ((1 + 1/m) cos(m-1)phi + (1 - 1/m) cos(m+1)phi)/2      (von Karman)
 *   round:  e(phi) + z (sum a (m^2 - 1)/r cos(m phi) - nu k),
 *   shear:  (r + z) chi + g(phi),   mean of g zero,
 *
 * e such that the wall carries p r round, g such that it carries one shear flow. The term of nu is
 * the curvature that bending leaves to a free wall.
 */
struct OvalPipe {
  OvalLayout layout;
  Material material;
  double E, nu, G, r, t, R, pressure, hoop;
  double radius[most_points], depth[most_points], area[most_points]; ///< area: of one station
  double station_area;
  double rigidity[n_section_strains];
  double stiffness[3];                 ///< of a point, see OvalPoint
  double unit_mode[most_modes] = {};   ///< amplitudes of unit curvature, elastic
  double held = 0., held_at_most = 0.; ///< of mode 2 by the ends: stiffness, largest force
  double free_hoop[oval + 1];          ///< e by along, bending and oval, elastic, no pressure
  bool is_possible;
  bool bursts; ///< no stress along the pipe bears this pressure

  OvalPipe(const double *p, const double temperature, const double pressure)
      : layout(p), material(p + n_oval_parameters, temperature), pressure(pressure) {
    E = p[oval_modulus] * material.modulus_factor;
    nu = p[oval_poisson_ratio];
    G = E / (2. * (1. + nu));
    t = p[oval_wall];
    r = (p[oval_diameter] - t) / 2.;
    R = p[oval_bend_radius];
    hoop = pressure * r / t;
    is_possible = material.is_possible && p[oval_diameter] > 2. * t;
    bursts = std::sqrt(0.75) * std::abs(hoop) >= material.largest(0.);
    stiffness[0] = E / (2. * (1. - nu));
    stiffness[1] = stiffness[2] = 3. * G;
    set_points();
    double second_moment = 0.;
    for (int j = 0; j < layout.points; ++j)
      second_moment += layout.stations * area[j] * radius[j] * radius[j];
    rigidity[0] = E * layout.stations * station_area;
    rigidity[1] = rigidity[2] = material.modulus_factor * p[oval_shear_rigidity];
    rigidity[3] = G * second_moment;
    rigidity[4] = rigidity[5] = E * second_moment / 2.;
    solve_elastically(p);
  }

  /// Strain along by mode m, of waves m - 1 and m + 1.
  double along_below(const int m) const { return (1. + 1. / m) / 2. * r / R; }
  double along_above(const int m) const { return (1. - 1. / m) / 2. * r / R; }
  /// Of the hoop, by the amplitude of mode k + 2.
  double mode_curvature(const int k) const { return ((k + 2.) * (k + 2.) - 1.) / r; }
  /// Of a mode, by pressure; the energy is half of it times its amplitudes' squares.
  double pressure_stiffness(const int k) const {
    return pi * pressure * r * r * r * mode_curvature(k);
  }

  /// No less than the largest equivalent stress by a unit curvature, elastic [N/m].
  double stress_of_bending() const;

private:
  /// Two Gauss points in each layer: bending and full plasticity of the wall are exact with two
  /// layers, area and moments of the section with one.
  void set_points() {
    const int layers = layout.points / 2;
    const double width = t / layers;
    station_area = 0.;
    for (int j = 0; j < layout.points; ++j) {
      const double middle = -t / 2. + (j / 2 + 0.5) * width;
      depth[j] = middle + (j % 2 == 0 ? -width : width) / (2. * std::sqrt(3.));
      radius[j] = r + depth[j];
      area[j] = pi * radius[j] * width / layout.stations;
      station_area += area[j];
    }
  }
  void set_free_wall(double (&k)[oval + 1][oval + 1]);
  void solve_elastically(const double *p);
  void hold_by_ends(const double *p, const double of_ring, const double of_oval);
};

/// The wall's stiffness over the strains along, bending and oval, where its hoop strain is free; of
/// all stations.
inline void OvalPipe::set_free_wall(double (&k)[oval + 1][oval + 1]) {
  constexpr int n = oval + 2; // the last is the hoop strain
  double all[n][n] = {};
  for (int j = 0; j < layout.points; ++j) {
    const double x[n] = {1., radius[j], 0., 0.}, h[n] = {0., -nu * depth[j], depth[j], 1.};
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        all[a][b] += layout.stations * area[j] * E / (1. - nu * nu) *
                     (x[a] * x[b] + h[a] * h[b] + nu * (x[a] * h[b] + h[a] * x[b]));
  }
  const int e = n - 1;
  for (int a = 0; a < e; ++a) {
    free_hoop[a] = -all[a][e] / all[e][e];
    for (int b = 0; b < e; ++b)
      k[a][b] = all[a][b] + free_hoop[a] * all[e][b];
  }
}

/// The sums over the stations are integrals: cosines of different waves have none with each other,
/// and 1/2 with themselves.
inline void OvalPipe::solve_elastically(const double *p) {
  double k[oval + 1][oval + 1];
  set_free_wall(k);
  const int n = layout.modes;
  if (n == 0 || !is_possible)
    return;
  SymmetricSystem<most_modes> modes(n);
  for (int wave = 1; wave <= n + 2; ++wave) {
    // Of this wave: the strain along by the modes below and above it, the oval by its own.
    const auto of_mode = [&](const int m, double &x, double &c) {
      x = m == wave - 1 ? along_above(m) : m == wave + 1 ? along_below(m) : 0.;
      c = m == wave ? mode_curvature(m - 2) : 0.;
    };
    for (int a = std::max(2, wave - 1); a <= std::min(n + 1, wave + 1); ++a)
      for (int b = std::max(2, wave - 1); b <= a; ++b) {
        double x_a, c_a, x_b, c_b;
        of_mode(a, x_a, c_a);
        of_mode(b, x_b, c_b);
        modes(a - 2, b - 2) += (k[along][along] * x_a * x_b + k[oval][oval] * c_a * c_b +
                                k[along][oval] * (x_a * c_b + c_a * x_b)) /
                               2.;
      }
  }
  for (int i = 0; i < n; ++i)
    modes(i, i) += pressure_stiffness(i);
  is_possible = modes.eliminate(n, n);
  if (!is_possible)
    return;
  const double coupling = along_below(2) / 2. * k[along][bending]; // of curvature and mode 2
  double by_force[most_modes] = {1.}; // amplitudes of a unit force on mode 2
  modes.solve(by_force);
  const double of_ring =
      k[oval][oval] * mode_curvature(0) * mode_curvature(0) / 2. + pressure_stiffness(0);
  hold_by_ends(p, of_ring, 1. / by_force[0] - coupling * coupling / rigidity[4]);
  for (int i = 0; i < n; ++i)
    unit_mode[i] = -coupling * by_force[i] / (1. + held * by_force[0]);
  rigidity[4] = rigidity[5] += coupling * unit_mode[0];
}

/**
 * In a bend of finite length mode 2 is held by as much as its elastic amplitude at this place falls
 * short of that in a long bend (OvalEnds). What holds yields as the wall does: it is not stronger
 * than the ring at its plastic limit, 2 sqrt(3) sy t^2 over the amplitude, by the same ratio.
 */
inline void OvalPipe::hold_by_ends(const double *p, const double of_ring, const double of_oval) {
  const double length = p[oval_bend_length];
  if (!(length > 0.))
    return;
  is_possible = of_ring > 0. && of_oval > 0.;
  if (!is_possible)
    return;
  const double warping = rigidity[0] / 2. * r * r * r * r / 16.; // B, over amplitudes
  const OvalEnds ends(length, std::pow(of_oval / (4. * warping), 0.25),
                      std::pow(of_ring / (4. * warping), 0.25));
  const double share = std::min(1., ends.share(p[oval_place]));
  held = of_oval * (1. / share - 1.);
  held_at_most = 2. * std::sqrt(3.) * material.first_yield() * t * t * (1. / share - 1.);
}

/// Wave by wave: along the pipe by the modes beside it, round it by its own.
inline double OvalPipe::stress_of_bending() const {
  const int n = layout.modes;
  const auto mode = [&](const int m) { return m >= 2 && m < n + 2 ? unit_mode[m - 2] : 0.; };
  double worst = 0.;
  for (int j = 0; j < layout.points; ++j) {
    double sum = 0.;
    for (int wave = 1; wave <= n + 2; ++wave) {
      double station[oval + 1] = {0., wave == 1 ? 1. : 0., 0.};
      if (n > 0)
        station[along] = along_below(wave + 1) * mode(wave + 1);
      if (wave > 2)
        station[along] += along_above(wave - 1) * mode(wave - 1);
      if (wave > 1)
        station[oval] = mode_curvature(wave - 2) * mode(wave);
      double round = depth[j] * (station[oval] - nu * station[bending]);
      for (const int a : {along, bending, oval})
        round += free_hoop[a] * station[a];
      const double strain = station[along] + radius[j] * station[bending];
      sum += std::hypot(stiffness[0] * (strain + round),
                        stiffness[1] * (strain - round) / std::sqrt(3.));
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

/// Modes and directions at the stations.
struct OvalShapes {
  double cosine[most_stations], sine[most_stations]; ///< of phi
  double along_by[most_stations][2 * most_modes];    ///< by an amplitude, cosines then sines
  double oval_by[most_stations][2 * most_modes];

  explicit OvalShapes(const OvalPipe &pipe) {
    const int n = pipe.layout.stations, modes = pipe.layout.modes;
    const double step = 2. * pi / n, cosine_of_step = std::cos(step), sine_of_step = std::sin(step);
    double c[highest_mode + 2] = {1., 1.}, s[highest_mode + 2] = {}; // of m phi
    for (int i = 0; i < n; ++i) {
      for (int m = 2; m < modes + 3; ++m) {
        c[m] = c[1] * c[m - 1] - s[1] * s[m - 1];
        s[m] = s[1] * c[m - 1] + c[1] * s[m - 1];
      }
      cosine[i] = c[1];
      sine[i] = s[1];
      for (int k = 0; k < modes; ++k) {
        const int m = k + 2;
        const double below = pipe.along_below(m), above = pipe.along_above(m);
        along_by[i][k] = below * c[m - 1] + above * c[m + 1];
        along_by[i][modes + k] = below * s[m - 1] + above * s[m + 1];
        oval_by[i][k] = pipe.mode_curvature(k) * c[m];
        oval_by[i][modes + k] = pipe.mode_curvature(k) * s[m];
      }
      c[1] = cosine_of_step * cosine[i] - sine_of_step * sine[i];
      s[1] = sine_of_step * cosine[i] + cosine_of_step * sine[i];
    }
  }
};

} // namespace frictionbeam::section
