// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/condensed_line.h"
#include "analysis/statics/linear_statics.h"

#include <map>

namespace frictionbeam::study {

/**
 * Statics of a study's runs on one line, which are condensed to its contacts. Increments begin from
 * the motions and forces that the case, as it stands in its file, has in them, so that a start
 * depends on no other run, and from those of the run itself where that comes to nothing.
 *
 * Where that comes to nothing, too, where a contact may jam, and where nothing determines which
 * contact carries what, the run is to be made alone, as by a program that knows of no study: from
 * elsewhere contacts might come to rest elsewhere.
 */
class CaseStarts final : public LinearStatics {
public:
  explicit CaseStarts(const Model &model);

  /// Begin a run, after the contacts' laws have got its numbers. @return false: it may jam
  bool begin();
  /// Begin the case, whose increments are remembered until another run begins.
  void begin_case();
  /// Begin a run with all unknowns, from nothing but its own states.
  void begin_alone();
  bool is_alone() const { return alone; }

  /// If the run is not alone, states know the unknowns of contacts only, until they are complete.
  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response) override;
  /// @return whether the forces on the whole line balance
  bool complete(LineState &state) const { return alone || line.complete(state); }
  /// Without the case's increments.
  void transfer(Archive &archive) override;

private:
  using Times = std::pair<double, double>; ///< begin and end of an increment

  CondensedLine line;
  Archive unused; ///< memory before anything is solved
  bool alone = false, is_case = false;
  std::map<Times, contact::NearbySolution> of_case;
};

} // namespace frictionbeam::study
