// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace frictionbeam {

/// The rigid motions of a body on contacts, and whether loads push it away along them.
template <int dim>
class FreeBody {
public:
  FreeBody(const ContinuumBody<dim> &body, const ContinuumSystem &system)
      : body(body), system(system) {}

  /**
   * Whether a rigid motion proves that loads have no equilibrium, whatever forces the contacts give
   * (unresisted_motion()).
   * @param friction coefficients of the cones that forces on this process's contact nodes stay in,
   * nothing where there is no such cone
   * @return nothing where one has none, or rigid motions press on no contact, whose normal forces
   * are then what the body's elasticity makes them
   */
  std::optional<bool> is_pushed_away(const ContinuumVector &loads,
                                     const std::vector<std::optional<double>> &friction);

  /**
   * Whether a rigid motion leads along the normals of nodes on which a pressure is prescribed, a
   * load that holds nothing, and nothing else is in its way: no constraint, no other contact, and
   * no friction, as these nodes do not slide.
   * @param is_pressed of this process's contact nodes
   */
  bool rises_freely(const std::vector<bool> &is_pressed);

private:
  using Motions = Eigen::Matrix<double, dim, Eigen::Dynamic>;

  /// Find the rigid motions, if that has not been done.
  void find_motions();
  /// What they do to a contact node: along its normal, and across.
  Motions motions_of(const ContinuumContactNode<dim> &node) const;
  /// Whether a motion strains nothing.
  bool is_free(ContinuumVector motion) const;

  const ContinuumBody<dim> &body;
  const ContinuumSystem &system;
  std::optional<std::vector<ContinuumVector>> motions; ///< once wanted; zero at constrained dofs
};

} // namespace frictionbeam
