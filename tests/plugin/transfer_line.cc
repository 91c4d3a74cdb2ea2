// transfer_line_solution() shall carry over exactly what the elements can represent, whatever is
// refined and coarsened: rigid motions, stretch and twist, bending with shear; a law's states, and
// what else an FESystem has. What it cannot do, and what deal.II would do wrong silently, is
// refused. SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <frictionbeam/line/transfer_line_solution.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/numerics/solution_transfer.h>
#include <deal.II/numerics/vector_tools.h>

#include <random>

using namespace host;

namespace {

const Tensor<1, 3> skew({2. / 3, -1. / 3, 2. / 3});
const double L = 1.7;

/// A cantilever of two cells of different section, and a tip load of every kind.
struct Cantilever : Line {
  Cantilever()
      : Line({Point<3>(), Point<3>(0.6 * skew), Point<3>(L * skew)}, {{{{0, 1}}, 0}, {{{1, 2}}, 1}},
             hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility, 0.3}),
                                    FE_TimoshenkoBeam({shear_flexibility, 0.3})),
             {{0, {elastic()}},
              {1,
               {law("elastic_section", {{"Axial rigidity", 90.},
                                        {"Shear rigidity", 12. * 0.5 / 0.3},
                                        {"Torsional rigidity", 0.4},
                                        {"Bending rigidity", 0.5}})}}}) {}

  void solve() {
    distribute();
    hold(0);
    close();
    Vector<double> load = no_load();
    const double tip[6] = {0.3, -0.2, 0.5, 0.1, 0.2, -0.15};
    for (unsigned int c = 0; c < 6; ++c)
      load[dof(2, c)] = tip[c];
    newton(load, {}, 1e-10);
  }

  /// Flags by chance: refine anything or, now and then, coarsen all that can be.
  void flag(std::mt19937 &random) {
    const bool coarsen = random() % 3 == 0;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (coarsen)
        cell->set_coarsen_flag();
      else if (random() % 2 == 0 && cell->level() < 4)
        cell->set_refine_flag();
  }
};

/// The solution of a cantilever is exact on any mesh, so the transferred one is the one that is
/// solved for anew.
void bending() {
  Cantilever line;
  line.solve();
  std::mt19937 random(3);
  double scale = line.u.linfty_norm();
  unsigned int most = 0, fewer = 0;
  for (unsigned int round = 0; round < 20; ++round) {
    const unsigned int before = line.triangulation.n_active_cells();
    line.flag(random);
    Vector<double> twice(line.u);
    twice *= 2.;
    transfer_line_solution(line.triangulation, line.dof_handler, {&line.u, &twice}, &line.points);
    Vector<double> carried(line.u);
    line.solve();
    carried -= line.u;
    CHECK_NEAR(carried.linfty_norm() / scale, 0., 1e-11);
    twice.add(-2., line.u);
    CHECK_NEAR(twice.linfty_norm() / scale, 0., 1e-11);
    most = std::max(most, line.triangulation.n_active_cells());
    fewer += line.triangulation.n_active_cells() < before;
  }
  std::cout << "up to " << most << " cells, coarsened " << fewer << " times\n";
  CHECK(most > 8 && fewer > 2);
}

/// Rigid motion u = a + w x p, rotation w, at every vertex.
void rigid_motion() {
  Cantilever line;
  const Tensor<1, 3> a({0.3, -0.4, 0.2}), w({0.2, 0.5, -0.1});
  const auto rigid = [&]() {
    Vector<double> values = line.no_load();
    for (unsigned int v = 0; v < line.triangulation.n_vertices(); ++v)
      if (line.triangulation.vertex_used(v))
        for (unsigned int d = 0; d < 3; ++d) {
          values[line.dof(v, d)] =
              (a + cross_product_3d(w, Tensor<1, 3>(line.triangulation.get_vertices()[v])))[d];
          values[line.dof(v, 3 + d)] = w[d];
        }
    return values;
  };
  std::mt19937 random(5);
  line.u = rigid();
  for (unsigned int round = 0; round < 20; ++round) {
    line.flag(random);
    transfer_line_solution(line.triangulation, line.dof_handler, {&line.u});
    Vector<double> expected = rigid();
    expected -= line.u;
    CHECK_NEAR(expected.linfty_norm(), 0., 1e-13);
  }
}

/// A bar in an FESystem with a quadratic temperature: both go over, temperatures of order two by
/// their own matrices; and the states of a law that has yielded: the bar is pulled on as if nothing
/// had been refined.
void system_and_states() {
  const double F = 2.5, Q = 4., b = 20.;
  const FESystem<1, 3> fe(FE_Q<1, 3>(2), 1, FE_TimoshenkoBeam({shear_flexibility}), 1);
  Line line(
      {{0, 0, 0}, {L, 0, 0}}, {{{{0, 1}}, 0}}, hp::FECollection<1, 3>(fe),
      {{0, {plastic({{"Yield force", 1.}, {"Force of hardening", Q}, {"Rate of hardening", b}})}}});
  const auto temperature = [](const Point<3> &p) { return 3. + 2. * p[0] - p[0] * p[0]; };
  const auto for_each_temperature = [&](const auto &function) {
    const Quadrature<1> nodes(std::vector<Point<1>>{Point<1>(0.), Point<1>(1.), Point<1>(0.5)});
    for (const auto &cell : line.dof_handler.active_cell_iterators()) {
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (fe.system_to_base_index(i).first.first == 0) {
          const double xi = nodes.point(fe.system_to_base_index(i).second)[0];
          function(dofs[i], Point<3>(cell->vertex(0) + xi * (cell->vertex(1) - cell->vertex(0))));
        }
    }
  };
  const auto prepare = [&]() {
    line.constraints.clear();
    line.hold(0);
    for_each_temperature([&](const auto dof, const auto &) { line.constraints.add_line(dof); });
    line.constraints.close();
  };
  const auto pull = [&](const double force) {
    Vector<double> load = line.no_load();
    load[line.dof(1, 0)] = force;
    return load;
  };
  prepare();
  line.close();
  line.newton(pull(F));
  for_each_temperature(
      [&](const auto dof, const auto &point) { line.u[dof] = temperature(point); });
  for (unsigned int round = 0; round < 3; ++round) {
    // Refine the first cell each time, at last coarsen what can be.
    for (const auto &cell : line.dof_handler.active_cell_iterators())
      if (round == 2)
        cell->set_coarsen_flag();
      else if (cell->center()[0] < L / 2 || round == 0)
        cell->set_refine_flag();
    transfer_line_solution(line.triangulation, line.dof_handler, {&line.u}, &line.points);
    CHECK(line.triangulation.n_active_cells() == (round == 1 ? 3 : 2));
    for_each_temperature([&](const auto dof, const auto &point) {
      CHECK_NEAR(line.u[dof], temperature(point), 1e-13);
    });
    // The residual of what has been carried over is zero, without an iteration.
    line.constraints.clear();
    prepare();
    Vector<double> residual = pull(F);
    LawPointData points(line.points);
    CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, line.constraints, points,
                        residual) == LawStatus::ok);
    line.constraints.set_zero(residual);
    CHECK_NEAR(residual.l2_norm(), 0., 1e-11);
    for (const auto &cell : line.dof_handler.active_cell_iterators())
      for (const LawPoint &point : line.points.committed(cell))
        CHECK_NEAR(point.internal_variables[0], -std::log(1. - (F - 1.) / Q) / b, 1e-10);
  }
}

/// A support beside the beam keeps its cell, its state and its displacement.
void beside_a_support() {
  const BoundLaw coulomb = law("coulomb", {{"Axial rigidity", 50.}, {"Shear rigidity", 20.}});
  Line line({{0, 0, 0}, {L, 0, 0}, {L, 0, -0.1}}, {{{{0, 1}}, 0}, {{{1, 2}}, 1}},
            hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility}), FE_FrictionBeam()),
            {{0, {elastic()}}, {1, {coulomb}}});
  line.hold(0);
  line.hold(2);
  line.close();
  Vector<double> load = line.no_load();
  load[line.dof(1, 2)] = -3.;
  line.newton(load);
  const double before = line.at(1, 2);
  double N = 0.;
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    if (cell->material_id() == 1)
      N = line.points.committed(cell)[0].stress[0];
  CHECK(N < -0.1);

  line.triangulation.set_all_refine_flags();
  const std::string message = message_of(
      [&]() { transfer_line_solution(line.triangulation, line.dof_handler, {&line.u}); });
  CHECK(says(message, "of material id 1") && says(message, "clear_refine_flag()"));
  CHECK(line.triangulation.n_active_cells() == 2);
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    if (cell->material_id() == 1)
      cell->clear_refine_flag();
  transfer_line_solution(line.triangulation, line.dof_handler, {&line.u}, &line.points);
  CHECK(line.triangulation.n_active_cells() == 3);
  CHECK_NEAR(line.at(1, 2), before, 1e-15);
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    if (cell->material_id() == 1)
      CHECK(line.points.committed(cell)[0].stress[0] == N);
}

/// What deal.II's own means would do silently, and bends.
void refusals() {
  Cantilever line;
  line.triangulation.set_all_refine_flags();
  line.triangulation.prepare_coarsening_and_refinement();
  SolutionTransfer<1, Vector<double>, 3> transfer(line.dof_handler);
  transfer.prepare_for_coarsening_and_refinement(line.u);
  line.triangulation.execute_coarsening_and_refinement();
  const Vector<double> old(line.u);
  line.distribute();
  CHECK(says(message_of([&]() { transfer.interpolate(old, line.u); }), "transfer_line_solution()"));
  // Away again.
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    cell->set_coarsen_flag();
  line.triangulation.prepare_coarsening_and_refinement();
  SolutionTransfer<1, Vector<double>, 3> back(line.dof_handler);
  CHECK(says(message_of([&]() { back.prepare_for_coarsening_and_refinement(line.u); }),
             "transfer_line_solution()"));
  const std::string interpolated = message_of([&]() {
    VectorTools::interpolate(line.dof_handler, Functions::ConstantFunction<3>(1., 6), line.u);
  });
  // In debug mode deal.II itself asserts before it comes to us.
  CHECK(interpolated.find("VertexDofs::index()") != std::string::npos ||
        interpolated.find("zero quadrature points") != std::string::npos);

  const Point<3> begin(2, 0, 0), end(0, 2, 0);
  Line arc({begin, end}, {{{{0, 1}}, 0}},
           hp::FECollection<1, 3>(FE_ArcBeam({{0, {Point<3>(), EA, GA, GJ, EI}}})),
           {{0, {elastic()}}});
  arc.triangulation.set_all_refine_flags();
  CHECK(says(
      message_of([&]() { transfer_line_solution(arc.triangulation, arc.dof_handler, {&arc.u}); }),
      "an arc"));

  Line bent({begin, end}, {{{{0, 1}}, 0}}, hp::FECollection<1, 3>(FE_TimoshenkoBeam()),
            {{0, {elastic()}}});
  const SphericalManifold<1, 3> circle{Point<3>()};
  bent.triangulation.set_manifold(7, circle);
  bent.triangulation.set_all_manifold_ids(7);
  bent.triangulation.set_all_refine_flags();
  CHECK(says(message_of([&]() {
               transfer_line_solution(bent.triangulation, bent.dof_handler, {&bent.u});
             }),
             "off the cell"));
  // A mapping that follows it gives other lengths than a straight line's; MappingQ1 does not.
  const auto on_mapping = [&](const unsigned int degree, const UpdateFlags flags) {
    return message_of([&]() {
      const MappingQ<1, 3> mapping(degree); // FEValues keep a pointer to it
      FEValues<1, 3> values(mapping, bent.fes[0], QGauss<1>(2), flags);
      values.reinit(bent.dof_handler.begin_active());
    });
  };
  for (const UpdateFlags flag : {update_JxW_values, update_quadrature_points}) {
    CHECK(says(on_mapping(3, update_values | flag), "FE_ArcBeam"));
    CHECK(on_mapping(1, update_values | flag).empty());
  }
  CHECK(message_of([&]() { bent.close(); }).empty());
}

} // namespace

int transfer_line(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  bending();
  rigid_motion();
  system_and_states();
  beside_a_support();
  refusals();
  return check::report();
}
