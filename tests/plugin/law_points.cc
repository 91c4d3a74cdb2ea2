// LawPointData shall keep a line's states: an increment that is rolled back leaves no trace, an
// archive goes on where it was written, laws see rates and fail by a status. Newton's first iterate
// takes the elastic tangent: what rests on contacts alone has no other. References: closed forms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>

#include <sstream>

using namespace host;

namespace {

const double L = 1.7;

/// A bar along x of two cells, held at its first end.
Line bar(const LineMaterial &material) {
  return Line({{0, 0, 0}, {0.6, 0, 0}, {L, 0, 0}}, {{{{0, 1}}, 0}, {{{1, 2}}, 0}},
              hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility})), {{0, material}});
}

Vector<double> pull(const Line &line, const double force) {
  Vector<double> load = line.no_load();
  load[line.dof(2, 0)] = force;
  return load;
}

LineMaterial hardening() {
  return {plastic({{"Yield force", 1.}, {"Force of hardening", 4.}, {"Rate of hardening", 20.}})};
}

double stretch(const double force, const double largest_force) {
  return L * (force / EA - std::log(1. - (largest_force - 1.) / 4.) / 20.);
}

/// Pulled to 2 N, tried at 4 N and given up, then to 3 N: as if nothing had been tried.
void roll_back() {
  Line line = bar(hardening());
  line.hold(0);
  line.close();
  line.newton(pull(line, 2.));
  CHECK_NEAR(line.at(2, 0), stretch(2., 2.), 1e-10);
  const Vector<double> before(line.u);
  const auto cell = line.dof_handler.begin_active();
  const double plastic_strain = line.points.committed(cell)[0].internal_variables[0];
  for (unsigned int i = 0; i < 3; ++i) {
    line.u *= 1.4;
    Vector<double> residual = line.no_load();
    CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, line.constraints, line.points,
                        residual) == LawStatus::ok);
  }
  CHECK(line.points.trial(cell)[0].internal_variables[0] > 1.1 * plastic_strain);
  CHECK(line.points.committed(cell)[0].internal_variables[0] == plastic_strain);
  line.points.roll_back();
  CHECK(line.points.trial(cell)[0].internal_variables[0] == plastic_strain);
  line.u = before;
  line.newton(pull(line, 3.));
  CHECK_NEAR(line.at(2, 0), stretch(3., 3.), 1e-10);
  line.newton(pull(line, -1.));
  CHECK_NEAR(line.at(2, 0), stretch(-1., 3.), 1e-10);
}

/// What another object reads from an archive goes on in the same way.
void archive() {
  Line line = bar(hardening());
  line.hold(0);
  line.close(3);
  line.newton(pull(line, 2.5));
  std::stringstream text;
  {
    boost::archive::text_oarchive out(text);
    const LawPointData &points = line.points;
    out << points << line.u;
  }
  line.newton(pull(line, 0.5));
  const double expected = line.at(2, 0);
  CHECK_NEAR(expected, stretch(0.5, 2.5), 1e-10);

  Line other = bar(hardening());
  other.hold(0);
  other.close();
  {
    boost::archive::text_iarchive in(text);
    in >> other.points >> other.u;
  }
  CHECK(other.points.n_points() == 3);
  other.newton(pull(other, 0.5));
  CHECK(other.at(2, 0) == expected);
}

/// A dashpot beside the bar: N = EA eps + c (eps - eps_old)/h, by implicit steps.
void rates() {
  const double c = 7., h = 0.2, F = 0.9;
  Line line = bar({plastic({{"Damping", c}})});
  line.hold(0);
  line.close();
  LineIncrement increment;
  double strain = 0.;
  for (unsigned int step = 1; step <= 4; ++step) {
    increment.time = h * step;
    increment.length = h;
    CHECK(line.newton(pull(line, F), increment).size() <= 3);
    strain = (F + c / h * strain) / (EA + c / h);
    CHECK_NEAR(line.at(2, 0), L * strain, 1e-11);
  }
}

/// A law without an answer is a status, and the increment is repeated from the committed states.
void no_answer() {
  Line line = bar({plastic({{"Largest strain", 0.01}})});
  line.hold(0);
  line.close();
  line.newton(pull(line, 2.));
  const Vector<double> before(line.u);
  line.u *= 2.;
  Vector<double> residual = line.no_load();
  CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, line.constraints, line.points,
                      residual) == LawStatus::failed);
  CHECK(assemble_line(line.dof_handler, line.materials, line.u, {}, line.constraints, line.points,
                      line.K, residual) == LawStatus::failed);
  line.points.roll_back();
  line.u = before;
  CHECK(line.newton(pull(line, 2.5)).size() == 2);
}

/// A beam that nothing holds but two friction elements below its ends: no consistent tangent at
/// rest, but an elastic one; then pushed along until both slip.
void on_contacts_alone() {
  const double l = 0.1, ES = 50., GS = 20., f = 0.4, P = 3.;
  const BoundLaw coulomb =
      law("coulomb", {{"Axial rigidity", ES}, {"Shear rigidity", GS}, {"Friction coefficient", f}});
  Line line({{0, 0, 0}, {L, 0, 0}, {0, 0, -l}, {L, 0, -l}},
            {{{{0, 1}}, 0}, {{{0, 2}}, 1}, {{{1, 3}}, 1}},
            hp::FECollection<1, 3>(FE_TimoshenkoBeam({shear_flexibility}), FE_FrictionBeam()),
            {{0, {elastic()}}, {1, {coulomb}}});
  line.hold(2);
  line.hold(3);
  line.hold(0, {{false, false, false, true, false, false}}); // it does not roll about its axis
  line.close();
  Vector<double> load = line.no_load();
  load[line.dof(0, 2)] = load[line.dof(1, 2)] = -P;

  LineIncrement increment; // consistent
  Vector<double> residual(load);
  CHECK(assemble_line(line.dof_handler, line.materials, line.u, increment, line.constraints,
                      line.points, line.K, residual) == LawStatus::ok);
  Vector<double> slide = line.no_load();
  slide[line.dof(0, 2)] = slide[line.dof(1, 2)] = 1.;
  CHECK(line.K.matrix_norm_square(slide) == 0.); // nothing carries it

  CHECK(line.newton(load, {}, 1e-11).size() <= 4);
  CHECK_NEAR(line.at(0, 2), -P * l / ES, 1e-10);
  CHECK_NEAR(line.at(1, 2), -P * l / ES, 1e-10);
  const double T = 0.9 * f * P; // along y at either end: it sticks
  load[line.dof(0, 1)] = load[line.dof(1, 1)] = T;
  CHECK(line.newton(load, {}, 1e-11).size() <= 4);
  CHECK_NEAR(line.at(1, 1), T * l / GS, 1e-9);
  for (const auto &cell : line.dof_handler.active_cell_iterators())
    if (cell->material_id() == 1) {
      CHECK(line.points.committed(cell)[0].contact == ContactStatus::stick);
      CHECK_NEAR(line.points.committed(cell)[0].stress[0], -P, 1e-9);
    }
}

void messages() {
  Line line = bar({elastic()});
  line.close();
  const auto assemble = [&](const LineMaterials &materials, LawPointData &points) {
    return message_of([&]() {
      Vector<double> residual = line.no_load();
      (void)assemble_line(line.dof_handler, materials, line.u, {}, line.constraints, points,
                          residual);
    });
  };
  CHECK(says(assemble({{3, {elastic()}}}, line.points), "a cell of material id 0"));
  CHECK(says(assemble({{3, {elastic()}}}, line.points), "have a LineMaterial: 3"));
  CHECK(says(assemble({{0, {}}}, line.points), "material 0 without a law"));
  CHECK(says(assemble({{0, {law("coulomb", {})}}}, line.points), "allowed: kind 'section'"));
  CHECK(says(assemble({{0, hardening()}}, line.points), "made for these laws"));
  line.triangulation.refine_global(1);
  line.distribute();
  CHECK(says(assemble(line.materials, line.points), "states of the points of 2 cells"));
  CHECK(says(message_of([&]() {
               LawPointData fresh(line.dof_handler, line.materials);
               LineIncrement increment;
               increment.tangent = LawTangent::none;
               Vector<double> residual = line.no_load();
               (void)assemble_line(line.dof_handler, line.materials, line.u, increment,
                                   line.constraints, fresh, line.K, residual);
             }),
             "asks for no tangent"));
  std::string message;
  try {
    law("coulomb", {{"Friction coefficient", -1.}});
  } catch (const std::runtime_error &error) {
    message = error.what();
  }
  CHECK(says(message, "read:    -1 for 'Friction coefficient'"));
}

/// Elements made of the materials have the numbers of their laws.
void numbers_of_sections() {
  const LineMaterials materials = {{1, {elastic()}}, {2, {law("coulomb", {})}}, {4, {elastic()}}};
  const std::vector<double> flexibilities = shear_flexibilities(materials);
  CHECK(flexibilities.size() == 5);
  for (const unsigned int id : {0, 2, 3})
    CHECK(flexibilities[id] == 0.);
  for (const unsigned int id : {1, 4})
    CHECK_NEAR(flexibilities[id], shear_flexibility, 1e-14 * shear_flexibility);
  const ArcData arc = arc_data(materials.at(1), Point<3>(1., 2., 3.));
  CHECK(arc.centre == Point<3>(1., 2., 3.));
  CHECK(arc.EA == EA && arc.GA == GA && arc.GJ == GJ && arc.EI == EI);
  CHECK(says(message_of([&]() { arc_data(materials.at(2), {}); }), "kind 'section'"));
}

} // namespace

int law_points(int, char **) {
  deal_II_exceptions::disable_abort_on_exception();
  roll_back();
  archive();
  rates();
  no_answer();
  on_contacts_alone();
  numbers_of_sections();
  messages();
  return check::report();
}
