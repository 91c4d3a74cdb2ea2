// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/exact_solver.h>

#include <optional>
#include <vector>

namespace frictionbeam::contact {

/// An increment on its way to its solution, pass by pass.
struct Pass {
  /// A solution within the tolerance, kept while something is tried that may fail.
  struct Accepted {
    Vector unknowns;
    Response response;
    std::vector<Strains> centre;
    double residual;
  };

  const Problem &problem;
  const ImposedMotion &imposed;
  const State &committed;
  Vector &unknowns;
  Response &response;
  const std::vector<Strains> centre_before;
  Result result = {};
  /// A body may move so far that its stiffness times a rounding error of the unknowns is a force:
  /// what rounding takes from them is kept until the increment is judged.
  Vector low = Vector::Zero(unknowns.size());
  double size = 0., largest = 0.; ///< what is left, and the largest force [N]
  const Vector unknowns_before = unknowns;
  Vector forces = {}; ///< to be balanced at the unknowns, without contacts; empty as it begins
  std::optional<Accepted> accepted = {};
  unsigned int n_releases = 0;
  bool is_corrected = false;

  bool is_static() const { return problem.increment.length == 0.; }
  void accept(const std::vector<Strains> &centre) {
    accepted = {unknowns, response, centre, result.residual};
  }
};

} // namespace frictionbeam::contact
