// Where an arc, a straight beam and a friction element meet, a host's program shall find their
// unknowns and forces right whatever the order of its collection, beside a temperature, too; a
// collection that shares nothing is refused; names tell elements apart. References: closed forms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <numeric>

using namespace host;

namespace {

const double R = 2., L = 3., l = 0.1, ES = 50., GS = 20., f = 0.3;

/// A quarter ring clamped at its beginning, a straight run from its end, a support below the place
/// where they meet; a moment M about the ring's axis and a weight P at the meeting place.
struct Bend : Line {
  /// @param temperature where an FE_Q stands in an FESystem: nowhere, before, or behind the line
  Bend(const std::vector<unsigned int> &place, const int temperature)
      : Line({{R, 0, 0}, {0, R, 0}, {-L, R, 0}, {0, R, -l}},
             {{{{0, 1}}, place[0]}, {{{1, 2}}, place[1]}, {{{1, 3}}, place[2]}},
             collection(place, temperature),
             {{place[0], {elastic()}},
              {place[1], {elastic()}},
              {place[2],
               {law("coulomb", {{"Axial rigidity", ES},
                                {"Shear rigidity", GS},
                                {"Friction coefficient", f}})}}}) {
    hold(0);
    hold(3, {{true, true, true, false, false, false}});
    if (temperature != 0)
      for (unsigned int v = 0; v < 4; ++v)
        constraints.add_line(dof(v, 6));
    close();
  }

  static hp::FECollection<1, 3> collection(const std::vector<unsigned int> &place,
                                           const int temperature) {
    std::map<unsigned int, ArcData> arcs = {{place[0], {Point<3>(), EA, GA, GJ, EI}}};
    const FE_ArcBeam arc(arcs);
    const FE_TimoshenkoBeam beam(std::vector<double>(3, shear_flexibility));
    const FE_FrictionBeam friction;
    const std::array<const FiniteElement<1, 3> *, 3> elements = {{&arc, &beam, &friction}};
    const FE_Q<1, 3> q(1);
    hp::FECollection<1, 3> fes;
    for (unsigned int i = 0; i < 3; ++i) {
      const FiniteElement<1, 3> &fe =
          *elements[std::find(place.begin(), place.end(), i) - place.begin()];
      if (temperature == 0)
        fes.push_back(fe);
      else if (temperature < 0)
        fes.push_back(FESystem<1, 3>(q, 1, fe, 1));
      else
        fes.push_back(FESystem<1, 3>(fe, 1, q, 1));
    }
    return fes;
  }
};

void meeting(const std::vector<unsigned int> &place, const int temperature) {
  const double M = 0.05, P = 0.6;
  Bend line(place, temperature);
  CHECK(line.dof_handler.n_dofs() == 3 * 6 + 3 + (temperature == 0 ? 0 : 4));
  Vector<double> load = line.no_load();
  // Pressed only: the bend's stiffness across its plane shares the load with the support.
  load[line.dof(1, 2)] = -P;
  CHECK(line.newton(load, {}, 1e-12).size() <= 4);
  const double w = -line.at(1, 2);
  double N = 0., T = 0.;
  const auto look = [&]() {
    for (const auto &cell : line.dof_handler.active_cell_iterators())
      if (cell->material_id() == place[2]) {
        const LawPoint &point = line.points.committed(cell)[0];
        N = point.stress[0];
        T = std::hypot(point.stress[1], point.stress[2]);
      }
  };
  look();
  // Of a quarter ring under a force across its plane at its end (Castigliano): pi/4 R^3 (1/EI +
  // 1/GJ) - R^3 (2 - pi/2...) by its own stiffness, which tests/plugin/arc.cc holds against it.
  const ArcBeam arc(Point<3>(R, 0, 0), Point<3>(0, R, 0), {Point<3>(), EA, GA, GJ, EI});
  const FullMatrix<double> K = arc.stiffness();
  FullMatrix<double> end(6, 6);
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      end(i, j) = K(6 + i, 6 + j);
  end.gauss_jordan();
  CHECK_NEAR(w, P / (ES / l + 1. / end(2, 2)), 1e-8);
  CHECK_NEAR(N, -ES / l * w, 1e-9);
  CHECK_NEAR(T, 0., 1e-10);

  // A moment at the tip passes the support; the support's friction holds the place back.
  load[line.dof(2, 5)] = M;
  CHECK(line.newton(load, {}, 1e-12).size() <= 8);
  look();
  CHECK(T > 0.01 * f * -N && T <= f * -N * (1. + 1e-12));
  CHECK_NEAR(line.at(2, 5) - line.at(1, 5), M * L / EI, 1e-9);
  // The ring's end under the moment and the friction force that the support's law tells.
  Vector<double> force(6), moved(6);
  Vector<double> residual = line.no_load();
  AffineConstraints<double> none;
  none.close();
  LawPointData points(line.points);
  CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, none, points, residual) ==
        LawStatus::ok);
  for (unsigned int d = 0; d < 3; ++d) // the ground's reaction is what the support gives the bend
    force[d] = -residual[line.dof(3, d)];
  force[2] -= P;
  force[5] = M;
  end.vmult(moved, force);
  for (unsigned int c = 0; c < 6; ++c)
    CHECK_NEAR(line.at(1, c) - moved[c], 0., 1e-9);
}

/// Elements are joined to the one that dominates: FE_Nothing has no unknown to share.
void shares_nothing() {
  const FE_Nothing<1, 3> dominating(6, true);
  const FE_TimoshenkoBeam beam, other({0.3});
  const auto look = [&](const hp::FECollection<1, 3> &fes, const unsigned int nothing) {
    Triangulation<1, 3> triangulation;
    create_line_triangulation(
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
        {{{{0, 1}}, nothing == 0}, {{{1, 2}}, nothing == 0 ? 2u : 1u}, {{{1, 3}}, nothing}},
        triangulation);
    DoFHandler<1, 3> dof_handler(triangulation);
    for (const auto &cell : dof_handler.active_cell_iterators())
      cell->set_active_fe_index(cell->material_id());
    dof_handler.distribute_dofs(fes);
    return message_of([&]() { VertexDofs vertex_dofs(dof_handler); }) + message_of([&]() {
             LawPointData points(dof_handler,
                                 {{0, {elastic()}}, {1, {elastic()}}, {2, {elastic()}}});
           });
  };
  const std::string message = look(hp::FECollection<1, 3>(dominating, beam, other), 0);
  CHECK(says(message, "meet in vertex 1"));
  CHECK(says(message, "FE_Nothing behind the lines"));
  CHECK(look(hp::FECollection<1, 3>(beam, other, dominating), 2).empty());
  CHECK(look(hp::FECollection<1, 3>(FE_Nothing<1, 3>(6), beam, other), 0).empty());
}

/// Unknowns beside the line's, before and behind them.
void vertex_dofs() {
  const FE_TimoshenkoBeam beam;
  for (const bool before : {true, false}) {
    Triangulation<1, 3> triangulation;
    create_line_triangulation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{{{0, 1}}, 0}, {{{1, 2}}, 0}},
                              triangulation);
    DoFHandler<1, 3> dof_handler(triangulation);
    const FE_Q<1, 3> q(2);
    const FESystem<1, 3> fe =
        before ? FESystem<1, 3>(q, 2, beam, 1) : FESystem<1, 3>(beam, 1, q, 2);
    dof_handler.distribute_dofs(fe);
    const VertexDofs vertex_dofs(dof_handler);
    AffineConstraints<double> constraints;
    vertex_dofs.constrain(1, all, constraints, {{1., 2., 3., 4., 5., 6.}});
    CHECK(constraints.n_constraints() == 6);
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int v : {0, 1})
        for (unsigned int i = 0; i < 8; ++i) {
          const unsigned int line = before ? i - 2 : i;
          const bool is_line = before ? i >= 2 : i < 6;
          const unsigned int component = is_line ? line : before ? 6 + i : i;
          CHECK(vertex_dofs.index(cell->vertex_index(v), component) ==
                cell->vertex_dof_index(v, i));
          if (is_line && cell->vertex_index(v) == 1)
            CHECK(constraints.get_inhomogeneity(cell->vertex_dof_index(v, i)) == 1. + line);
        }
  }
  // Two lines, or a system of systems, are not understood.
  const auto look = [](const FiniteElement<1, 3> &fe) {
    return message_of([&]() { line_part(fe); });
  };
  const FE_Q<1, 3> q(1);
  CHECK(says(look(FESystem<1, 3>(beam, 2)), "one line in an FESystem"));
  CHECK(says(look(FESystem<1, 3>(beam, 1, FE_FrictionBeam(), 1)), "one line in an FESystem"));
  CHECK(says(look(FESystem<1, 3>(FESystem<1, 3>(beam, 1, q, 1), 1, q, 1)), "one FESystem of all"));
  CHECK(look(beam).empty() && look(q).empty() && look(FESystem<1, 3>(q, 3)).empty());
}

void names() {
  std::vector<std::unique_ptr<FiniteElement<1, 3>>> elements;
  const auto add = [&](const FiniteElement<1, 3> &fe) { elements.push_back(fe.clone()); };
  add(FE_TimoshenkoBeam());
  add(FE_TimoshenkoBeam({0.3}));
  add(FE_TimoshenkoBeam({0.3, 0.1}));
  add(FE_TimoshenkoBeam({0.3 * (1. + 1e-15)}));
  add(FE_ArcBeam({{0, {Point<3>(), 1., 0., 1., 1.}}}));
  add(FE_ArcBeam({{0, {Point<3>(), 1., 2., 1., 1.}}}));
  add(FE_ArcBeam({{1, {Point<3>(), 1., 2., 1., 1.}}}));
  add(FE_FrictionBeam());
  for (const auto &one : elements)
    for (const auto &other : elements) {
      CHECK((one->get_name() == other->get_name()) == (one == other));
      CHECK((*one == *other) == (one == other));
    }
  CHECK(elements[2]->get_name() == FE_TimoshenkoBeam({0.3, 0.1}).get_name());
}

} // namespace

int line_meeting(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  std::vector<unsigned int> place = {0, 1, 2};
  do
    for (const int temperature : {0, -1, 1})
      meeting(place, temperature);
  while (std::next_permutation(place.begin(), place.end()));
  shares_nothing();
  vertex_dofs();
  names();
  return check::report();
}
