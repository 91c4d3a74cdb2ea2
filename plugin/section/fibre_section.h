// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "fibre_ring.h"

namespace frictionbeam::section {

enum FibreParameter {
  youngs_modulus,
  poisson_ratio,
  outside_diameter,
  wall_thickness,
  shear_rigidity,
  n_fibres,
  n_radii,
  n_fibre_parameters,
  n_all_fibre_parameters = n_fibre_parameters + n_material_parameters + n_creep_parameters
};

/// Strains that fibres know, and their places among those of the section.
enum FibreStrain { axial_strain, twist, curvature_y, curvature_z, n_fibre_strains };
constexpr int fibre_strain_place[n_fibre_strains] = {0, 3, 4, 5};

constexpr int n_ring_states = 3;

/**
 * Where the parts of the state stand. A section that creeps keeps the last strains and hoop stress;
 * then each ring its mean shear and hoop strains, inelastic, and its shear stress, to begin the
 * next search with; each fibre its inelastic axial strain and its accumulated plastic strain; then,
 * if they are needed: plastic strains of the back stress, accumulated creep strain, that of primary
 * creep.
 */
struct FibreLayout {
  int fibres, rings, first = 0, per_fibre = 2, e = -1, g = -1, h = -1, creep = -1, primary = -1;

  explicit FibreLayout(const double *p)
      : fibres(static_cast<int>(std::lround(p[n_fibres]))),
        rings(static_cast<int>(std::lround(p[n_radii]))) {
    const double *const of_creep = p + n_fibre_parameters + n_material_parameters;
    const bool creeps = Creep::is_any(of_creep);
    if (creeps) {
      first = n_fibre_strains + 1;
      creep = per_fibre++;
      if (Creep::needs_primary(of_creep))
        primary = per_fibre++;
    }
    if (p[n_fibre_parameters + kinematic_modulus] > 0.) {
      g = per_fibre++;
      h = per_fibre++;
      if (creeps)
        e = per_fibre++;
    }
  }

  int of_ring(const int ring) const { return first + ring * (n_ring_states + fibres * per_fibre); }
  int of_fibre(const int ring, const int i) const {
    return of_ring(ring) + n_ring_states + i * per_fibre;
  }
  int size() const { return of_ring(rings); }
};

constexpr int most_fibre_states = n_fibre_strains + 1 + 2 * (n_ring_states + most_fibres * 7);

/// Over Young's modulus, of a curve with a level end: the shear's equation needs one.
constexpr double least_slope = 1e-8;

/// A pipe's figures at a temperature and under a pressure.
struct FibrePipe {
  FibreLayout layout;
  Material material;
  double E, G, hoop;
  double radius[2], area[2]; ///< of the rings, two Gauss points through the wall
  double rigidity[n_section_strains];
  bool is_possible;
  bool bursts; ///< no stress along the pipe bears this pressure

  FibrePipe(const double *p, const double temperature, const double pressure)
      : layout(p), material(p + n_fibre_parameters, temperature) {
    E = p[youngs_modulus] * material.modulus_factor;
    G = E / (2. * (1. + p[poisson_ratio]));
    const double t = p[wall_thickness], outer = p[outside_diameter] / 2., inner = outer - t;
    const double middle = outer - t / 2., whole = 2. * pi * middle * t;
    is_possible = material.is_possible && inner > 0. && layout.fibres <= most_fibres;
    if (layout.rings == 1) {
      radius[0] = std::sqrt((outer * outer + inner * inner) / 2.);
      area[0] = whole;
    } else
      for (int j = 0; j < 2; ++j) {
        radius[j] = middle + (j == 0 ? -t : t) / (2. * std::sqrt(3.));
        area[j] = pi * radius[j] * t;
      }
    hoop = pressure * middle / t;
    bursts = std::sqrt(0.75) * std::abs(hoop) >= material.largest(least_slope * E);
    if (!material.is_perfect() || layout.creep >= 0)
      material.raise_level_end(least_slope * E);
    double second_moment = 0.;
    for (int j = 0; j < layout.rings; ++j)
      second_moment += area[j] * radius[j] * radius[j];
    rigidity[0] = E * whole;
    rigidity[1] = rigidity[2] = material.modulus_factor * p[shear_rigidity];
    rigidity[3] = G * second_moment;
    rigidity[4] = rigidity[5] = E * second_moment / 2.;
  }

  /// Largest equivalent stress of elastic fibres over the yield stress.
  double elastic_bound(const double *strain) const {
    const double r = radius[layout.rings - 1];
    const double bending = r * std::sqrt(strain[4] * strain[4] + strain[5] * strain[5]);
    const double x = std::abs(E * strain[0] - hoop / 2.) + E * bending, tau = G * r * strain[3];
    return std::sqrt(x * x + 0.75 * hoop * hoop + 3. * tau * tau) / material.first_yield();
  }
};

/// Cosines and sines of the fibres' places, from the section's axis z to y.
struct FibrePlaces {
  double z[most_fibres], y[most_fibres];

  explicit FibrePlaces(const int n) {
    const double step = 2. * pi / n, c = std::cos(step), s = std::sin(step);
    z[0] = 1.;
    y[0] = 0.;
    for (int i = 1; i < n; ++i) {
      z[i] = c * z[i - 1] - s * y[i - 1];
      y[i] = s * z[i - 1] + c * y[i - 1];
    }
  }
};

} // namespace frictionbeam::section
