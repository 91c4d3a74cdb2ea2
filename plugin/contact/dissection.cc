// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dissection.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace frictionbeam::contact {

namespace {

constexpr int largest_leaf = 64;       // unknowns
constexpr double least_side = 1. / 3.; // of a piece

/// Unknowns with the same neighbours, themselves included, are one node: those of a finite element
/// node are.
struct Nodes {
  std::vector<std::vector<int>> unknowns, neighbours;

  explicit Nodes(const SparseMatrix &matrix);
};

Nodes::Nodes(const SparseMatrix &matrix) {
  const int n = matrix.rows();
  const auto begin = [&](const int i) {
    return matrix.innerIndexPtr() + matrix.outerIndexPtr()[i];
  };
  std::unordered_map<std::uint64_t, std::vector<int>> by_hash; // nodes
  std::vector<int> node_of(n);
  for (int i = 0; i < n; ++i) {
    std::uint64_t hash = 14695981039346656037u; // FNV-1a
    for (const int *j = begin(i); j != begin(i + 1); ++j)
      hash = (hash ^ *j) * 1099511628211u;
    std::vector<int> &same = by_hash[hash];
    const auto found = std::find_if(same.begin(), same.end(), [&](const int node) {
      const int other = unknowns[node].front();
      return std::equal(begin(i), begin(i + 1), begin(other), begin(other + 1));
    });
    if (found == same.end()) {
      node_of[i] = unknowns.size();
      same.push_back(node_of[i]);
      unknowns.push_back({i});
    } else {
      node_of[i] = *found;
      unknowns[*found].push_back(i);
    }
  }
  neighbours.resize(unknowns.size());
  for (std::size_t node = 0; node < unknowns.size(); ++node) {
    const int i = unknowns[node].front();
    std::vector<int> &list = neighbours[node];
    for (const int *j = begin(i); j != begin(i + 1); ++j)
      if (node_of[*j] != static_cast<int>(node))
        list.push_back(node_of[*j]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

/// Nodes of a connected piece by their distance from the first.
struct Levels {
  std::vector<int> nodes, starts; ///< starts of the levels in nodes, and the end

  int n() const { return starts.size() - 1; }
};

class Dissector {
public:
  explicit Dissector(const SparseMatrix &matrix)
      : nodes(matrix), piece_of(nodes.unknowns.size(), 0), visit(piece_of.size(), 0) {}

  std::vector<Dissected> run();

private:
  struct Piece {
    std::vector<int> nodes;
    int parent;
  };
  /// A level and how many unknowns it has.
  struct Cut {
    Levels levels;
    int level = -1;
    double cost = 0.;
  };

  double weight(const int node) const { return nodes.unknowns[node].size(); }
  Levels levels_from(const int start);
  /// Split what is left of a piece into its connected parts.
  void push_parts(const std::vector<int> &left, const int parent);
  Cut best_level(Levels levels) const;
  Cut best_cut(const Piece &piece);
  void add_front(const std::vector<int> &of_nodes, const int parent);
  void dissect(const Piece &piece);

  const Nodes nodes;
  std::vector<int> piece_of, visit;
  int n_pieces = 0, n_visits = 0;
  std::vector<Piece> pieces;     ///< to do
  std::vector<Dissected> fronts; ///< parents first
};

Levels Dissector::levels_from(const int start) {
  ++n_visits;
  Levels result;
  result.nodes = {start};
  visit[start] = n_visits;
  for (std::size_t k = 0; k < result.nodes.size();) {
    result.starts.push_back(k);
    for (const std::size_t end = result.nodes.size(); k < end; ++k)
      for (const int neighbour : nodes.neighbours[result.nodes[k]])
        if (piece_of[neighbour] == piece_of[start] && visit[neighbour] != n_visits) {
          visit[neighbour] = n_visits;
          result.nodes.push_back(neighbour);
        }
  }
  result.starts.push_back(result.nodes.size());
  return result;
}

void Dissector::push_parts(const std::vector<int> &left, const int parent) {
  const int mark = ++n_pieces;
  for (const int node : left)
    piece_of[node] = mark;
  for (const int node : left)
    if (piece_of[node] == mark) {
      Piece part{levels_from(node).nodes, parent};
      ++n_pieces;
      for (const int of_part : part.nodes)
        piece_of[of_part] = n_pieces;
      pieces.push_back(std::move(part));
    }
}

Dissector::Cut Dissector::best_level(Levels levels) const {
  std::vector<double> weights(levels.n(), 0.);
  for (int l = 0; l < levels.n(); ++l)
    for (int k = levels.starts[l]; k < levels.starts[l + 1]; ++k)
      weights[l] += weight(levels.nodes[k]);
  const double all = std::accumulate(weights.begin(), weights.end(), 0.);
  Cut cut;
  double before = weights[0];
  for (int l = 1; l + 1 < levels.n(); ++l) {
    const double after = all - before - weights[l], lesser = std::min(before, after);
    // a side that is too small costs as if the level were so much larger
    const double cost = weights[l] * std::max(1., least_side * all / lesser);
    if (cut.level < 0 || cost < cut.cost) {
      cut.level = l;
      cut.cost = cost;
    }
    before += weights[l];
  }
  cut.levels = std::move(levels);
  return cut;
}

Dissector::Cut Dissector::best_cut(const Piece &piece) {
  Cut best;
  const auto take = [&](Levels levels) {
    Cut cut = best_level(std::move(levels));
    if (cut.level >= 0 && (best.level < 0 || cut.cost < best.cost))
      best = std::move(cut);
  };
  int end = piece.nodes.front();
  for (int turn = 0; turn < 3; ++turn) {
    Levels levels = levels_from(end);
    const int first = levels.starts[levels.n() - 1], last = levels.nodes.size() - 1;
    const int middle = levels.nodes[(first + last) / 2];
    end = levels.nodes[last];
    take(std::move(levels));
    take(levels_from(middle));
  }
  return best;
}

void Dissector::add_front(const std::vector<int> &of_nodes, const int parent) {
  Dissected front{{}, parent};
  for (const int node : of_nodes) {
    piece_of[node] = -1;
    front.unknowns.insert(front.unknowns.end(), nodes.unknowns[node].begin(),
                          nodes.unknowns[node].end());
  }
  fronts.push_back(std::move(front));
}

void Dissector::dissect(const Piece &piece) {
  double size = 0.;
  for (const int node : piece.nodes)
    size += weight(node);
  const Cut cut = size > largest_leaf ? best_cut(piece) : Cut();
  if (cut.level < 0) { // small, or as good as dense
    add_front(piece.nodes, piece.parent);
    return;
  }
  const Levels &levels = cut.levels;
  const auto begin = levels.nodes.begin();
  const int first = levels.starts[cut.level], end = levels.starts[cut.level + 1];
  std::vector<int> separator, left(begin, begin + first);
  ++n_visits;
  std::for_each(begin + end, levels.nodes.end(), [&](const int node) { visit[node] = n_visits; });
  for (int k = first; k < end; ++k) {
    const int node = levels.nodes[k];
    const auto &around = nodes.neighbours[node];
    const bool separates = std::any_of(around.begin(), around.end(),
                                       [&](const int other) { return visit[other] == n_visits; });
    (separates ? separator : left).push_back(node);
  }
  left.insert(left.end(), begin + end, levels.nodes.end());
  add_front(separator, piece.parent);
  push_parts(left, fronts.size() - 1);
}

std::vector<Dissected> Dissector::run() {
  std::vector<int> all(nodes.unknowns.size());
  std::iota(all.begin(), all.end(), 0);
  push_parts(all, -1);
  while (!pieces.empty()) {
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    dissect(piece);
  }
  std::reverse(fronts.begin(), fronts.end());
  const int last = fronts.size() - 1;
  for (Dissected &front : fronts)
    if (front.parent >= 0)
      front.parent = last - front.parent;
  return std::move(fronts);
}

} // namespace

std::vector<Dissected> dissect(const SparseMatrix &matrix) { return Dissector(matrix).run(); }

} // namespace frictionbeam::contact
