// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"
#include "results/results.h"

namespace frictionbeam {

/// A contact node's state, for tables: as `contact.csv` has it.
struct ContactRow {
  unsigned int surface = 0, step = 0, increment = 0;
  double time = 0.;
  Point3 position;
  double area = 0.; ///< [m2]
  ContactStatus status = ContactStatus::none;
  double pressure = 0., traction1 = 0., traction2 = 0.; ///< of the foundation on the body [Pa]
  double gap = 0., slip1 = 0., slip2 = 0.;              ///< [m]
  Vector3 displacement;
};

/// All contact nodes of all processes at one instant, by surface and then by x, y, z.
template <int dim>
std::vector<ContactRow> contact_rows(const ContinuumBody<dim> &body,
                                     const FoundationContacts &contacts,
                                     const ContinuumState &state);

/// `contact.csv`: surface, step, increment, time, x, y, z, area, status, pressure, t1, t2, gap,
/// slip1, slip2, ux, uy, uz; a row for each contact node at the end of each step.
void write_contact_csv(const Scene &scene, const std::vector<ContactRow> &rows,
                       const std::string &folder);

/**
 * Value of a quantity; the same on all processes.
 *
 * Axial force at x: what is applied to the body left of x, loads and friction, the latter
 * integrated as the polynomial through the nodes' tractions. Equilibrium of the discrete solution
 * makes it far more accurate than stresses are.
 *
 * Ends of zones: where a parabola through four nodes' slip (or gap) to the power 2/3 meets zero,
 * since slip and gap go to zero with the distance to the power 3/2 where the traction is
 * continuous; halfway to the next node where that makes no sense.
 */
template <int dim>
double evaluate_quantity(const ContinuumBody<dim> &body, const ContinuumState &state,
                         const std::vector<ContactRow> &rows, const ContinuumQuantity &quantity);

std::string unit_of(const ContinuumQuantity &quantity);

/// One mesh of the adaptive refinement.
struct ContinuumLevel {
  std::size_t cells = 0, unknowns = 0, contacts = 0;
  unsigned int iterations = 0;
  std::optional<double> estimate; ///< relative, of the energy norm, if it was needed
  double seconds = 0.;            ///< since the start
  std::vector<double> quantities;

  void transfer(Archive &archive) {
    archive(cells, unknowns, contacts, iterations, estimate, seconds, quantities);
  }
};

/// Convergence table of the quantities, as HTML, and `convergence.csv`.
std::string convergence_table(const Scene &scene, const std::vector<ContinuumLevel> &levels);
void write_convergence_csv(const Scene &scene, const std::vector<ContinuumLevel> &levels,
                           const std::string &folder);

/// Charts of tractions, slip and gap along the surfaces, as HTML.
std::string contact_charts(const Scene &scene, const std::vector<ContactRow> &rows);

} // namespace frictionbeam
