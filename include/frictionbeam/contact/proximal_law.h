// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/site.h>

#include <optional>

namespace frictionbeam::contact {

/// The irreversible part of a contact's strains, which its law keeps.
struct Slip {
  double y = 0., z = 0., twist = 0.;
  bool slips = false; ///< whether it does so at present

  /// Among the law's internal variables.
  static Slip read(const FrictionThreshold &law, const double *internal) {
    return {internal[law.slip_y], internal[law.slip_z], internal[law.twist],
            internal[law.was_slipping] != 0.};
  }
  void write(const FrictionThreshold &law, double *internal) const {
    internal[law.slip_y] = y;
    internal[law.slip_z] = z;
    internal[law.twist] = twist;
    internal[law.was_slipping] = slips ? 1. : 0.;
  }
};

/// Where a contact is asked for its force, per friction element of a line or square metre of a
/// body.
struct ProximalPoint {
  Strains strain;               ///< times the length: how far the ground is from the pipe [m, rad]
  double length;                ///< of the friction element [m]
  double friction, gap;         ///< coefficient in force [-]; [m]
  double normal_rho, shear_rho; ///< numerical stiffness along the normal and across [N/m]
  Strains centre;               ///< (-P_c, T_c, of no meaning) [N]
  std::optional<double> pressure = {}; ///< P is this, whatever the strain [N]
  /// `open`, `stick` or `slip`, whatever P and |T| say: the branch that an active set has chosen.
  /// What slides against the friction at the centre keeps this friction's direction.
  std::optional<ContactStatus> branch = {};
  double patch_scale = 1.; ///< on the law's patch radius
};

/// Of the friction element and of its numerical stiffness, which many answers have in common.
struct ProximalStiffness {
  ProximalStiffness() = default;
  ProximalStiffness(const FrictionThreshold &law, const double length, const double normal_rho,
                    const double shear_rho);

  double flexibility[3]; ///< of the element alone, along the normal and across; 0 if rigid [m/N]
  double kappa[3];       ///< of both in series [N/m]
};

/// What it answers.
struct ProximalAnswer {
  Strains stress = Strains::Zero(); ///< (-P, T_y, T_z, M) [N, N m]
  /// The stress less the centre, and not as a difference: rho times a gap or a slip that is told
  /// from zero may be lost beside the forces. Torsion has none.
  Strains misfit = Strains::Zero();
  Eigen::Matrix<double, n_strains, n_strains, Eigen::RowMajor> tangent =
      Eigen::Matrix<double, n_strains, n_strains>::Zero(); ///< d stress / d strain
  Slip slip;
  ContactStatus status = ContactStatus::none;
  double dissipated = 0.; ///< per unit length of the element [J/m]
};

/**
 * Unilateral contact with Coulomb friction, rigid or on an elastic element, in proximal form: the
 * law of every exact contact, of lines and of bodies.
 *
 * With compression P, friction force T, gap g (of the rigid part) and slip p of the increment, the
 * laws P = max(0, P - rho g) and T = proj_{fP}(T + rho p), (1) in doc/theory.md, "Exact contact",
 * hold for any rho > 0. With a centre (P_c, T_c) the proximal contact replaces g by
 * g + (P - P_c)/rho and p by p - (T - T_c)/rho:
 *   P = max(0, kappa_n (P_c/rho_n - g_total)),   T = proj_{fP}(kappa_t (s - p_old + T_c/rho_t)),
 * (2) 1/kappa = 1/rho + 1/k, k the element's own stiffness (infinite if rigid), which is the
 * friction element of 1983 with an initial force; its fixed point (P, T) = (P_c, T_c) is the exact
 * contact, whatever rho is. proj is to the point of the disc nearest in the norm of 1/kappa
 * (DiscProjection). tests/contact/proximal_law.cc has an example of each branch.
 *
 * @param old slip at the start of the increment
 */
ProximalAnswer proximal_law(const FrictionThreshold &law, const ProximalPoint &point,
                            const Slip &old);
/// The same; @p stiffness is that of the law, the length and the two rho.
ProximalAnswer proximal_law(const FrictionThreshold &law, const ProximalPoint &point,
                            const ProximalStiffness &stiffness, const Slip &old);

} // namespace frictionbeam::contact
