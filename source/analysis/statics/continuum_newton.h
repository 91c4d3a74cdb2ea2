// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "analysis/statics/foundation_contacts.h"

namespace frictionbeam {

struct ContinuumNewtonResult {
  bool converged = false;
  unsigned int iterations = 0;
  double residual = 0.; ///< relative to the largest force
  ContactCheck check;
  std::string remark; ///< why not converged
};

/**
 * Newton's method for one increment of a body on its foundation, on displacements and contact
 * tractions together: ContactNewton::solve_together() for a body, whose words hold here as well.
 * With direct linear algebra on one process, an iteration costs two triangular solves and a dense
 * system of the contacts.
 */
template <int dim>
class ContinuumNewton {
public:
  ContinuumNewton(const ContinuumBody<dim> &body, ContinuumSystem &system,
                  FoundationContacts &contacts);

  /**
   * @param forces of the loads, on unconstrained dofs
   * @param u in: first guess; out: solution, zero at held and hanging dofs
   * @param response of the contacts at the solution
   */
  ContinuumNewtonResult solve(const ContinuumVector &forces, const FoundationState &committed,
                              const LawIncrement &increment, ContinuumVector &u,
                              FoundationResponse &response);

  /// Displacements of the contact nodes in their own axes.
  std::vector<LocalVector> local(const ContinuumVector &u) const;
  /// Add the forces of tractions on the body.
  void add_forces(const std::vector<LocalVector> &stress, ContinuumVector &forces) const;

private:
  bool iterate(const ContinuumVector &forces, const FoundationState &committed,
               const LawIncrement &increment, ContinuumVector &u, FoundationResponse &response,
               ContinuumNewtonResult &result);
  /// Loads minus elastic forces, stiffness times u, plus forces of tractions.
  void residual(const ContinuumVector &forces, const ContinuumVector &elastic,
                const std::vector<LocalVector> &stress, ContinuumVector &left) const;
  double energy(const ContinuumVector &forces) const;
  /// Largest contact force and traction.
  std::pair<double, double> largest(const std::vector<LocalVector> &stress) const;

  const ContinuumBody<dim> &body;
  ContinuumSystem &system;
  FoundationContacts &contacts;
  const SolverSettings &settings;
  ContinuumVector diagonal;
};

} // namespace frictionbeam
