// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"

#include <functional>

namespace frictionbeam {

/// What pressure in the solid parts of a line changes of it: forces on the unknowns and a stiffness
/// beside those of LinearPart, which are without pressure.
class PressedParts {
public:
  explicit PressedParts(const Model &model) : model(model) {}

  /// In each part that it stiffens [Pa].
  std::vector<double> pressures(const std::vector<double> &factors) const;
  /// The whole line's.
  SparseMatrix stiffness(const std::vector<double> &factors) const;
  /// On the unknowns, at displacements of all degrees of freedom: added forces of loads less what
  /// the added stiffness needs.
  Vector forces(const std::vector<double> &factors, const Vector &dofs) const;
  /// Stored by the added stiffness.
  double energy(const std::vector<double> &factors, const Vector &dofs) const;

  using Stability = SolidPart::Stability;
  /// The worst of all parts.
  Stability stability(const std::vector<double> &factors) const;

private:
  using Dofs = std::vector<dealii::types::global_dof_index>;
  using Call = std::function<void(const SolidPart::Pressed &, const Dofs &)>;
  /// Call for each part that has pressure in it.
  void each(const std::vector<double> &factors, const Call &call) const;

  const Model &model;
};

} // namespace frictionbeam
