// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/site_list.h>

#include <optional>

namespace frictionbeam::contact {

/// What find_free_motion() tells.
struct FreeMotionProof {
  bool is_any_force = true; ///< whether motions without strains press contacts together
  Vector motion; ///< without entries: none, and forces up to 1e4 times the loads may hold them
};

/**
 * A motion w that proves that loads have no equilibrium: it strains nothing, S w = 0, the loads do
 * work on it, g . w > 0, and at every contact
 *   d_N >= mu |d_T|,
 * d = B w, d_N > 0 opening, so that no force that friction allows, r_N >= 0, |r_T| <= mu r_N, takes
 * work from it. An equilibrium would need forces that take g . w.
 *
 * It is what is left of the loads, A (g - H^T r), A the projector on motions without strains, by
 * the allowed forces r that leave least (the dual of a projection on the cone of such motions), by
 * projected gradients with momentum (A. Beck, M. Teboulle, SIAM J. Imaging Sci. 2 (2009) 183-202,
 * doi:10.1137/080716542). Contacts without a closed form may give any force, which proves less.
 *
 * Where no motion without strains presses contacts with friction together, their normal forces are
 * what the loads and the body's elasticity make them, and not anything: loads can then be too large
 * for friction without such a motion, and none is sought.
 *
 * @param unknowns of each contact, places in S @param diagonal of S, positive
 */
FreeMotionProof find_free_motion(const SiteList &contacts,
                                 const std::vector<std::vector<int>> &unknowns,
                                 const SparseMatrix &S, const Vector &diagonal,
                                 const Vector &loads);

/**
 * Forces r that friction allows and that balance the loads on all motions without strains,
 * A (g - H^T r) = 0, as stresses of the contacts: the other end of find_free_motion()'s iteration,
 * where it does not prove. Of a wedge that jams, no path of the loads need lead to them.
 * @return nothing if there are none, or if no motion without strains presses contacts together
 */
std::optional<std::vector<Strains>>
find_balanced_forces(const SiteList &contacts, const std::vector<std::vector<int>> &unknowns,
                     const SparseMatrix &S, const Vector &diagonal, const Vector &loads);

} // namespace frictionbeam::contact
