// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/condensed_line.h"
#include "analysis/algebra/line_factorization.h"
#include "analysis/contact/contact_attempts.h"
#include "analysis/contact/equilibrium.h"

namespace frictionbeam {

/**
 * Newton's methods for one increment of a condensed line on proximal contacts:
 * find x, the motion of the kept unknowns, with S x + H^T r = g and r = R(H x, centre).
 */
class ContactNewton {
public:
  ContactNewton(const SolverSettings &settings, const Contacts &contacts, const CondensedLine &line,
                ProximalContacts &proximal);

  using Outcome = ContactOutcome;

  /**
   * Begin from the displacements q.
   * @param forces on the unknowns that the line at q does not balance, without those of contacts
   * @param largest_load to measure them by; @param force_so_far largest of the load sequence
   * @param dofs all displacements at q
   */
  void begin(const Vector &forces, const double largest_load, const double force_so_far,
             const Vector &dofs, const ContactState &committed, const ContactIncrement &increment);

  /// Newton's method on the contacts around a fixed centre, with a line search.
  Outcome solve_proximal(Vector &x, ContactResponse &response, EquilibriumResult &result);

  /**
   * Newton's method on motions and contact forces together, for the exact contact: the centre takes
   * part as an unknown. With r the forces, D the proximal tangent and C = D diag(by centre), the
   * linearised law is (I - C) dr = D H dx + R - r; C has the eigenvalue 1 where a rigid contact is
   * closed or sticks, so that I - (1 - epsilon) C takes its place, which is a stiffness of rho /
   * epsilon in the direction of Newton's step and leaves the solution alone. dr is eliminated
   * contact by contact. The line search is on the energy
   * (g - S x - H^T r)^2 / diag S + (R - r)^2 / (c k_d).
   */
  Outcome solve_together(const unsigned int most_iterations, Vector &x, ContactResponse &response,
                         EquilibriumResult &result);

  /// Whether solve_together() stalled at a solution of the contact laws because of rounding, which
  /// is too large beside the forces to be excused.
  bool rounding_bars() const { return is_barred; }
  std::string rounding_remark() const;

  void take_forces_as_centre(const ContactResponse &response) { proximal.centre = response.stress; }
  /// Whether no further attempt is worth its iterations.
  bool gives_up(const EquilibriumResult &result) const {
    return is_barred || result.iterations >= most_iterations;
  }
  double agreed(const double number) const { return number; } ///< of one process
  unsigned int most_iterations = 0;                           ///< of the present problem

  /// The tangents that are factored, and reading them, their factors.
  void transfer(Archive &archive);

  /// Of the exact laws, at the last evaluation.
  ContactCheck check(const ContactResponse &response) const;

private:
  /// Evaluate the contacts and return the forces left over.
  Vector evaluate(const Vector &x, ContactResponse &response);
  Vector forces_left(const Vector &x, const ContactResponse &response) const;
  bool balanced(const Vector &forces, const Vector &x, const ContactResponse &response,
                EquilibriumResult &result);
  Contact::Strains strain_of(const unsigned int i, const Vector &motion) const {
    return contacts[i].strain_by_unknowns(motion, places[i].unknowns);
  }
  void subtract_force(const unsigned int i, const Contact::Strains &stress, Vector &forces) const {
    contacts[i].add_to(forces, stress, -1., places[i].unknowns);
  }
  double energy(const Vector &forces) const;
  double energy_together(const Vector &x, const ContactResponse &response) const;

  using Block = Eigen::Matrix<double, n_support_strains, n_support_strains>;
  /// Add a contact's stiffness, of its strains, to the tangent.
  void add_block(const unsigned int i, const Block &stiffness);
  /// Add to the stresses and their tangents what the centre as an unknown makes of them, and to
  /// @p step what the centre moves by itself (doc/theory.md).
  void eliminate_centre(ContactResponse &response, std::vector<Contact::Strains> &step) const;
  /// Factor S with the contacts' tangents, and a small multiple of the diagonal where that fails.
  bool factor(const ContactResponse &response, EquilibriumResult &result);
  /**
   * Whether an iterate proves that there is no equilibrium: a motion without elastic forces that
   * presses on no contact, along which every contact gives its utmost resistance or none, and the
   * loads still do work.
   */
  bool slides_away(const Vector &x, ContactResponse &response);

  /// Places of a contact's unknowns in x, and of its block in the values of S.
  struct Places {
    std::vector<int> unknowns, values;
  };

  const SolverSettings &settings;
  const Contacts &contacts;
  const SparseMatrix &S;
  const CondensedLine &line;
  ProximalContacts &proximal;
  std::vector<Places> places;
  std::vector<int> diagonal_places; ///< in the values of S
  Vector diagonal;                  ///< of S, positive
  LineFactorization factors;
  SparseMatrix tangent;
  decltype(ContactResponse::tangent) factored; ///< the contacts' tangents that factors hold

  // of the increment
  Vector loads; ///< g
  double largest_load = 0., force_so_far = 0.;
  double force_left = 0., rounding = 0., largest_force = 0.; ///< as last judged [N]
  bool is_barred = false;
  std::vector<Contact::Strains> start_strain;
  double start_displacement = 0., largest_displacement = 0.;
  const ContactState *committed = nullptr;
  ContactIncrement increment;
};

} // namespace frictionbeam
