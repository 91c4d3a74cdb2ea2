// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/load_course.h"
#include <frictionbeam/contact/line_factorization.h>

#include <limits>

namespace frictionbeam {

/// Part of a friction force at its limit up to which statics knows that it is there.
constexpr double limit_of_statics = 1e-8;

/// What a contact does at present.
struct EventState {
  ContactStatus status = ContactStatus::open;
  Eigen::Vector2d plastic = Eigen::Vector2d::Zero();   ///< slip p, of elastic shear [m]
  Eigen::Vector2d direction = Eigen::Vector2d::Zero(); ///< of slip, unit
  bool curved = false; ///< slip changes its direction: TaylorMotion expands that as well
  /// At rest since a static step, with friction at its limit to the accuracy of statics.
  bool at_limit = false;
  double offset = 0.; ///< by which a rigid contact that is closed misses its gap, as is [m]
  double given = 0.;  ///< the same at the beginning of a step, of which those before are judged [m]
  double began = -1.; ///< when slip on a rigid surface began from rest [s]

  bool is_closed() const { return status != ContactStatus::open; }
  void transfer(Archive &archive) {
    archive(status, plastic, direction, curved, at_limit, offset, given, began);
  }
};

/// A contact for the event integrator: displacements g = G q + e(t) of the pipe's node relative to
/// the ground, along the normal (positive: apart) and in the two directions of the sliding plane;
/// forces r on them, so that -G^T r acts on the line.
struct EventContact {
  enum class Normal { platen, elastic, rigid };

  const Contact *contact = nullptr;
  FrictionThreshold law{};
  Normal normal = Normal::rigid;
  bool has_friction = false, rigid_shear = false;
  double share = 1.;            ///< forces per stress
  double normal_stiffness = 0.; ///< [N/m]
  double shear_stiffness = 0.;  ///< [N/m]
  std::vector<int> unknowns;    ///< with mass, that it depends on
  Eigen::Matrix3Xd G;           ///< on these
  std::array<bool, 3> moves{};  ///< whether that row is not zero
  int platen_unknown = -1;      ///< and its part in g_n
  double platen_weight = 0.;

  Eigen::Vector3d displacement(const Vector &unknowns) const;
  /// Whether it holds its sliding plane's motion, rigidly.
  bool sticks(const EventState &state) const {
    return has_friction && rigid_shear && state.status == ContactStatus::stick;
  }
};

/**
 * The line for the event integrator. Unknowns without mass that no contact touches are condensed,
 * exactly; platens press with a constant force and follow the pipe.
 * @throws UserError for what it cannot treat.
 */
class EventModel {
public:
  explicit EventModel(const Model &model);

  const Model &model;
  std::vector<EventContact> contacts;
  std::vector<bool> has_mass;
  bool damped = false, ground_moves = false;

  /// forces - K q - C v on the unknowns with mass, the others in balance; @p unknowns are completed
  /// by those without mass.
  Vector forces_left(const Vector &forces, Vector &unknowns, const Vector &velocity) const;
  /// M^-1 f, zero where there is no mass.
  Vector accelerate(Vector forces) const;
  /// -G^T r added to forces.
  void add_contact_force(const unsigned int i, const Eigen::Vector3d &r, Vector &forces) const;
  /// e(t) of all contacts, three each, from the motions imposed on degrees of freedom.
  Vector ground_displacement(const Vector &imposed) const;

private:
  void make_contact(const unsigned int i);
  /// The unknowns that a contact's displacements depend on, and how.
  void take_unknowns(EventContact &result) const;
  /// Unknowns without mass follow the others without delay.
  void condense_massless();

  contact::LineFactorization mass, inner;
  std::vector<int> massless; ///< condensed
  SparseMatrix coupling, damping;
};

} // namespace frictionbeam
