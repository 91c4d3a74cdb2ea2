// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"

namespace frictionbeam {

/// Exact contact on the line condensed to the nodes that contacts touch (contact::ExactSolver).
class ExactMethod final : public EquilibriumSolver {
public:
  ExactMethod(const SolverSettings &settings, const Contacts &contacts,
              const SparseMatrix &stiffness, contact::PartMemory *const memory = nullptr);

  static contact::Settings settings_of(const SolverSettings &settings);
  /// All unknowns of the nodes that contacts touch.
  static std::vector<int> kept_unknowns(const Contacts &contacts);
  /// What motions imposed on degrees of freedom make of the contacts' strains.
  static contact::ImposedMotion imposed_motion(const Contacts &contacts, const Vector &imposed);

  void matrix_changed() override {}
  EquilibriumResult solve(const EquilibriumProblem &problem, const ContactState &committed,
                          Vector &unknowns, ContactResponse &response) override;
  /// Take these stresses for the first guess of the next problem, in place of the last solution's.
  void guess(const std::vector<Contact::Strains> &stress) { solver.guess(stress); }
  void transfer(Archive &archive) override;
  std::vector<contact::BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &status) const override {
    return solver.beyond_uniqueness(status);
  }

private:
  const Contacts &contacts;
  contact::ExactSolver solver;
};

void transfer(Archive &archive, contact::WarmStart &memory);

} // namespace frictionbeam
