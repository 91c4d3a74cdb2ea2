// SPDX-License-Identifier: LGPL-2.1-or-later
// Random bodies of springs with contacts among them and on moving ground, loaded, turned, unloaded:
// what is called converged is judged by the definitions, and by nothing of the library.
//   contact_random [FIRST = 1] [NUMBER = 200]
#include "../check.h"

#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace frictionbeam;
using contact::Vector3;
using Vector = contact::Vector;

namespace {

class Random {
public:
  explicit Random(const unsigned int seed) : engine(seed) {}
  double number() { return std::uniform_real_distribution<double>(0., 1.)(engine); }
  double between(const double a, const double b) { return a + (b - a) * number(); }
  unsigned int below(const unsigned int n) { return std::min(n - 1, unsigned(n * number())); }
  bool one_in(const unsigned int n) { return below(n) == 0; }
  Vector3 vector() { // in the order of its components
    Vector3 result;
    for (double &component : result)
      component = between(-0.5, 0.5);
    return result;
  }
  Vector3 direction() {
    const Vector3 any = vector();
    const unsigned int axis = below(3);
    return any.norm() < 1e-3 || one_in(2) ? Vector3(Vector3::Unit(axis)) : any.normalized();
  }

private:
  std::mt19937 engine;
};

struct Scene {
  double stiffness; ///< typical [N/m]
  Eigen::SparseMatrix<double> K;
  std::vector<contact::Contact> contacts;
  std::vector<double> friction, axial_rigidity; ///< of each; 0: rigid

  bool is_on_ground(const unsigned int i) const { return contacts[i].dofs.size() == 3; }
};

std::vector<unsigned int> translations(const unsigned int node) {
  return {3 * node, 3 * node + 1, 3 * node + 2};
}

/// Two bodies at most, each of nodes with springs among them; some float.
Scene make(Random &random, const LawDescription &law) {
  const unsigned int n_bodies = 1 + random.below(2), n_nodes = 2 + random.below(8),
                     n = 3 * n_bodies * n_nodes;
  Scene scene;
  scene.stiffness = random.one_in(3) ? std::pow(10., random.between(-6., 12.)) : 1e3;
  std::vector<Eigen::Triplet<double>> entries;
  const auto spring = [&](const unsigned int a, const int b, const double k) {
    const Vector3 d = random.direction();
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j) {
        const double value = k * d[i] * d[j];
        entries.emplace_back(3 * a + i, 3 * a + j, value);
        if (b < 0)
          continue;
        entries.emplace_back(3 * b + i, 3 * b + j, value);
        entries.emplace_back(3 * a + i, 3 * b + j, -value);
        entries.emplace_back(3 * b + i, 3 * a + j, -value);
      }
  };
  const bool some_float = random.one_in(3);
  for (unsigned int body = 0; body < n_bodies; ++body) {
    const unsigned int first = body * n_nodes;
    for (unsigned int i = 1; i < n_nodes; ++i)
      for (unsigned int k = 0; k < 8; ++k)
        spring(first + i, first + random.below(i),
               scene.stiffness * std::pow(10., random.between(0., 2.)));
    if (!some_float || random.one_in(2))
      for (unsigned int k = 0; k < 9; ++k)
        spring(first + random.below(n_nodes), -1,
               scene.stiffness * std::pow(10., random.between(-1., 1.)));
  }
  scene.K.resize(n, n);
  scene.K.setFromTriplets(entries.begin(), entries.end());
  const unsigned int n_contacts = 1 + random.below(2 * n_nodes);
  for (unsigned int c = 0; c < n_contacts; ++c) {
    std::vector<double> parameters = default_parameters(law);
    const auto set = [&](const char *name, const double value) {
      parameters[parameter_index(law, name)] = value;
      return value;
    };
    scene.friction.push_back(set("Friction coefficient", random.one_in(5) ? 0.
                                                         : random.one_in(6)
                                                             ? 3. * random.number()
                                                             : 0.6 * random.number()));
    scene.axial_rigidity.push_back(0.);
    if (random.one_in(4)) {
      scene.axial_rigidity.back() =
          set("Axial rigidity", scene.stiffness * std::pow(10., random.between(-1., 3.)));
      set("Shear rigidity", scene.stiffness * std::pow(10., random.between(-1., 3.)));
    }
    const unsigned int one = random.below(n_nodes), other = n_nodes + random.below(n_nodes);
    const bool on_ground = n_bodies == 1 || random.one_in(2);
    const Vector3 normal = random.one_in(2) ? Vector3(0., 0., -1.) : random.direction();
    scene.contacts.push_back(
        on_ground
            ? contact::on_ground(translations(random.below(n_bodies * n_nodes)), normal, law,
                                 parameters)
            : contact::between(translations(one), translations(other), normal, law, parameters));
    if (random.one_in(3))
      scene.contacts.back().gap = random.between(-2e-3, 8e-3);
    if (random.one_in(4))
      scene.contacts.back().area = random.between(0.1, 3.);
  }
  return scene;
}

/// What is wrong with an increment; empty if nothing is.
std::string faults(const Scene &scene, const Vector &f, const std::vector<Vector3> &ground,
                   const Vector &u, const contact::Report &report, const double force_so_far) {
  Vector left = f - scene.K * u;
  double force = std::max(f.lpNorm<Eigen::Infinity>(), 1e-4 * force_so_far);
  for (const contact::ContactState &state : report.contacts)
    force = std::max(force, state.force.norm());
  const double length = std::max(1e-5, u.lpNorm<Eigen::Infinity>()), excused = 1e-7;
  std::string text;
  for (unsigned int c = 0; c < scene.contacts.size(); ++c) {
    const contact::Contact &contact = scene.contacts[c];
    const contact::ContactState &state = report.contacts[c];
    Vector3 opening = scene.is_on_ground(c) ? ground[c] : Vector3(Vector3::Zero());
    for (unsigned int j = 0; j < contact.dofs.size(); ++j) {
      left[contact.dofs[j]] -= contact.rows[j].dot(state.force);
      opening += u[contact.dofs[j]] * contact.rows[j];
    }
    const double pressing = -state.force.dot(contact.normal), k = scene.axial_rigidity[c];
    const Vector3 across = state.force + pressing * contact.normal;
    double gap = contact.gap + opening.dot(contact.normal);
    if (k > 0.) // of an element of length one
      gap += pressing / contact.area / k;
    if (pressing < -excused * force)
      text += " pulls";
    if (gap < -excused * length)
      text += " penetrates";
    if (pressing > excused * force && gap > excused * length)
      text += " presses across a gap";
    if (across.norm() > scene.friction[c] * pressing + excused * force)
      text += " beyond its cone";
    const double slip = state.slip.norm();
    if (state.status == ContactStatus::stick && k == 0. && slip > excused * length)
      text += " sticks and slips";
    if (state.status == ContactStatus::slip && across.norm() > excused * force &&
        slip > 1e-4 * length && across.dot(state.slip) < (1. - 1e-6) * across.norm() * slip)
      text += " slips beside its friction";
  }
  // What two forces that nearly cancel leave is rounding of the stiffness.
  const double rounding = 1e-13 * (scene.K.cwiseAbs() * u.cwiseAbs()).lpNorm<Eigen::Infinity>();
  if (left.lpNorm<Eigen::Infinity>() > excused * force + rounding)
    text += " not balanced";
  return text;
}

/// Of a motion that is said to prove that there is no equilibrium.
std::string faults(const Scene &scene, const Vector &f, const Vector &motion) {
  if (!(f.dot(motion) > 0.))
    return " no load does work on the motion";
  return motion.dot(scene.K * motion) > 1e-8 * scene.stiffness * motion.squaredNorm()
             ? " the motion is not free"
             : "";
}

struct Counts {
  unsigned int converged = 0, no_equilibrium = 0, not_solved = 0;
};

std::string judge(const unsigned int seed, const LawDescription &law, Counts &counts) {
  Random random(seed);
  const Scene scene = make(random, law);
  contact::Solver solver(contact::system_of(scene.K), scene.contacts);
  contact::ContactMemory memory = solver.initial_memory();
  const unsigned int n = scene.K.rows();
  Vector u = Vector::Zero(n), before = u;
  std::vector<Vector3> ground(scene.contacts.size(), Vector3::Zero());
  for (unsigned int step = 0; step < 4; ++step) {
    Vector f(n);
    for (unsigned int i = 0; i < n; ++i)
      f[i] = 0.01 * scene.stiffness * (random.between(-0.5, 0.5) - (i % 3 == 2 ? 0.5 : 0.));
    if (!random.one_in(3))
      f = (before + 0.3 * f).eval();
    if (random.one_in(6))
      f.setZero();
    if (random.one_in(3)) {
      for (unsigned int c = 0; c < ground.size(); ++c)
        if (scene.is_on_ground(c))
          ground[c] += 3e-3 * random.vector();
      solver.move_ground(ground);
    }
    const Vector start = u;
    const double force_so_far = memory.largest_force;
    const contact::Report report = solver.solve(f, memory, u, memory);
    if (!report.converged) {
      ++(report.no_equilibrium ? counts.no_equilibrium : counts.not_solved);
      const std::string text = report.no_equilibrium ? faults(scene, f, report.free_motion) : "";
      return u == start ? text : text + " a failed increment moved the body";
    }
    ++counts.converged;
    const std::string text = faults(scene, f, ground, u, report, force_so_far);
    if (!text.empty())
      return text;
    before = f;
  }
  return "";
}

/// A body of springs without any hold, on one contact, about which it turns.
void on_one_point(const LawDescription &law) {
  std::vector<Eigen::Triplet<double>> entries; // two masses, joined along x alone
  for (const int i : {0, 3})
    for (const int j : {0, 3})
      entries.emplace_back(i, j, i == j ? 1e3 : -1e3);
  Eigen::SparseMatrix<double> K(6, 6);
  K.setFromTriplets(entries.begin(), entries.end());
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = 0.5;
  contact::Solver solver(contact::system_of(K),
                         {contact::on_ground(translations(0), {0., 0., -1.}, law, parameters)});
  const contact::ContactMemory none = solver.initial_memory();
  contact::ContactMemory after;
  Vector u = Vector::Zero(6), f = u;
  f[2] = -10.;
  f[3] = 4.; // on the far one, along the spring: friction holds it
  const contact::Report held = solver.solve(f, none, u, after);
  CHECK(held.converged);
  CHECK_NEAR(held.contacts[0].force[0], -4., 1e-9);
  CHECK_NEAR(u[3] - u[0], 4e-3, 1e-12);
  f[4] = 1.; // across: nothing holds it
  u.setZero();
  const contact::Report turns = solver.solve(f, none, u, after);
  CHECK(!turns.converged);
  CHECK(!turns.no_equilibrium || faults({1e3, K, {}, {}, {}}, f, turns.free_motion).empty());
}

} // namespace

int main(int argc, char **argv) {
  const unsigned int first = argc > 1 ? std::atoi(argv[1]) : 1,
                     number = argc > 2 ? std::atoi(argv[2]) : 200;
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &law = laws.find("coulomb");
  on_one_point(law);
  Counts counts;
  for (unsigned int seed = first; seed < first + number; ++seed) {
    const std::string text = judge(seed, law, counts);
    if (!text.empty())
      std::cout << "seed " << seed << ':' << text << '\n';
    CHECK(text.empty());
  }
  std::cout << counts.converged << " increments converged, " << counts.no_equilibrium
            << " have no equilibrium, " << counts.not_solved << " were not solved\n";
  CHECK(counts.not_solved <= 0.06 * (counts.converged + counts.no_equilibrium));
  return check::report();
}
