// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/exact_solver.h>
#include <frictionbeam/contact/system.h>

#include <array>

namespace frictionbeam::contact {

using Vector3 = Eigen::Vector3d;

/**
 * One contact of a host: between a body and the ground, or between two bodies, whose degrees of
 * freedom may belong to different handlers as long as the system numbers them all.
 *
 * The opening is `d = sum_j rows[j] u[dofs[j]]`, the motion of the second body (or the ground)
 * minus that of the first: for a vertex on the ground, rows are minus the unit vectors. In two
 * dimensions the third component stays zero.
 */
struct Contact {
  std::vector<unsigned int> dofs;
  std::vector<Vector3> rows; ///< beside dofs, in global axes [-]
  Vector3 normal;            ///< unit vector from the first body to the second
  double gap = 0.;           ///< before any motion [m]; below zero: pressed together
  double area = 1.;          ///< how many times the law stands there [m2 for a law per area, -]
  const LawDescription *law = nullptr; ///< of kind `support`; it must outlive the solver
  std::vector<double> parameters;      ///< of the law, in its order
  Vector3 tangent = Vector3::Zero();   ///< first direction of slip; zero: any across the normal
};

/// A point of a body on rigid ground; dofs of its translations, three at most.
/// @throws std::invalid_argument if there are more, or one twice
Contact on_ground(const std::vector<unsigned int> &translations, const Vector3 &normal,
                  const LawDescription &law, const std::vector<double> &parameters);
/// A point of one body on a point of another.
Contact between(const std::vector<unsigned int> &first, const std::vector<unsigned int> &second,
                const Vector3 &normal, const LawDescription &law,
                const std::vector<double> &parameters);

/// What contacts remember, the caller's: copyable, comparable, for boost's archives and others of
/// that interface.
struct ContactMemory {
  State sites;
  std::vector<Strains> stress;
  double largest_force = 0.; ///< of loads and contacts so far, which rounding is judged by [N]

  template <class Archive>
  void serialize(Archive &archive, const unsigned int) {
    archive &sites.internal &sites.dissipated &sites.wear &sites.impulse &largest_force;
    for (std::vector<Strains> *list : {&sites.strain, &sites.touch, &stress})
      transfer(archive, *list);
  }

private:
  template <class Archive>
  static void transfer(Archive &archive, std::vector<Strains> &list) {
    std::vector<double> numbers(n_strains * list.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = list[i / n_strains][i % n_strains];
    archive &numbers;
    list.resize(numbers.size() / n_strains);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      list[i / n_strains][i % n_strains] = numbers[i];
  }
};

/// One contact at the end of an increment.
struct ContactState {
  ContactStatus status = ContactStatus::none;
  double normal_force = 0.;        ///< pressing, >= 0 [N]
  Vector3 force = Vector3::Zero(); ///< on the first body, global axes [N]
  double gap = 0.;                 ///< of the rigid part [m]
  Vector3 slip = Vector3::Zero();  ///< of the second body on the first, of the increment [m]
};

/// Of an increment [J]. `left_over` is what increments miss: friction that turned within one, a gap
/// that closed within one. Of the unknowns: where constraints give degrees of freedom values,
/// `external` and `stored` both lack the same, what the stiffness between these and the others does
/// (u^T K u/2 of the whole matrix has it).
struct EnergyAccount {
  double external = 0.;    ///< work of the loads
  double stored = 0.;      ///< in the body
  double in_contacts = 0.; ///< stored in elastic contacts
  double dissipated = 0.;
  double ground = 0.; ///< work of ground that moved, on the body

  double left_over() const { return external + ground - stored - in_contacts - dissipated; }
};

/// How an increment ended, and the proof.
struct Report {
  bool converged = false;
  bool no_equilibrium = false; ///< proved: `free_motion` is resisted by nothing
  double residual = 0.;        ///< of the forces, relative to the largest
  Check check;                 ///< of the contact laws
  EnergyAccount energy;
  std::vector<ContactState> contacts;
  std::vector<BeyondUniqueness> not_unique; ///< contacts that may have another state
  Vector free_motion;                       ///< on the host's dofs
  unsigned int iterations = 0, factorizations = 0;
  std::string remark; ///< why not converged
};

/**
 * Exact contact for a host's own linear system: K u + forces of contacts = f with Signorini's
 * condition and Coulomb's law, or any law of kind `support`, proved to hold.
 *
 * The matrix is condensed once and serves all increments; a solver is made anew for another matrix.
 * See doc/contact_library.md.
 */
class Solver {
public:
  /// @throws std::invalid_argument that names the contact, what was read, what is allowed
  Solver(System system, const std::vector<Contact> &contacts, const Settings &settings = {});
  ~Solver();
  Solver(Solver &&);
  Solver &operator=(Solver &&);

  /// At displacements @p u of the host (empty: none): no friction force yet.
  ContactMemory initial_memory(const Vector &u = {}) const;

  /**
   * One increment.
   * @param f forces at its end, on the host's dofs; what stands at constrained ones is not read
   * @param before contacts at its beginning
   * @param u in: displacements at its beginning, out: at its end, on the host's dofs
   * @param after contacts at its end; @p before may be the same object
   * u and after are as they were if the report says that it has not converged.
   */
  Report solve(const Vector &f, const ContactMemory &before, Vector &u, ContactMemory &after,
               const Increment &increment = {});
  /// Ground that moves: displacements of the second side, one for each contact, at the end of the
  /// increments that follow; zeros for contacts between two bodies, which it would drive apart.
  /// Empty: at rest.
  void move_ground(const std::vector<Vector3> &displacement);

  /**
   * Velocities after an impact, or after a time step on velocities: A v + impulses = momentum, with
   * v_N >= -e min(0, v_N(before)) for contacts that are closed, and Coulomb's law between impulses
   * and the sliding velocity. A is the system's matrix: the mass, or what an implicit step makes of
   * it. Laws must be rigid.
   * @param v in: before, out: after; as it was if not converged
   * @param takes_part whether a contact is closed, for each
   */
  Report strike(const Vector &momentum, const std::vector<bool> &takes_part,
                const double restitution, Vector &v);

  /// Contacts beyond the limit of uniqueness are looked for up to this number of contacts, since
  /// the cost is quadratic in them.
  unsigned int most_contacts_for_uniqueness = 100;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace frictionbeam::contact
