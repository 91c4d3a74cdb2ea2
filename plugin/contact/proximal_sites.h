// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/exact_solver.h>
#include <frictionbeam/contact/proximal_law.h>

namespace frictionbeam::contact {

/**
 * The sites in an increment: exact ones in the proximal form of proximal_law() with a
 * centre each, so that rho, the element's numerical stiffness, is a parameter of the method and not
 * of the model; others by their laws as they are.
 *
 * rho = c k_d, k_d the diagonal of the matrix without contacts at the site.
 */
class ProximalSites {
public:
  /// @param diagonal of the matrix without contacts, on all unknowns; 0 where it is not known
  ProximalSites(const SiteList &contacts, const Vector &diagonal);

  /// Begin an increment: friction coefficients by what slipped before.
  void begin(const State &committed, const Overrides *const overrides = nullptr);
  /// Contacts that began to slip obey their dynamic coefficient. @return whether any changed.
  bool let_slipping_go(const Response &response);

  /// Until take_all() or the next increment, contact @p i does not touch.
  void leave_out(const unsigned int i) { is_left_out[i] = true; }
  void take_all() { is_left_out.assign(scales.size(), false); }

  double stiffness_factor = 1e-3; ///< c
  /// Of exact contacts, what an active set has chosen; empty: what forces and motions say.
  std::vector<ContactStatus> branch;
  std::vector<Strains> centre; ///< stresses (P_c, T_c), as -N, T
  /// Of exact contacts at the last evaluation: the stresses less the centre (ProximalAnswer).
  std::vector<Strains> misfit;

  /// Whether a motion drags a contact along, and does not merely open contacts.
  bool is_slide(const Vector &motion) const;

  /// Centre, coefficients and gaps at present.
  void save(WarmStart &memory) const;
  void restore(const WarmStart &memory);

  /// Evaluate all contacts at response.state.strain: the proximal form of laws that have a
  /// threshold, any other law as it is.
  void evaluate(const State &committed, const Increment &increment, const LawTangent tangent,
                Response &response);

  /// Derivative of the proximal stresses by the centre: the tangent times this diagonal.
  Strains by_centre(const unsigned int i) const { return scales[i].by_centre / stiffness_factor; }

  /// Force, gap and slip of exact contact @p i at a stress and a strain.
  Check::Point point_of(const unsigned int i, const Strains &stress, const Strains &strain,
                        const State &committed, const double rounding) const;
  /**
   * Judge forces and displacements by the exact laws, without the proximal term.
   * @param rounding error of displacements [m]
   */
  Check check(const Response &response, const State &committed, const double rounding) const;

  /// Whether contact @p i, moved at the strain rate @p rate, resists as much as it ever can: it
  /// opens, or its friction at the threshold opposes the motion, or it does not move.
  bool gives_utmost(const unsigned int i, const Response &response, const Strains &rate) const;

  /// Whether contact @p i is of the kind that the exact laws cover.
  bool is_exact(const unsigned int i) const { return contacts[i].law.has_closed_form(); }
  /// In force in this increment.
  double friction_coefficient(const unsigned int i) const { return friction[i]; }
  double gap_of(const unsigned int i) const { return gap[i]; } ///< in this increment [m]
  const std::vector<double> &friction_coefficients() const { return friction; }
  void set_friction_coefficients(const std::vector<double> &values) { friction = values; }
  /// k_d of the contact, along its normal and across [N/m].
  Eigen::Vector2d diagonal_stiffness(const unsigned int i) const {
    const double share = contacts[i].share();
    return {scales[i].normal_diagonal * share, scales[i].shear_diagonal * share};
  }

private:
  struct Scale {
    double normal_diagonal = 0., shear_diagonal = 0.; ///< k_d over the share [N/m]
    Strains by_centre = Strains::Zero();              ///< with c = 1; 0 where it is not exact
  };

  /// For the present c.
  void find_stiffness();
  void evaluate_exact(const unsigned int i, const State &committed, Response &response);

  const SiteList &contacts;
  std::vector<Scale> scales;
  std::vector<ProximalStiffness> stiffness; ///< of exact contacts, for the c that follows
  double factor_of_stiffness = 0.;
  std::vector<double> friction;                         ///< coefficient in force in this increment
  std::vector<double> friction_scale, patch_scale, gap; ///< of this increment
  std::vector<bool> is_left_out;
};

} // namespace frictionbeam::contact
