// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "analysis/algebra/elasticity_kernel.h"

#include <Eigen/Core>

namespace frictionbeam {

/**
 * Stiffness of a body of hexahedra on its free dofs, without a matrix: hanging nodes get their
 * values from those that they hang on, and hand their forces to them; held dofs are zero, and their
 * forces dropped.
 */
class ElasticOperator {
public:
  explicit ElasticOperator(const ContinuumBody<3> &body);

  /// y = K x; zero at held and hanging dofs.
  void vmult(ContinuumVector &y, const ContinuumVector &x) const;
  /// Of this process's dofs, as if hanging nodes moved alone; zero where a dof is constrained.
  const ContinuumVector &diagonal() const { return own_diagonal; }

private:
  struct Line { ///< of a constrained dof
    unsigned int dof;
    std::size_t begin, end; ///< in masters
  };

  void read_cells();
  void read_lines();
  void set_constrained(ContinuumVector &x) const;
  void collect_constrained(ContinuumVector &y) const;

  const ContinuumBody<3> &body;
  ElasticHexahedra cells;
  std::vector<Line> lines;
  std::vector<std::pair<unsigned int, double>> masters;
  mutable ContinuumVector values; ///< of x, at all dofs of this process and its neighbours'
  ContinuumVector own_diagonal;
};

/// A stiffness and tangents of contacts.
class StiffnessWithContacts {
public:
  /// A contact's 3x3 tangent on three free dofs of this process (n_free of them, the others held).
  struct Contact {
    std::array<unsigned int, 3> dofs; ///< places in the vector
    std::array<bool, 3> is_free;
    Eigen::Matrix3d tangent;
  };

  StiffnessWithContacts(const ElasticOperator &stiffness, std::vector<Contact> contacts)
      : stiffness(stiffness), contacts(std::move(contacts)) {}
  void vmult(ContinuumVector &y, const ContinuumVector &x) const;

private:
  const ElasticOperator &stiffness;
  const std::vector<Contact> contacts;
};

} // namespace frictionbeam
