// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "proximal_sites.h"
#include "reduced_tangent.h"
#include "tangent_factors.h"
#include <frictionbeam/contact/condensation.h>

#include <array>
#include <optional>

namespace frictionbeam::contact {

/**
 * The equations of one increment of a condensed system on proximal contacts, S x + H^T r = g and
 * r = R(H x, centre) with x the motion of the kept unknowns, their residuals, and factors of their
 * tangent.
 */
class IncrementEquations {
public:
  IncrementEquations(const Settings &settings, const SiteList &contacts, const Condensation &line,
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

  /// Strains of the sites, which are not evaluated.
  void place(const Vector &x, Response &response) const;
  /// Evaluate the contacts, and the forces that the body leaves to them.
  void evaluate(const Vector &x, Response &response);
  /// From the last x evaluated on, a step.
  void begin_step() { left_at_start = left_by_body; }
  /// Evaluate at x, a part of the step's length from its start; first at all of it, between which
  /// the forces that the body leaves are linear.
  void evaluate_on_step(const double length, const Vector &x, Response &response);
  /// Left over by body and contacts, at the last x evaluated.
  Vector forces_left(const Response &response) const;
  /// Whether these count as zero: by the tolerance, or by rounding.
  bool balanced(const Vector &forces, const Vector &x, const Response &response, Result &result);
  /// By the inverse diagonal, that forces and moments count alike [J].
  double energy(const Vector &forces) const;
  /// Of Newton's method on motions and forces together, the centre being the forces:
  /// (g - S x - H^T r)^2 / diag S + (R - r)^2 / (c k_d).
  double energy_together(const Response &response) const;
  /// Of the exact laws, at the last evaluation, whose response it is.
  const Check &check(const Response &response);
  /// The next check is of another response.
  void forget_check() { checked.reset(); }
  /// Of exact contact @p i at the response's strain, under a stress.
  Check::Point point_of(const unsigned int i, const Strains &stress, const double rounding,
                        const Response &response) const {
    return proximal.point_of(i, stress, response.state.strain[i], *committed, rounding);
  }
  /// Of displacements that x makes [m].
  double rounding_of_motion(const Vector &x) const;
  Strains strain_of(const unsigned int i, const Vector &motion) const {
    Strains strain = Strains::Zero();
    for (unsigned int j = first_place[i]; j < first_place[i + 1]; ++j)
      strain += motion[places[j].unknown] * places[j].strain;
    return strain;
  }

  /// Factor S with the contacts' tangents: for a body the directions alone that are free. What is
  /// factored already is not factored again. @return false if a pivot vanishes
  bool factor(const Response &response, Result &result);
  /// With what factor() has left; where the reduced factors do not do, with all.
  bool solve(const Vector &forces, const Response &response, Result &result, Vector &direction);
  /// Whether a line cannot move without forces in the states of contact of a response: if it can, a
  /// pose is one of many, and where it was begun from shows in it.
  bool is_held(const Response &response, Result &result);
  /// S and a multiple of its diagonal, without the contacts, for factor_tangent().
  void begin_tangent(const double shift);
  /// Add a contact's stiffness, of its strains, to that.
  void add_block(const unsigned int i, const Block &stiffness);
  bool factor_tangent();
  Vector solve_tangent(const Vector &forces) const { return factors.solve(forces); }

  /// The tangents that are factored; restoring them, their factors are made again.
  void save(WarmStart &memory) const { memory.factored = factored; }
  void restore(const WarmStart &memory);

  /// From here on a drag on all kept unknowns, this times diag S, holds what nothing else does; 0
  /// takes it off.
  void set_drag(const double factor);
  double drag_factor() const { return drag; }
  bool is_in_motion() const { return increment.length > 0.; }
  /// Whether the contacts are all coupled.
  bool is_of_body() const { return factors.is_of_body(); }
  std::vector<std::vector<int>> unknowns_of_contacts() const;

  const Settings &settings;
  const SiteList &contacts;
  const SparseMatrix &S;
  ProximalSites &proximal;
  const Vector diagonal; ///< of S, positive

  // of the increment
  Vector loads; ///< g
  /// As last judged [N].
  double force_left = 0., rounding = 0., largest_force = 0.;

private:
  void subtract_force(const unsigned int i, const Strains &stress, Vector &forces) const {
    const double weight = contacts[i].weight;
    for (unsigned int j = first_place[i]; j < first_place[i + 1]; ++j)
      forces[places[j].unknown] -= weight * places[j].strain.dot(stress);
  }
  /// Whether the contacts' tangents are those that are factored but for directions in which no
  /// unknown moves a contact: the sum with S is the same.
  bool differs_without_unknowns(const Response &response) const;
  void evaluate_contacts(const Vector &x, Response &response);
  /// What changes of the tangent from factorization to factorization.
  void find_changing();
  /// Add a multiple of S's diagonal.
  void shift_tangent(const double shift);
  /// All directions, and a small multiple of the diagonal where that fails.
  bool factor_all(const Response &response, Result &result);

  /// An unknown of a contact: its place in x, and the strains that it makes, a column of B.
  struct Place {
    int unknown;
    Strains strain;
  };

  const Condensation &line;
  std::vector<Place> places; ///< of all contacts, one after the other, as are those of their blocks
  std::vector<unsigned int> first_place, first_value;
  std::vector<std::array<bool, 4>> moves;     ///< strains of a contact that its unknowns make
  std::vector<int> value_places;              ///< among the changing values
  std::vector<int> diagonal_places;           ///< among the changing values
  std::vector<double> changing_of_S, tangent; ///< changing values of S and of the tangent
  const SparseMatrix stiffness; ///< S without its zeros, two thirds of a line along the axes
  TangentFactors factors;
  std::optional<ReducedTangent> reduced; ///< of a body
  bool is_reduced = false;               ///< which of the two holds the factors
  std::vector<Block> factored;           ///< the contacts' tangents that factors hold
  std::vector<ContactStatus> status_of_factors;
  bool is_shifted = false;  ///< by a small multiple of the diagonal, without which nothing is left
  bool is_singular = false; ///< at least nearly

  // of the increment
  Vector left_by_body; ///< g - S x without the contacts' forces, at the last x evaluated
  Vector left_at_start, left_at_end; ///< the same, of a step
  double largest_load = 0., force_so_far = 0.;
  double drag = 0.;
  std::vector<Strains> start_strain;
  double start_displacement = 0., displacement_rounding = 0.;
  std::optional<Check> checked; ///< the last evaluation
  const State *committed = nullptr;
  Increment increment;
};

} // namespace frictionbeam::contact
