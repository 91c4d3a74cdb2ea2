// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/mass_factorization.h"

#include "analysis/time/step_helpers.h"
#include "base/user_error.h"

namespace frictionbeam {

void factor_mass(const SparseMatrix &M, LineFactorization &mass) {
  const SparseMatrix regular = regular_mass(M);
  mass.analyze(regular);
  if (!mass.factorize(regular))
    throw UserError("The mass matrix has no inverse.\n  read:    masses and densities that differ "
                    "by so much that the small ones are rounding errors of the large ones, or a "
                    "pipe so flexible in shear that its rotations move no mass\n  allowed: masses "
                    "that are 0 or within some twelve orders of magnitude\n  try:     Density = 0 "
                    "where mass is negligible, Rotary inertia = true, or Time/Integrator = "
                    "moreau_jean, which inverts no mass");
}

} // namespace frictionbeam
