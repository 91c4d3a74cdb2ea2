// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact library as a host uses it: every case has its answer on paper.
#include "../check.h"

#include <frictionbeam/contact/local_solver.h>
#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <Eigen/SparseCholesky>
#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/vector.hpp>

#include <functional>
#include <random>
#include <sstream>
#include <stdexcept>

using namespace frictionbeam;
using contact::Vector3;
using Vector = contact::Vector;

namespace {

constexpr double tolerance = 1e-10; // of Settings

LawLibrary &laws() {
  static LawLibrary library;
  static const bool loaded = (library.load_builtin(), true);
  (void)loaded;
  return library;
}

std::vector<double> coulomb(const double friction, const double shear_rigidity = 0.) {
  const LawDescription &law = laws().find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = friction;
  parameters[parameter_index(law, "Shear rigidity")] = shear_rigidity;
  return parameters;
}

contact::Contact on_floor(const unsigned int node, const double friction) {
  return contact::on_ground({3 * node, 3 * node + 1, 3 * node + 2}, {0., 0., -1.},
                            laws().find("coulomb"), coulomb(friction));
}

contact::SparseMatrix diagonal(const std::vector<double> &values) {
  contact::SparseMatrix matrix(values.size(), values.size());
  for (unsigned int i = 0; i < values.size(); ++i)
    matrix.insert(i, i) = values[i];
  matrix.makeCompressed();
  return matrix;
}

Vector vector_of(const std::vector<double> &values) {
  return Eigen::Map<const Vector>(values.data(), values.size());
}

/// A point on springs over a floor.
void stick_slip_open() {
  contact::Solver solver(contact::system_of(diagonal({100., 100., 1000.})), {on_floor(0, 0.5)});
  contact::ContactMemory memory = solver.initial_memory();
  Vector u = Vector::Zero(3);

  const contact::Report pressed = solver.solve(vector_of({0., 0., -10.}), memory, u, memory);
  CHECK(pressed.converged && pressed.contacts[0].status == ContactStatus::stick);
  CHECK_NEAR(pressed.contacts[0].normal_force, 10., tolerance);
  CHECK_NEAR(pressed.contacts[0].force[2], 10., tolerance); // the floor lifts it
  CHECK_NEAR(u.norm(), 0., tolerance);

  contact::Report report = solver.solve(vector_of({4., 0., -10.}), memory, u, memory);
  CHECK(report.converged && report.contacts[0].status == ContactStatus::stick);
  CHECK_NEAR(report.contacts[0].force[0], -4., tolerance);
  CHECK_NEAR(u[0], 0., tolerance);

  // 5 N of 8 N are friction's, the spring has 3 N.
  report = solver.solve(vector_of({0., 8., -10.}), memory, u, memory);
  CHECK(report.converged && report.contacts[0].status == ContactStatus::slip);
  CHECK_NEAR(u[1], 0.03, tolerance);
  CHECK_NEAR(report.contacts[0].force[1], -5., tolerance);
  CHECK_NEAR(report.contacts[0].slip[1], -0.03, tolerance); // of the floor on the point
  CHECK_NEAR(report.energy.dissipated, 5. * 0.03, tolerance);
  CHECK_NEAR(report.energy.stored, 0.5 * 100. * 0.03 * 0.03, tolerance);
  CHECK_NEAR(memory.sites.wear[0], 10. * 0.03, tolerance);

  report = solver.solve(vector_of({0., 0., 20.}), memory, u, memory);
  CHECK(report.converged && report.contacts[0].status == ContactStatus::open);
  CHECK_NEAR(report.contacts[0].gap, 0.02, tolerance);
  CHECK_NEAR(u[1], 0., tolerance);
}

/// A belt under a point: the ground does the work that friction takes.
void moving_ground() {
  contact::Solver solver(contact::system_of(diagonal({100., 100., 1000.})), {on_floor(0, 0.5)});
  contact::ContactMemory memory = solver.initial_memory();
  Vector u = Vector::Zero(3);
  const Vector f = vector_of({0., 0., -10.});
  solver.solve(f, memory, u, memory);
  solver.move_ground({Vector3(0.04, 0., 0.)});
  contact::Report report = solver.solve(f, memory, u, memory);
  CHECK(report.converged && report.contacts[0].status == ContactStatus::stick);
  CHECK_NEAR(u[0], 0.04, tolerance);
  solver.move_ground({Vector3(0.2, 0., 0.)});
  report = solver.solve(f, memory, u, memory);
  CHECK(report.contacts[0].status == ContactStatus::slip);
  CHECK_NEAR(u[0], 0.05, tolerance);
  CHECK_NEAR(report.contacts[0].slip[0], 0.15, tolerance);
  CHECK_NEAR(report.energy.dissipated, 5. * 0.15, tolerance);
  CHECK_NEAR(report.energy.ground, 4.5 * 0.16, tolerance); // friction grows from 4 N to 5 N
  CHECK_NEAR(report.energy.left_over(), report.energy.ground - report.energy.stored - 0.75,
             tolerance);
}

/// Two points whose springs do not couple them, one above the other with a gap.
void two_bodies_without_places() {
  const LawDescription &law = laws().find("coulomb");
  contact::Contact contact =
      contact::between({0, 1, 2}, {3, 4, 5}, {0., 0., 1.}, law, coulomb(0.3));
  contact.gap = 0.001;
  const contact::System one_matrix = contact::system_of(diagonal({1e3, 1e3, 1e3, 1e3, 1e3, 1e3}));
  // The second of two systems has a dof that is held, before those that are free.
  contact::System held = contact::system_of(diagonal({1e3, 1e3, 1e3}));
  held.dofs.insert(held.dofs.begin(), contact::System::Resolved{});
  held.dof_of = {1, 2, 3};
  const contact::System two_systems =
      contact::join(contact::system_of(diagonal({1e3, 1e3, 1e3})), held);
  for (const contact::System &system : {one_matrix, two_systems}) {
    const unsigned int second = system.dofs.size() - 3;
    contact.dofs = {0, 1, 2, second, second + 1, second + 2};
    contact::Solver solver(system, {contact});
    contact::ContactMemory memory = solver.initial_memory();
    Vector u = Vector::Zero(second + 3), f = u;
    // -21 N on the upper one close the gap with 1 N; the other 20 N are shared by both springs.
    f[second] = 1.;
    f[second + 2] = -21.;
    const contact::Report report = solver.solve(f, memory, u, memory);
    CHECK(report.converged && report.contacts[0].status == ContactStatus::stick);
    CHECK_NEAR(report.contacts[0].normal_force, 10., tolerance);
    CHECK_NEAR(u[2], -0.01, tolerance);
    CHECK_NEAR(u[second + 2], -0.011, tolerance);
    CHECK_NEAR(u[0], 0.0005, tolerance); // they stick to each other
    CHECK_NEAR(u[second], 0.0005, tolerance);
    CHECK_NEAR(report.contacts[0].force[2], -10., tolerance); // on the lower one
  }
}

/// A block without springs along the floor.
void slides_away() {
  contact::SparseMatrix matrix = diagonal({0., 1e3, 1e3});
  contact::Solver solver(contact::system_of(matrix), {on_floor(0, 0.5)});
  const contact::ContactMemory before = solver.initial_memory();
  contact::ContactMemory after = before;
  Vector u = Vector::Zero(3);
  contact::Report report = solver.solve(vector_of({4., 0., -10.}), before, u, after);
  CHECK(report.converged && report.contacts[0].status == ContactStatus::stick);
  const Vector u_before = u;
  const contact::ContactMemory kept = after;
  report = solver.solve(vector_of({6., 0., -10.}), before, u, after);
  CHECK(!report.converged && report.no_equilibrium);
  CHECK(report.free_motion.size() == 3 && report.free_motion[0] > 0.);
  CHECK_NEAR(report.free_motion[1] / report.free_motion[0], 0., 1e-9);
  CHECK(u == u_before && after.stress == kept.stress &&
        after.sites.internal == kept.sites.internal);
}

/// A mass that falls on a floor, obliquely.
void impact() {
  contact::Solver solver(contact::system_of(diagonal({2., 2., 2.})), {on_floor(0, 0.25)});
  Vector v = vector_of({3., 0., -4.});
  const Vector momentum = 2. * v;
  contact::Report report = solver.strike(momentum, {true}, 0.5, v);
  CHECK(report.converged);
  CHECK_NEAR(v[2], 2., tolerance);                         // -e v
  CHECK_NEAR(report.contacts[0].force[2], 12., tolerance); // N s
  CHECK_NEAR(v[0], 3. - 0.25 * 12. / 2., tolerance);
  CHECK_NEAR(report.energy.dissipated, 25. - (1.5 * 1.5 + 4.), tolerance);
  v = vector_of({3., 0., -4.});
  report = solver.strike(momentum, {false}, 0.5, v);
  CHECK(report.converged);
  CHECK_NEAR(v[2], -4., tolerance);
}

/// A chain of points by all ways to bring a matrix: the same answers.
void ways_to_bring_a_matrix() {
  constexpr unsigned int n = 30;
  std::minstd_rand random;
  std::uniform_real_distribution<double> number(0., 1.);
  std::vector<Eigen::Triplet<double>> entries;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int d = 0; d < 3; ++d) {
      entries.emplace_back(3 * i + d, 3 * i + d, 2e3 + 1e2 * (d + 1));
      if (i > 0) {
        entries.emplace_back(3 * i + d, 3 * i - 3 + d, -1e3);
        entries.emplace_back(3 * i - 3 + d, 3 * i + d, -1e3);
      }
    }
  Eigen::SparseMatrix<double> K(3 * n, 3 * n);
  K.setFromTriplets(entries.begin(), entries.end());
  std::vector<contact::Contact> contacts;
  for (unsigned int i = 1; i < n; i += 2)
    contacts.push_back(on_floor(i, 0.4));
  Vector f(3 * n);
  for (double &force : f)
    force = 10. * number(random) - 7.;

  contact::Solver by_matrix(contact::system_of(K), contacts);
  contact::System of_inverse = contact::system_of(K);
  of_inverse.matrix.resize(0, 0);
  of_inverse.multiply = [&](const Vector &x) { return Vector(K * x); };
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(K);
  of_inverse.condense = [&](const std::vector<int> &keep) {
    return contact::condense_by_inverse(3 * n, keep,
                                        [&](const Vector &b) { return Vector(factors.solve(b)); });
  };
  contact::Solver by_inverse(of_inverse, contacts);
  contact::ContactMemory one = by_matrix.initial_memory(), other = one;
  Vector u = Vector::Zero(3 * n), w = u;
  for (const double part : {0.4, 1., -0.3}) {
    const contact::Report a = by_matrix.solve(part * f, one, u, one),
                          b = by_inverse.solve(part * f, other, w, other);
    CHECK(a.converged && b.converged);
    CHECK_NEAR((u - w).norm(), 0., 1e-11 * u.norm());
    CHECK(a.check.holds(1e-8) && b.check.holds(1e-8));
    for (unsigned int i = 0; i < contacts.size(); ++i)
      CHECK(a.contacts[i].status == b.contacts[i].status);
  }

  // Written and read again, a state is the same to the last bit.
  std::stringstream file;
  boost::archive::text_oarchive(file) << one;
  contact::ContactMemory read;
  boost::archive::text_iarchive(file) >> read;
  CHECK(read.sites.internal == one.sites.internal && read.stress == one.stress &&
        read.sites.touch == one.sites.touch);
}

/// Eliminating the rest of a body with a wide border: S is the Schur complement.
void wide_border() {
  constexpr int m = 9; // nodes along an edge, of a cube with springs
  const auto node = [](const int x, const int y, const int z) { return (z * m + y) * m + x; };
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](const int a, const int b, const double k) {
    entries.emplace_back(a, a, k);
    entries.emplace_back(b, b, k);
    entries.emplace_back(a, b, -k);
    entries.emplace_back(b, a, -k);
  };
  for (int z = 0; z < m; ++z)
    for (int y = 0; y < m; ++y)
      for (int x = 0; x < m; ++x) {
        if (x + 1 < m)
          couple(node(x, y, z), node(x + 1, y, z), 1. + 0.1 * y);
        if (y + 1 < m)
          couple(node(x, y, z), node(x, y + 1, z), 2. + 0.1 * z);
        if (z + 1 < m)
          couple(node(x, y, z), node(x, y, z + 1), 3. + 0.1 * x);
      }
  contact::SparseMatrix K(m * m * m, m * m * m);
  K.setFromTriplets(entries.begin(), entries.end());
  std::vector<int> keep;
  for (int k = 0; k < m * m; ++k)
    keep.push_back(k); // all nodes of the base; the body is free but for them
  const auto condensed = contact::condense_parts(K, keep);
  const Vector x = Vector::LinSpaced(m * m, -1., 2.), f = Vector::LinSpaced(m * m * m, 3., -1.);
  const Vector u = condensed->expand(x, f), left = f - K * u;
  CHECK_NEAR((u.head(m * m) - x).norm(), 0., 1e-13);
  CHECK_NEAR(left.tail(m * m * m - m * m).norm(), 0., 1e-11 * f.norm());
  const Vector of_border = condensed->condense(f) - condensed->matrix() * x;
  CHECK_NEAR((of_border - left.head(m * m)).norm(), 0., 1e-11 * f.norm());
}

/// (W, q) alone.
void local_form() {
  contact::LocalProblem problem;
  problem.W.resize(3, 3);
  for (int i = 0; i < 3; ++i)
    problem.W.insert(i, i) = 1e-3;
  problem.q = vector_of({-0.01, 0.02, 0.});
  problem.friction = Vector::Constant(1, 0.5);
  const contact::LocalSolution solution = contact::solve_local_contact(problem, 1e-10);
  CHECK(solution.converged);
  CHECK_NEAR(solution.reactions[0], 10., 1e-10);
  CHECK_NEAR(solution.reactions[1], -5., 1e-10);
  CHECK_NEAR(solution.motions[1], 0.015, 1e-10);
}

void refused(const std::string &what, const std::function<void()> &attempt) {
  std::string message;
  try {
    attempt();
  } catch (const std::invalid_argument &error) {
    message = error.what();
  }
  check::truth(message.find(what) != std::string::npos, (what + " | " + message).c_str(), __FILE__,
               __LINE__);
}

void bad_input() {
  const contact::SparseMatrix K = diagonal({1., 1., 1.});
  const auto with = [&](const std::function<void(contact::Contact &)> &change) {
    return [=]() {
      contact::Contact contact = on_floor(0, 0.3);
      change(contact);
      contact::Solver(contact::system_of(K), {contact});
    };
  };
  using C = contact::Contact;
  refused("of length 0", with([](C &c) { c.normal.setZero(); }));
  refused("of length 2", with([](C &c) { c.normal *= 2.; }));
  refused("is not across its normal", with([](C &c) { c.tangent = {1., 0., 1.}; }));
  refused("it has no law", with([](C &c) { c.law = nullptr; }));
  refused("is one of sections", with([](C &c) { c.law = &laws().find("elastic_section"); }));
  refused("is given 1 parameters", with([](C &c) { c.parameters = {0.3}; }));
  refused("'Friction coefficient' of -1", with([](C &c) { c.parameters = coulomb(-1.); }));
  refused("its area is -2", with([](C &c) { c.area = -2.; }));
  refused("its gap is nan", with([](C &c) { c.gap = std::nan(""); }));
  refused("it names dof 7", with([](C &c) { c.dofs[0] = 7; }));
  refused("2 dofs and 3 rows", with([](C &c) { c.dofs.pop_back(); }));
  refused("nothing that is free moves it along its normal", [&]() {
    contact::System system = contact::system_of(diagonal({1., 1.}));
    system.dofs.push_back({{}, 0.}); // dof 2 is held
    contact::Solver(system, {on_floor(0, 0.3)});
  });
  refused("entries (0, 1) and (1, 0), counted in unknowns, are 0.5 and 0", [&]() {
    contact::SparseMatrix skew = K;
    skew.coeffRef(0, 1) = 0.5;
    contact::Solver(contact::system_of(skew), {on_floor(0, 0.3)});
  });
  contact::Solver solver(contact::system_of(K), {on_floor(0, 0.3)});
  Vector u = Vector::Zero(3);
  contact::ContactMemory memory;
  refused("A memory of 0 contacts", [&]() { solver.solve(u, memory, u, memory); });
  memory = solver.initial_memory();
  Vector shorter = Vector::Zero(2);
  refused("A vector of 2 entries", [&]() { solver.solve(shorter, memory, u, memory); });
  refused("2 contacts with restitution", [&]() { solver.strike(u, {true, true}, 0., u); });
  contact::Contact elastic = on_floor(0, 0.3);
  elastic.parameters = coulomb(0.3, 1e6);
  contact::Solver of_elastic(contact::system_of(K), {elastic});
  refused("is not rigid, and an impact takes no time",
          [&]() { of_elastic.strike(u, {true}, 0., u); });
}

} // namespace

int main() {
  stick_slip_open();
  moving_ground();
  two_bodies_without_places();
  slides_away();
  impact();
  ways_to_bring_a_matrix();
  wide_border();
  local_form();
  bad_input();
  return check::report();
}
