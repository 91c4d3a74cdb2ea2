// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/sequence/load_sequence.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Writes the friction-contact problem of every static increment, with its solution, into the folder
 * `contact_problems`, for other programs to solve: STEP_NAME_INCREMENT.hdf5 condensed to its
 * contacts, STEP_NAME_INCREMENT_global.hdf5 with the line's own unknowns. What cannot be written is
 * said in a remark.
 */
class ContactProblemWriter {
public:
  /// Makes the folder; problems of an earlier run in it are removed, unless @p keep is set.
  ContactProblemWriter(const Model &model, Results &results, const bool keep = false);

  void transfer(Archive &archive) { archive(before); }

  /// @param state after an increment of the step in @p progress, or at the start
  void observe(const Progress &progress, const LineState &state);

private:
  void write(const Progress &progress, const LineState &after);
  void remark(const std::string &text);

  const Model &model;
  Results &results;
  const std::string folder;
  LineState before;
};

} // namespace frictionbeam
