// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <set>

namespace frictionbeam {

/**
 * The stations that a model is drawn from: all of a line, or some 2500 of a long one, with the ends
 * of pipes, corners and bends, named points and supports among them.
 */
class ModelStations {
public:
  /// @param first a frame whose line is chosen from, which has to last
  /// @param named vertices, @param held positions of supports
  ModelStations(const Frame &first, const std::set<unsigned int> &named,
                const std::set<std::array<double, 3>> &held);

  std::size_t size() const { return kept.size(); }
  const Station &operator[](const std::size_t k) const { return first.line[kept[k]]; }
  bool leaves_some_out() const { return kept.size() < first.line.size(); }
  std::size_t nearest(const Point3 &position) const;

  /// Where the stations are in another frame's line, which may have one or two where forces jump;
  /// empty if it has not the same pipes.
  std::vector<std::size_t> places_in(const Frame &frame) const;
  /// Of numbers at all stations of that line, for each that is kept the largest up to the next one.
  std::vector<double> thinned(const std::vector<double> &values,
                              const std::vector<std::size_t> &places) const;

  /// Which of that line's stations one that is kept stands for, the second not among them.
  std::pair<std::size_t, std::size_t> stretch(const std::size_t k,
                                              const std::vector<std::size_t> &places) const;

private:
  bool continues(const std::size_t k) const; ///< whether the next one is on the same pipe

  const Frame &first;
  std::vector<std::size_t> kept;
};

} // namespace frictionbeam
