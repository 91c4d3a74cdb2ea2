// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "oval_point.h"

namespace frictionbeam::section {

/// Strains of the section that its wall knows: eps less that of a free pipe under its hoop stress,
/// chi, and the curvatures about z (in the bend's plane) and y.
struct OvalStrains {
  double axial, twist, in_plane, out_of_plane;

  OvalStrains(const OvalPipe &pipe, const double *strain)
      : axial(strain[0] - pipe.nu * pipe.hoop / pipe.E), twist(strain[3]), in_plane(strain[5]),
        out_of_plane(strain[4]) {}
};

/// What is not known beforehand: amplitudes of the modes, the mean shear stress, and of each
/// station its hoop strain and its warping.
struct OvalUnknowns {
  double mode[2 * most_modes] = {}, shear = 0., own[most_stations][2] = {};
};

/// Strains of a station, of the enumeration's places.
inline void station_strains(const OvalPipe &pipe, const OvalShapes &shapes, const int i,
                            const OvalStrains &strain, const OvalUnknowns &unknown,
                            double (&result)[n_station_strains]) {
  result[along] = strain.axial;
  result[bending] = shapes.cosine[i] * strain.in_plane + shapes.sine[i] * strain.out_of_plane;
  result[oval] = 0.;
  for (int k = 0; k < 2 * pipe.layout.modes; ++k) {
    result[along] += shapes.along_by[i][k] * unknown.mode[k];
    result[oval] += shapes.oval_by[i][k] * unknown.mode[k];
  }
  result[twisting] = strain.twist;
  result[hoop_strain] = unknown.own[i][0];
  result[warping] = unknown.own[i][1];
}

inline PointStrain point_strain(const OvalPipe &pipe, const int j,
                                const double (&station)[n_station_strains]) {
  return {station[along] + pipe.radius[j] * station[bending],
          station[hoop_strain] + pipe.depth[j] * (station[oval] - pipe.nu * station[bending]),
          station[warping] + pipe.radius[j] * station[twisting]};
}

/// The answer of a section that is elastic.
inline void answer_elastically(const OvalPipe &pipe, const OvalShapes &shapes,
                               const OvalStrains &strain, OvalUnknowns &unknown) {
  const int modes = pipe.layout.modes;
  for (int k = 0; k < modes; ++k) {
    unknown.mode[k] = strain.in_plane * pipe.unit_mode[k];
    unknown.mode[modes + k] = strain.out_of_plane * pipe.unit_mode[k];
  }
  for (int i = 0; i < pipe.layout.stations; ++i) {
    double station[n_station_strains];
    unknown.own[i][0] = unknown.own[i][1] = 0.;
    station_strains(pipe, shapes, i, strain, unknown, station);
    double &e = unknown.own[i][0];
    e = pipe.hoop * (1. - pipe.nu * pipe.nu) / pipe.E;
    for (const int a : {along, bending, oval})
      e += pipe.free_hoop[a] * station[a];
  }
}

} // namespace frictionbeam::section
