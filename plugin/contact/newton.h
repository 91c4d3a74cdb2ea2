// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "proximal_sites.h"
#include "reduced_tangent.h"
#include "tangent_factors.h"
#include <frictionbeam/contact/attempts.h>
#include <frictionbeam/contact/condensation.h>

#include <optional>

namespace frictionbeam::contact {

/**
 * Newton's methods for one increment of a condensed system on proximal contacts:
 * find x, the motion of the kept unknowns, with S x + H^T r = g and r = R(H x, centre).
 */
class Newton {
public:
  Newton(const Settings &settings, const SiteList &contacts, const Condensation &line,
         ProximalSites &proximal);

  /**
   * Begin from the displacements q.
   * @param forces on the unknowns that the body at q does not balance, without those of contacts
   * @param largest_load to measure them by; @param force_so_far largest of the load sequence
   * @param strain of the sites at q, @param displacement the largest that makes it [m]
   */
  void begin(const Vector &forces, const double largest_load, const double force_so_far,
             std::vector<Strains> strain, const double displacement, const State &committed,
             const Increment &increment);

  /// Whether the contacts are all coupled.
  bool is_of_body() const { return factors.is_of_body(); }

  /// Newton's method on the contacts around a fixed centre, with a line search.
  Outcome solve_proximal(Vector &x, Response &response, Result &result);

  /**
   * Newton's method on motions and contact forces together, for the exact contact: the centre takes
   * part as an unknown. With r the forces, D the proximal tangent and C = D diag(by centre), the
   * linearised law is (I - C) dr = D H dx + R - r; C has the eigenvalue 1 where a rigid contact is
   * closed or sticks, so that I - (1 - epsilon) C takes its place, which is a stiffness of rho /
   * epsilon in the direction of Newton's step and leaves the solution alone. dr is eliminated
   * contact by contact. The line search is on the energy
   * (g - S x - H^T r)^2 / diag S + (R - r)^2 / (c k_d).
   */
  Outcome solve_together(const unsigned int most_iterations, Vector &x, Response &response,
                         Result &result);

  /// Whether solve_together() stalled at a solution of the contact laws because of rounding, which
  /// is too large beside the forces to be excused.
  bool rounding_bars() const { return is_barred; }
  void bar(const bool by_rounding) { is_barred = by_rounding; }
  std::string rounding_remark() const;

  /**
   * From here on a drag on all kept unknowns, this times diag S, holds what nothing else does; 0
   * takes it off. With a small one every problem has a solution.
   */
  void set_drag(const double factor);
  /// Whether the solution with drag proves that without it there is none: next to all of it strains
  /// nothing, every contact that resists it gives its utmost, and the loads do the work.
  bool drag_alone_holds(const Vector &x, const Response &response);

  /// Of the kept unknowns, where an outcome is `slides_away`.
  const Vector &free_motion() const { return motion_of_proof; }

  void take_forces_as_centre(const Response &response) { proximal.centre = response.stress; }
  /// Whether no further attempt is worth its iterations.
  bool gives_up(const Result &result) const {
    return is_barred || result.iterations >= most_iterations;
  }
  double agreed(const double number) const { return number; } ///< of one process
  unsigned int most_iterations = 0;                           ///< of the present problem

  /// The tangents that are factored; restoring them, their factors are made again.
  void save(WarmStart &memory) const { memory.factored = factored; }
  void restore(const WarmStart &memory);

  /// Of the exact laws, at the last evaluation.
  Check check(const Response &response) const;

private:
  /// Evaluate the contacts, and the forces that the body leaves to them.
  void evaluate(const Vector &x, Response &response);
  /// Left over by body and contacts, at the last x evaluated.
  Vector forces_left(const Response &response) const;
  bool balanced(const Vector &forces, const Vector &x, const Response &response, Result &result);
  Strains strain_of(const unsigned int i, const Vector &motion) const {
    return contacts[i].strain_by_unknowns(motion, places[i].unknowns);
  }
  void subtract_force(const unsigned int i, const Strains &stress, Vector &forces) const {
    contacts[i].add_to(forces, stress, -1., places[i].unknowns);
  }
  double energy(const Vector &forces) const;
  double energy_together(const Response &response) const;

  /// S and a multiple of its diagonal, without the contacts.
  void begin_tangent(const double shift);
  /// Add a contact's stiffness, of its strains, to the tangent.
  void add_block(const unsigned int i, const Block &stiffness);
  /// Add to the stresses and their tangents what the centre as an unknown makes of them, and to
  /// @p step what the centre moves by itself (doc/theory.md).
  void eliminate_centre(Response &response, std::vector<Strains> &step) const;
  /// Factor S with the contacts' tangents: for a body the directions alone that are free.
  bool factor(const Response &response, Result &result);
  /// All directions, and a small multiple of the diagonal where that fails.
  bool factor_all(const Response &response, Result &result);
  /// With what factor() has left; where the reduced factors do not do, with all.
  bool solve(const Vector &forces, const Response &response, Result &result, Vector &direction);
  /**
   * Whether an iterate proves that there is no equilibrium: a motion without elastic forces that
   * presses on no contact, along which every contact gives its utmost resistance or none, and the
   * loads still do work.
   */
  bool slides_away(const Vector &x, Response &response);
  /// Whether next to all of a motion of the kept unknowns is softer than 1e-13 of diag S: a soft
  /// line is not taken for a free body.
  bool strains_nothing(const Vector &x);
  /// Contacts only take off what loads do on a motion; where these do less than is left, a pose far
  /// off has rounding for its forces, or ground pushes what floats out of its way.
  bool loads_do(const double work, const Vector &motion) const;
  /// Whether all contacts give their utmost against a motion, which is kept as the proof.
  bool is_resisted_in_vain(const Vector &motion, const Response &response);

  /// Places of a contact's unknowns in x, and of its block in the values of S.
  struct Places {
    std::vector<int> unknowns, values;
  };

  std::vector<std::vector<int>> unknowns_of_contacts() const {
    std::vector<std::vector<int>> unknowns;
    for (const Places &of_contact : places)
      unknowns.push_back(of_contact.unknowns);
    return unknowns;
  }

  const Settings &settings;
  const SiteList &contacts;
  const SparseMatrix &S;
  const Condensation &line;
  ProximalSites &proximal;
  std::vector<Places> places;
  std::vector<int> diagonal_places; ///< in the values of S
  Vector diagonal;                  ///< of S, positive
  TangentFactors factors;
  std::optional<ReducedTangent> reduced; ///< of a body
  bool is_reduced = false;               ///< which of the two holds the factors
  SparseMatrix tangent;
  std::vector<Block> factored; ///< the contacts' tangents that factors hold

  // of the increment
  Vector loads;        ///< g
  Vector left_by_body; ///< g - S x without the contacts' forces, at the last x evaluated
  double largest_load = 0., force_so_far = 0.;
  double force_left = 0., rounding = 0., largest_force = 0.; ///< as last judged [N]
  bool is_barred = false;
  double drag = 0.;
  std::vector<Strains> start_strain;
  double start_displacement = 0., largest_displacement = 0.;
  Vector motion_of_proof; ///< without entries: there is none
  bool is_proved = false; ///< whether these loads have been looked at
  const State *committed = nullptr;
  Increment increment;
};

} // namespace frictionbeam::contact
