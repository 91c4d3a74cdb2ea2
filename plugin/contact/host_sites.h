// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/solver.h>

namespace frictionbeam::contact {

/// A host's contacts as sites on its unknowns, one of length 1 m each.
struct HostSites {
  /// @throws std::invalid_argument that names the contact, what was read, what is allowed
  HostSites(const System &system, const std::vector<Contact> &contacts);

  std::vector<Site> sites;
  std::vector<Strains> given;          ///< strains of gaps and of given values
  std::vector<Eigen::Matrix3d> frames; ///< rows: normal, two tangents

  /// All unknowns that they touch.
  std::vector<int> unknowns() const;
};

} // namespace frictionbeam::contact
