// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "model/contact/contacts.h"

namespace frictionbeam {

/// What of the contacts differs from their laws in an increment: on velocities instead of
/// displacements in nonsmooth time steps.
struct ContactOverrides {
  std::vector<double> gap;            ///< [m]; far for contacts that do not take part
  std::vector<double> friction_scale; ///< on the coefficient
};

/// How far the contacts are from Signorini's condition and Coulomb's law, each on its own scale.
struct ContactCheck {
  /// Largest natural-map residual |r - P(r - rho u)| / max(|r|, rho |u|, 1e-12 of the largest
  /// force), beyond what rounding of the displacements makes of it.
  double natural_map = 0.;
  double penetration = 0.;    ///< largest, rigid part [m]
  double cone_violation = 0.; ///< largest (|T| - f N) / max(N, 1e-12 of the largest force)
  /// Largest angle between slip and friction force, where slip is above rounding and both, rho
  /// |slip| and |T|, are above 1e-4 of the contact's scale [rad].
  double slip_angle = 0.;
  double least_dissipation = 0.; ///< of one contact in the increment, at most 0 [J]

  /// Whether the contact laws hold: natural map and cone to the tolerance, slip within a
  /// milliradian of the friction force, and so no dissipation below zero.
  bool holds(const double tolerance) const {
    return natural_map <= tolerance && cone_violation <= tolerance && slip_angle <= 1e-3;
  }
  /// The worst of both.
  void include(const ContactCheck &other);

  /// One contact with compression P, friction force T, gap of the rigid part, slip of the
  /// increment.
  struct Point {
    double P, T[2]; ///< [N]
    double gap, slip[2];
    double friction;                  ///< coefficient
    double normal_scale, shear_scale; ///< rho_N, rho_T [N/m]
    double rounding;                  ///< of gap and slip
  };
  /// @param largest force of all contacts
  void judge(const Point &point, const double largest);
};

/**
 * The contacts of a line in an increment: exact ones in the proximal form of proximal_law() with a
 * centre each, so that rho, the element's numerical stiffness, is a parameter of the method and not
 * of the model; others by their laws as they are.
 *
 * rho = c k_d, k_d the diagonal of the line's own stiffness at the contact.
 */
class ProximalContacts {
public:
  /// @param stiffness of the line, without contacts.
  ProximalContacts(const Contacts &contacts, const SparseMatrix &stiffness);

  /// Begin an increment: friction coefficients by what slipped before.
  void begin(const ContactState &committed, const ContactOverrides *const overrides = nullptr);
  /// Contacts that began to slip obey their dynamic coefficient. @return whether any changed.
  bool let_slipping_go(const ContactResponse &response);

  /// Until take_all() or the next increment, contact @p i does not touch.
  void leave_out(const unsigned int i) { is_left_out[i] = true; }
  void take_all() { is_left_out.assign(scales.size(), false); }

  double stiffness_factor = 1e-3;       ///< c
  std::vector<Contact::Strains> centre; ///< stresses (P_c, T_c), as -N, T
  /// Of exact contacts at the last evaluation: the stresses less the centre (ProximalAnswer).
  std::vector<Contact::Strains> misfit;

  /// Centre, coefficients and gaps at present.
  void transfer(Archive &archive) {
    archive(stiffness_factor, centre, friction, friction_scale, gap);
  }

  /// Evaluate all contacts at response.state.strain: the proximal form of laws that have a
  /// threshold, any other law as it is.
  void evaluate(const ContactState &committed, const ContactIncrement &increment,
                const LawTangent tangent, ContactResponse &response);

  /// Derivative of the proximal stresses by the centre: the tangent times this diagonal.
  Contact::Strains by_centre(const unsigned int i) const;

  /**
   * Judge forces and displacements by the exact laws, without the proximal term.
   * @param rounding error of displacements [m]
   */
  ContactCheck check(const ContactResponse &response, const ContactState &committed,
                     const double rounding) const;

  /// Whether contact @p i, moved at the strain rate @p rate, resists as much as it ever can: it
  /// opens, or its friction at the threshold opposes the motion, or it does not move.
  bool gives_utmost(const unsigned int i, const ContactResponse &response,
                    const Contact::Strains &rate) const;

  /// Whether contact @p i is of the kind that the exact laws cover.
  bool is_exact(const unsigned int i) const { return contacts[i].law.has_closed_form(); }
  /// In force in this increment.
  double friction_coefficient(const unsigned int i) const { return friction[i]; }
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
  };

  void evaluate_exact(const unsigned int i, const ContactState &committed,
                      ContactResponse &response);

  const Contacts &contacts;
  std::vector<Scale> scales;
  std::vector<double> friction;            ///< coefficient in force in this increment
  std::vector<double> friction_scale, gap; ///< of this increment
  std::vector<bool> is_left_out;
};

} // namespace frictionbeam
