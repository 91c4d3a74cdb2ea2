// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line_triangulation.h>

#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr unsigned int none = numbers::invalid_unsigned_int;

/// Cells at each vertex, row-compressed.
struct Incidence {
  std::vector<unsigned int> start, cell;

  Incidence(const unsigned int n_vertices, const std::vector<LineCell> &cells)
      : start(n_vertices + 1, 0), cell(2 * cells.size()) {
    for (const LineCell &c : cells)
      for (const unsigned int v : c.vertices)
        ++start[v + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<unsigned int> next(start.begin(), start.end() - 1);
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (const unsigned int v : cells[i].vertices)
        cell[next[v]++] = i;
  }

  unsigned int degree(const unsigned int v) const { return start[v + 1] - start[v]; }
};

/**
 * An order and directions of the cells such that at every vertex the first-listed cell points the
 * other way from all others there.
 *
 * A depth-first walk splits the line into trails: a trail goes on through a vertex with the first
 * cell taken there, every other cell begins a trail of its own; a trail ends where there is no cell
 * left or where it meets a vertex visited before. With d = +-1 the direction of a trail (along the
 * walk or against it) and p = +-1 that of the cells attached to a vertex that a trail goes through
 * (away from it or to it), the rules are
 *   d = p at the start of a trail,  p = -d at its end,
 * and of the two cells of the trail that goes through, the one that points the other way from the
 * attached ones is listed first. Without loops d = p = 1 and the order is that of the walk.
 *
 * deal.II's time is another matter: it follows neighbors from the first-listed cell on, and where
 * that ends, searches all cells from the beginning for one not met yet. A vertex's first cell has
 * its last as neighbor, and all others have its first. So where a trail passes dead ends, it is
 * best listed backwards but for its beginning, p = -d, with a dead end as the vertex's last: then
 * the neighbors lead from one end of the trail to the other past all its dead ends. Where the
 * beginning itself leads to one, it is the vertex's first, p = d, and what goes on its last.
 */
class Walk {
public:
  Walk(const unsigned int n_vertices, const std::vector<LineCell> &cells)
      : cells(cells), incidence(n_vertices, cells) {
    for (unsigned int v = 0; v < n_vertices; ++v)
      AssertThrow(incidence.degree(v) > 0,
                  ExcMessage("Vertex " + std::to_string(v) +
                             " of the line belongs to no cell. Leave it out of the list."));
    // Loops may leave no directions or no order for one way to walk and some for another.
    for (unsigned int attempt = 0; attempt < 200; ++attempt) {
      walk(n_vertices, attempt);
      for (const bool chained : {true, false}) {
        if (!find_directions(n_vertices, chained))
          continue;
        find_ends(n_vertices, chained);
        if (find_order(n_vertices, chained))
          return;
      }
    }
    AssertThrow(false,
                ExcMessage("The loops of the line meet in such a way that deal.II accepts no "
                           "order of its cells. Pull apart a vertex of four or more cells by "
                           "a short cell."));
  }

  std::vector<CellOrigin> order;

private:
  struct Step {
    unsigned int cell, from, to, trail;
  };
  struct Trail {
    unsigned int start, end;
  };

  void walk(const unsigned int n_vertices, const unsigned int attempt) {
    steps.clear();
    trails.clear();
    parent.assign(n_vertices, none);
    continuation.assign(n_vertices, none);
    visited.assign(n_vertices, false);
    used.assign(cells.size(), false);
    // Trails go on along the pipe, not into its supports.
    std::mt19937 random(attempt);
    for (unsigned int v = 0; v < n_vertices; ++v) {
      const auto begin = incidence.cell.begin() + incidence.start[v],
                 end = incidence.cell.begin() + incidence.start[v + 1];
      if (attempt > 0)
        std::shuffle(begin, end, random);
      std::stable_partition(begin, end, [this](const unsigned int c) { return !is_dead_end(c); });
    }
    // Start at free ends, best at those from which the author's own cell points away, or at the
    // supports of free ends, where they can be turned back; a part without (a ring) where two meet.
    const auto rank = [this](const unsigned int v) {
      if (incidence.degree(v) > 1)
        return incidence.degree(v) == 2 ? 3 : 4;
      const auto &ends = cells[incidence.cell[incidence.start[v]]].vertices;
      return ends[0] == v ? 0 : incidence.degree(ends[0]) == 2 ? 1 : 2;
    };
    for (int wanted = 0; wanted < 5; ++wanted)
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (!visited[v] && rank(v) == wanted)
          walk_from(v);
  }

  bool is_dead_end(const unsigned int c) const {
    return incidence.degree(cells[c].vertices[0]) == 1 ||
           incidence.degree(cells[c].vertices[1]) == 1;
  }

  /// Whether a trail goes on through a vertex that has one dead end, too. Of several, only one
  /// could keep the author's direction.
  bool has_dead_end_beside(const unsigned int v) const {
    if (parent[v] == none || continuation[v] == none || is_dead_end(steps[continuation[v]].cell))
      return false;
    unsigned int n = 0;
    for (unsigned int i = incidence.start[v]; i < incidence.start[v + 1]; ++i)
      n += incidence.cell[i] != steps[parent[v]].cell && is_dead_end(incidence.cell[i]);
    return n == 1;
  }

  /// Whether it is the second vertex of a walk.
  bool follows_root(const unsigned int v) const {
    return parent[v] != none && parent[steps[parent[v]].from] == none;
  }

  bool passes_dead_end(const unsigned int v) const {
    return has_dead_end_beside(v) && !follows_root(v);
  }

  bool begins_at_dead_end(const unsigned int v) const {
    return has_dead_end_beside(v) && follows_root(v);
  }

  /// The first step of a trail, from @p step on, that does not lead to a dead end.
  unsigned int beginning(unsigned int step) const {
    for (;;) {
      const unsigned int next = continuation[steps[step].to];
      if (next == none || next <= step ||
          !passes_dead_end(steps[step].to)) // <=: once around a ring
        return step;
      step = next;
    }
  }

  void walk_from(const unsigned int root) {
    visited[root] = true;
    std::vector<std::pair<unsigned int, unsigned int>> stack{{root, incidence.start[root]}};
    while (!stack.empty()) {
      const unsigned int vertex = stack.back().first;
      if (stack.back().second == incidence.start[vertex + 1]) {
        stack.pop_back();
        continue;
      }
      const unsigned int c = incidence.cell[stack.back().second++];
      if (used[c])
        continue;
      used[c] = true;
      const unsigned int other = cells[c].vertices[cells[c].vertices[0] == vertex ? 1 : 0];
      const bool goes_on = continuation[vertex] == none;
      if (!goes_on || vertex == root)
        trails.push_back({goes_on ? none : vertex, none});
      const unsigned int trail =
          goes_on && vertex != root ? steps[parent[vertex]].trail : trails.size() - 1;
      if (goes_on)
        continuation[vertex] = steps.size();
      if (visited[other])
        trails[trail].end = other;
      else {
        visited[other] = true;
        parent[other] = steps.size();
        stack.emplace_back(other, incidence.start[other]);
      }
      steps.push_back({c, vertex, other, trail});
    }
  }

  /// Solve the rules of directions, a graph to be coloured with two colours.
  bool find_directions(const unsigned int n_vertices, const bool chained) {
    struct Relation {
      unsigned int other;
      bool equal;
    };
    std::vector<std::vector<Relation>> relations(n_vertices + trails.size());
    const auto relate = [&](const unsigned int trail, const unsigned int vertex, const bool equal) {
      relations[n_vertices + trail].push_back({vertex, equal});
      relations[vertex].push_back({n_vertices + trail, equal});
    };
    for (unsigned int t = 0; t < trails.size(); ++t) {
      if (trails[t].start != none)
        relate(t, trails[t].start, true);
      if (trails[t].end != none)
        relate(t, trails[t].end, false);
    }
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (parent[v] == none) // a root: no cell of its trail arrives
        relate(steps[continuation[v]].trail, v, false);
      else if (chained && has_dead_end_beside(v))
        relate(steps[parent[v]].trail, v, follows_root(v));

    sign.assign(relations.size(), 0);
    std::vector<unsigned int> pending;
    for (unsigned int t = 0; t < trails.size(); ++t) {
      if (sign[n_vertices + t] != 0)
        continue;
      sign[n_vertices + t] = 1;
      pending.push_back(n_vertices + t);
      while (!pending.empty()) {
        const unsigned int node = pending.back();
        pending.pop_back();
        for (const Relation &relation : relations[node]) {
          const int wanted = relation.equal ? sign[node] : -sign[node];
          if (sign[relation.other] == -wanted)
            return false;
          if (sign[relation.other] == 0)
            pending.push_back(relation.other);
          sign[relation.other] = wanted;
        }
      }
    }
    return true;
  }

  int direction(const unsigned int step) const {
    return sign[parent.size() + steps[step].trail]; // d, behind p of the vertices
  }

  /// Find which cell is to be listed first at each vertex with attached cells, and which cells are
  /// turned. deal.II follows neighbors from a vertex's first cell to its last and back, and turns
  /// what it meets there; so one dead end at each vertex, listed last, may keep the author's
  /// direction.
  void find_ends(const unsigned int n_vertices, const bool chained) {
    first.assign(n_vertices, none);
    last.assign(n_vertices, none);
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (parent[v] == none)
        first[v] = continuation[v];
      else if (sign[v] != 0)
        first[v] = direction(parent[v]) == sign[v] ? parent[v] : continuation[v];
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (chained && begins_at_dead_end(v))
        last[v] = continuation[v];
    reversed.assign(steps.size(), false);
    for (unsigned int s = 0; s < steps.size(); ++s) {
      const Step &step = steps[s];
      const bool walked_back = cells[step.cell].vertices[0] != step.from;
      reversed[s] = walked_back == (direction(s) == 1);
      const unsigned int v = incidence.degree(step.from) == 1 ? step.to : step.from;
      const unsigned int end = v == step.from ? step.to : step.from;
      if (reversed[s] && incidence.degree(end) == 1 && first[v] != s && last[v] == none) {
        last[v] = s;
        reversed[s] = false;
      }
    }
  }

  /// List the cells in the order of the walk, but at each vertex the first one first and the last
  /// one last.
  bool find_order(const unsigned int n_vertices, const bool chained) {
    std::vector<unsigned int> step_of(cells.size());
    for (unsigned int s = 0; s < steps.size(); ++s)
      step_of[steps[s].cell] = s;
    std::vector<unsigned int> n_waits_for(steps.size(), 0);
    std::vector<bool> begins(steps.size(), !chained);
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (chained && parent[v] == none)
        begins[beginning(continuation[v])] = true;
    // In the order of the walk, or backwards but for its beginning; dead ends beside the cell that
    // leads to them.
    std::set<std::pair<unsigned int, unsigned int>> ready;
    const auto insert = [&](const unsigned int step) {
      const unsigned int from = steps[step].from;
      const bool beside = is_dead_end(steps[step].cell) && continuation[from] != step;
      const unsigned int place = beside && parent[from] != none ? parent[from] : step;
      ready.insert({begins[step] ? place : 2 * steps.size() - place, step});
    };
    for (unsigned int s = 0; s < steps.size(); ++s) {
      for (const unsigned int v : {steps[s].from, steps[s].to})
        if (last[v] == s)
          n_waits_for[s] += incidence.degree(v) - 1;
        else if (first[v] != none && first[v] != s)
          ++n_waits_for[s];
      if (n_waits_for[s] == 0)
        insert(s);
    }
    order.clear();
    while (!ready.empty()) {
      const unsigned int s = ready.begin()->second;
      ready.erase(ready.begin());
      order.push_back({steps[s].cell, reversed[s]});
      const auto release = [&](const unsigned int step) {
        if (--n_waits_for[step] == 0)
          insert(step);
      };
      for (const unsigned int v : {steps[s].from, steps[s].to}) {
        if (first[v] == s)
          for (unsigned int i = incidence.start[v]; i < incidence.start[v + 1]; ++i)
            if (const unsigned int other = step_of[incidence.cell[i]];
                other != s && other != last[v])
              release(other);
        if (last[v] != none && last[v] != s)
          release(last[v]);
      }
    }
    return order.size() == steps.size();
  }

  const std::vector<LineCell> &cells;
  Incidence incidence;
  std::vector<Step> steps;                        ///< one for each cell
  std::vector<Trail> trails;                      ///< vertices where attached, or none
  std::vector<unsigned int> parent, continuation; ///< steps to and from a vertex, or none
  std::vector<bool> visited, used;
  std::vector<int> sign;                 ///< p of vertices (0: nothing attached), then d of trails
  std::vector<unsigned int> first, last; ///< steps to be listed so at a vertex, or none
  std::vector<bool> reversed;            ///< steps whose cells are turned
};

} // namespace

std::vector<CellOrigin> create_line_triangulation(const std::vector<Point<3>> &vertices,
                                                  const std::vector<LineCell> &cells,
                                                  Triangulation<1, 3> &triangulation) {
  for (unsigned int v = 0; v < vertices.size(); ++v)
    for (unsigned int d = 0; d < 3; ++d)
      AssertThrow(std::isfinite(vertices[v][d]),
                  ExcMessage("Vertex " + std::to_string(v) + " of the line is at " +
                             std::to_string(vertices[v][d]) + " in direction " + std::to_string(d) +
                             ". Coordinates are numbers."));
  for (unsigned int i = 0; i < cells.size(); ++i)
    for (const unsigned int v : cells[i].vertices)
      AssertThrow(v < vertices.size(),
                  ExcMessage("Cell " + std::to_string(i) + " of the line names vertex " +
                             std::to_string(v) + " of " + std::to_string(vertices.size()) +
                             ". They are counted from 0."));
  for (unsigned int i = 0; i < cells.size(); ++i)
    AssertThrow(vertices[cells[i].vertices[0]].distance(vertices[cells[i].vertices[1]]) > 0.,
                ExcMessage("Cell " + std::to_string(i) + " of the line has length zero."));

  const Walk walk(vertices.size(), cells);
  std::vector<CellData<1>> data(cells.size());
  for (unsigned int i = 0; i < data.size(); ++i) {
    const CellOrigin origin = walk.order[i];
    const LineCell &cell = cells[origin.index];
    data[i].vertices = {cell.vertices[origin.reversed ? 1 : 0],
                        cell.vertices[origin.reversed ? 0 : 1]};
    data[i].material_id = cell.material_id;
  }
  triangulation.create_triangulation(vertices, data, SubCellData());
  return walk.order;
}

} // namespace frictionbeam
