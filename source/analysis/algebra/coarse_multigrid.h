// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/linear_elements.h"

namespace frictionbeam {

/// Algebraic multigrid, with the rigid motions, for the stiffness of LinearElements and what
/// contacts add to it: SmoothedAggregation in one process without MPI, else Trilinos' ML.
class CoarseMultigrid {
public:
  struct Entry {
    dealii::types::global_dof_index row, column;
    double value;
  };

  virtual ~CoarseMultigrid() = default;

  /// @param added by this process to the stiffness, within what cells couple
  virtual void set_up(const std::vector<Entry> &added) = 0;
  /// One cycle from zero, a symmetric operator.
  virtual void cycle(ContinuumVector &x, const ContinuumVector &b) const = 0;
};

std::unique_ptr<CoarseMultigrid> make_coarse_multigrid(const LinearElements &elements,
                                                       const ContinuumBody<3> &body);

} // namespace frictionbeam
