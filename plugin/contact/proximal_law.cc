// SPDX-License-Identifier: LGPL-2.1-or-later
#include "proximal_answer.h"

namespace frictionbeam::contact {

ProximalStiffness::ProximalStiffness(const FrictionThreshold &law, const double length,
                                     const double normal_rho, const double shear_rho) {
  const double rigidity[3] = {law.axial_rigidity, law.shear_rigidity_y, law.shear_rigidity_z},
               rho[3] = {normal_rho, shear_rho, shear_rho};
  for (int d = 0; d < 3; ++d) {
    flexibility[d] = length / rigidity[d];
    kappa[d] = 1. / (flexibility[d] + 1. / rho[d]);
  }
}

ProximalAnswer proximal_law(const FrictionThreshold &law, const ProximalPoint &point,
                            const Slip &old) {
  return proximal_law(law, point, {law, point.length, point.normal_rho, point.shear_rho}, old);
}

ProximalAnswer proximal_law(const FrictionThreshold &law, const ProximalPoint &point,
                            const ProximalStiffness &stiffness, const Slip &old) {
  return answer_of(law, point, stiffness, old);
}

} // namespace frictionbeam::contact
