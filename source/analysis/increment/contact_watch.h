// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"
#include "model/line_state.h"
#include "model/model.h"

namespace frictionbeam {

/// Whether a contact is rigid along its normal and what it touches has mass, so that an impact on
/// it is an impulse. (A point without mass is stopped by no impulse: the line behind it is a
/// spring.)
bool is_rigid_stop(const Model &model, const Contact &contact);

/// What says which contacts close in the increments to come.
struct ContactsBefore {
  std::vector<ContactStatus> status;
  std::vector<double> since;   ///< open ones only touch since then [s]; minus infinity: were apart
  std::vector<int> other_half; ///< of a rigid stop or guide, -1 if there is none

  /// At the end of an increment, or at the beginning of the first one.
  void take(const Model &model, const LineState &state);
  void transfer(Archive &archive) { archive(status, since, other_half); }
};

/// Contacts that closed in an increment with these events; not those that were open for no time, as
/// one is that lets go and touches again by rounding, nor halves of a stop without gap, whose other
/// half has held until then.
std::vector<unsigned int> closed_in(const ContactsBefore &contacts,
                                    const std::vector<ContactEvent> &events);

/// Note in the report of a transient step how near contacts came to a change of state in a time
/// step, and which rigid ones were struck.
void watch_contacts(const Model &model, const ContactsBefore &before, const LineState &after,
                    StepReport &report);

} // namespace frictionbeam
