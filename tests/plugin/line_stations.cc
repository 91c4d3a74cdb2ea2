// Stations of one cell shall show the section forces of the textbook between its nodes: a beam
// under its own weight, clamped or simply supported, a quarter ring; with free strains and a
// friction element beside it; DataOut shall write the same. References: closed forms, below.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <frictionbeam/line/line_postprocessor.h>
#include <frictionbeam/line/line_stations.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/data_out.h>

using namespace host;

namespace {

const double L = 1.7, q = 0.8;
const std::vector<double> places = {0., 0.125, 0.3, 0.5, 0.75, 1.};

LineIncrement weight() {
  LineIncrement increment;
  increment.line_force = [](const auto &) { return Tensor<1, 3>({0., 0., -q}); };
  return increment;
}

Line beam(const hp::FECollection<1, 3> &fes) {
  return Line({{0, 0, 0}, {L, 0, 0}}, {{{{0, 1}}, 0}}, fes, {{0, {elastic()}}});
}

/// One cell along x: V_z = q (x - L), M_y = q (L - x)^2/2 at its free end; simply supported
/// V_z = q (x - L/2), M_y = -q x (L - x)/2 (sagging stretches the lower side, M_y = EI theta_y').
void uniform_load() {
  for (const bool cantilever : {true, false}) {
    Line line = beam(hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})));
    line.hold(0, cantilever ? all : std::array<bool, 6>{{true, true, true, true, false, true}});
    if (!cantilever)
      line.hold(1, {{false, true, true, true, false, true}});
    line.close();
    const LineIncrement increment = weight();
    CHECK(line.newton(line.no_load(), increment).size() == 2);
    const auto cell = line.dof_handler.begin_active();
    for (const LineStation &station : line_stations(cell, line.u, line.points, increment, places)) {
      const double x = station.s;
      CHECK_NEAR(station.point[0], x, 1e-14);
      const double V = cantilever ? q * (x - L) : q * (x - L / 2);
      const double M = cantilever ? q * (L - x) * (L - x) / 2 : -q * x * (L - x) / 2;
      CHECK_NEAR(station.force[2] / q - V / q, 0., 1e-12);
      CHECK_NEAR(station.force[4] / q, M / q, 1e-12);
      for (const unsigned int s : {0, 1, 3, 5})
        CHECK_NEAR(station.force[s], 0., 1e-13);
    }
    // The ends move as they must, and the strains are right in the mean only.
    if (cantilever)
      CHECK_NEAR(line.at(1, 2), -(q * L * L * L * L / 8 / EI + q * L * L / 2 / GA), 1e-12);
    double mean = 0.;
    const QGauss<1> gauss(2);
    const auto stations =
        line_stations(cell, line.u, line.points, increment, {gauss.point(0)[0], gauss.point(1)[0]});
    for (const LineStation &station : stations)
      mean += station.strain[4] / 2;
    CHECK_NEAR(mean, (cantilever ? q * L * L / 6 : -q * L * L / 12) / EI, 1e-12);
  }
}

/// A quarter ring in its plane, clamped at psi = 0, pulled by F along x at its free end: N, V and M
/// by hand, and under a line force, too.
void ring() {
  const double R = 2., F = 0.7;
  Line line({{R, 0, 0}, {0, R, 0}}, {{{{0, 1}}, 0}},
            hp::FECollection<1, 3>(FE_ArcBeam({{0, {Point<3>(), EA, GA, GJ, EI}}})),
            {{0, {elastic()}}});
  line.hold(0);
  line.close();
  Vector<double> load = line.no_load();
  load[line.dof(1, 0)] = F;
  for (const bool loaded : {false, true}) {
    LineIncrement increment;
    const Tensor<1, 3> p({0.1, loaded ? 0.2 : 0., 0.3});
    if (loaded)
      increment.line_force = [&](const auto &) { return p; };
    line.newton(load, increment, 1e-11);
    const auto cell = line.dof_handler.begin_active();
    for (const LineStation &station : line_stations(cell, line.u, line.points, increment, places)) {
      const double psi = station.s / R, rest = numbers::PI_2 - psi;
      const Point<3> here(R * std::cos(psi), R * std::sin(psi), 0.), end(0., R, 0.);
      CHECK_NEAR(station.point.distance(here), 0., 1e-13);
      const Tensor<1, 3> tip({F, 0., 0.});
      Tensor<1, 3> P = tip, M = cross_product_3d(end - here, tip);
      if (loaded) { // of the rest of the ring: its length, and its arms by integration
        P += R * rest * p;
        const Tensor<1, 3> arms({R * R * (1. - std::sin(psi)) - R * rest * here[0],
                                 R * R * std::cos(psi) - R * rest * here[1], 0.});
        M += cross_product_3d(arms, p);
      }
      const LocalAxes axes(Tensor<1, 3>({-std::sin(psi), std::cos(psi), 0.}));
      const GeneralizedStrain expected(
          {axes.x * P, axes.y * P, axes.z * P, axes.x * M, axes.y * M, axes.z * M});
      for (unsigned int s = 0; s < 6; ++s)
        CHECK_NEAR(station.force[s] - expected[s], 0., 1e-9);
      if (!loaded)
        CHECK_NEAR(station.strain[0] - station.force[0] / EA, 0., 1e-11);
    }
  }
}

/// Heated between two holds, with a curvature that wants to be and must not: N and M_z are
/// constant.
void free_strain() {
  Line line = beam(hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})));
  line.hold(0);
  line.hold(1);
  line.close();
  LineIncrement increment;
  increment.free_strain = [](const auto &, const auto &) {
    return GeneralizedStrain({1e-3, 0., 0., 0., 0., 2e-3});
  };
  line.newton(line.no_load(), increment);
  for (const LineStation &station :
       line_stations(line.dof_handler.begin_active(), line.u, line.points, increment, places)) {
    CHECK_NEAR(station.force[0], -EA * 1e-3, 1e-12);
    CHECK_NEAR(station.force[5], -EI * 2e-3, 1e-12);
    CHECK_NEAR(station.strain.norm(), 0., 1e-14);
    CHECK_NEAR(station.displacement.norm() + station.rotation.norm(), 0., 1e-14);
  }
}

/// What DataOut writes of a postprocessor of a line's solution.
std::string in_gnuplot(const Line &line, const DataPostprocessor<3> &postprocessor,
                       const unsigned int n_subdivisions) {
  DataOut<1, 3> data_out;
  data_out.attach_dof_handler(line.dof_handler);
  data_out.add_data_vector(line.u, postprocessor);
  data_out.build_patches(n_subdivisions);
  std::ostringstream text;
  data_out.write_gnuplot(text);
  return text.str();
}

/// What DataOut writes by the postprocessor are the stations' numbers, in a collection with a
/// friction element, and beside a temperature that comes first.
void postprocessor() {
  const FE_Q<1, 3> temperature(1);
  const FESystem<1, 3> beams(temperature, 1, FE_TimoshenkoBeam({shear_flexibility}), 1);
  const FESystem<1, 3> supports(temperature, 1, FE_FrictionBeam(), 1);
  const BoundLaw coulomb = law("coulomb", {{"Axial rigidity", 50.}, {"Shear rigidity", 20.}});
  Line line({{0, 0, 0}, {L, 0, 0}, {L, 0, -0.1}}, {{{{0, 1}}, 0}, {{{1, 2}}, 1}},
            hp::FECollection<1, 3>(beams, supports), {{0, {elastic()}}, {1, {coulomb}}});
  line.hold(0);
  line.hold(2);
  for (unsigned int v = 0; v < 3; ++v)
    line.constraints.add_line(line.dof(v, 6));
  line.close();
  const LineIncrement increment = weight();
  line.newton(line.no_load(), increment, 1e-11);

  /// Keeps what is asked of it.
  struct Keep : LinePostprocessor {
    using LinePostprocessor::LinePostprocessor;
    mutable std::vector<std::array<double, 16>> rows; // material, place, 12 quantities

    void evaluate_vector_field(const DataPostprocessorInputs::Vector<3> &inputs,
                               std::vector<Vector<double>> &quantities) const override {
      LinePostprocessor::evaluate_vector_field(inputs, quantities);
      for (unsigned int i = 0; i < quantities.size(); ++i) {
        std::array<double, 16> row{};
        row[0] = inputs.get_cell<1>()->material_id();
        for (unsigned int d = 0; d < 3; ++d)
          row[1 + d] = inputs.evaluation_points[i][d];
        for (unsigned int s = 0; s < 12; ++s)
          row[4 + s] = quantities[i][s];
        rows.push_back(row);
      }
    }
  };
  const Keep keep(line.points, increment);
  MultithreadInfo::set_thread_limit(1); // rows are kept in a vector
  const std::string text = in_gnuplot(line, keep, 4);
  MultithreadInfo::set_thread_limit();
  CHECK(text.find("kappa_z") != std::string::npos);
  CHECK(keep.rows.size() == 10);
  double largest = 0.;
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    for (const auto &row : keep.rows)
      if (row[0] == cell->material_id()) {
        const double xi = (cell->vertex(0).distance({row[1], row[2], row[3]})) / cell->diameter();
        const LineStation station =
            line_stations(cell, line.u, line.points, increment, {xi}).front();
        for (unsigned int s = 0; s < 6; ++s) {
          CHECK_NEAR(row[4 + s] - station.strain[s], 0., 1e-13);
          CHECK_NEAR(row[10 + s] - station.force[s], 0., 1e-11);
          largest = std::max(largest, std::abs(row[10 + s]));
        }
        if (row[0] == 1)
          CHECK(row[10] < -0.1); // the support is pressed
      }
  CHECK(largest > 0.3);

  // One object for all cells says the same.
  LineStations stations(line.dof_handler, line.points, increment, places);
  for (const auto &cell : line.dof_handler.active_cell_iterators()) {
    const std::vector<LineStation> all = stations.on(cell, line.u);
    CHECK(all.size() == places.size());
    for (unsigned int i = 0; i < all.size(); ++i) {
      const LineStation one =
          line_stations(cell, line.u, line.points, increment, {places[i]}).front();
      CHECK(one.s == all[i].s && one.point == all[i].point && one.strain == all[i].strain);
      CHECK(one.displacement == all[i].displacement && one.rotation == all[i].rotation);
      CHECK(one.force == all[i].force);
    }
  }
}

/// What a postprocessor keeps from cell to cell must not bind it to the dofs of one mesh.
void postprocessor_of_other_dofs() {
  Line line = beam(hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})));
  line.hold(0);
  line.close();
  const LineIncrement increment = weight();
  line.newton(line.no_load(), increment);
  const LinePostprocessor forces(line.points, increment);
  std::string first;
  for (int time = 0; time < 2; ++time) {
    const std::string text = in_gnuplot(line, forces, 2);
    CHECK(time == 0 || text == first);
    first = text;
    line.dof_handler.distribute_dofs(
        hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})));
  }
}

} // namespace

int line_stations(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  uniform_load();
  ring();
  free_strain();
  postprocessor();
  postprocessor_of_other_dofs();
  return check::report();
}
