// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/difference.h"
#include "accuracy/pipes/bend_model.h"

#include <map>

namespace frictionbeam::accuracy {

using Flexibility = double BendModel::*;

/// A scene of pipes with some of its bends as solid walls have them: as flexible, or as much
/// further from the rule as that may be off, and turning by pressure as far.
class BendVariants {
public:
  using Bends = std::vector<const BendModel *>;

  BendVariants(const Scene &whole, const Results &beams, const BendModels &models,
               const SolveAs &solve);

  /// Whether a bend has a flexibility of its own, and not one of its pipe.
  bool is_alone(const BendModel &bend) const {
    return pieces[bend.pipe].size() > 1 || n_bends.at(bend.pipe) == 1;
  }

  /// What walls change in the quantities.
  Difference change(const Bends &walls, const Flexibility by, const std::string &what) const;
  /// What they are off by a part in: their flexibility, and the turn by pressure that goes with it,
  /// or that alone.
  enum class Off { with_turn_by_pressure, flexibility };
  /// What walls change that are off by a part, per part.
  double change_per_part(const Bends &walls, const Off off) const;

private:
  /// Each bend a pipe, if the line stays the same.
  void cut_pipes(const Scene &whole);
  unsigned int pipe_of(const BendModel &bend) const {
    return pieces[bend.pipe].size() > 1 ? pieces[bend.pipe][bend.number] : pieces[bend.pipe][0];
  }
  /// A pipe has one flexibility, that of the bend that its rule misses most.
  Scene with(const Bends &walls, const Flexibility by, const double times = 1.,
             const Off off = Off::flexibility) const;
  Difference between(const Results &coarse, const Results &fine) const;

  Scene scene;                                   ///< in which bends are pipes, if that may be
  std::map<unsigned int, unsigned int> n_bends;  ///< judged ones of each pipe
  std::vector<std::vector<unsigned int>> pieces; ///< of each pipe of the whole scene
  const Results &beams;
  const SolveAs &solve;
};

} // namespace frictionbeam::accuracy
