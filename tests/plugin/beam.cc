// FE_TimoshenkoBeam shall give the closed forms of the Timoshenko cantilever to rounding, the
// Euler-Bernoulli mass matrix, and no strain in rigid motions. References: closed forms, below.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include "../check.h"
#include "line_problem.h"

#include <deal.II/numerics/data_out.h>

#include <sstream>

using namespace line_problem;
using namespace frictionbeam;

namespace {

const Tensor<1, 3> skew = Tensor<1, 3>({2. / 3, -1. / 3, 2. / 3});
const Rigidities section({3., 0.7, 0.7, 0.9, 1.3, 1.3});
const double length = 1.7;

/// A straight line along @p skew from an odd point, with one clamped end.
struct Cantilever {
  Triangulation<1, 3> triangulation;
  DoFHandler<1, 3> dofs{triangulation};

  Cantilever(const std::vector<double> &lengths, const FiniteElement<1, 3> &fe) {
    std::vector<Point<3>> vertices{Point<3>(0.3, -0.2, 0.1)};
    std::vector<LineCell> cells;
    for (unsigned int i = 0; i < lengths.size(); ++i) {
      vertices.push_back(vertices.back() + lengths[i] * skew);
      cells.push_back({{{i, i + 1}}, i == 2 ? 9 : i});
    }
    create_line_triangulation(vertices, cells, triangulation);
    dofs.distribute_dofs(fe);
  }
};

void check_vector(const Tensor<1, 3> &value, const Tensor<1, 3> &reference, const double scale) {
  CHECK_NEAR((value - reference).norm() / scale, 0., 1e-12);
}

/// One cell under end force, moment and torque in each direction.
void end_loads() {
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  const Cantilever line({length}, fe);
  const VertexDofs vertex_dofs(line.dofs);
  const auto K = assemble(line.dofs, {section});
  const auto [x, y, z] = axes_of(line.dofs.begin_active());
  const double L = length, EA = 3., GA = 0.7, GJ = 0.9, EI = 1.3;
  const double w_F = L * L * L / 3 / EI + L / GA, w_M = L * L / 2 / EI, t_M = L / EI;
  struct Case {
    Tensor<1, 3> force, moment, displacement, rotation;
  };
  const Tensor<1, 3> none;
  for (const Case &c : {Case{x, none, L / EA * x, none}, Case{y, none, w_F * y, w_M * z},
                        Case{z, none, w_F * z, -w_M * y}, Case{none, x, none, L / GJ * x},
                        Case{none, y, -w_M * z, t_M * y}, Case{none, z, w_M * y, t_M * z}}) {
    Vector<double> load(12);
    add_at(load, vertex_dofs, 1, 0, c.force);
    add_at(load, vertex_dofs, 1, 3, c.moment);
    const auto u = solve(K, load, clamp(vertex_dofs, 0));
    check_vector(at(u, vertex_dofs, 1, 0), c.displacement, w_F);
    check_vector(at(u, vertex_dofs, 1, 3), c.rotation, w_F);
  }
}

/// Two Gauss points integrate the stiffness exactly, one does not.
void two_gauss_points() {
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  const Cantilever line({length}, fe);
  const auto cell = line.dofs.begin_active();
  auto two = stiffness(cell, section, 2), one = stiffness(cell, section, 1);
  const auto four = stiffness(cell, section, 4);
  two.add(-1., four);
  one.add(-1., four);
  CHECK_NEAR(two.frobenius_norm() / four.frobenius_norm(), 0., 1e-14);
  CHECK(one.frobenius_norm() > 0.01 * four.frobenius_norm());
}

/// Three sections by material id 0, 1, 9, the last without shear flexibility: tip force,
/// u = F sum ((b^3 - a^3)/(3 EI) + l/GA), a and b the cell's distances from the tip.
void sections_by_material_id() {
  const Rigidities thin({1., 0.4, 0.4, 1., 0.3, 0.3}), rigid({1., 1., 1., 1., 0.8, 0.8});
  const FE_TimoshenkoBeam fe({shear_flexibility(section), shear_flexibility(thin)});
  const std::vector<double> lengths{0.5, 0.8, 1.1};
  const Cantilever line(lengths, fe);
  const VertexDofs vertex_dofs(line.dofs);
  std::vector<Rigidities> sections(10);
  sections[0] = section, sections[1] = thin, sections[9] = rigid;
  const auto [x, y, z] = axes_of(line.dofs.begin_active());
  Vector<double> load(line.dofs.n_dofs());
  add_at(load, vertex_dofs, 3, 0, z);
  const auto u = solve(assemble(line.dofs, sections), load, clamp(vertex_dofs, 0));
  const auto cube = [](const double a) { return a * a * a; };
  const double exact = (cube(2.4) - cube(1.9)) / 3 / 1.3 + 0.5 / 0.7 +
                       (cube(1.9) - cube(1.1)) / 3 / 0.3 + 0.8 / 0.4 + cube(1.1) / 3 / 0.8;
  CHECK_NEAR(at(u, vertex_dofs, 3, 0) * z, exact, 1e-12);
}

/// Uniform load q: tip q L^4/(8 EI) + q L^2/(2 GA), rotation q L^3/(6 EI), also on refined lines,
/// and displaced shape between the nodes under a tip force.
void uniform_load_and_refinement() {
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  Cantilever line({length}, fe);
  for (unsigned int round = 0; round < 3; ++round) {
    if (round == 1)
      line.triangulation.refine_global(2);
    else if (round == 2) {
      line.triangulation.begin_active()->set_refine_flag();
      line.triangulation.execute_coarsening_and_refinement();
      CHECK(line.triangulation.n_active_cells() == 5);
    }
    line.dofs.distribute_dofs(fe);
    const VertexDofs vertex_dofs(line.dofs);
    Vector<double> load(line.dofs.n_dofs());
    const auto [x, y, z] = axes_of(line.dofs.begin_active());
    FEValues<1, 3> values(mapping, fe, QGauss<1>(2), update_values | update_JxW_values);
    std::vector<types::global_dof_index> indices(12);
    for (const auto &cell : line.dofs.active_cell_iterators()) {
      values.reinit(Triangulation<1, 3>::cell_iterator(cell));
      cell->get_dof_indices(indices);
      for (unsigned int q = 0; q < 2; ++q)
        for (unsigned int i = 0; i < 12; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            load[indices[i]] += values.shape_value_component(i, q, c) * y[c] * values.JxW(q);
    }
    const auto u = solve(assemble(line.dofs, {section}), load, clamp(vertex_dofs, 0));
    const double L = length;
    check_vector(at(u, vertex_dofs, 1, 0), (std::pow(L, 4) / 8 / 1.3 + L * L / 2 / 0.7) * y, 1.);
    check_vector(at(u, vertex_dofs, 1, 3), L * L * L / 6 / 1.3 * z, 1.);
  }
}

/// With four Gauss points: total mass for any Phi, and for Phi = 0 the matrix of Euler-Bernoulli
/// beams, m L/420 [156 22L 54 -13L; .. 4L^2 13L -3L^2; .. 156 -22L; .. 4L^2].
void consistent_mass() {
  for (const double flexibility : {0., 5.}) {
    const FE_TimoshenkoBeam fe({flexibility});
    const Cantilever line({length}, fe);
    FEValues<1, 3> values(mapping, fe, QGauss<1>(4), update_values | update_JxW_values);
    values.reinit(Triangulation<1, 3>::cell_iterator(line.dofs.begin_active()));
    FullMatrix<double> M(12, 12);
    for (unsigned int q = 0; q < 4; ++q)
      for (unsigned int i = 0; i < 12; ++i)
        for (unsigned int j = 0; j < 12; ++j)
          for (unsigned int c = 0; c < 3; ++c)
            M(i, j) += values.shape_value_component(i, q, c) *
                       values.shape_value_component(j, q, c) * values.JxW(q);
    for (unsigned int d = 0; d < 3; ++d)
      CHECK_NEAR(M(d, d) + 2 * M(d, 6 + d) + M(6 + d, 6 + d), length, 1e-14);
    if (flexibility > 0.)
      continue;
    const double L = length;
    const auto [x, y, z] = axes_of(line.dofs.begin_active());
    const double exact[4][4] = {{156, 22 * L, 54, -13 * L},
                                {22 * L, 4 * L * L, 13 * L, -3 * L * L},
                                {54, 13 * L, 156, -22 * L},
                                {-13 * L, -3 * L * L, -22 * L, 4 * L * L}};
    for (const auto &[w, theta] : {std::make_pair(y, z), std::make_pair(z, -y)}) {
      std::array<Vector<double>, 4> unit;
      for (unsigned int k = 0; k < 4; ++k) {
        unit[k].reinit(12);
        for (unsigned int d = 0; d < 3; ++d)
          unit[k][3 * k + d] = k % 2 == 0 ? w[d] : theta[d];
      }
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int l = 0; l < 4; ++l)
          CHECK_NEAR(M.matrix_scalar_product(unit[k], unit[l]), L / 420 * exact[k][l], 1e-13);
    }
  }
}

/// u = a + w x r, theta = w is reproduced at every point and has no strain.
void rigid_motions() {
  for (const double flexibility : {0., 5.}) {
    const FE_TimoshenkoBeam fe({flexibility});
    const Cantilever line({length}, fe);
    const auto cell = line.dofs.begin_active();
    FEValues<1, 3> values(mapping, fe, QGauss<1>(4),
                          update_values | update_gradients | update_quadrature_points);
    values.reinit(Triangulation<1, 3>::cell_iterator(cell));
    const LocalAxes axes(skew);
    const Tensor<1, 3> a({0.3, -1.1, 0.4}), w({-0.7, 0.2, 0.9});
    const auto displacement = [&](const Point<3> &p) { return a + cross_product_3d(w, p); };
    std::vector<double> dof_values(12);
    for (unsigned int i = 0; i < 12; ++i) {
      const unsigned int node = i / 6, c = i % 6;
      dof_values[i] = c < 3 ? displacement(cell->vertex(node))[c] : w[c - 3];
    }
    for (unsigned int q = 0; q < 4; ++q) {
      CHECK_NEAR(generalized_strain(values, axes, dof_values, q).norm(), 0., 1e-14);
      for (unsigned int c = 0; c < 6; ++c) {
        double value = 0.;
        for (unsigned int i = 0; i < 12; ++i)
          value += dof_values[i] * values.shape_value_component(i, q, c);
        CHECK_NEAR(value, c < 3 ? displacement(values.quadrature_point(q))[c] : w[c - 3], 1e-13);
      }
    }
  }
}

/// Strains of all twelve functions against the matrix in local axes (Przemieniecki, section 5.6),
/// and of a tip-loaded cantilever: gamma_y = V/GA, kappa_z = V (L - s)/EI.
void strains() {
  const double phi = shear_flexibility(section) / length / length, m = 1 / (1 + phi), L = length;
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  const Cantilever line({length}, fe);
  FEValues<1, 3> values(mapping, fe, QGauss<1>(3), update_values | update_gradients);
  values.reinit(Triangulation<1, 3>::cell_iterator(line.dofs.begin_active()));
  const LocalAxes axes(skew);
  for (unsigned int q = 0; q < 3; ++q) {
    const double xi = values.get_quadrature().point(q)[0];
    for (unsigned int i = 0; i < 12; ++i) {
      const unsigned int node = i / 6, d = i % 3;
      const double sign = node == 0 ? -1. : 1.;
      const double gamma_w = sign * m * phi / L, gamma_t = -m * phi / 2;
      const double kappa_w = -sign * m * 6 / L / L * (2 * xi - 1);
      const double kappa_t = m * (node == 0 ? -4 + 6 * xi - phi : -2 + 6 * xi + phi) / L;
      GeneralizedStrain exact;
      if (i % 6 < 3) {
        exact[0] = sign / L * axes.x[d];
        exact[1] = gamma_w * axes.y[d];
        exact[2] = gamma_w * axes.z[d];
        exact[4] = -kappa_w * axes.z[d];
        exact[5] = kappa_w * axes.y[d];
      } else {
        exact[1] = gamma_t * axes.z[d];
        exact[2] = -gamma_t * axes.y[d];
        exact[3] = sign / L * axes.x[d];
        exact[4] = kappa_t * axes.y[d];
        exact[5] = kappa_t * axes.z[d];
      }
      CHECK_NEAR((generalized_strain(values, axes, i, q) - exact).norm(), 0., 1e-13);
    }
    const double V = 0.37, w = V * (L * L * L / 3 / 1.3 + L / 0.7), theta = V * L * L / 2 / 1.3;
    std::vector<double> tip(12, 0.);
    for (unsigned int d = 0; d < 3; ++d) {
      tip[6 + d] = w * axes.y[d];
      tip[9 + d] = theta * axes.z[d];
    }
    GeneralizedStrain exact;
    exact[1] = V / 0.7;
    exact[5] = V * L * (1 - xi) / 1.3;
    CHECK_NEAR((generalized_strain(values, axes, tip, q) - exact).norm(), 0., 1e-13);
  }
}

/// x along the cell, z as near to global z as can be (global x if vertical), y = z cross x.
void local_axes() {
  const Tensor<1, 3> e[3] = {Tensor<1, 3>({1., 0., 0.}), Tensor<1, 3>({0., 1., 0.}),
                             Tensor<1, 3>({0., 0., 1.})};
  const auto check = [](const Tensor<1, 3> &direction, const Tensor<1, 3> &y,
                        const Tensor<1, 3> &z) {
    const LocalAxes axes(direction);
    CHECK_NEAR((axes.x - direction / direction.norm()).norm(), 0., 1e-15);
    CHECK_NEAR((axes.y - y).norm(), 0., 1e-15);
    CHECK_NEAR((axes.z - z).norm(), 0., 1e-15);
  };
  check(e[0], e[1], e[2]);
  check(-3. * e[0], -e[1], e[2]);
  check(e[1], -e[0], e[2]);
  check(e[2], -e[1], e[0]);
  check(-2. * e[2], e[1], e[0]);
  // In the plane of x and z, 3-4-5: z leans back.
  check(Tensor<1, 3>({3., 0., 4.}), e[1], Tensor<1, 3>({-0.8, 0., 0.6}));
}

/// Frame with a tee: run along x, branch along y at its middle, force F in z at the branch's end:
/// the run's middle is moved by F a^3/(3 EI) + F a/GA, turned by F a^2/(2 EI) and F b a/GJ.
void tee() {
  const double a = 1.2, b = 0.6, F = 0.1, EI = 1.3, GA = 0.7, GJ = 0.9;
  Triangulation<1, 3> triangulation;
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  create_line_triangulation({Point<3>(), {a, 0, 0}, {2 * a, 0, 0}, {a, b, 0}},
                            {{{{3, 1}}, 0}, {{{2, 1}}, 0}, {{{0, 1}}, 0}}, triangulation);
  for (unsigned int round = 0; round < 3; ++round) {
    if (round == 1)
      triangulation.refine_global(1);
    else if (round == 2) {
      triangulation.last_active()->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
    DoFHandler<1, 3> dofs(triangulation);
    dofs.distribute_dofs(fe);
    CHECK(dofs.n_dofs() == 6 * triangulation.n_used_vertices());
    const VertexDofs vertex_dofs(dofs);
    Vector<double> load(dofs.n_dofs());
    load[vertex_dofs.index(3, 2)] = F;
    const auto u = solve(assemble(dofs, {section}), load, clamp(vertex_dofs, 0));
    const double middle = F * (a * a * a / 3 / EI + a / GA);
    CHECK_NEAR(u[vertex_dofs.index(1, 2)], middle, 1e-12);
    CHECK_NEAR(u[vertex_dofs.index(2, 2)], middle + a * F * a * a / 2 / EI, 1e-12);
    CHECK_NEAR(u[vertex_dofs.index(3, 2)],
               middle + F * b * a / GJ * b + F * (b * b * b / 3 / EI + b / GA), 1e-12);
  }
}

/// DataOut writes the displaced shape between the nodes: cantilever along x under a tip force F in
/// z, w(s) = F (L s^2/2 - s^3/6)/EI + F s/GA.
void data_out() {
  Triangulation<1, 3> triangulation;
  const double L = length, F = 0.1;
  create_line_triangulation({Point<3>(), {L, 0, 0}}, {{{{0, 1}}, 0}}, triangulation);
  DoFHandler<1, 3> dofs(triangulation);
  const FE_TimoshenkoBeam fe({shear_flexibility(section)});
  dofs.distribute_dofs(fe);
  const VertexDofs vertex_dofs(dofs);
  Vector<double> load(12);
  load[vertex_dofs.index(1, 2)] = F;
  const auto u = solve(assemble(dofs, {section}), load, clamp(vertex_dofs, 0));
  DataOut<1, 3> data_out;
  data_out.attach_dof_handler(dofs);
  data_out.add_data_vector(u, std::vector<std::string>{"ux", "uy", "uz", "rx", "ry", "rz"});
  data_out.build_patches(4);
  DataOutBase::GnuplotFlags flags;
  std::stringstream text;
  data_out.set_flags(flags);
  text.precision(12);
  data_out.write_gnuplot(text);
  unsigned int n_points = 0;
  for (std::string row; std::getline(text, row);) {
    std::istringstream numbers(row);
    double x, y, z, ux, uy, uz;
    if (row.empty() || row[0] == '#' || !(numbers >> x >> y >> z >> ux >> uy >> uz))
      continue;
    ++n_points;
    CHECK_NEAR(uz, F * (L * x * x / 2 - x * x * x / 6) / 1.3 + F * x / 0.7, 1e-5);
  }
  CHECK(n_points == 5);
}

/// A cell of length zero, shear flexibilities that are none.
void nonsense() {
  deal_II_exceptions::disable_abort_on_exception();
  const auto is_refused = [](const auto &act) {
    try {
      act();
    } catch (const ExceptionBase &) {
      return true;
    }
    return false;
  };
  for (const double s : {-1., std::nan(""), HUGE_VAL})
    CHECK(is_refused([&]() { FE_TimoshenkoBeam({0.1, s}); }));
  CHECK(!is_refused([]() { FE_TimoshenkoBeam({0.1, 0.}); }));
  const FE_TimoshenkoBeam fe;
  Cantilever line({length}, fe);
  const auto values = [&]() {
    FEValues<1, 3>(fe, QGauss<1>(2), update_values | update_gradients | update_JxW_values)
        .reinit(line.dofs.begin_active());
  };
  CHECK(!is_refused(values));
  line.triangulation.begin_active()->vertex(1) = line.triangulation.begin_active()->vertex(0);
  CHECK(is_refused(values));
}

} // namespace

int beam(int, char **) {
  end_loads();
  two_gauss_points();
  sections_by_material_id();
  uniform_load_and_refinement();
  consistent_mass();
  rigid_motions();
  strains();
  local_axes();
  tee();
  data_out();
  nonsense();
  return check::report();
}
