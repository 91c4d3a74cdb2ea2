// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/condensed_line.h"
#include "analysis/statics/linear_statics.h"

namespace frictionbeam::study {

/**
 * Statics of a study's runs on one line, which are condensed to its contacts. Each run begins from
 * nothing but its own states, as a program that knows of no study does: from elsewhere contacts
 * might come to rest elsewhere.
 *
 * Where that comes to nothing, where a contact may jam, and where nothing determines which contact
 * carries what, the run is to be made alone, with all unknowns.
 */
class CondensedRuns final : public LinearStatics {
public:
  explicit CondensedRuns(const Model &model);

  /// Begin a run, after the contacts' laws have got its numbers. @return false: it may jam
  bool begin();
  /// Begin a run with all unknowns.
  void begin_alone();
  bool is_alone() const { return alone; }

  /// If the run is not alone, states know the unknowns of contacts only, until they are complete.
  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response) override;
  /// @return whether the forces on the whole line balance
  bool complete(LineState &state) const { return alone || line.complete(state); }
  void transfer(Archive &archive) override;

private:
  CondensedLine line;
  Archive unused; ///< memory before anything is solved
  bool alone = false;
};

} // namespace frictionbeam::study
