// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

#include <vector>

namespace frictionbeam::contact {

/// Unknowns that are eliminated together, after all that are below them in the tree.
struct Dissected {
  std::vector<int> unknowns;
  int parent; ///< its place in the list; -1 for a root
};

/**
 * Nested dissection of the graph of a symmetric matrix: a small separator splits it, each side is
 * split again, down to leaves of some tens of unknowns. Sides do not touch each other, so that what
 * a front fills in are entries between itself and the fronts on its way to the root. Each connected
 * part of the graph has a root of its own. (A. George, Nested dissection of a regular finite
 * element mesh, SIAM J. Numer. Anal. 10, 1973, doi:10.1137/0710032.)
 *
 * Separators are level sets of distances from some node (A. George, J. W. H. Liu, An automatic
 * nested dissection algorithm for irregular finite element problems, SIAM J. Numer. Anal. 15, 1978,
 * doi:10.1137/0715069).
 *
 * @param matrix of which the pattern is read, both triangles
 * @return children before their parents, and what is below a front in one run before it
 */
std::vector<Dissected> dissect(const SparseMatrix &matrix);

} // namespace frictionbeam::contact
