// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "program.h"
#include "scene.h"

#include <map>

namespace oracle {

/// What two runs of related scenes can be asked to agree on, at the end of each step: motions of
/// named points, forces of supports. Each is a vector, which turns with the scene.
struct Answer {
  enum class Kind { displacement, rotation, force, moment };
  struct Entry {
    Kind kind;
    Vec value;
  };
  std::vector<std::map<std::string, Entry>> steps;
  std::vector<double> frequencies;

  Answer(const Scene &scene, const Outcome &program);
  Answer() = default;
};

/// How the answer to a changed scene follows from that to the original one.
struct Mapping {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< of vectors; of rotations, times its det
  double length = 1., force = 1., time = 1.;          ///< factors
};

/// The largest difference between an answer and the one that follows from the original by the
/// mapping, relative to the largest displacement, rotation, force or moment; what is in one of the
/// two only is not asked for.
double largest_difference(const Answer &original, const Mapping &mapping, const Answer &changed,
                          std::string &what, int &numbers);

} // namespace oracle
