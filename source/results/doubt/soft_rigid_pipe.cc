// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/soft_rigid_pipe.h"

#include "model/unknowns/rigid_part.h"
#include "results/frame/frame_choice.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

SoftRigidPipe softest_rigid_pipe(const Scene &scene, const Frame &frame) {
  SoftRigidPipe worst;
  const double largest = largest_motion(frame);
  for (std::size_t begin = 0, end = 0; begin < frame.line.size() && largest > 0.; begin = end) {
    const unsigned int number = frame.line[begin].pipe;
    const Pipe &pipe = scene.pipes[number];
    const Section &section = scene.sections[pipe.section];
    const double E = rigid_part * scene.materials[pipe.material].youngs_modulus;
    double stretch = 0., turn = 0., length = 0.;
    for (end = begin + 1; end < frame.line.size() && frame.line[end].pipe == number; ++end) {
      const Station &one = frame.line[end - 1], &next = frame.line[end];
      const double way = next.s - one.s;
      length += way;
      stretch += way * std::abs(one.force[0] + next.force[0]) / (2. * E * section.area);
      turn += way * std::hypot(one.force[4] + next.force[4], one.force[5] + next.force[5]) /
              (2. * E * section.inertia);
    }
    const double share = std::max(stretch, turn * length / 3.) / largest;
    if (pipe.rigid && share > worst.share)
      worst = {number, share};
  }
  return worst;
}

} // namespace frictionbeam
