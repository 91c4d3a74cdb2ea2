// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/contact_attempts.h"
#include "analysis/contact/contact_newton.h"

namespace frictionbeam {

/**
 * Exact contact: Signorini's condition and Coulomb's law without a stiffness to choose.
 *
 * The line is condensed to the nodes of its contacts, and solved there by ContactAttempts. The
 * iteration ends when the contact laws themselves, judged without the proximal term, hold: each
 * contact's natural-map residual on its own scale. Neither a small change from step to step nor the
 * convergence of an inner solve decides (doc/theory.md, "Exact contact").
 */
class ExactSolver final : public EquilibriumSolver {
public:
  ExactSolver(const SolverSettings &settings, const Contacts &contacts, const ReducedSpace &space,
              const SparseMatrix &stiffness);

  void matrix_changed() override {}
  EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                          Vector &unknowns, ContactResponse &response) override;
  /// Take these stresses for the first guess of the next problem, in place of the last solution's.
  void guess(const std::vector<Contact::Strains> &stress) { proximal.centre = stress; }
  void transfer(Archive &archive) override { archive(attempts.first_factor, proximal, newton); }
  std::vector<BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &status) const override {
    return contacts_beyond_uniqueness(contacts, line, proximal, status);
  }

private:
  using Outcome = ContactOutcome;

  /// On the condensed line, from no motion, and where that stalls from elsewhere.
  Outcome solve_contacts(const unsigned int most_restarts, Vector &x, ContactResponse &response,
                         EquilibriumResult &result);
  struct Increment;
  /// Solve the contacts at the present motion of the line, and move it by what that gives.
  /// @return whether they are solved
  bool move(Increment &now);
  /// Whether the forces of the whole line count as balanced.
  bool is_balanced(Increment &now) const;
  /// Whether a line in balance is to be solved once more: slip is let go, pairs of stops are
  /// released, rounding is corrected.
  bool goes_on(Increment &now);
  /// Say why there is no solution.
  void explain(const Outcome outcome, EquilibriumResult &result) const;
  /// @return whether the contact laws hold; the result says so.
  bool judge(const ContactResponse &response, EquilibriumResult &result) const;

  using Pair = std::array<unsigned int, 2>; ///< the halves of a rigid stop
  /// With which both halves press on each other [N]; 0 if they do not.
  double force_in_common(const Pair &pair, const ContactResponse &response) const;
  bool presses_pairs(const ContactResponse &response) const;
  /// Begin anew without what the halves have in common, and without the one that presses less: were
  /// both closed, Newton's method would share a change of the force between them, and the friction
  /// of both, which statics does not determine, would depend on its path. That the half may be left
  /// out is the certificate's to say, which knows nothing of it.
  void release_pairs(const ContactResponse &response);

  const SolverSettings &settings;
  const Contacts &contacts;
  const ReducedSpace &space;
  CondensedLine line;
  ProximalContacts proximal;
  ContactNewton newton;
  ContactAttempts<ContactNewton, ProximalContacts> attempts;
  Vector diagonal;               ///< of the line's stiffness
  const std::vector<Pair> pairs; ///< rigid_pairs()
};

} // namespace frictionbeam
