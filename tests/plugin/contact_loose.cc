// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that nothing but contacts hold, found by a fresh user: forces that contacts make among
// themselves are no answer, what can be held is not said to have no equilibrium, and what does not
// fit is refused.
#include "../check.h"

#include <frictionbeam/contact/local_solver.h>
#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace frictionbeam;
using Vector = contact::Vector;
using contact::Vector3;

namespace {

LawLibrary laws;

contact::Contact on_wall(const Vector3 &normal, const double friction, const double gap = 0.) {
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = friction;
  contact::Contact wall = contact::on_ground({0, 1, 2}, normal, law, parameters);
  wall.gap = gap;
  return wall;
}

contact::SparseMatrix stiffness(const double k) {
  contact::SparseMatrix matrix(3, 3);
  for (int i = 0; i < 3; ++i)
    matrix.insert(i, i) = k;
  return matrix;
}

contact::Report push(const std::vector<contact::Contact> &walls, const Vector &load) {
  contact::Solver solver(contact::system_of(stiffness(0.)), walls);
  const contact::ContactMemory before = solver.initial_memory();
  contact::ContactMemory after = before;
  Vector u = Vector::Zero(3);
  return solver.solve(load, before, u, after);
}

/// Between a floor and a ceiling that recedes, pushed along beyond friction.
void walls_that_press_on_each_other() {
  const contact::Report report =
      push({on_wall({0., 0., -1.}, 0.3), on_wall({std::sin(0.1), 0., std::cos(0.1)}, 0.3, 0.1)},
           Vector3(-50., 0., -100.));
  CHECK(!report.converged);
}

/// What has an upright spring under it and is free sideways is held by friction, as far as a push
/// is below what friction bears, in any direction; above, nothing holds it.
void an_upright_spring() {
  constexpr double mu = 0.5, weight = 100.;
  const auto pushed = [&](const double k, const double x, const double y) {
    contact::SparseMatrix matrix(3, 3);
    matrix.insert(2, 2) = k;
    contact::Solver solver(contact::system_of(matrix), {on_wall({0., 0., -1.}, mu)});
    contact::ContactMemory memory = solver.initial_memory();
    Vector u = Vector::Zero(3);
    return solver.solve(Vector3(x, y, -weight), memory, u, memory);
  };
  // Some in 1,000 directions have led Newton's method by an iterate that would slide away.
  CHECK(pushed(357586.0651460221, 19.31724253918361, -0.8979223241432805).converged);
  CHECK(pushed(1e5, -1.430208925839705, 13.675415987400477).converged);
  std::minstd_rand random;
  std::uniform_real_distribution<double> part(0.01, 0.99), turn(0., 6.283), exponent(1., 6.);
  for (unsigned int i = 0; i < 3000; ++i) {
    const double k = std::pow(10., exponent(random)), angle = turn(random),
                 held = part(random) * mu * weight, x = std::cos(angle), y = std::sin(angle);
    CHECK(pushed(k, held * x, held * y).converged);
    const double beyond = 2. * mu * weight - held;
    CHECK(i % 10 > 0 || pushed(k, beyond * x, beyond * y).no_equilibrium);
  }
}

/// Loads that are the sum of forces inside the cones, at no motion: an equilibrium there is.
void what_can_be_held() {
  const Vector3 down(0., 0., -1.);
  for (const double angle : {0.3, 0.8, 1.3, 2.5})
    for (const double mu : {0.2, 0.5, 0.8})
      for (const double part : {-0.9, 0., 0.6}) {
        const Vector3 side(std::sin(angle), 0., -std::cos(angle)),
            along_side(std::cos(angle), 0., std::sin(angle));
        const Vector3 forces = 40. * (-down + part * mu * Vector3(1., 0., 0.)) +
                               25. * (-side - part * mu * along_side);
        const contact::Report report = push({on_wall(down, mu), on_wall(side, mu)}, -forces);
        CHECK(!report.no_equilibrium);
        if (report.converged)
          CHECK((report.contacts[0].force + report.contacts[1].force - forces).norm() < 1e-8);
      }
  const contact::Report pushed = push({on_wall(down, 0.5)}, Vector3(60., 0., -100.));
  CHECK(pushed.no_equilibrium); // beyond friction
  const Vector &w = pushed.free_motion;
  CHECK(w.size() == 3 && 60. * w[0] - 100. * w[2] > 0.);     // the loads do work on it
  CHECK(w[2] >= (1. - 1e-3) * 0.5 * std::hypot(w[0], w[1])); // and no friction takes it
}

/// What neither a stiffness nor a contact holds moves freely, beside a body that is held.
void what_nothing_holds() {
  contact::SparseMatrix K(4, 4);
  for (int i = 0; i < 3; ++i)
    K.insert(i, i) = 1e3;
  contact::Solver solver(contact::system_of(K), {on_wall({0., 0., -1.}, 0.3)});
  const contact::ContactMemory before = solver.initial_memory();
  contact::ContactMemory after = before;
  Vector u, loads(4);
  loads << 1., 0., -100., 1.;
  const contact::Report pushed = solver.solve(loads, before, u, after);
  CHECK(pushed.no_equilibrium && pushed.free_motion.size() == 4);
  if (pushed.no_equilibrium)
    CHECK(pushed.free_motion[3] > 1e9 * pushed.free_motion.head(3).norm());
  loads[3] = 0.;
  CHECK(solver.solve(loads, before, u, after).converged);
}

template <typename Act>
bool is_refused(const Act &act) {
  try {
    act();
  } catch (const std::invalid_argument &) {
    return true;
  }
  return false;
}

void what_does_not_fit() {
  contact::Solver solver(contact::system_of(stiffness(1e3)), {on_wall({0., 0., -1.}, 0.3)});
  const contact::ContactMemory whole = solver.initial_memory();
  const auto with = [&](const auto &spoil) {
    contact::ContactMemory memory = whole, after = whole;
    spoil(memory);
    Vector u = Vector::Zero(3);
    return is_refused([&]() { solver.solve(Vector3(0., 0., -1.), memory, u, after); });
  };
  CHECK(!with([](contact::ContactMemory &) {}));
  CHECK(with([](contact::ContactMemory &memory) { memory.sites.internal.clear(); }));
  CHECK(with([](contact::ContactMemory &memory) { memory.sites.wear.clear(); }));
  CHECK(with([](contact::ContactMemory &memory) { memory.sites.touch.clear(); }));

  // Friction that grows when slip begins is none.
  CHECK(is_refused([]() {
    const LawDescription &law = laws.find("coulomb");
    std::vector<double> parameters = default_parameters(law);
    parameters[parameter_index(law, "Friction coefficient")] = 0.3;
    parameters[parameter_index(law, "Dynamic friction coefficient")] = 0.4;
    contact::Solver(contact::system_of(stiffness(1e3)),
                    {contact::on_ground({0, 1, 2}, {0., 0., -1.}, law, parameters)});
  }));

  // A point has three translations at most, each another dof; rows by hand may name one twice.
  const LawDescription &law = laws.find("coulomb");
  for (const std::vector<unsigned int> &dofs :
       {std::vector<unsigned int>{0, 1, 2, 3, 4, 5}, std::vector<unsigned int>{0, 1, 1}}) {
    CHECK(is_refused([&]() {
      contact::on_ground(dofs, {0., 0., -1.}, law, default_parameters(law));
    }));
    CHECK(is_refused([&]() {
      contact::between({0, 1, 2}, dofs, {0., 0., -1.}, law, default_parameters(law));
    }));
  }
  contact::System by_hand = contact::system_of(stiffness(1e3));
  by_hand.condense = {};
  CHECK(is_refused([&]() { contact::Solver(by_hand, {on_wall({0., 0., -1.}, 0.3)}); }));

  contact::LocalProblem local;
  local.W = stiffness(1.);
  local.q = Vector3(-1., 0., 0.);
  local.friction = Vector::Constant(1, 0.3);
  const auto is_local_refused = [](const contact::LocalProblem &problem) {
    return is_refused([&]() { contact::solve_local_contact(problem, 1e-10); });
  };
  CHECK(!is_local_refused(local) && contact::solve_local_contact(local, 1e-10).converged);
  contact::LocalProblem wrong = local;
  wrong.friction = Vector::Constant(2, 0.3);
  CHECK(is_local_refused(wrong));
  wrong = local;
  wrong.q = Vector::Zero(2);
  CHECK(is_local_refused(wrong));
  wrong = local;
  wrong.dimension = 4;
  CHECK(is_local_refused(wrong));
  wrong = local;
  wrong.W.coeffRef(0, 1) = 0.5;
  CHECK(is_local_refused(wrong));
}

/// A plane block of bars on three points of a floor, pushed along it. Without friction nothing
/// holds it, and it moves so far in a trial that rounding is all that its bars say.
void a_block_on_ice() {
  const auto at = [](const int column, const int row) { return 2 * (2 * column + row); };
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(12, 12);
  const auto bar = [&](const int i, const int j, const int k, const int l) {
    const Eigen::Vector2d way(k - i, l - j);
    Vector b = Vector::Zero(12);
    b.segment<2>(at(i, j)) = -way.normalized();
    b.segment<2>(at(k, l)) = way.normalized();
    K += 1e6 / way.norm() * b * b.transpose();
  };
  std::vector<contact::Contact> floor;
  const LawDescription &law = laws.find("coulomb");
  Vector f = Vector::Zero(12);
  for (int i = 0; i < 3; ++i) {
    bar(i, 0, i, 1);
    for (int j = 0; j < 2 && i < 2; ++j) {
      bar(i, j, i + 1, j);
      bar(i, j, i + 1, 1 - j);
    }
    const unsigned int dof = at(i, 0);
    floor.push_back(contact::on_ground({dof, dof + 1}, {0., -1., 0.}, law,
                                       law_parameters(law, {{"Friction coefficient", 0.}})));
    f[at(i, 1) + 1] = -100. / 3.;
  }
  contact::Solver solver(contact::system_of(contact::SparseMatrix(K.sparseView())), floor);
  contact::ContactMemory memory = solver.initial_memory();
  Vector u;
  const contact::Report pressed = solver.solve(f, memory, u, memory);
  CHECK(pressed.converged);
  f[0] = 1.;
  const contact::Report pushed = solver.solve(f, memory, u, memory);
  CHECK(pushed.no_equilibrium && pushed.remark.find("slides away") != std::string::npos);
  const Vector w = pushed.free_motion / pushed.free_motion.lpNorm<Eigen::Infinity>();
  for (int dof = 0; dof < w.size(); ++dof)
    CHECK_NEAR(w[dof], dof % 2 == 0 ? 1. : 0., 1e-6);
}

/// A point without stiffness between two walls at an angle a to the vertical: pressed in with 1 N,
/// pulled with 0.1 N. Where the cones of both contain each other's foot, f > tan a, forces of the
/// walls on each other can hold any pull.
void a_wedge_that_jams() {
  for (const double degrees : {10., 30., 45.}) {
    const double a = degrees * std::acos(-1.) / 180., s = std::sin(a), c = std::cos(a);
    for (const double times : {0.5, 0.9, 1.05, 1.3, 2., 2.9}) {
      contact::Solver solver(
          contact::system_of(stiffness(0.)),
          {on_wall({-c, -s, 0.}, times * std::tan(a)), on_wall({c, -s, 0.}, times * std::tan(a))});
      contact::ContactMemory memory = solver.initial_memory();
      Vector u;
      CHECK(solver.solve(Vector3(0., -1., 0.), memory, u, memory).converged);
      const contact::Report pulled = solver.solve(Vector3(0., 0.1, 0.), memory, u, memory);
      CHECK(times > 1. ? pulled.converged : pulled.no_equilibrium);
      if (pulled.converged)
        CHECK_NEAR(pulled.contacts[0].force[1] + pulled.contacts[1].force[1], -0.1, 1e-9);
    }
  }
}

/// Why there is no answer, in words that are so.
void what_is_said() {
  const auto says = [](const contact::Report &report, const std::string &words) {
    return !report.converged && report.remark.find(words) != std::string::npos;
  };
  const std::vector<contact::Contact> floor = {on_wall({0., 0., -1.}, 0.3)};
  CHECK(says(push(floor, Vector3(31., 0., -100.)), "slides away"));
  CHECK(says(push(floor, Vector3(0., 0., 1.)), "lifts off"));
  CHECK(says(push(floor, Vector3(1., 0., 1.)), "lifts off"));
  CHECK(says(push({on_wall({0., 0., -1.}, 0.3, -1e-3), on_wall({0., 0., 1.}, 0.3, -1e-3)},
                  Vector3(0., 0., -1.)),
             "contacts 0 and 1 (counted from 0) are rigid, face each other and overlap"));
}

/// The memory before may be the one after.
void memory_in_place() {
  contact::Solver solver(contact::system_of(stiffness(1e3)), {on_wall({0., 0., -1.}, 0.3)});
  contact::ContactMemory in_place = solver.initial_memory(), before = in_place, after = before;
  Vector u, v;
  for (int i = 1; i <= 3; ++i, before = after) { // 100 N slide by 10 mm each time
    const Vector f = Vector3(30. + 10. * i, 0., -100.);
    CHECK(solver.solve(f, in_place, u, in_place).converged);
    CHECK(solver.solve(f, before, v, after).converged);
    CHECK_NEAR(in_place.sites.wear[0], 1. * i, 1e-8);
    CHECK_NEAR(after.sites.wear[0], 1. * i, 1e-8);
  }
}

/// What is no number, or not as long as there are contacts, is refused where it comes in.
void what_is_no_number() {
  const auto none = {std::nan(""), HUGE_VAL};
  const std::vector<contact::Contact> contacts = {on_wall({0., 0., -1.}, 0.3)};
  contact::Solver solver(contact::system_of(stiffness(1e3)), contacts);
  const contact::ContactMemory memory = solver.initial_memory();
  const auto is_refused_at = [&](const Vector &f, const Vector &at,
                                 const contact::Increment &increment) {
    Vector u = at;
    contact::ContactMemory after = memory;
    return is_refused([&]() { solver.solve(f, memory, u, after, increment); });
  };
  const Vector f = Vector3(0., 0., -1.), u = Vector::Zero(3);
  CHECK(!is_refused_at(f, u, {1., 1., {20.}}));
  CHECK(is_refused_at(f, u, {1., -1.}) && is_refused_at(f, u, {1., 1., {20., 20.}}));
  for (const double x : none) {
    const Vector wrong = Vector3(0., x, 0.);
    CHECK(is_refused_at(wrong, u, {}) && is_refused_at(f, wrong, {}));
    CHECK(is_refused_at(f, u, {x}) && is_refused_at(f, u, {0., x}));
    CHECK(is_refused_at(f, u, {0., 0., {x}}));
    CHECK(is_refused([&]() { solver.initial_memory(wrong); }));
    CHECK(is_refused([&]() { solver.move_ground({wrong}); }));
    Vector v = u;
    CHECK(is_refused([&]() { solver.strike(wrong, {true}, 0., v); }));
    v = wrong;
    CHECK(is_refused([&]() { solver.strike(f, {true}, 0., v); }));
    CHECK(is_refused([&]() { contact::system_of(stiffness(x)); }));
  }
  for (const double tolerance : {std::nan(""), -1., 0., 1e3}) {
    const auto with = [&](const contact::Settings &settings) {
      contact::Solver(contact::system_of(stiffness(1e3)), contacts, settings);
    };
    CHECK(is_refused([&]() { with({tolerance, 1e-8}); }));
    CHECK(is_refused([&]() { with({1e-10, tolerance}); }));
  }
}

/// A law is bound to as many parameters as it has, within their bounds.
void bound_laws() {
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  CHECK(!is_refused([&]() { BoundLaw(law, parameters); }));
  CHECK(is_refused([&]() { BoundLaw(law, {}); }));
  for (const double x : {std::nan(""), -1.}) {
    parameters[parameter_index(law, "Friction coefficient")] = x;
    CHECK(is_refused([&]() { BoundLaw(law, parameters); }));
  }
}

} // namespace

int main() {
  laws.load_builtin();
  walls_that_press_on_each_other();
  an_upright_spring();
  what_can_be_held();
  what_nothing_holds();
  what_does_not_fit();
  a_block_on_ice();
  a_wedge_that_jams();
  what_is_said();
  memory_in_place();
  what_is_no_number();
  bound_laws();
  return check::report();
}
