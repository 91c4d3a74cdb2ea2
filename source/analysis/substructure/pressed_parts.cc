// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/pressed_parts.h"

namespace frictionbeam {

namespace {

Vector at(const std::vector<dealii::types::global_dof_index> &dofs, const Vector &all) {
  Vector result(dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i)
    result[i] = all[dofs[i]];
  return result;
}

} // namespace

void PressedParts::each(const std::vector<double> &factors, const Call &call) const {
  for (const SolidPart &part : model.linear.parts())
    if (const double p = part.pressure(factors); p != 0.) {
      Dofs dofs;
      for (const unsigned int vertex : part.vertices)
        for (unsigned int c = 0; c < 6; ++c)
          dofs.push_back(model.discretization.vertex_dofs().index(vertex, c));
      call(part.pressed(p), dofs);
    }
}

std::vector<double> PressedParts::pressures(const std::vector<double> &factors) const {
  std::vector<double> result;
  for (const SolidPart &part : model.linear.parts())
    result.push_back(part.pressure(factors));
  return result;
}

SparseMatrix PressedParts::stiffness(const std::vector<double> &factors) const {
  MatrixEntries added(MatrixEntries::Zeros::left_out);
  each(factors, [&](const SolidPart::Pressed &pressed, const Dofs &dofs) {
    model.space.add_local(pressed.stiffness, dofs, added);
  });
  return model.linear.stiffness() + added.matrix(model.space.n_unknowns());
}

Vector PressedParts::forces(const std::vector<double> &factors, const Vector &dofs) const {
  Vector on_dofs = Vector::Zero(model.space.n_dofs());
  each(factors, [&](const SolidPart::Pressed &pressed, const Dofs &of_part) {
    const Vector added = pressed.by_itself - pressed.stiffness * at(of_part, dofs) +
                         pressed.forces * Eigen::Map<const Vector>(factors.data(), factors.size());
    for (std::size_t i = 0; i < of_part.size(); ++i)
      on_dofs[of_part[i]] += added[i];
  });
  return model.space.restrict_forces(on_dofs);
}

double PressedParts::energy(const std::vector<double> &factors, const Vector &dofs) const {
  double sum = 0.;
  each(factors, [&](const SolidPart::Pressed &pressed, const Dofs &of_part) {
    const Vector q = at(of_part, dofs);
    sum += 0.5 * q.dot(pressed.stiffness * q);
  });
  return sum;
}

PressedParts::Stability PressedParts::stability(const std::vector<double> &factors) const {
  Stability worst = Stability::known;
  each(factors, [&](const SolidPart::Pressed &pressed, const Dofs &) {
    if (worst != Stability::buckled && pressed.stability != Stability::known)
      worst = pressed.stability;
  });
  return worst;
}

} // namespace frictionbeam
