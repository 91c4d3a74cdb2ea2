// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/condensation.h>

#include <functional>
#include <string>
#include <vector>

namespace frictionbeam::contact {

/**
 * A host's linear system as a Solver sees it: degrees of freedom as the host numbers them, of which
 * the free ones are unknowns, one after the other. Made by system_of(), for deal.II and Trilinos
 * from deal_ii.h, or by hand where the host brings its own condensation or inverse.
 */
struct System {
  struct Term {
    int unknown;
    double weight;
  };
  /// What a degree of freedom is made of: unknowns and a given value. Free: itself alone.
  struct Resolved {
    std::vector<Term> terms;
    double given = 0.;
  };

  std::vector<int> dof_of;    ///< of each unknown
  std::vector<Resolved> dofs; ///< all of the host
  SparseMatrix matrix;        ///< K on the unknowns; empty where `multiply` stands for it
  Vector diagonal;            ///< of K, for scales: right to an order of magnitude
  /// Keep these unknowns, condense the others.
  std::function<std::unique_ptr<Condensation>(const std::vector<int> &keep)> condense;
  /// K times unknowns, where there is no matrix.
  std::function<Vector(const Vector &)> multiply = {};

  int n_unknowns() const { return dof_of.size(); }
};

/**
 * All of an Eigen matrix, of either storage order; nothing is constrained.
 * @throws std::invalid_argument if it is not square or not symmetric: to 1e-9 of the diagonal's two
 * entries in a row and a column
 */
System system_of(const SparseMatrix &matrix);
System system_of(const Eigen::SparseMatrix<double> &matrix);

/**
 * Two bodies that touch through contacts alone, of two handlers or two programs: the second's
 * degrees of freedom follow those of the first, from `first.dofs.size()` on.
 * @throws std::invalid_argument if one has no matrix
 */
System join(const System &first, const System &second);

/// Complete a system whose matrix and dofs are there: diagonal and condensation.
/// @throws std::invalid_argument as system_of()
void complete(System &system);

/**
 * By an inverse that the host has, of a body that is held without its contacts: one application for
 * each unknown that contacts touch, and two for each increment. Multigrid may be behind it.
 * @param solve K^-1 f on the unknowns, to a relative 1e-12 or better, for the certificate asks it
 */
std::unique_ptr<Condensation>
condense_by_inverse(const int n_unknowns, const std::vector<int> &keep,
                    const std::function<Vector(const Vector &forces)> &solve);

} // namespace frictionbeam::contact
