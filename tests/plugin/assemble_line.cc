// assemble_line() shall give a host the closed forms: the Timoshenko cantilever, heated bars and
// arcs, bars and beams that yield (with quadratic convergence, and elastic unloading), the mass and
// the frequency of a beam; with any of the elements, alone, in a collection, beside a temperature.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/meshworker/mesh_loop.h>

using namespace host;

namespace {

const double L = 1.7;
const Tensor<1, 3> skew({2. / 3, -1. / 3, 2. / 3});

std::vector<Point<3>> points_along(const Tensor<1, 3> &direction, const unsigned int n_cells) {
  std::vector<Point<3>> vertices;
  for (unsigned int v = 0; v <= n_cells; ++v)
    vertices.emplace_back(Point<3>(0.3, -0.2, 0.1) + L * v / n_cells * direction);
  return vertices;
}

std::vector<LineCell> chain(const unsigned int n_cells) {
  std::vector<LineCell> cells;
  for (unsigned int c = 0; c < n_cells; ++c)
    cells.push_back({{{c, c + 1}}, 0});
  return cells;
}

/// One cell under a force across its tip, F L^3/(3 EI) + F L/GA, as it stands in any program.
void cantilever() {
  const FE_TimoshenkoBeam beam({shear_flexibility});
  const FE_Q<1, 3> q(1);
  std::vector<hp::FECollection<1, 3>> collections;
  collections.emplace_back(beam);
  collections.emplace_back(beam, FE_FrictionBeam());
  collections.emplace_back(FESystem<1, 3>(beam, 1, q, 1));
  collections.emplace_back(FESystem<1, 3>(q, 2, beam, 1));
  const LocalAxes axes(skew);
  for (const auto &fes : collections) {
    Line line(points_along(skew, 1), chain(1), fes, {{0, {elastic()}}});
    const unsigned int n_others = fes.n_components() - 6;
    line.hold(0);
    for (unsigned int v = 0; v < 2; ++v)
      for (unsigned int i = 0; i < n_others; ++i)
        line.constraints.add_line(line.dof(v, 6 + i));
    line.close();
    CHECK(line.dof_handler.n_dofs() == 12 + 2 * n_others);
    Vector<double> load = line.no_load();
    const double F = 0.3, M = 0.2, N = 5.;
    for (unsigned int d = 0; d < 3; ++d) {
      load[line.dof(1, d)] = F * axes.y[d] + N * axes.x[d];
      load[line.dof(1, 3 + d)] = M * axes.x[d];
    }
    const auto norms = line.newton(load);
    CHECK(norms.size() == 2); // linear
    CHECK_NEAR(line.at(1) * axes.y, F * (L * L * L / 3 / EI + L / GA), 1e-12);
    CHECK_NEAR(line.at(1) * axes.x, N * L / EA, 1e-12);
    double twist = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      twist += line.at(1, 3 + d) * axes.x[d];
    CHECK_NEAR(twist, M * L / GJ, 1e-12);

    // The elastic stiffness by itself is the same matrix, and solves at once.
    SparseMatrix<double> K(line.pattern);
    assemble_line_stiffness(line.dof_handler, line.materials, line.constraints, K);
    K.add(-1., line.K);
    CHECK_NEAR(K.frobenius_norm() / line.K.frobenius_norm(), 0., 1e-14);

    // Without constraints the residual has what the clamp answers, with the opposite sign.
    AffineConstraints<double> none;
    none.close();
    Vector<double> residual = line.no_load();
    CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, none, line.points,
                        residual) == LawStatus::ok);
    for (unsigned int d = 0; d < 3; ++d) {
      CHECK_NEAR(residual[line.dof(0, d)], F * axes.y[d] + N * axes.x[d], 1e-11);
      CHECK_NEAR(residual[line.dof(1, d)], -F * axes.y[d] - N * axes.x[d], 1e-11);
    }
  }
}

LineIncrement heated(const GeneralizedStrain &free) {
  LineIncrement increment;
  increment.free_strain = [free](const auto &, const auto &) { return free; };
  return increment;
}

/// Held at both ends N = -EA alpha T, free u = alpha T x; a free curvature bends a cantilever to
/// kappa L^2/2 without stress; an arc that is warmed all over grows like a picture.
void free_strains() {
  const double warm = 1e-3;
  const FE_TimoshenkoBeam beam({shear_flexibility});
  const LocalAxes axes(skew);
  for (const bool held : {true, false}) {
    Line bar(points_along(skew, 3), chain(3), hp::FECollection<1, 3>(beam), {{0, {elastic()}}});
    bar.hold(0);
    if (held)
      bar.hold(3);
    bar.close();
    CHECK(bar.newton(bar.no_load(), heated(GeneralizedStrain({warm, 0., 0., 0., 0., 0.}))).size() <=
          2);
    for (const auto &cell : bar.dof_handler.active_cell_iterators())
      for (const LawPoint &point : bar.points.committed(cell))
        CHECK_NEAR(point.stress[0] / EA / warm, held ? -1. : 0., 1e-12);
    for (unsigned int v = 0; v <= 3; ++v)
      CHECK_NEAR((bar.at(v) - (held ? 0. : warm * L * v / 3) * skew).norm() / warm / L, 0., 1e-12);
  }
  const double kappa = 2e-2;
  Line bent(points_along(skew, 1), chain(1), hp::FECollection<1, 3>(beam), {{0, {elastic()}}});
  bent.hold(0);
  bent.close();
  bent.newton(bent.no_load(), heated(GeneralizedStrain({0., 0., 0., 0., 0., kappa})));
  CHECK_NEAR(bent.at(1) * axes.y, kappa * L * L / 2., 1e-12);
  for (const LawPoint &point : bent.points.committed(bent.dof_handler.begin_active()))
    CHECK_NEAR(point.stress.norm(), 0., 1e-13);

  const Point<3> begin(2, 0, 0), end(0, 2, 0);
  Line arc({begin, end}, chain(1),
           hp::FECollection<1, 3>(FE_ArcBeam({{0, {Point<3>(), EA, GA, GJ, EI}}})),
           {{0, {elastic()}}});
  arc.hold(0);
  arc.close();
  arc.newton(arc.no_load(), heated(GeneralizedStrain({warm, 0., 0., 0., 0., 0.})));
  CHECK_NEAR((arc.at(1) - warm * (end - begin)).norm() / warm, 0., 1e-10);
  CHECK_NEAR(arc.at(1, 5) / warm, 0., 1e-10);
}

/// The arc's stiffness by its law is the closed one.
void arc_stiffness() {
  const Point<3> begin(2, 0, 0), end(0, 2, 0);
  const ArcData data{Point<3>(), EA, GA, GJ, EI};
  Line line({begin, end}, chain(1), hp::FECollection<1, 3>(FE_ArcBeam({{0, data}})),
            {{0, {elastic(), 3.}}});
  line.close();
  assemble_line_stiffness(line.dof_handler, line.materials, line.constraints, line.K);
  const FullMatrix<double> closed = ArcBeam(begin, end, data).stiffness();
  double difference = 0.;
  for (unsigned int i = 0; i < 12; ++i)
    for (unsigned int j = 0; j < 12; ++j)
      difference = std::max(difference, std::abs(closed(i, j) - line.K.el(i, j)));
  CHECK_NEAR(difference / closed.linfty_norm(), 0., 1e-12);
  // Its mass is that of its length along the arc.
  SparseMatrix<double> mass(line.pattern);
  assemble_line_mass(line.dof_handler, line.materials, line.constraints, mass);
  Vector<double> moved = line.no_load();
  moved[line.dof(0, 1)] = moved[line.dof(1, 1)] = 1.;
  CHECK_NEAR(mass.matrix_norm_square(moved), 3. * 2. * numbers::PI / 2., 1e-10);
}

/// The order of convergence seen in the last three norms above rounding.
double order(const std::vector<double> &norms, const double scale) {
  constexpr double rounding = 1e-12; // 6e-14 to 1e-13 by the BLAS that is there
  double last = 0.;
  for (unsigned int k = 2; k < norms.size(); ++k)
    if (norms[k] > rounding * scale && norms[k - 1] < 0.1 * scale)
      last = std::log(norms[k] / norms[k - 1]) / std::log(norms[k - 1] / norms[k - 2]);
  return last;
}

/// Three bars in a row, pulled by F beyond their yield forces and let go: each has stretched by
/// F/EA + p with F = y + Q (1 - exp(-b p)), and keeps p.
void yielding_bars() {
  const double F = 3., Q = 4., b = 20.;
  const std::vector<double> y = {1., 1.5, 2.};
  LineMaterials materials;
  hp::FECollection<1, 3> fes;
  std::vector<LineCell> cells;
  double stretched = 0., kept = 0.;
  for (unsigned int i = 0; i < 3; ++i) {
    materials[i] = {
        plastic({{"Yield force", y[i]}, {"Force of hardening", Q}, {"Rate of hardening", b}})};
    fes.push_back(FE_TimoshenkoBeam({shear_flexibility, shear_flexibility, shear_flexibility}));
    cells.push_back({{{i, i + 1}}, i});
    const double p = -std::log(1. - (F - y[i]) / Q) / b;
    stretched += L / 3 * (F / EA + p);
    kept += L / 3 * p;
  }
  Line line(points_along(skew, 3), cells, fes, materials);
  line.hold(0);
  line.close();
  Vector<double> load = line.no_load();
  for (unsigned int d = 0; d < 3; ++d)
    load[line.dof(3, d)] = F * skew[d];
  const auto norms = line.newton(load);
  std::cout << "bars: residuals";
  for (const double norm : norms)
    std::cout << ' ' << norm;
  std::cout << ", order " << order(norms, F) << '\n';
  CHECK(order(norms, F) > 1.8);
  CHECK_NEAR(line.at(3) * skew, stretched, 1e-10);
  const auto cell = line.dof_handler.begin_active();
  CHECK(line.points.committed(cell)[0].dissipation > 0.);

  // Let go: the elastic tangent of the first iterate is right at once.
  CHECK(line.newton(line.no_load()).size() == 2);
  CHECK_NEAR(line.at(3) * skew, kept, 1e-10);
  CHECK_NEAR(line.points.committed(cell)[0].stress[0], 0., 1e-12);
}

/// A cantilever whose root yields: quadratic convergence with several points a cell, and what comes
/// back when it is let go is elastic, F L^3/(3 EI) + F L/GA.
void yielding_beam() {
  const double F = 0.5;
  const LocalAxes axes(skew);
  Line line(points_along(skew, 4), chain(4),
            hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})),
            {{0,
              {plastic({{"Yield moment", 0.6 * F * L},
                        {"Moment of hardening", F * L},
                        {"Rate of hardening", 0.7}})}}});
  line.hold(0);
  line.close(3);
  Vector<double> load = line.no_load();
  for (unsigned int d = 0; d < 3; ++d)
    load[line.dof(4, d)] = F * axes.y[d];
  const auto norms = line.newton(load);
  std::cout << "beam: residuals";
  for (const double norm : norms)
    std::cout << ' ' << norm;
  std::cout << ", order " << order(norms, F) << '\n';
  CHECK(order(norms, F) > 1.8);
  const double loaded = line.at(4) * axes.y, spring = L * L * L / 3 / EI + L / GA;
  CHECK(loaded > 1.1 * F * spring);
  CHECK(line.newton(line.no_load()).size() == 2);
  CHECK_NEAR(loaded - line.at(4) * axes.y, F * spring, 1e-10);
}

/// A rigid body's mass is m L, and a cantilever's frequency is 1.8751^2 sqrt(EI/(m L^4)), the error
/// falling with the fourth power of the cells' length. Rotary inertia of a spinning bar is 2 rho I
/// L.
void mass_and_frequency() {
  const double m = 2.5, root = 1.875104068711961;
  std::vector<double> error;
  for (const unsigned int n : {2u, 4u}) {
    Line line(points_along(skew, n), chain(n), hp::FECollection<1, 3>(FE_TimoshenkoBeam()),
              {{0, {elastic(), m, 0.3}}});
    line.close();
    SparseMatrix<double> M(line.pattern);
    assemble_line_mass(line.dof_handler, line.materials, line.constraints, M);
    Vector<double> moved = line.no_load(), spun = line.no_load();
    for (unsigned int v = 0; v <= n; ++v)
      for (unsigned int d = 0; d < 3; ++d) {
        moved[line.dof(v, d)] = skew[d];
        spun[line.dof(v, 3 + d)] = skew[d];
      }
    CHECK_NEAR(M.matrix_norm_square(moved), m * L, 1e-12);
    CHECK_NEAR(M.matrix_norm_square(spun), 2. * 0.3 * L, 1e-12);

    line.materials[0].rotary_inertia = 0.;
    line.distribute();
    line.hold(0);
    line.close();
    SparseMatrix<double> mass(line.pattern);
    assemble_line_stiffness(line.dof_handler, line.materials, line.constraints, line.K);
    assemble_line_mass(line.dof_handler, line.materials, line.constraints, mass);
    SparseDirectUMFPACK inverse;
    inverse.initialize(line.K);
    Vector<double> x(line.no_load()), y(x);
    for (unsigned int d = 0; d < 3; ++d)
      x[line.dof(n, d)] = LocalAxes(skew).y[d];
    for (unsigned int k = 0; k < 60; ++k) { // inverse iteration
      mass.vmult(y, x);
      line.constraints.set_zero(y);
      inverse.vmult(x, y);
      line.constraints.set_zero(x);
      x /= x.linfty_norm();
    }
    const double omega = std::sqrt(line.K.matrix_norm_square(x) / mass.matrix_norm_square(x));
    error.push_back(omega / (root * root * std::sqrt(EI / m) / L / L) - 1.);
  }
  std::cout << "frequency: errors " << error[0] << ' ' << error[1] << '\n';
  CHECK(error[0] > 0. && error[0] < 1e-3);
  CHECK(error[0] / error[1] > 14. && error[0] / error[1] < 18.);
}

/// MeshWorker on several threads gives the same matrix and vector.
void mesh_worker() {
  const unsigned int n = 12;
  Line line(points_along(skew, n), chain(n),
            hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})),
            {{0, {plastic({{"Yield force", 1.}, {"Force of hardening", 5.}})}}});
  line.hold(0);
  line.close();
  for (unsigned int i = 0; i < line.u.size(); ++i)
    line.u[i] = 0.01 * std::sin(1. + i);
  LineIncrement increment;
  Vector<double> residual = line.no_load(), other = line.no_load();
  CHECK(assemble_line(line.dof_handler, line.materials, line.u, increment, line.constraints,
                      line.points, line.K, residual) == LawStatus::ok);
  SparseMatrix<double> K(line.pattern);
  LawPointData points(line.dof_handler, line.materials);
  struct Copy {
    FullMatrix<double> tangent;
    Vector<double> residual;
    std::vector<types::global_dof_index> dofs;
    LawStatus status = LawStatus::ok;
  };
  const auto worker = [&](const LineCellIterator &cell, LineValues &values, Copy &copy) {
    values.reinit(cell);
    copy.dofs.resize(values.n_dofs());
    cell->get_dof_indices(copy.dofs);
    std::vector<double> dof_values;
    for (const auto dof : copy.dofs)
      dof_values.push_back(line.u[dof]);
    copy.status = assemble_line_cell(values, cell, line.materials, dof_values, increment, points,
                                     copy.tangent, copy.residual);
  };
  const auto copier = [&](const Copy &copy) {
    CHECK(copy.status == LawStatus::ok);
    line.constraints.distribute_local_to_global(copy.tangent, copy.residual, copy.dofs, K, other);
  };
  MeshWorker::mesh_loop(line.dof_handler.active_cell_iterators(), worker, copier,
                        LineValues(line.fes), Copy(), MeshWorker::assemble_own_cells);
  K.add(-1., line.K);
  other -= residual;
  CHECK(K.frobenius_norm() == 0.);
  CHECK(other.l2_norm() == 0.);
}

} // namespace

int assemble_line(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  cantilever();
  free_strains();
  arc_stiffness();
  yielding_bars();
  yielding_beam();
  mass_and_frequency();
  mesh_worker();
  return check::report();
}
