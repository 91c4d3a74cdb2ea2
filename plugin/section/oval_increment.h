// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "oval_stations.h"

namespace frictionbeam::section {

/**
 * One implicit increment of an ovalising wall: what is not known makes the potential least,
 *   sum over the points of area (what they store and dissipate) - hoop area e
 *     + pi p (m^2 - 1) a^2/2 + the hold of the ends,
 * which is convex. Newton's method with a search along its steps; the stations' own unknowns are
 * condensed, then the modes and the shear stress, which leaves the section's tangent.
 */
class OvalIncrement {
public:
  /// @param old state at the start of the increment; @param now gets that of its end
  OvalIncrement(const OvalPipe &pipe, const OvalShapes &shapes, const OvalStrains &strain,
                const double *old, double *now)
      : pipe(pipe), at(pipe.layout), shapes(shapes), strain(strain), old(old), now(now) {
    std::copy(old, old + 2 * at.modes, unknown.mode);
    unknown.shear = old[at.shear()];
    for (int i = 0; i < at.stations; ++i)
      std::copy(old + at.of_station(i), old + at.of_station(i) + 2, unknown.own[i]);
  }

  /// @return whether there is an answer.
  bool solve();
  /// State, stress of the wall, energies.
  void write(LawOutput &out) const;
  /// Adds the wall's tangent.
  void add_tangent(double *tangent) const;

private:
  static constexpr int n_own = 2, n_strains = 4;
  static constexpr int most_unknowns = 2 * most_modes + 1; ///< amplitudes and mean shear stress
  static constexpr int most_columns = most_unknowns + n_strains;
  /// What a station carries by its strains, and the derivative; that of its own strains, inverted.
  struct Station {
    double stress[n_station_strains], tangent[n_station_strains][n_station_strains];
    double inverse[n_own][n_own];
  };
  using System = SymmetricSystem<most_columns>;

  int n_unknowns() const { return 2 * at.modes + 1; }
  bool evaluate();
  bool add_point(const int i, const int j, const PointStrain &at_point, Station &station);
  void add_hold();
  void measure_residual();
  /// Of a station's own equations.
  void own_residual(const int i, double (&residual)[n_own]) const;
  /// Newton's equations: the unknowns, then axial strain, twist, curvatures in plane and out of it.
  void linearize(System &system, double *right) const;
  void condense(const Station &station,
                double (&stiffness)[n_given_strains + 1][n_given_strains + 1]) const;
  bool step(OvalUnknowns &direction) const;
  double slope(const OvalUnknowns &direction) const;
  bool go(const OvalUnknowns &from, const OvalUnknowns &direction, const double length);

  const OvalPipe &pipe;
  const OvalLayout &at;
  const OvalShapes &shapes;
  const OvalStrains &strain;
  const double *old;
  double *now;
  OvalUnknowns unknown;
  Station stations[most_stations];
  double mode_force[2 * most_modes];                    ///< residuals of the modes
  double held_force[2] = {}, held_stiffness[2][2] = {}; ///< of mode 2: cosine, sine
  double held_given[2] = {};                            ///< what the hold has given
  /// Stresses: missing balance, what rounding leaves of it, largest equivalent one.
  double residual, rounding, largest;
};

inline bool OvalIncrement::evaluate() {
  rounding = largest = 0.;
  for (int i = 0; i < at.stations; ++i) {
    double strains[n_station_strains];
    station_strains(pipe, shapes, i, strain, unknown, strains);
    Station &station = stations[i];
    station = {};
    for (int j = 0; j < at.points; ++j)
      if (!add_point(i, j, point_strain(pipe, j, strains), station))
        return false;
    double(&T)[n_station_strains][n_station_strains] = station.tangent;
    for (int a = 0; a < n_station_strains; ++a)
      for (int b = 0; b < a; ++b)
        T[b][a] = T[a][b];
    const double a = T[hoop_strain][hoop_strain], b = T[hoop_strain][warping],
                 c = T[warping][warping], determinant = a * c - b * b;
    station.inverse[0][0] = c / determinant;
    station.inverse[0][1] = station.inverse[1][0] = -b / determinant;
    station.inverse[1][1] = a / determinant;
  }
  for (int k = 0; k < 2 * at.modes; ++k) {
    mode_force[k] = pipe.pressure_stiffness(k % at.modes) * unknown.mode[k];
    for (int i = 0; i < at.stations; ++i)
      mode_force[k] += shapes.along_by[i][k] * stations[i].stress[along] +
                       shapes.oval_by[i][k] * stations[i].stress[oval];
  }
  if (pipe.held > 0.)
    add_hold();
  measure_residual();
  return std::isfinite(residual);
}

inline bool OvalIncrement::add_point(const int i, const int j, const PointStrain &at_point,
                                     Station &station) {
  const int place = at.of_point(i, j);
  const PointResponse of(OvalPoint(pipe, at_point, old + place), now + place);
  rounding = std::max(rounding, of.rounding);
  largest = std::max(largest, of.equivalent);
  // Strains of the point by those of the station: along (1, 0, 0), bending (r, -nu z, 0), oval
  // (0, z, 0), twisting (0, 0, r), hoop strain (0, 1, 0), warping (0, 0, 1).
  const double r = pipe.radius[j], z = pipe.depth[j], n = -pipe.nu * z, area = pipe.area[j];
  const double stress[n_station_strains] = {of.x, r * of.x + n * of.h, z * of.h, r * of.t, of.h,
                                            of.t};
  const double x = r * of.xx + n * of.xh, h = r * of.xh + n * of.hh, t = r * of.xt + n * of.ht;
  const double lower[n_station_strains][n_station_strains] = {
      {of.xx},
      {x, r * x + n * h},
      {z * of.xh, z * h, z * z * of.hh},
      {r * of.xt, r * t, r * z * of.ht, r * r * of.tt},
      {of.xh, h, z * of.hh, r * of.ht, of.hh},
      {of.xt, t, z * of.ht, r * of.tt, of.ht, of.tt}};
  for (int a = 0; a < n_station_strains; ++a) {
    station.stress[a] += area * stress[a];
    for (int b = 0; b <= a; ++b)
      station.tangent[a][b] += area * lower[a][b];
  }
  return of.converged;
}

/// Of the ends: a spring that gives way at a force of some size, in any direction of the oval.
inline void OvalIncrement::add_hold() {
  const double *const given = old + at.given();
  const double amplitude[2] = {unknown.mode[0], unknown.mode[at.modes]};
  double size = 0.;
  for (int c = 0; c < 2; ++c) {
    held_force[c] = pipe.held * (amplitude[c] - given[c]);
    size = std::hypot(size, held_force[c]);
  }
  const double part = size > pipe.held_at_most ? pipe.held_at_most / size : 1.;
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d)
      held_stiffness[c][d] =
          pipe.held * part *
          ((c == d ? 1. : 0.) - (part < 1. ? held_force[c] * held_force[d] / (size * size) : 0.));
  for (int c = 0; c < 2; ++c) {
    held_force[c] *= part;
    held_given[c] = amplitude[c] - held_force[c] / pipe.held;
    mode_force[c * at.modes] += held_force[c];
  }
}

inline void OvalIncrement::own_residual(const int i, double (&result)[n_own]) const {
  result[0] = stations[i].stress[hoop_strain] - pipe.hoop * pipe.station_area;
  result[1] = stations[i].stress[warping] - unknown.shear * pipe.station_area;
}

inline void OvalIncrement::measure_residual() {
  residual = 0.;
  double warped = 0.;
  for (int i = 0; i < at.stations; ++i) {
    double own[n_own];
    own_residual(i, own);
    residual = std::max(
        {residual, std::abs(own[0]) / pipe.station_area, std::abs(own[1]) / pipe.station_area});
    warped += unknown.own[i][1];
  }
  residual = std::max(residual, std::abs(warped / at.stations) * pipe.G);
  for (int k = 0; k < 2 * at.modes; ++k) {
    const int m = k % at.modes + 2;
    const double unit = at.stations * pipe.station_area *
                        (pipe.along_below(m) + pipe.t * pipe.mode_curvature(m - 2));
    residual = std::max(residual, std::abs(mode_force[k]) / unit);
  }
}

inline void
OvalIncrement::condense(const Station &station,
                        double (&stiffness)[n_given_strains + 1][n_given_strains + 1]) const {
  const double W = pipe.station_area;
  double coupling[n_given_strains + 1][n_own]; // to the station's own strains
  for (int a = 0; a < n_given_strains; ++a) {
    coupling[a][0] = station.tangent[a][hoop_strain];
    coupling[a][1] = station.tangent[a][warping];
  }
  coupling[n_given_strains][0] = 0.;
  coupling[n_given_strains][1] = -W;
  for (int a = 0; a <= n_given_strains; ++a)
    for (int b = 0; b <= n_given_strains; ++b) {
      double sum = a < n_given_strains && b < n_given_strains ? station.tangent[a][b] : 0.;
      for (int c = 0; c < n_own; ++c)
        for (int d = 0; d < n_own; ++d)
          sum -= coupling[a][c] * station.inverse[c][d] * coupling[b][d];
      stiffness[a][b] = sum;
    }
}

inline void OvalIncrement::linearize(System &system, double *right) const {
  const int modes = 2 * at.modes, shear = modes, first = shear + 1;
  for (int k = 0; k < modes; ++k)
    right[k] = -mode_force[k];
  right[shear] = 0.;
  for (int i = 0; i < at.stations; ++i) {
    const Station &station = stations[i];
    const double *const along_by = shapes.along_by[i], *const oval_by = shapes.oval_by[i];
    const double W = pipe.station_area, direction[2] = {shapes.cosine[i], shapes.sine[i]};
    double C[n_given_strains + 1][n_given_strains + 1];
    condense(station, C);
    // Of each row of C the product with every column of unknowns and strains.
    double by[n_given_strains + 1][most_columns];
    for (int a = 0; a <= n_given_strains; ++a) {
      for (int k = 0; k < modes; ++k)
        by[a][k] = C[a][along] * along_by[k] + C[a][oval] * oval_by[k];
      by[a][shear] = C[a][n_given_strains];
      by[a][first] = C[a][along];
      by[a][first + 1] = C[a][twisting];
      for (int c = 0; c < 2; ++c)
        by[a][first + 2 + c] = direction[c] * C[a][bending];
    }
    for (int k = 0; k < modes; ++k)
      for (int l = 0; l <= k; ++l)
        system(k, l) += along_by[k] * by[along][l] + oval_by[k] * by[oval][l];
    for (int l = 0; l <= shear; ++l)
      system(shear, l) += by[n_given_strains][l];
    for (int l = 0; l <= first; ++l)
      system(first, l) += by[along][l];
    for (int l = 0; l <= first + 1; ++l)
      system(first + 1, l) += by[twisting][l];
    for (int c = 0; c < 2; ++c)
      for (int l = 0; l <= first + 2 + c; ++l)
        system(first + 2 + c, l) += direction[c] * by[bending][l];
    // What is left over in the station's own equations.
    double own[n_own], moved[n_own] = {};
    own_residual(i, own);
    for (int c = 0; c < n_own; ++c)
      for (int d = 0; d < n_own; ++d)
        moved[c] += station.inverse[c][d] * own[d];
    for (int k = 0; k < modes; ++k)
      for (int c = 0; c < n_own; ++c)
        right[k] += (along_by[k] * station.tangent[along][hoop_strain + c] +
                     oval_by[k] * station.tangent[oval][hoop_strain + c]) *
                    moved[c];
    right[shear] += W * (unknown.own[i][1] - moved[1]);
  }
  for (int k = 0; k < modes; ++k)
    system(k, k) += pipe.pressure_stiffness(k % at.modes);
  if (pipe.held > 0.)
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d <= c; ++d)
        system(c * at.modes, d * at.modes) += held_stiffness[c][d];
}

inline bool OvalIncrement::step(OvalUnknowns &direction) const {
  System system(n_unknowns() + n_strains);
  double right[most_unknowns];
  linearize(system, right);
  if (!system.eliminate(n_unknowns(), 2 * at.modes))
    return false;
  system.solve(right);
  std::copy(right, right + 2 * at.modes, direction.mode);
  direction.shear = right[2 * at.modes];
  for (int i = 0; i < at.stations; ++i) {
    double left[n_own], along_change = 0., oval_change = 0.;
    own_residual(i, left);
    for (int k = 0; k < 2 * at.modes; ++k) {
      along_change += shapes.along_by[i][k] * direction.mode[k];
      oval_change += shapes.oval_by[i][k] * direction.mode[k];
    }
    for (int c = 0; c < n_own; ++c)
      left[c] += stations[i].tangent[hoop_strain + c][along] * along_change +
                 stations[i].tangent[hoop_strain + c][oval] * oval_change;
    left[1] -= pipe.station_area * direction.shear;
    for (int c = 0; c < n_own; ++c)
      direction.own[i][c] =
          -(stations[i].inverse[c][0] * left[0] + stations[i].inverse[c][1] * left[1]);
  }
  return true;
}

/// Of the potential along a direction, whose warping is none in the mean.
inline double OvalIncrement::slope(const OvalUnknowns &direction) const {
  double sum = 0.;
  for (int k = 0; k < 2 * at.modes; ++k)
    sum += mode_force[k] * direction.mode[k];
  for (int i = 0; i < at.stations; ++i) {
    double own[n_own];
    own_residual(i, own);
    sum += own[0] * direction.own[i][0] + own[1] * direction.own[i][1];
  }
  return sum;
}

inline bool OvalIncrement::go(const OvalUnknowns &from, const OvalUnknowns &direction,
                              const double length) {
  for (int k = 0; k < 2 * at.modes; ++k)
    unknown.mode[k] = from.mode[k] + length * direction.mode[k];
  unknown.shear = from.shear + length * direction.shear;
  for (int i = 0; i < at.stations; ++i)
    for (int c = 0; c < n_own; ++c)
      unknown.own[i][c] = from.own[i][c] + length * direction.own[i][c];
  return evaluate();
}

inline bool OvalIncrement::solve() {
  constexpr int most_iterations = 100, most_searches = 40;
  constexpr double solved_to = 1e-13, as_good_as_rounding = 1e-10;
  if (!evaluate())
    return false;
  const auto is_solved = [&](const double to) { return residual <= to * largest + rounding; };
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    if (is_solved(solved_to) || (is_solved(as_good_as_rounding) && residual > last / 2.))
      return true;
    last = residual;
    OvalUnknowns direction;
    if (!step(direction))
      return false;
    const OvalUnknowns from = unknown;
    const double at_start = slope(direction), allowed = std::abs(at_start) / 2.;
    if (!go(from, direction, 1.))
      return false;
    double low = 0., high = 1., of_low = at_start, of_high = slope(direction);
    for (int k = 0; at_start < 0. && of_high > allowed && k < most_searches; ++k) {
      double length = low - of_low * (high - low) / (of_high - of_low);
      if (k % 2 == 1) // a plateau would hold the secant at one end
        length = std::sqrt(std::max(low, 1e-3 * high) * high);
      if (!go(from, direction, length))
        return false;
      const double here = slope(direction);
      if (std::abs(here) <= allowed)
        break;
      (here < 0. ? low : high) = length;
      (here < 0. ? of_low : of_high) = here;
    }
  }
  return is_solved(as_good_as_rounding);
}

inline void OvalIncrement::add_tangent(double *tangent) const {
  System system(n_unknowns() + n_strains);
  double right[most_unknowns];
  linearize(system, right);
  system.eliminate(n_unknowns(), 2 * at.modes);
  constexpr int place[n_strains] = {0, 3, 5, 4};
  for (int a = 0; a < n_strains; ++a)
    for (int b = 0; b <= a; ++b) {
      const double entry = system(n_unknowns() + a, n_unknowns() + b);
      tangent[n_section_strains * place[a] + place[b]] = entry;
      tangent[n_section_strains * place[b] + place[a]] = entry;
    }
}

inline void OvalIncrement::write(LawOutput &out) const {
  std::copy(unknown.mode, unknown.mode + 2 * at.modes, now);
  std::copy(held_given, held_given + 2, now + at.given());
  now[at.shear()] = unknown.shear;
  double stored = pipe.hoop * pipe.hoop * pipe.rigidity[0] / (pipe.E * pipe.E) / 2., lost = 0.,
         from_hold = 0.;
  for (int i = 0; i < at.stations; ++i) {
    std::copy(unknown.own[i], unknown.own[i] + n_own, now + at.of_station(i));
    const double *const stress = stations[i].stress;
    out.stress[0] += stress[along];
    out.stress[3] += stress[twisting];
    out.stress[4] += shapes.sine[i] * stress[bending];
    out.stress[5] += shapes.cosine[i] * stress[bending];
    stored -= pipe.hoop * pipe.station_area * unknown.own[i][0];
    double strains[n_station_strains];
    station_strains(pipe, shapes, i, strain, unknown, strains);
    for (int j = 0; j < at.points; ++j) {
      const int place = at.of_point(i, j);
      const PointEnergy energy(OvalPoint(pipe, point_strain(pipe, j, strains), old + place),
                               now + place);
      stored += pipe.area[j] * energy.stored;
      lost += pipe.area[j] * energy.lost;
    }
  }
  for (int k = 0; k < 2 * at.modes; ++k)
    stored += pipe.pressure_stiffness(k % at.modes) * unknown.mode[k] * unknown.mode[k] / 2.;
  for (int c = 0; c < 2 && pipe.held > 0.; ++c) {
    stored += held_force[c] * held_force[c] / pipe.held / 2.;
    from_hold += held_force[c] * (held_given[c] - old[at.given() + c]);
  }
  out.stored_energy += stored;
  out.dissipation = lost + std::max(0., from_hold);
}

} // namespace frictionbeam::section
