// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/mass_factorization.h"

#include "analysis/time/step_helpers.h"
#include "base/user_error.h"

namespace frictionbeam {

void factor_mass(const SparseMatrix &M, contact::LineFactorization &mass) {
  constexpr double rounding = 1e-14; // of a pivot by its diagonal, in units of which it is judged
  const SparseMatrix regular = regular_mass(M);
  const Vector unit = regular.diagonal().cwiseSqrt().cwiseInverse();
  mass.analyze(regular);
  if (!mass.factorize(unit.asDiagonal() * regular * unit.asDiagonal()) ||
      (unit.size() > 0 && mass.least_pivot() < rounding) || !mass.factorize(regular))
    throw UserError("The mass matrix has no inverse.\n  read:    masses and densities that differ "
                    "by so much that the small ones are rounding errors of the large ones, or a "
                    "pipe so flexible in shear that its rotations move no mass\n  allowed: masses "
                    "that are 0 or within some twelve orders of magnitude\n  try:     Density = 0 "
                    "where mass is negligible, Rotary inertia = true, or Time/Integrator = "
                    "moreau_jean, which inverts no mass");
}

void check_dashpots_have_mass(const Model &model, const std::string &reader) {
  const Vector mass = model.linear.mass().diagonal();
  for (const Spring &spring : model.scene.springs)
    for (const std::string &point : {spring.point, spring.other})
      for (unsigned int c = 0; c < 6 && !point.empty(); ++c) {
        const auto dof = model.discretization.vertex_dofs().index(model.mesh.points.at(point), c);
        bool damps = false;
        for (unsigned int k = 0; k < 6; ++k)
          damps = damps || (spring.damping[k] != 0. && spring.directions[k][c] != 0.);
        if (!damps || dof == dealii::numbers::invalid_dof_index)
          continue;
        for (const auto &term : model.space.terms(dof))
          if (mass[term.unknown] == 0.)
            throw UserError("Spring " + spring.name + " damps point " + point +
                            ", which has no mass.\n  read:    " + reader +
                            ", which lets such points follow without a velocity of their own\n"
                            "  allowed: dashpots between points with mass\n  try:     a small "
                            "Mass at the point, or Time/Integrator = moreau_jean with Modes = all");
      }
}

} // namespace frictionbeam
