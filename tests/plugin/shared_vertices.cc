// However many elements meet in a vertex of an hp collection, in whatever order they stand there,
// it shall have the unknowns of the largest of them, once, and every element shall use these: a
// moment passes from beam to beam past any support. References: counting, and the bending of an arc
// and a straight run by an end moment.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_arc_beam.h>
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include "../check.h"
#include "line_problem.h"

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/hp/fe_collection.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <set>

using namespace line_problem;
using namespace frictionbeam;
using Rotations = FE_FrictionBeam::Rotations;

namespace {

/// Every element that can stand in a collection; the last one is of deal.II.
std::vector<std::unique_ptr<FiniteElement<1, 3>>> all_elements() {
  std::vector<std::unique_ptr<FiniteElement<1, 3>>> all;
  const auto add = [&](const FiniteElement<1, 3> &fe) { all.push_back(fe.clone()); };
  add(FE_TimoshenkoBeam());
  add(FE_TimoshenkoBeam({0.3, 0.1}));
  add(FE_ArcBeam({{0, {Point<3>(), 1., 0., 1., 1.}}}));
  add(FE_ArcBeam({{0, {Point<3>(), 2., 1., 2., 2.}}, {1, {Point<3>(), 3., 0., 1., 1.}}}));
  for (const bool torsion : {false, true}) {
    add(FE_FrictionBeam(Rotations::none, torsion));
    add(FE_FrictionBeam(Rotations::averaged, torsion));
    add(FE_FrictionBeam(Rotations::first_node, torsion));
    add(FE_FrictionBeam(Rotations::second_node, torsion));
  }
  add(FE_Nothing<1, 3>(FE_Line::n_line_components));
  return all;
}

const auto elements = all_elements();
constexpr unsigned int n_elements = 13;

/// Cells from one vertex (number 0) outwards, the i-th with the element collection[cells[i]].
struct Star {
  Triangulation<1, 3> triangulation;
  hp::FECollection<1, 3> fes;
  DoFHandler<1, 3> dofs{triangulation};

  /// @param collection the elements' numbers in their order in the collection
  Star(const std::vector<unsigned int> &collection, const std::vector<unsigned int> &cells) {
    for (const unsigned int e : collection)
      fes.push_back(*elements[e]);
    std::vector<Point<3>> vertices(1);
    std::vector<LineCell> lines;
    for (unsigned int i = 0; i < cells.size(); ++i) {
      vertices.emplace_back(std::cos(0.9 * i), std::sin(0.9 * i), 0.1 * i);
      lines.push_back({{{0, i + 1}}, cells[i]});
      if (i % 2 == 1)
        std::swap(lines.back().vertices[0], lines.back().vertices[1]);
    }
    create_line_triangulation(vertices, lines, triangulation);
    distribute();
  }

  void distribute() {
    for (const auto &cell : dofs.active_cell_iterators())
      cell->set_active_fe_index(cell->material_id());
    dofs.distribute_dofs(fes);
  }

  /// At every vertex: the unknowns of the largest element there, each once, used by all.
  void check() const {
    std::vector<std::vector<types::global_dof_index>> at(triangulation.n_vertices());
    for (const bool compare : {false, true})
      for (const auto &cell : dofs.active_cell_iterators()) {
        const unsigned int n = cell->get_fe().n_dofs_per_vertex();
        std::vector<types::global_dof_index> indices(2 * n);
        cell->get_dof_indices(indices);
        for (const unsigned int v : {0, 1}) {
          auto &known = at[cell->vertex_index(v)];
          const std::vector<types::global_dof_index> own(indices.begin() + n * v,
                                                         indices.begin() + n * (v + 1));
          if (!compare && n > known.size())
            known = own;
          if (compare)
            CHECK(std::equal(own.begin(), own.end(), known.begin()));
        }
      }
    std::set<types::global_dof_index> all;
    unsigned int n = 0;
    for (const auto &known : at) {
      all.insert(known.begin(), known.end());
      n += known.size();
    }
    CHECK(all.size() == n);
    CHECK(dofs.n_dofs() == n);
  }
};

/// Every set of @p size elements at one vertex, in every order of the collection, the cells in the
/// order of the list.
void every_set(const unsigned int size) {
  std::vector<bool> chosen(n_elements, false);
  std::fill(chosen.end() - size, chosen.end(), true);
  do {
    std::vector<unsigned int> collection, cells(size);
    for (unsigned int e = 0; e < n_elements; ++e)
      if (chosen[e])
        collection.push_back(e);
    std::iota(cells.begin(), cells.end(), 0);
    do
      Star(collection, cells).check();
    while (std::next_permutation(collection.begin(), collection.end()));
  } while (std::next_permutation(chosen.begin(), chosen.end()));
}

/// Any cells of the whole collection in any order, then with straight cells refined, once and in
/// one place more: the vertex then joins cells of different levels.
void random_stars(const unsigned int n) {
  std::mt19937 random(4);
  std::vector<unsigned int> collection(n_elements);
  std::iota(collection.begin(), collection.end(), 0);
  for (unsigned int i = 0; i < n; ++i) {
    std::shuffle(collection.begin(), collection.end(), random);
    std::vector<unsigned int> cells(2 + random() % 6);
    for (unsigned int &cell : cells)
      cell = random() % n_elements;
    Star star(collection, cells);
    star.check();
    for (unsigned int time = 0; time < 2; ++time) {
      bool any = false;
      for (const auto &cell : star.triangulation.active_cell_iterators())
        if (dynamic_cast<const FE_ArcBeam *>(&star.fes[cell->material_id()]) == nullptr &&
            random() % 2 == 0) {
          cell->set_refine_flag();
          any = true;
        }
      if (!any)
        continue;
      star.triangulation.execute_coarsening_and_refinement();
      star.distribute();
      star.check();
    }
  }
}

/// A quarter ring, clamped, and a straight run on from its end, a support of three unknowns without
/// forces at the place where they meet: under a moment M at the tip about the ring's axis the end
/// of the ring turns by M (R pi/2)/EI, the tip by M L/EI more.
void moment_past_a_support(const std::vector<unsigned int> &place) {
  const double R = 2., L = 3., EI = 1.3, M = 0.7;
  const Rigidities section({300., 0., 0., 0.9, EI, EI});
  const ArcData ring{Point<3>(), 300., 0., 0.9, EI};
  Triangulation<1, 3> triangulation;
  create_line_triangulation({{R, 0, 0}, {0, R, 0}, {-L, R, 0}, {0, R, -1}},
                            {{{{0, 1}}, 0}, {{{1, 2}}, 1}, {{{1, 3}}, 2}}, triangulation);
  const FE_ArcBeam arc({{0, ring}});
  const FE_TimoshenkoBeam beam;
  const FE_FrictionBeam friction;
  const std::array<const FiniteElement<1, 3> *, 3> of_material = {{&arc, &beam, &friction}};
  hp::FECollection<1, 3> fes;
  for (unsigned int i = 0; i < 3; ++i)
    fes.push_back(*of_material[std::find(place.begin(), place.end(), i) - place.begin()]);
  DoFHandler<1, 3> dofs(triangulation);
  for (const auto &cell : dofs.active_cell_iterators())
    cell->set_active_fe_index(place[cell->material_id()]);
  dofs.distribute_dofs(fes);
  CHECK(dofs.n_dofs() == 3 * 6 + 3);

  FullMatrix<double> K(dofs.n_dofs(), dofs.n_dofs());
  for (const auto &cell : dofs.active_cell_iterators()) {
    if (cell->material_id() == 2)
      continue;
    std::vector<types::global_dof_index> indices(12);
    cell->get_dof_indices(indices);
    const auto local = cell->material_id() == 0
                           ? ArcBeam(cell->vertex(0), cell->vertex(1), ring).stiffness()
                           : stiffness(cell, section, 2);
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int j = 0; j < 12; ++j)
        K(indices[i], indices[j]) += local(i, j);
  }
  const VertexDofs vertex_dofs(dofs);
  AffineConstraints<double> held;
  vertex_dofs.constrain(0, {{true, true, true, true, true, true}}, held);
  vertex_dofs.constrain(3, {{true, true, true}}, held);
  held.close();
  Vector<double> load(dofs.n_dofs());
  load[vertex_dofs.index(2, 5)] = M;
  const auto u = solve(K, load, held);
  CHECK_NEAR(u[vertex_dofs.index(1, 5)], M * R * numbers::PI_2 / EI, 1e-12);
  CHECK_NEAR(u[vertex_dofs.index(2, 5)], M * (R * numbers::PI_2 + L) / EI, 1e-12);
}

} // namespace

int shared_vertices(int, char **) {
  for (const unsigned int size : {2, 3, 4})
    every_set(size);
  random_stars(1000);
  std::vector<unsigned int> place = {0, 1, 2};
  do
    moment_past_a_support(place);
  while (std::next_permutation(place.begin(), place.end()));
  return check::report();
}
