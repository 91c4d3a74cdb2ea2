// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "scene/body.h"
#include <frictionbeam/bound_law.h>
#include <frictionbeam/contact/check.h>

#include <Eigen/Core>

#include <vector>

namespace frictionbeam {

class LawLibrary;

/// Components along outward normal, t1, t2.
using LocalVector = Eigen::Vector3d;
using LocalMatrix = Eigen::Matrix3d;

/// A place where a body rests on its foundation: a law on one square metre, and an area.
struct FoundationPoint {
  unsigned int surface = 0;
  double weight = 0.;          ///< [m2]
  double normal_diagonal = 0.; ///< diagonal of the body's stiffness over the area [Pa/m]
  double shear_diagonal = 0.;
};

/// State of all points of this process, committed or trial.
struct FoundationState {
  std::vector<double> internal;    ///< of the laws, point by point
  std::vector<LocalVector> stress; ///< traction on the body [Pa]
  std::vector<LocalVector> touch;  ///< displacement at which the contact began
  std::vector<ContactStatus> status;
  std::vector<double> dissipated; ///< [J/m2]

  void transfer(Archive &archive) { archive(internal, stress, touch, status, dissipated); }
};

struct FoundationResponse {
  FoundationState state;
  std::vector<LocalMatrix> tangent; ///< d stress / d displacement
  std::vector<LocalVector>
      misfit; ///< of exact contacts: stress less centre (contact::ProximalAnswer)
  bool failed = false;
};

/**
 * Friction on the foundation, point by point: the law that a support has, of a friction element
 * from the body to the ground for each square metre. A law with a threshold in closed form is exact
 * contact in the proximal form of contact::proximal_law(). Any other law, and all of them with the
 * method `newton`, is integrated as it is: return mapping with the consistent tangent. On a surface
 * with a prescribed pressure the compression is that pressure; a law that is integrated is then
 * solved for the normal strain that gives it.
 */
class FoundationContacts {
public:
  FoundationContacts(const ContinuumScene &scene, const LawLibrary &laws, const bool exact,
                     const std::vector<FoundationPoint> &points);

  FoundationState initial_state() const;

  /// Begin an increment: friction coefficients by what slipped before.
  void begin(const FoundationState &committed);
  /// Contacts that began to slip obey their dynamic coefficient. @return whether any changed.
  bool let_slipping_go(const FoundationState &state);

  double stiffness_factor = 1.;    ///< rho over the diagonal stiffness
  std::vector<LocalVector> centre; ///< tractions (-P_c, T_c)

  /// What an increment takes over from the one before; the rest is set by begin().
  void transfer(Archive &archive) { archive(stiffness_factor, centre); }

  /// Evaluate all points at @p displacement.
  void evaluate(const std::vector<LocalVector> &displacement, const FoundationState &committed,
                const LawIncrement &increment, FoundationResponse &response) const;

  /// Derivative of the stress by the centre: minus the tangent times this diagonal.
  LocalVector by_centre(const unsigned int i) const;

  /// Judge tractions and displacements by the exact laws. @p largest traction of all.
  contact::Check check(const std::vector<LocalVector> &displacement, const FoundationState &state,
                       const FoundationState &committed, const double largest,
                       const double rounding) const;

  unsigned int size() const { return points.size(); }
  const FoundationPoint &operator[](const unsigned int i) const { return points[i]; }
  bool is_exact(const unsigned int i) const { return surfaces[points[i].surface].exact; }
  /// Whether that is so anywhere.
  bool are_exact() const;
  /// As gives_utmost() of a line, of a motion in the point's own axes. @p largest motion of
  /// all points, beside which one without motion is told.
  bool gives_utmost(const unsigned int i, const FoundationState &state, const LocalVector &rate,
                    const double largest) const;
  /// Coefficients of the cones that the points' forces never leave; nothing where a pressure is
  /// prescribed, or no cone known.
  std::vector<std::optional<double>> most_friction() const;
  /// In force in this increment.
  const std::vector<double> &friction_coefficients() const { return friction; }
  void set_friction_coefficients(const std::vector<double> &values) { friction = values; }
  bool has_pressure(const unsigned int i) const {
    return surfaces[points[i].surface].pressure.has_value();
  }
  /// How an exact contact without pressure is at rest.
  struct Rest {
    LocalVector at_zero;    ///< gap, and slip so far, of a body without displacement [m]
    LocalVector compliance; ///< [m/Pa]
  };
  Rest rest(const unsigned int i, const FoundationState &committed) const;
  /// Gap of the rigid part and elastic-free slip in the sliding plane since contact began.
  double gap(const unsigned int i, const LocalVector &displacement) const;
  LocalVector slip(const unsigned int i, const LocalVector &displacement,
                   const FoundationState &state) const;

private:
  struct Surface {
    BoundLaw law;
    std::optional<double> pressure;
    bool exact;
  };

  void evaluate_exact(const unsigned int i, const LocalVector &u, const FoundationState &committed,
                      FoundationResponse &response) const;
  bool evaluate_law(const unsigned int i, const LocalVector &u, const FoundationState &committed,
                    const LawIncrement &increment, FoundationResponse &response) const;

  std::vector<FoundationPoint> points;
  std::vector<Surface> surfaces;
  std::vector<unsigned int> offset; ///< of a point's internal variables
  std::vector<double> friction;     ///< coefficient in force in this increment
  unsigned int n_internal = 0;
};

} // namespace frictionbeam
