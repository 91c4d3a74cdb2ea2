// SPDX-License-Identifier: LGPL-2.1-or-later
// Dofs of contacts in programs of deal.II: the displacement at a vertex, wherever an element has
// it.
#include "../check.h"

#include <frictionbeam/contact/deal_ii.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/hp/fe_collection.h>

#include <stdexcept>

using namespace dealii;
using namespace frictionbeam;
using contact::translations_at_vertex;
using contact::translations_at_vertices;

namespace {

template <typename Function>
bool is_refused(const Function &function) {
  try {
    function();
  } catch (const std::invalid_argument &fault) {
    return std::string(fault.what()).find("allowed:") != std::string::npos;
  }
  return false;
}

/// Of a vertex: the dofs of any cell there whose component is asked for.
template <int dim>
std::vector<unsigned int> by_components(const DoFHandler<dim> &dof_handler,
                                        const unsigned int vertex, const unsigned int first) {
  std::vector<unsigned int> dofs(dim, numbers::invalid_unsigned_int);
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    const FiniteElement<dim> &fe = cell->get_fe();
    std::vector<types::global_dof_index> of_cell(fe.n_dofs_per_cell());
    cell->get_dof_indices(of_cell);
    for (unsigned int i = 0; i < of_cell.size(); ++i) {
      const unsigned int c = fe.system_to_component_index(i).first;
      if (!fe.has_support_points() || c < first || c >= first + dim)
        continue;
      const Point<dim> place =
          MappingQ1<dim>().transform_unit_to_real_cell(cell, fe.unit_support_point(i));
      if (place.distance(dof_handler.get_triangulation().get_vertices()[vertex]) < 1e-12)
        dofs[c - first] = of_cell[i];
    }
  }
  return dofs;
}

/// A temperature before the displacement, and quadratic elements.
template <int dim>
void systems() {
  Triangulation<dim> triangulation;
  GridGenerator::subdivided_hyper_cube(triangulation, 2);
  for (const unsigned int degree : {1, 2}) {
    const FESystem<dim> fe(FE_Q<dim>(1), 1, FE_Q<dim>(degree), dim);
    DoFHandler<dim> dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    std::vector<unsigned int> vertices;
    for (unsigned int v = triangulation.n_vertices(); v-- > 0;)
      vertices.push_back(v);
    const auto all = translations_at_vertices(dof_handler, vertices, 7, 1);
    CHECK(all.size() == vertices.size());
    for (unsigned int i = 0; i < all.size(); ++i) {
      std::vector<unsigned int> expected = by_components(dof_handler, vertices[i], 1);
      CHECK(translations_at_vertex(dof_handler, vertices[i], 0, 1) == expected);
      for (unsigned int &dof : expected)
        dof += 7;
      CHECK(all[i] == expected);
    }
    CHECK(is_refused([&]() { translations_at_vertex(dof_handler, 0, 0, 2); }));
    CHECK(is_refused([&]() { translations_at_vertex(dof_handler, 1000); }));
  }
}

/// A solid beside a hole: whichever cell comes first, the vertex between them has its dofs.
void beside_nothing() {
  Triangulation<2> triangulation;
  GridGenerator::subdivided_hyper_rectangle(triangulation, {2, 1}, Point<2>(), Point<2>(2., 1.));
  const hp::FECollection<2> fes(FESystem<2>(FE_Q<2>(1), 2), FESystem<2>(FE_Nothing<2>(), 2));
  for (const unsigned int solid : {0, 1}) {
    DoFHandler<2> dof_handler(triangulation);
    unsigned int c = 0;
    for (const auto &cell : dof_handler.active_cell_iterators())
      cell->set_active_fe_index(c++ == solid ? 0 : 1);
    dof_handler.distribute_dofs(fes);
    for (unsigned int v = 0; v < triangulation.n_vertices(); ++v) {
      const double x = triangulation.get_vertices()[v][0];
      if ((solid == 0 && x > 1.5) || (solid == 1 && x < 0.5))
        CHECK(is_refused([&]() { translations_at_vertex(dof_handler, v); }));
      else
        CHECK(translations_at_vertex(dof_handler, v) == by_components(dof_handler, v, 0));
    }
  }
}

/// Of a line they are the first three of a vertex's six.
void of_a_line() {
  Triangulation<1, 3> triangulation;
  create_line_triangulation({Point<3>(0, 0, 0), Point<3>(1, 0, 0), Point<3>(2, 0, 1)},
                            {{{{0, 1}}, 0}, {{{1, 2}}, 0}}, triangulation);
  const FESystem<1, 3> beside(FE_Q<1, 3>(1), 1, FE_TimoshenkoBeam({0.}), 1);
  for (const bool is_alone : {true, false}) {
    DoFHandler<1, 3> dof_handler(triangulation);
    if (is_alone)
      dof_handler.distribute_dofs(FE_TimoshenkoBeam({0.}));
    else
      dof_handler.distribute_dofs(beside);
    const unsigned int first = is_alone ? 0 : 1;
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices()) {
        const auto dofs = translations_at_vertex(dof_handler, cell->vertex_index(v), 0, first);
        for (unsigned int d = 0; d < 3; ++d)
          CHECK(dofs[d] == cell->vertex_dof_index(v, first + d));
      }
  }
}

} // namespace

int contact_dofs(int, char **) {
  systems<2>();
  systems<3>();
  beside_nothing();
  of_a_line();
  return check::report();
}
