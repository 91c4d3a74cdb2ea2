// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Follows sections that yield or creep through all increments of a run, those of cut ones too: at
 * the points that Output/Sections names, or all of them, of which the two are shown in the end that
 * have flowed most. Where that becomes too much to keep, every second increment is forgotten, again
 * and again.
 */
class SectionWatch {
public:
  /// @throws UserError where a point of Output/Sections has no such section
  explicit SectionWatch(const Model &model);

  /// To be called with the start and with every increment solved.
  void observe(const LineState &state);
  /// The histories to show; none of sections that neither yielded nor crept, unless they were asked
  /// for. @param last the state at the end of the run
  std::vector<SectionHistory> histories(const LineState &last);

  void transfer(Archive &archive) { archive(time, states, n_seen, every); }

private:
  struct Followed {
    unsigned int cell = 0, place = 0; ///< among sections_of_cell()
    unsigned int vertex = 0;          ///< of the mesh, or Station::between_nodes
  };

  void follow(const unsigned int cell, const unsigned int vertex);
  void keep(const LineState &state);
  void forget_every_second();
  double flowed(const unsigned int section) const { return most[section]; }
  /// Of several at a point the one that has flowed most.
  unsigned int most_flowed_at(const unsigned int vertex) const;
  /// The one that has flowed most, and the next one elsewhere.
  std::vector<unsigned int> most_flowed() const;
  std::string name_of(const unsigned int section) const;
  SectionHistory history_of(const unsigned int section, const std::string &name) const;

  const Model &model;
  std::vector<Followed> followed;   ///< in the order of the cells
  std::vector<double> time;         ///< of the instants kept
  std::vector<SectionState> states; ///< all of `followed` at the first instant, the second, ...
  unsigned int n_seen = 0, every = 1;
  std::vector<double> most; ///< inelastic strain of each of `followed`, at any instant kept
};

} // namespace frictionbeam
