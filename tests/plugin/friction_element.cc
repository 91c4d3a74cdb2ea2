// FE_FrictionBeam shall resist slip, normal motion and twist as its options say, and share its
// displacements with a beam in an hp collection. References: statics of the element, below.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_friction_beam.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/line_triangulation.h>

#include "../check.h"
#include "line_problem.h"

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/numerics/data_out.h>

#include <sstream>

using namespace line_problem;
using namespace frictionbeam;
using Rotations = FE_FrictionBeam::Rotations;

namespace {

/// ES, GS_y, GS_z, GJ; the element has no bending stiffness.
const Rigidities rigidities({5., 2., 3., 0.7, 0., 0.});
const double l = 0.4;
const Tensor<1, 3> skew = Tensor<1, 3>({6. / 7, 2. / 7, -3. / 7});

struct Support {
  Triangulation<1, 3> triangulation;
  DoFHandler<1, 3> dofs{triangulation};
  FE_FrictionBeam fe;
  FullMatrix<double> K;

  Support(const Rotations rotations, const bool torsion) : fe(rotations, torsion) {
    const Point<3> pipe(0.3, -0.2, 0.1);
    create_line_triangulation({pipe, pipe + l * skew}, {{{{0, 1}}, 0}}, triangulation);
    dofs.distribute_dofs(fe);
    K = stiffness(dofs.begin_active(), rigidities, 1);
  }

  /// Forces and moments (force, moment of the first vertex, then of the second) that hold the
  /// element with its first vertex moved by u and turned by theta.
  std::array<Tensor<1, 3>, 4> hold(const Tensor<1, 3> &u, const Tensor<1, 3> &theta) const {
    const unsigned int n = fe.n_dofs_per_vertex();
    Vector<double> x(2 * n), f(2 * n);
    for (unsigned int c = 0; c < n; ++c)
      x[c] = c < 3 ? u[c] : theta[c - 3];
    K.vmult(f, x);
    std::array<Tensor<1, 3>, 4> result;
    for (unsigned int node = 0; node < 2; ++node)
      for (unsigned int c = 0; c < n; ++c)
        result[2 * node + c / 3][c % 3] = f[n * node + c];
    return result;
  }
};

void check_vector(const Tensor<1, 3> &value, const Tensor<1, 3> &reference) {
  CHECK_NEAR((value - reference).norm(), 0., 1e-13);
}

/// The moment of the shear force that the options put on either end.
void moments(const Rotations rotations, const bool torsion, const double arm_1,
             const double arm_2) {
  const Support support(rotations, torsion);
  CHECK(support.fe.n_dofs_per_vertex() == (rotations == Rotations::none && !torsion ? 3u : 6u));
  const auto [x, y, z] = axes_of(support.dofs.begin_active());
  const Tensor<1, 3> none;

  const auto axial = support.hold(x, none), shear_y = support.hold(y, none),
             shear_z = support.hold(z, none);
  check_vector(axial[0], 5. / l * x);
  check_vector(axial[1], none);
  check_vector(axial[2], -5. / l * x);
  check_vector(shear_y[0], 2. / l * y);
  check_vector(shear_y[2], -2. / l * y);
  check_vector(shear_z[0], 3. / l * z);
  check_vector(shear_z[2], -3. / l * z);
  // The ground pulls the pipe back at the arm: the holding force 1 at the pipe along y turns the
  // ground's -1 at x by -z, held by +z.
  check_vector(shear_y[1], arm_1 * 2. / l * z);
  check_vector(shear_y[3], arm_2 * 2. / l * z);
  check_vector(shear_z[1], -arm_1 * 3. / l * y);
  check_vector(shear_z[3], -arm_2 * 3. / l * y);

  const auto twist = support.hold(none, x);
  check_vector(twist[0], none);
  check_vector(twist[1], torsion ? 0.7 / l * x : none);
  check_vector(twist[3], torsion ? -0.7 / l * x : none);
}

/// With rotations, a rigid motion leaves no force.
void rigid_motion(const Rotations rotations) {
  const Support support(rotations, true);
  const Tensor<1, 3> a({0.3, -1.1, 0.4}), w({-0.7, 0.2, 0.9});
  Vector<double> x(12), f(12);
  for (unsigned int node = 0; node < 2; ++node)
    for (unsigned int d = 0; d < 3; ++d) {
      x[6 * node + d] = (a + cross_product_3d(w, node * l * skew))[d];
      x[6 * node + 3 + d] = w[d];
    }
  support.K.vmult(f, x);
  CHECK_NEAR(f.l2_norm(), 0., 1e-14);
}

/// The four strains of a displaced element, one by one: u/l each, and twist/l.
void strains() {
  const Support support(Rotations::none, true);
  FEValues<1, 3> values(mapping, support.fe, QGauss<1>(1), update_values | update_gradients);
  values.reinit(Triangulation<1, 3>::cell_iterator(support.dofs.begin_active()));
  const LocalAxes axes(skew);
  const Tensor<1, 3> directions[] = {axes.x, axes.y, axes.z, axes.x};
  for (unsigned int s = 0; s < 4; ++s) {
    std::vector<double> dof_values(12, 0.);
    for (unsigned int d = 0; d < 3; ++d)
      dof_values[(s == 3 ? 9 : 6) + d] = directions[s][d];
    GeneralizedStrain exact;
    exact[s] = 1 / l;
    CHECK_NEAR((generalized_strain(values, axes, dof_values, 0) - exact).norm(), 0., 1e-14);
  }
}

/// A cantilever of two cells with a support of three dofs at its middle: spring of stiffness
/// k = ES/l, ground settled by s, tip force F. Force method, b the beam's flexibility at its
/// middle: R = k (s - w_mid), w_mid = w_F + b R, tip = w_F,tip + c R.
void beam_on_support() {
  const double a = 0.9, L = 2 * a, F = -0.2, s = 0.05, EI = 1.3, GA = 0.7, k = 5. / l;
  const Rigidities section({3., GA, GA, 0.9, EI, EI});
  Triangulation<1, 3> triangulation;
  // The user's cells, one against the walk's direction; the ground is below the pipe.
  create_line_triangulation({Point<3>(), {a, 0, 0}, {L, 0, 0}, {a, 0, -l}},
                            {{{{1, 3}}, 1}, {{{2, 1}}, 0}, {{{0, 1}}, 0}}, triangulation);
  const FE_TimoshenkoBeam beam({shear_flexibility(section)});
  const hp::FECollection<1, 3> fes(beam, FE_FrictionBeam());
  DoFHandler<1, 3> dofs(triangulation);
  for (const auto &cell : dofs.active_cell_iterators())
    cell->set_active_fe_index(cell->material_id());
  dofs.distribute_dofs(fes);
  CHECK(dofs.n_dofs() == 3 * 6 + 3);

  const VertexDofs vertex_dofs(dofs);
  for (const auto &cell : dofs.active_cell_iterators()) {
    std::vector<types::global_dof_index> indices(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(indices);
    const unsigned int n = cell->get_fe().n_dofs_per_vertex();
    for (const unsigned int v : {0, 1})
      for (unsigned int c = 0; c < n; ++c)
        CHECK(indices[n * v + c] == vertex_dofs.index(cell->vertex_index(v), c));
  }
  CHECK(vertex_dofs.index(3, 2) < dofs.n_dofs());
  CHECK(vertex_dofs.index(3, 3) == numbers::invalid_dof_index);

  AffineConstraints<double> constraints;
  vertex_dofs.constrain(0, {{true, true, true, true, true, true}}, constraints);
  // Asks for rotations that the ground does not have, and leaves uy for a second call.
  vertex_dofs.constrain(3, {{true, false, true, true, true, true}}, constraints, {{0., 9., s}});
  CHECK(constraints.n_constraints() == 8);
  CHECK(!constraints.is_constrained(vertex_dofs.index(3, 1)));
  vertex_dofs.constrain(3, {{false, true}}, constraints);
  constraints.close();
  CHECK(constraints.n_constraints() == 9);

  // Three vertices of six and two beam cells between them; ground and pipe share three by three.
  DynamicSparsityPattern pattern(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, pattern);
  CHECK(pattern.n_nonzero_elements() == 3 * 36 + 4 * 36 + 9 + 2 * 9);

  Vector<double> load(dofs.n_dofs());
  load[vertex_dofs.index(2, 2)] = F;
  const auto u = solve(assemble(dofs, {section, rigidities}), load, constraints);
  const double b = a * a * a / 3 / EI + a / GA, c = b + a * a / 2 / EI * a;
  const double R = k * (s - c * F) / (1 + k * b);
  CHECK_NEAR(u[vertex_dofs.index(1, 2)], c * F + b * R, 1e-12);
  CHECK_NEAR(u[vertex_dofs.index(2, 2)], F * (L * L * L / 3 / EI + L / GA) + c * R, 1e-12);
  CHECK_NEAR(u[vertex_dofs.index(3, 2)], s, 1e-15);

  // DataOut takes the hp handler and writes the settled ground.
  DataOut<1, 3> data_out;
  data_out.attach_dof_handler(dofs);
  data_out.add_data_vector(u, std::vector<std::string>{"ux", "uy", "uz", "rx", "ry", "rz"});
  data_out.build_patches(2);
  std::stringstream text;
  data_out.write_gnuplot(text);
  unsigned int n_ground = 0;
  for (std::string row; std::getline(text, row);) {
    std::istringstream numbers(row);
    double x, y, z, ux, uy, uz;
    if (row.empty() || row[0] == '#' || !(numbers >> x >> y >> z >> ux >> uy >> uz) || z > -0.9 * l)
      continue;
    ++n_ground;
    CHECK_NEAR(uz, s, 1e-5);
  }
  CHECK(n_ground == 1);

  // Renumbered, the tip moves as before.
  const unsigned int tip = vertex_dofs.index(2, 2);
  DoFRenumbering::Cuthill_McKee(dofs);
  const VertexDofs renumbered(dofs);
  CHECK(renumbered.index(2, 2) != tip);
  constraints.clear();
  renumbered.constrain(0, {{true, true, true, true, true, true}}, constraints);
  renumbered.constrain(3, {{true, true, true}}, constraints, {{0., 0., s}});
  constraints.close();
  load = 0.;
  load[renumbered.index(2, 2)] = F;
  const auto v = solve(assemble(dofs, {section, rigidities}), load, constraints);
  CHECK_NEAR(v[renumbered.index(2, 2)], u[tip], 1e-12);
}

} // namespace

int friction_element(int, char **) {
  for (const bool torsion : {false, true}) {
    moments(Rotations::none, torsion, 0., 0.);
    moments(Rotations::averaged, torsion, l / 2, l / 2);
    moments(Rotations::first_node, torsion, l, 0.);
    moments(Rotations::second_node, torsion, 0., l);
  }
  rigid_motion(Rotations::averaged);
  rigid_motion(Rotations::first_node);
  rigid_motion(Rotations::second_node);
  strains();
  beam_on_support();
  return check::report();
}
