// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/connections.h"

#include "base/number_text.h"
#include "import/line/bend_geometry.h"

#include <algorithm>
#include <numeric>

namespace frictionbeam::import {

namespace {

constexpr double nearly = 10.;        ///< tolerances within which free ends all but meet
constexpr std::size_t most_gaps = 10; ///< that a message lists

struct FreeEnd {
  unsigned int node;
  std::size_t piece;
  bool is_declared; ///< END-CONNECTION, END-POSITION, a cap, or a support there
};

struct Gap {
  double distance;
  const FreeEnd *one, *other;
};

class Connections {
public:
  Connections(const PcfLine &line, const Network &network)
      : line(line), network(network), parents(network.nodes.size()) {
    std::iota(parents.begin(), parents.end(), 0u);
    for (const Piece &piece : network.pieces)
      parents[part(piece.from)] = part(piece.to);
    const auto pieces_at = network.pieces_at();
    for (unsigned int n = 0; n < pieces_at.size(); ++n)
      if (pieces_at[n].size() == 1)
        ends.push_back({n, pieces_at[n][0], is_declared(n, pieces_at[n][0])});
  }

  unsigned int part(unsigned int node) {
    while (parents[node] != node)
      node = parents[node] = parents[parents[node]];
    return node;
  }

  /// The pipelines that belong to each part.
  std::map<unsigned int, std::set<unsigned int>> pipelines_of_parts() {
    std::map<unsigned int, std::set<unsigned int>> result;
    for (const Piece &piece : network.pieces)
      result[part(piece.from)].insert(line.components[piece.component].pipeline);
    return result;
  }

  /// Pairs of free ends, each end with its nearest, the nearest first.
  template <typename Counts>
  std::vector<Gap> gaps(const Counts &counts) {
    std::vector<Gap> result;
    for (const FreeEnd &one : ends) {
      Gap best{1e300, nullptr, nullptr};
      for (const FreeEnd &other : ends)
        if (const double way = network.nodes[one.node].distance(network.nodes[other.node]);
            &one != &other && way < best.distance && counts(one, other, way))
          best = {way, &one, &other};
      if (best.one != nullptr && std::none_of(result.begin(), result.end(), [&](const Gap &known) {
            return known.one == best.other && known.other == best.one;
          }))
        result.push_back(best);
    }
    std::sort(result.begin(), result.end(),
              [](const Gap &a, const Gap &b) { return a.distance < b.distance; });
    return result;
  }

  std::string text(const std::vector<Gap> &list) const {
    std::string result;
    for (std::size_t i = 0; i < std::min(most_gaps, list.size()); ++i)
      result += (i == 0 ? "" : "\n           ") + text(*list[i].one) + " and " +
                text(*list[i].other) + ", " + rounded_number(1e3 * list[i].distance, 5) +
                " mm apart";
    if (list.size() > most_gaps)
      result += "\n           and " + std::to_string(list.size() - most_gaps) + " more";
    return result;
  }

  std::string text(const FreeEnd &end) const {
    return line.components[network.pieces[end.piece].component].text() + " at " +
           text_of_place(network.nodes[end.node]);
  }

  const PcfLine &line;
  const Network &network;
  std::vector<FreeEnd> ends;

private:
  bool is_declared(const unsigned int node, const std::size_t piece) const {
    const auto stands = [&](const Placed &placed) { return placed.node && *placed.node == node; };
    return line.components[network.pieces[piece].component].shape == Shape::end ||
           std::any_of(network.joints.begin(), network.joints.end(), stands) ||
           std::any_of(network.supports.begin(), network.supports.end(), stands) ||
           std::any_of(network.masses.begin(), network.masses.end(), stands);
  }

  std::vector<unsigned int> parents;
};

} // namespace

void check_connections(const PcfFile &file, const PcfLine &line, const Network &network,
                       const double tolerance, Notes &notes) {
  if (network.pieces.empty())
    file.fail(0, "no component with a length",
              "PIPE, ELBOW, TEE and the like with their END-POINTs",
              "the file as its program wrote it: was it cut off?");
  Connections connections(line, network);
  const std::string allowed = "ends that meet within " + rounded_number(1e3 * tolerance) + " mm";
  const std::string hint = "--tolerance with more mm, or the component that is missing there";
  const auto parts = connections.pipelines_of_parts();
  std::map<unsigned int, unsigned int> parts_of_pipeline;
  for (const auto &[part, pipelines] : parts)
    for (const unsigned int pipeline : pipelines)
      ++parts_of_pipeline[pipeline];
  for (const auto &[pipeline, n] : parts_of_pipeline)
    if (n > 1) {
      const std::vector<Gap> gaps =
          connections.gaps([&](const FreeEnd &a, const FreeEnd &b, const double) {
            return connections.part(a.node) != connections.part(b.node);
          });
      const std::string name = line.pipelines[pipeline];
      file.fail(0,
                (name.empty() ? "a line" : "pipeline " + name) + " in " + std::to_string(n) +
                    " parts that do not meet: " + connections.text(gaps),
                allowed, hint);
    }
  if (parts.size() > 1)
    notes.assumed.push_back(
        {0, std::to_string(parts.size()) + " lines that do not meet, of as many pipelines"});
  const std::vector<Gap> gaps =
      connections.gaps([&](const FreeEnd &a, const FreeEnd &b, const double way) {
        return !a.is_declared && !b.is_declared && a.piece != b.piece && way < nearly * tolerance;
      });
  if (!gaps.empty())
    file.fail(0, "free ends that all but meet: " + connections.text(gaps), allowed, hint);
  for (const FreeEnd &end : connections.ends)
    if (!end.is_declared)
      notes.assumed.push_back({line.components[network.pieces[end.piece].component].line,
                               "free end at " + text_of_place(network.nodes[end.node]) +
                                   ": nothing in the file says what is there"});
}

} // namespace frictionbeam::import
