// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/contact_newton.h"

namespace frictionbeam {

/**
 * Exact contact: Signorini's condition and Coulomb's law without a stiffness to choose.
 *
 * On the line condensed to the nodes of its contacts, Newton's method on displacements and contact
 * forces together is tried first, for some values of c, the scale between the two. Where it stalls,
 * a proximal-point iteration takes over: the line is solved on proximal contacts (ProximalContacts)
 * of stiffness c k_d around the forces of the step before, c grows from step to step and is lowered
 * where the solution fails, and after each step Newton's method on both is tried again. The
 * iteration ends when the contact laws themselves, judged without the proximal term, hold: each
 * contact's natural-map residual on its own scale. Neither a small change from step to step nor the
 * convergence of an inner solve decides.
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
  void transfer(Archive &archive) override { archive(first_factor, proximal, newton); }
  std::vector<BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &status) const override {
    return contacts_beyond_uniqueness(contacts, line, proximal, status);
  }

private:
  using Outcome = ContactNewton::Outcome;

  /// From the displacements that newton began with.
  Outcome solve_contacts(Vector &x, ContactResponse &response, EquilibriumResult &result);
  /// Both again, from scattered contact forces and by way of less friction: far above the limit of
  /// uniqueness, states that are near in time need not be near each other.
  Outcome solve_from_elsewhere(const unsigned int most, Vector &x, ContactResponse &response,
                               EquilibriumResult &result);
  Outcome solve_by_proximal_steps(Vector &x, ContactResponse &response, EquilibriumResult &result);

  /// @return whether the contact laws hold; the result says so.
  bool judge(const ContactResponse &response, EquilibriumResult &result) const;

  using Pair = std::array<unsigned int, 2>; ///< the halves of a rigid stop
  /// With which both halves press on each other [N]; 0 if they do not.
  double force_in_common(const Pair &pair, const ContactResponse &response) const;
  bool presses_pairs(const ContactResponse &response) const;
  /// Begin anew without what the halves have in common.
  void release_pairs(const ContactResponse &response);

  /// Whether no further attempt is worth its iterations.
  bool gives_up(const EquilibriumResult &result) const {
    return newton.rounding_bars() || result.iterations >= most_iterations;
  }

  const SolverSettings &settings;
  const Contacts &contacts;
  const ReducedSpace &space;
  CondensedLine line;
  ProximalContacts proximal;
  ContactNewton newton;
  Vector diagonal; ///< of the line's stiffness
  double first_factor;
  const std::vector<Pair> pairs;    ///< rigid_pairs()
  unsigned int most_iterations = 0; ///< of the present problem
};

} // namespace frictionbeam
