// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/connections.h"

#include "base/number_text.h"
#include "import/line/bend_geometry.h"

#include <algorithm>
#include <numeric>
#include <tuple>

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
    std::set<unsigned int> declared;
    for (const std::vector<Placed> *const list :
         {&network.joints, &network.supports, &network.masses})
      for (const Placed &placed : *list)
        if (placed.node)
          declared.insert(*placed.node);
    const auto pieces_at = network.pieces_at();
    for (unsigned int n = 0; n < pieces_at.size(); ++n)
      if (pieces_at[n].size() == 1)
        ends.push_back(
            {n, pieces_at[n][0],
             declared.count(n) == 1 ||
                 line.components[network.pieces[pieces_at[n][0]].component].shape == Shape::end});
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

  /// Pairs of free ends, each end with its nearest that @p counts, the nearest first.
  /// @param farthest beyond which ends do not count
  template <typename Counts>
  std::vector<Gap> gaps(const Counts &counts, const double farthest = 1e300) {
    std::vector<const FreeEnd *> sorted; // along x: the nearest is not far in this order
    for (const FreeEnd &end : ends)
      sorted.push_back(&end);
    const auto x = [&](const FreeEnd *const end) { return network.nodes[end->node][0]; };
    std::sort(sorted.begin(), sorted.end(),
              [&](const FreeEnd *const a, const FreeEnd *const b) { return x(a) < x(b); });
    std::map<std::pair<const FreeEnd *, const FreeEnd *>, double> pairs;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      Gap best{farthest, sorted[i], nullptr};
      const auto look_at = [&](const FreeEnd *const other) {
        const double way = network.nodes[sorted[i]->node].distance(network.nodes[other->node]);
        if (way < best.distance && counts(*sorted[i], *other))
          best = {way, sorted[i], other};
      };
      for (std::size_t k = i; k-- > 0 && x(sorted[i]) - x(sorted[k]) < best.distance;)
        look_at(sorted[k]);
      for (std::size_t k = i + 1; k < sorted.size() && x(sorted[k]) - x(sorted[i]) < best.distance;
           ++k)
        look_at(sorted[k]);
      if (best.other != nullptr)
        pairs.emplace(std::minmax(best.one, best.other), best.distance);
    }
    std::vector<Gap> result;
    for (const auto &[pair, distance] : pairs)
      result.push_back({distance, pair.first, pair.second});
    std::sort(result.begin(), result.end(), [](const Gap &a, const Gap &b) {
      return std::make_tuple(a.distance, a.one->node, a.other->node) <
             std::make_tuple(b.distance, b.one->node, b.other->node);
    });
    return result;
  }

  /// The shortest gaps whose closing would make one line of all parts: each round joins every part
  /// with its nearest (Boruvka's minimum spanning tree).
  std::vector<Gap> between_parts() {
    std::vector<Gap> result;
    for (std::vector<Gap> found; !(found = gaps([&](const FreeEnd &a, const FreeEnd &b) {
                                     return part(a.node) != part(b.node);
                                   })).empty();)
      for (const Gap &gap : found)
        if (part(gap.one->node) != part(gap.other->node)) {
          result.push_back(gap);
          parents[part(gap.one->node)] = part(gap.other->node);
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
      const std::vector<Gap> gaps = connections.between_parts();
      const std::string name = line.pipelines[pipeline];
      file.fail(0,
                (name.empty() ? "a line" : "pipeline " + name) + " in " + std::to_string(n) +
                    " parts that do not meet: " + connections.text(gaps),
                allowed, hint);
    }
  if (parts.size() > 1)
    notes.assumed.push_back(
        {0, std::to_string(parts.size()) + " lines that do not meet, of as many pipelines"});
  const std::vector<Gap> gaps = connections.gaps(
      [&](const FreeEnd &a, const FreeEnd &b) {
        return !a.is_declared && !b.is_declared && a.piece != b.piece;
      },
      nearly * tolerance);
  if (!gaps.empty())
    file.fail(0, "free ends that all but meet: " + connections.text(gaps), allowed, hint);
  for (const FreeEnd &end : connections.ends)
    if (!end.is_declared)
      notes.assumed.push_back({line.components[network.pieces[end.piece].component].line,
                               "free end at " + text_of_place(network.nodes[end.node]) +
                                   ": nothing in the file says what is there"});
}

} // namespace frictionbeam::import
