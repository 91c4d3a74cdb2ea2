// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "frame.h"

/**
 * @file
 * Unilateral contact with Coulomb's friction by projected Gauss-Seidel on the dense matrix W of
 * what contact forces do to contact motions, one increment after the other.
 */
namespace oracle {

/// One contact in place. Its three components are along the normal and two tangents.
struct Contact {
  std::string name;
  int support = 0;
  Vec normal, t1, t2;                          ///< normal: from the ground into the pipe
  Eigen::Matrix<Real, 3, Eigen::Dynamic> rows; ///< relative motion by motions of the nodes
  Real gap = 0., friction = 0.;
  Vec3 soft = Vec3::Zero(); ///< flexibility of its own
  Real platen = 0.;         ///< given normal force; 0: it follows from contact
  std::vector<std::array<double, 4>> ground_motion; ///< t, x, y, z

  /// Friction against twist about the normal, a scalar law of its own.
  Eigen::Matrix<Real, 1, Eigen::Dynamic> twist_row;
  Real twist_stiffness = 0.; ///< 0: none
  Real patch_radius = 0.;    ///< the moment is below friction * force * this; 0: any moment

  // State at the end of an increment.
  Vec3 motion = Vec3::Zero();  ///< of the pipe relative to the ground
  Vec3 force = Vec3::Zero();   ///< on the pipe; first >= 0
  Vec3 plastic = Vec3::Zero(); ///< slip so far, components 1 and 2
  Vec3 touch = Vec3::Zero();   ///< motion where contact began
  Real moment = 0., twist = 0., plastic_twist = 0.;
  enum class Status { open, stick, slip, closed } status = Status::open;
  bool sure = true; ///< its status is far enough from the next one
  /// Whether it is known where contact began: not after it touched without a force, when rounding
  /// decides whether it had opened.
  bool sure_of_touch = true;
};

std::vector<Contact> contacts_of(const Scene &scene, const Frame &frame);

/// How far the ground of a contact has moved, in the contact's axes.
Vec3 ground_at(const Contact &contact, double time);

/// Rows of the motions of all contacts, three each, and then of their twists.
Matrix contact_rows(const std::vector<Contact> &contacts, int n);

/**
 * Find the forces of an increment: u = free + W f obeys all contact laws, f three for each contact
 * and then the moments against twist. A contact without a normal force, 1e-14 of the largest of the
 * sequence, resists nothing: whatever moved there has slipped.
 * @param largest_so_far force of the sequence, in contacts or of clamped loads; what is below 1e-4
 * of it is judged as if it were that
 * @return whether the sweeps have converged, to 1e-14 of the largest force.
 */
bool solve_contacts(const Matrix &W, const Vector &free, std::vector<Contact> &contacts,
                    Real &largest_so_far);

} // namespace oracle
