// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"
#include "model/line_state.h"
#include "model/model.h"

namespace frictionbeam {

/**
 * Compares the sections that yield or creep at the ends of the cycles of loads that repeat
 * themselves (Step/Repeat): whether they shake down, yield to and fro, or ratchet (CycleVerdict).
 */
class CycleWatch {
public:
  explicit CycleWatch(const Model &model) : model(model) {}

  /// Where a step begins. The first of a first cycle.
  void step_begins(const LoadStep &step, const LineState &state);
  /// Where a step ends. @return of the last step of a cycle
  std::optional<CycleVerdict> step_ends(const LoadStep &step, const LineState &state);

  void transfer(Archive &archive) { archive(before, growth_before, has_lost); }

private:
  const Model &model;
  Vector before;             ///< states of sections at the end of the cycle before
  double growth_before = 0.; ///< in that cycle
  bool has_lost = false;     ///< whether a cycle so far has dissipated anything
};

} // namespace frictionbeam
