// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"

namespace frictionbeam {

/**
 * How finely a step of the sequence followed the motion in time and, with large displacements,
 * along the line: what its increments leave behind for an estimate of their error.
 */
struct Resolution {
  /// Sum over the time steps h of h^2/12 |a_1 - a_0|, the leading error of the trapezoidal rule in
  /// the displacements, as the largest of all translations [m].
  double local_errors = 0.;
  /// Of all translations, and of what bends within cells with large displacements [m].
  double largest_displacement = 0.;
  double accelerations = 0., acceleration_changes = 0.; ///< sums of |a|, |a_1 - a_0| [m/s2]
  unsigned int state_changes = 0; ///< time steps in which a contact changed its state
  /// Of the contact where it is largest, the sum over the time steps of this step of half its path
  /// times the sine by which its friction force turns: an error of first order [m].
  double turned_in_motion = 0.;
  bool starts_to_move = false; ///< in a time step before which nothing accelerates: not in the sums
  bool forces_lag = false;     ///< a support's force depends on the mean rate of the time step
  bool exact_in_time = true;   ///< no time step has an error of its own (event)
  bool handed_over = false;    ///< parts of the motion, by event to an integrator that has one
  /// Large displacements: by how much cells, whose length is that of their chords, are longer than
  /// the curves that they stand for: the sum of l (2 a^2 - a b + 2 b^2)/30, a and b the angles
  /// between the chord and the line at its ends [m].
  double unbent = 0.;
  /// Static increments: of the contact where it is largest, the sum over the increments so far of
  /// 1/2 |dT x dslip| / |T|, by how much its path may be off where friction turns [m].
  double slip_turned = 0.;
  /// Likewise the longest slip of an increment at whose start there was no friction force [m].
  double slip_from_rest = 0.;
  bool slip_is_known = true; ///< all laws have a closed form
  /// Static increments: a contact closed within one and has friction, which counts the way along
  /// the ground from the increment's beginning.
  bool touched_within = false;
  /// Static increments: contacts closed a gap, opened, began or ceased to slip within one, and
  /// forces over time have a corner there.
  bool turned_within = false;
  /// Static increments: contacts closed a gap, opened, turned back or let go within one, while
  /// others have friction, whose slip may have turned unseen.
  bool turned_unseen = false;
  /// Static increments: of contacts that have slipped in no more than one increment of this step,
  /// on a way that may bend, the longest slip [m]. More increments, each with all of it in its
  /// last, say nothing of that way.
  double slip_in_one = 0.;
  unsigned int flow_increments = 0; ///< static increments of this step in which pipes have flowed
  /// Static increments: a contact began or ceased to slip within one while what it can hold
  /// changed, so that the work of friction depends on when.
  bool limit_changed_within = false;
  /// Static increments: a History, or motion of the ground, goes no straight way within one.
  bool loads_bend_within = false;

  void include(const Resolution &other);
  void transfer(Archive &archive) {
    archive(local_errors, largest_displacement, accelerations, acceleration_changes, state_changes,
            exact_in_time, handed_over, unbent, slip_turned, slip_from_rest, slip_is_known,
            touched_within, turned_in_motion, turned_within, turned_unseen, starts_to_move,
            loads_bend_within, slip_in_one, flow_increments, limit_changed_within, forces_lag);
  }
};

} // namespace frictionbeam
