// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/solid/wall_state.h"

#include <deal.II/numerics/data_postprocessor.h>

#include <map>
#include <string>
#include <vector>

namespace frictionbeam {

/// The wall at the end of a step.
struct WallFrame {
  unsigned int step = 0; ///< in Scene::steps
  std::vector<RingState> rings;
};

/**
 * In the units of the scene:
 * - `solid.csv`: step, pipe, s, x, y, z, widening, mode2, angle2, mode3, ovality, mises_inside,
 *   mises_outside, axial_least, axial_largest, of each ring; angle2 [degrees] is where the radius
 *   grows most, from the local y towards z of the line;
 * - `wall.csv`: step, pipe, s, angle, surface, axial, hoop, radial, shear, mises, of each point of
 *   the rings on the inside and the outside.
 */
void write_wall_csv(const Scene &scene, const PipeWall &wall, const std::vector<WallFrame> &frames,
                    const std::string &folder);

/// Of the free strain of the loads: stress xx, yy, xy, zz, yz, zx and von Mises's, for
/// write_body_vtu().
std::unique_ptr<dealii::DataPostprocessor<3>> stress_of_wall(const WallLoads &loads,
                                                             const ContinuumBody<3> &body,
                                                             const std::vector<double> &factors);

/// Names of points, by the wall's ring there.
using RingNames = std::map<unsigned int, std::vector<std::string>>;

/// The wall coloured by its stress, tables of the shape of its sections, and charts along the chain
/// of pipes, as HTML; the picture is `solid.svg` in the folder as well, and cut open
/// `solid_open.svg`. @param id of the section on its page
std::string wall_report(const Scene &scene, const PipeWall &wall,
                        const std::vector<WallFrame> &frames, const RingNames &names,
                        const std::string &id, const std::string &folder);

} // namespace frictionbeam
