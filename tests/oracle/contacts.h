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

  // State at the end of an increment.
  Vec3 motion = Vec3::Zero();  ///< of the pipe relative to the ground
  Vec3 force = Vec3::Zero();   ///< on the pipe; first >= 0
  Vec3 plastic = Vec3::Zero(); ///< slip so far, components 1 and 2
  Vec3 touch = Vec3::Zero();   ///< motion where contact began
  enum class Status { open, stick, slip, closed } status = Status::open;
  bool sure = true; ///< its status is far enough from the next one
};

std::vector<Contact> contacts_of(const Scene &scene, const Frame &frame);

/// Find the forces of an increment: u = free + W f obeys all contact laws. @return whether the
/// sweeps have converged, to 1e-14 of the largest force.
bool solve_contacts(const Matrix &W, const Vector &free, std::vector<Contact> &contacts);

} // namespace oracle
