// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line_triangulation.h>

#include <algorithm>
#include <numeric>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr unsigned int unvisited = numbers::invalid_unsigned_int;

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

/// A depth-first walk: tree cells in the order met, then the cells that close loops.
class Walk {
public:
  Walk(const unsigned int n_vertices, const std::vector<LineCell> &cells)
      : cells(cells), incidence(n_vertices, cells), number(n_vertices, unvisited),
        used(cells.size(), false) {
    // Free ends first; a part without one (a closed ring) starts at a vertex of two cells.
    for (const unsigned int wanted_degree : {1u, 2u, 0u})
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (number[v] == unvisited && (wanted_degree == 0 || incidence.degree(v) == wanted_degree))
          walk_from(v);
    append_loop_cells();
  }

  std::vector<CellOrigin> order;

private:
  void walk_from(const unsigned int root) {
    AssertThrow(incidence.degree(root) > 0,
                ExcMessage("Vertex " + std::to_string(root) +
                           " of the line belongs to no cell. Leave it out of the list of vertices."));
    number[root] = n_visited++;
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
      const bool reversed = cells[c].vertices[0] != vertex;
      const unsigned int other = cells[c].vertices[reversed ? 0 : 1];
      if (number[other] != unvisited) {
        loop_cells.push_back(c);
        continue;
      }
      order.push_back({c, reversed});
      number[other] = n_visited++;
      stack.emplace_back(other, incidence.start[other]);
    }
  }

  /// A loop's last cell points from the vertex met earlier to the one met later. The deepest come
  /// first, so that where a cell arrives, nothing is listed after it.
  void append_loop_cells() {
    const auto deeper_end = [this](const unsigned int c) {
      return std::max(number[cells[c].vertices[0]], number[cells[c].vertices[1]]);
    };
    std::stable_sort(loop_cells.begin(), loop_cells.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return deeper_end(a) > deeper_end(b);
                     });
    for (unsigned int i = 0; i < loop_cells.size(); ++i) {
      const auto &v = cells[loop_cells[i]].vertices;
      const bool reversed = number[v[0]] > number[v[1]];
      AssertThrow(i == 0 || deeper_end(loop_cells[i]) != deeper_end(loop_cells[i - 1]) ||
                      incidence.degree(v[reversed ? 0 : 1]) < 3,
                  ExcMessage("Several loops of the line close in one vertex by a single cell each. "
                             "Cut these cells in two."));
      order.push_back({loop_cells[i], reversed});
    }
  }

  const std::vector<LineCell> &cells;
  const Incidence incidence;
  std::vector<unsigned int> number;
  std::vector<bool> used;
  std::vector<unsigned int> loop_cells;
  unsigned int n_visited = 0;
};

} // namespace

std::vector<CellOrigin> create_line_triangulation(const std::vector<Point<3>> &vertices,
                                                  const std::vector<LineCell> &cells,
                                                  Triangulation<1, 3> &triangulation) {
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
