// create_line_triangulation shall accept lines with tees, loops, rings and pipe-to-pipe cells in
// any order and direction, keep every cell, and number along the line; deal.II's assertions (debug)
// and counts are the reference. SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include "../check.h"

#include <deal.II/dofs/dof_handler.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>

using namespace dealii;
using namespace frictionbeam;

namespace {

struct Line {
  std::string name;
  std::vector<LineCell> cells;
  unsigned int n_vertices = 0;

  void add(const unsigned int a, const unsigned int b) {
    cells.push_back({{{a, b}}, static_cast<types::material_id>(cells.size())});
    n_vertices = std::max({n_vertices, a + 1, b + 1});
  }

  /// Cells between consecutive numbers.
  void chain(const unsigned int first, const unsigned int last) {
    for (unsigned int v = first; v < last; ++v)
      add(v, v + 1);
  }

  /// A cell from each vertex to a ground node of its own.
  void supports(const std::vector<unsigned int> &vertices) {
    for (const unsigned int v : vertices)
      add(v, n_vertices);
  }
};

std::vector<Line> lines() {
  std::vector<Line> result;
  const auto line = [&](const std::string &name, const std::function<void(Line &)> &build) {
    result.push_back({name, {}, 0});
    build(result.back());
  };
  line("one cell", [](Line &l) { l.chain(0, 1); });
  line("tee", [](Line &l) {
    l.chain(0, 4);
    l.add(2, 5);
    l.supports({1, 3, 3, 2, 0});
  });
  line("header with a bypass", [](Line &l) {
    l.chain(0, 8);
    l.add(2, 9), l.add(9, 10), l.add(10, 6);
    l.supports({1, 4, 7, 10});
  });
  line("bypass of one cell, another inside", [](Line &l) {
    l.chain(0, 9);
    l.add(2, 7), l.add(3, 5), l.add(5, 8);
    l.supports({5});
  });
  line("ring", [](Line &l) {
    l.chain(0, 5);
    l.add(5, 0);
  });
  line("ring with supports and a branch", [](Line &l) {
    l.chain(0, 5);
    l.add(5, 0);
    l.supports({0, 1, 2, 3, 4, 5, 2});
  });
  line("two rings joined by a cell, and a loose cell", [](Line &l) {
    l.chain(0, 3);
    l.add(3, 0);
    l.add(0, 7), l.add(7, 4), l.add(4, 5), l.add(5, 7);
    l.add(6, 8);
  });
  line("a ring on a header", [](Line &l) {
    l.chain(0, 4);
    l.add(2, 5), l.add(5, 6), l.add(6, 2);
  });
  line("two pipes with friction cells between them", [](Line &l) {
    l.chain(0, 6), l.chain(7, 13);
    for (const unsigned int v : {1, 2, 3, 5})
      l.add(v, v + 7);
    l.supports({2, 9, 11});
  });
  line("three pipes in a row of friction cells", [](Line &l) {
    l.chain(0, 5), l.chain(6, 11), l.chain(12, 17);
    l.add(1, 7), l.add(7, 13), l.add(3, 9), l.add(9, 15);
  });
  line("two cells between the same vertices", [](Line &l) {
    l.chain(0, 3);
    l.add(1, 2);
  });
  line("closed frame, three cells at every vertex", [](Line &l) {
    l.add(0, 1), l.add(0, 2), l.add(0, 3), l.add(1, 2), l.add(2, 3), l.add(3, 1);
  });
  return result;
}

void check_line(const Line &line, const unsigned int seed) {
  std::mt19937 random(seed);
  // Number the vertices anew, list the cells anew, turn some.
  std::vector<unsigned int> number(line.n_vertices);
  for (unsigned int v = 0; v < number.size(); ++v)
    number[v] = v;
  std::vector<LineCell> cells = line.cells;
  if (seed > 0) {
    std::shuffle(number.begin(), number.end(), random);
    std::shuffle(cells.begin(), cells.end(), random);
  }
  for (LineCell &cell : cells) {
    for (unsigned int &v : cell.vertices)
      v = number[v];
    if (seed > 0 && random() % 2 == 0)
      std::swap(cell.vertices[0], cell.vertices[1]);
  }
  std::vector<Point<3>> vertices(line.n_vertices);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (Point<3> &p : vertices)
    p = Point<3>(uniform(random), uniform(random), uniform(random));

  Triangulation<1, 3> triangulation;
  std::vector<CellOrigin> origins;
  try {
    origins = create_line_triangulation(vertices, cells, triangulation);
  } catch (const std::exception &error) {
    std::cerr << line.name << ", seed " << seed << ": " << error.what() << '\n';
    CHECK(false);
    return;
  }
  CHECK(triangulation.n_active_cells() == cells.size());
  CHECK(origins.size() == cells.size());
  std::set<unsigned int> seen;
  unsigned int i = 0;
  for (const auto &cell : triangulation.active_cell_iterators()) {
    const CellOrigin origin = origins[i++];
    seen.insert(origin.index);
    const LineCell &original = cells[origin.index];
    CHECK(cell->material_id() == original.material_id);
    for (const unsigned int v : {0, 1})
      CHECK(cell->vertex(v) == vertices[original.vertices[origin.reversed ? 1 - v : v]]);
  }
  CHECK(seen.size() == cells.size());

  const FE_TimoshenkoBeam fe;
  DoFHandler<1, 3> dofs(triangulation);
  dofs.distribute_dofs(fe);
  CHECK(dofs.n_dofs() == 6 * line.n_vertices);
  triangulation.refine_global(1);
  unsigned int n = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (++n % 3 == 0)
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
  dofs.distribute_dofs(fe);
  CHECK(dofs.n_dofs() == 6 * (line.n_vertices + cells.size() + n / 3));
}

/// A random tree of @p n vertices.
Line tree(const unsigned int n, const unsigned int seed) {
  std::mt19937 random(seed);
  Line line{"tree", {}, 0};
  for (unsigned int v = 1; v < n; ++v)
    line.add(random() % v, v);
  return line;
}

/// Supports listed from pipe to ground keep this direction, whatever the order of the cells: on a
/// branched pipe with all its ends supported, and where a bypass leaves and returns.
void direction_of_supports() {
  for (unsigned int seed = 0; seed < 80; ++seed) {
    Line line{"supported pipe", {}, 0};
    line.chain(0, 10);
    line.add(4, 11), line.add(11, 12);
    if (seed % 2 == 0)
      line.add(12, 8), line.supports({0, 1, 2, 4, 8, 9, 10, 11, 12});
    else
      line.supports({0, 1, 2, 4, 4, 10, 11, 12});
    std::mt19937 random(seed);
    std::vector<LineCell> cells = line.cells;
    std::shuffle(cells.begin(), cells.end(), random);
    std::vector<Point<3>> vertices(line.n_vertices);
    for (unsigned int v = 0; v < vertices.size(); ++v)
      vertices[v] = Point<3>(v, v * v, 0);
    Triangulation<1, 3> triangulation;
    for (const CellOrigin &origin : create_line_triangulation(vertices, cells, triangulation))
      CHECK(!origin.reversed || cells[origin.index].vertices[1] < 13);
  }
}

/// How often deal.II must look for a cell that it has not met yet, following neighbors.
unsigned int n_searches(const Triangulation<1, 3> &triangulation) {
  std::set<int> met;
  unsigned int n = 0;
  for (const auto &start : triangulation.active_cell_iterators()) {
    if (!met.insert(start->index()).second)
      continue;
    ++n;
    std::vector<int> pending = {start->index()};
    while (!pending.empty()) {
      const Triangulation<1, 3>::cell_iterator cell(&triangulation, 0, pending.back());
      pending.pop_back();
      for (const unsigned int f : {0, 1})
        if (!cell->at_boundary(f) && met.insert(cell->neighbor_index(f)).second)
          pending.push_back(cell->neighbor_index(f));
    }
  }
  return n;
}

/// A straight pipe with supports, listed at random, is numbered along its length: a cell's degrees
/// of freedom are those of its two vertices and of @p n_between others, which are supports or
/// next to them. Only a cell at the pipe's beginning stands out of the row. deal.II meets all cells
/// from there, so that it takes linear time.
void numbering(const unsigned int cells_of_span, const unsigned int n_between,
               const unsigned int most_searches) {
  Line pipe{"pipe", {}, 0};
  pipe.chain(0, 40);
  for (unsigned int v = 1; v < 40; v += cells_of_span)
    pipe.add(v, pipe.n_vertices);
  std::mt19937 random(5);
  std::shuffle(pipe.cells.begin(), pipe.cells.end(), random);
  std::vector<Point<3>> vertices(pipe.n_vertices);
  for (unsigned int v = 0; v < vertices.size(); ++v)
    vertices[v] = Point<3>(v, v % 7, v % 5);
  Triangulation<1, 3> triangulation;
  create_line_triangulation(vertices, pipe.cells, triangulation);
  const FE_TimoshenkoBeam fe;
  DoFHandler<1, 3> dofs(triangulation);
  dofs.distribute_dofs(fe);
  std::vector<types::global_dof_index> indices(12);
  const auto first = dofs.begin_active();
  const auto meets_first = [&](const auto &cell) {
    for (const unsigned int v : {0, 1})
      for (const unsigned int w : {0, 1})
        if (cell->vertex_index(v) == first->vertex_index(w))
          return true;
    return false;
  };
  CHECK(n_searches(triangulation) <= most_searches);
  for (const auto &cell : dofs.active_cell_iterators()) {
    if (meets_first(cell))
      continue;
    cell->get_dof_indices(indices);
    CHECK(*std::max_element(indices.begin(), indices.end()) <=
          *std::min_element(indices.begin(), indices.end()) + 11 + 6 * n_between);
  }
}

void refused(const std::vector<Point<3>> &vertices, const std::vector<LineCell> &cells,
             const std::string &words) {
  Triangulation<1, 3> triangulation;
  std::string message;
  try {
    create_line_triangulation(vertices, cells, triangulation);
  } catch (const ExceptionBase &error) {
    message = error.what();
  }
  CHECK(message.find(words) != std::string::npos);
}

} // namespace

int line_mesh(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  for (const Line &line : lines())
    for (unsigned int seed = 0; seed < 40; ++seed)
      check_line(line, seed);
  for (unsigned int seed = 1; seed < 40; ++seed)
    check_line(tree(30, seed), seed);
  direction_of_supports();
  numbering(3, 1, 2);
  numbering(1, 4, 4);

  const Point<3> o, x(1, 0, 0), y(0, 1, 0);
  refused({o, x, x}, {{{{0, 1}}, 0}, {{{1, 2}}, 0}}, "Cell 1 of the line has length zero");
  refused({o, x}, {{{{0, 5}}, 0}}, "Cell 0 of the line names vertex 5 of 2");
  refused({o, Point<3>(0, std::nan(""), 0)}, {{{{0, 1}}, 0}}, "Vertex 1 of the line is at nan");
  refused({o, x, y}, {{{{0, 1}}, 0}}, "Vertex 2 of the line belongs to no cell");
  // Two rings with one vertex in common: each wants the first cell there to be its own.
  const Point<3> z(0, 0, 1);
  refused(
      {o, x, y, z, -1. * z},
      {{{{0, 1}}, 0}, {{{1, 2}}, 0}, {{{2, 0}}, 0}, {{{0, 3}}, 0}, {{{3, 4}}, 0}, {{{4, 0}}, 0}},
      "Pull apart");
  return check::report();
}
