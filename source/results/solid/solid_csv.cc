// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/solid/solid_files.h"
#include "results/text.h"

#include <frictionbeam/generalized_strain.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

std::string wall_row(const std::string &head, const std::vector<double> &numbers) {
  std::string row = head;
  for (const double number : numbers)
    row += ',' + exact_number(number);
  return row;
}

/// Angle from a ring's first axis to the local y of a line [rad].
double angle_of_y(const WallRing &ring) {
  const LocalAxes axes(ring.tangent);
  return std::atan2(axes.y * ring.b, axes.y * ring.a);
}

} // namespace

void write_wall_csv(const Scene &scene, const PipeWall &wall, const std::vector<WallFrame> &frames,
                    const std::string &folder) {
  const double m = scene.units.factor("m"), Pa = scene.units.factor("Pa");
  OutputFile rings(folder + "/solid.csv"), points(folder + "/wall.csv");
  rings.stream() << "step,pipe,s,x,y,z,widening,mode2,angle2,mode3,ovality,mises_inside,"
                    "mises_outside,axial_least,axial_largest\n";
  points.stream() << "step,pipe,s,angle,surface,axial,hoop,radial,shear,mises\n";
  for (const WallFrame &frame : frames)
    for (unsigned int r = 0; r < frame.rings.size(); ++r) {
      const WallRing &at = wall.rings[r];
      const RingState &ring = frame.rings[r];
      const unsigned int pipe = wall.pipe_of_layer(r == 0 ? 0 : r - 1);
      const std::string head = csv_field(scene.steps[frame.step].name) + ',' +
                               csv_field(scene.pipes[pipe].name) + ',' +
                               exact_number((at.s - wall.pipe_start[pipe]) / m);
      constexpr double none = std::numeric_limits<double>::infinity();
      double least = none, largest = -none;
      for (const auto &surface : ring.stress)
        for (const WallStress &point : surface) {
          least = std::min(least, point.axial);
          largest = std::max(largest, point.axial);
        }
      const double y = angle_of_y(at), angle = 0.5 * std::atan2(ring.mode2[1], ring.mode2[0]) - y,
                   half_turn = numbers::PI;
      rings.stream() << wall_row(head,
                                 {at.centre[0] / m, at.centre[1] / m, at.centre[2] / m,
                                  ring.widening / m, std::hypot(ring.mode2[0], ring.mode2[1]) / m,
                                  180. / numbers::PI *
                                      (angle - half_turn * std::floor(angle / half_turn)),
                                  std::hypot(ring.mode3[0], ring.mode3[1]) / m,
                                  ring.ovality(2. * wall.outer), ring.largest_mises(0) / Pa,
                                  ring.largest_mises(1) / Pa, least / Pa, largest / Pa})
                     << '\n';
      for (unsigned int side = 0; side < 2; ++side)
        for (unsigned int i = 0; i < ring.stress[side].size(); ++i) {
          const WallStress &point = ring.stress[side][i];
          const double turn = 2. * numbers::PI, place = turn * i / ring.stress[side].size() - y;
          points.stream() << wall_row(head, {180. / numbers::PI *
                                             (place - turn * std::floor(place / turn + 1e-12))})
                          << (side == 0 ? ",inside" : ",outside")
                          << wall_row("", {point.axial / Pa, point.hoop / Pa, point.radial / Pa,
                                           point.shear / Pa, point.mises() / Pa})
                          << '\n';
        }
    }
  rings.flush();
  points.flush();
}

} // namespace frictionbeam
