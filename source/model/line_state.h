// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "model/contact/contacts.h"

#include <string>
#include <vector>

namespace frictionbeam {

/// A contact changes its state.
struct ContactEvent {
  double time = 0.;
  unsigned int contact = 0;
  ContactStatus status = ContactStatus::none; ///< from then on
};

/// The line at one instant: everything needed to go on from there and to report it.
struct LineState {
  Vector unknowns;               ///< free unknowns q
  Vector dofs;                   ///< all degrees of freedom u = C q + imposed motions
  Vector velocity, acceleration; ///< of the unknowns; zero or empty in statics
  Vector turns;                  ///< of the line's vertices (Pose); empty in linear kinematics
  Vector sections;               ///< states of sections that yield or creep (PipeSections)
  ContactState contacts;         ///< committed
  std::vector<Contact::Strains> contact_stress;
  std::vector<ContactStatus> contact_status;
  std::vector<double> load_factors; ///< beside Scene::loads
  /// First and second derivatives in time of the factors; empty in statics, and where no load moves
  /// what has mass.
  std::vector<double> load_rates, load_accelerations;
  double time = 0.;
  Vector auxiliary;                 ///< of the time integrator
  std::vector<ContactEvent> events; ///< of the last increment
};

void transfer(Archive &archive, ContactState &state);
void transfer(Archive &archive, LineState &state);

} // namespace frictionbeam
