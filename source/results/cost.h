// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace frictionbeam {

/// What a run took, and how large it was.
struct Cost {
  double wall_seconds = 0., mesh_seconds = 0., setup_seconds = 0., solve_seconds = 0.;
  std::size_t unknowns = 0, cells = 0, contacts = 0;
  std::size_t steps = 0, iterations = 0, factorizations = 0;
  std::size_t back_substitutions = 0; ///< with a matrix of the whole line
  double peak_memory_mb = 0.;

  /// Add what another run took, but for its size and memory.
  void add_work(const Cost &other) {
    mesh_seconds += other.mesh_seconds;
    setup_seconds += other.setup_seconds;
    solve_seconds += other.solve_seconds;
    steps += other.steps;
    iterations += other.iterations;
    factorizations += other.factorizations;
    back_substitutions += other.back_substitutions;
  }
  /// Of mesh, set-up and solution.
  double seconds() const { return mesh_seconds + setup_seconds + solve_seconds; }
};

} // namespace frictionbeam
