// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

#include <memory>
#include <vector>

namespace frictionbeam::contact {

/**
 * A linear system K q = f condensed exactly onto the unknowns that contacts touch.
 *
 * With kept unknowns c and inner ones i it becomes S q_c = f_c - K_ci K_ii^-1 f_i with
 * S = K_cc - K_ci K_ii^-1 K_ic. What friction changes from iteration to iteration are entries of S
 * at the contacts: S is made once, and serves as long as K does (doc/theory.md, "Exact contact",
 * condensation).
 */
class Condensation {
public:
  virtual ~Condensation() = default;

  /// S, symmetric. Its pattern contains the tangents of sites where K has them, or add_places().
  const SparseMatrix &matrix() const { return S; }
  int n_kept() const { return kept.size(); }
  int n_unknowns() const { return place_of.size(); }
  /// Place of a kept unknown among those of S; -1 for an inner one.
  int place(const int unknown) const { return place_of[unknown]; }

  /// Put zeros where the pattern lacks entries between the unknowns of one block, all of them kept.
  void add_places(const std::vector<std::vector<int>> &blocks);

  /// f_c - K_ci K_ii^-1 f_i.
  virtual Vector condense(const Vector &forces) const = 0;
  /// All unknowns: q_c as given, q_i = K_ii^-1 (f_i - K_ic q_c).
  virtual Vector expand(const Vector &kept_unknowns, const Vector &forces) const = 0;

protected:
  /// @param keep in any order, also more than once
  Condensation(const int n_unknowns, const std::vector<int> &keep);

  std::vector<int> kept, place_of; ///< in ascending order
  SparseMatrix S;
};

/// The parts of matrices that were condensed last, for those to come that differ from them in some
/// parts only: as those of a line do where few of its cells yield. See condense_parts().
class PartMemory;
std::shared_ptr<PartMemory> make_part_memory();

/**
 * Of a sparse matrix, symmetric and positive definite on the inner unknowns. K_ii falls apart into
 * its connected parts, each factored by itself: a line between two supports costs no more than its
 * two ends, and the whole is linear in its length.
 * @param memory of parts whose numbers are the same as before, which are taken over then
 */
std::unique_ptr<Condensation> condense_parts(const SparseMatrix &stiffness,
                                             const std::vector<int> &keep,
                                             PartMemory *const memory = nullptr);

/**
 * The same of bodies that need not be held by the kept unknowns, as one on a single contact, about
 * which it turns: an unknown that would move freely is kept besides, for each such motion, so that
 * what carries it is the contact method's to find.
 */
std::unique_ptr<Condensation> condense_bodies(const SparseMatrix &stiffness,
                                              const std::vector<int> &keep);

} // namespace frictionbeam::contact
