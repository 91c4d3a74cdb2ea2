// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "program.h"
#include "scene.h"

#include <map>

namespace oracle {

/// What two runs of related scenes can be asked to agree on, at the end of each step: motions of
/// named points, forces and slip of supports, and with what they use of what is allowed; then the
/// same of spectra and combinations. Most are vectors, which turn with the scene.
struct Answer {
  enum class Kind { displacement, rotation, force, moment, ratio, energy };
  enum class Turns {
    vector,   ///< with the scene
    absolute, ///< sizes of components: of ranges, of sums of squares
    fixed,    ///< a number that stays
    unknown   ///< sums of both; can only be asked for where nothing turns
  };
  struct Entry {
    Kind kind;
    Vec value;
    Turns turns = Turns::vector;
    bool by_stations =
        false; ///< the largest of the stations of the line, which depend on its nodes
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
  bool same_stations = true;
  double accuracy = 0.; ///< to which it follows, where that is less than the relation's
  /// Steps of the original one and of the changed one that are to agree; empty: each with its own.
  std::vector<std::pair<std::size_t, std::size_t>> steps;
};

/// The largest difference between an answer and the one that follows from the original by the
/// mapping, relative to the largest displacement, rotation, force or moment; what is in one of the
/// two only is not asked for.
double largest_difference(const Answer &original, const Mapping &mapping, const Answer &changed,
                          std::string &what, int &numbers);

} // namespace oracle
