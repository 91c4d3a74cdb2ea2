// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid bodies on contacts alone: what forces inside the cones can hold is held, and of the rest it
// is proved that nothing holds it. References: by hand, below.
#include "../check.h"

#include <frictionbeam/contact/solver.h>
#include <frictionbeam/law_library.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

using namespace frictionbeam;
using Vector = contact::Vector;
using contact::Vector3;

namespace {

LawLibrary laws;

/// Contact of a rigid body with the ground at a place: rows of its translations and rotations.
contact::Contact at_place(const Vector3 &place, const Vector3 &normal, const double friction) {
  const LawDescription &law = laws.find("coulomb");
  contact::Contact contact = contact::on_ground(
      {0, 1, 2}, normal, law, law_parameters(law, {{"Friction coefficient", friction}}));
  for (unsigned int d = 3; d < 6; ++d) {
    contact.dofs.push_back(d);
    contact.rows.push_back(-Vector3(Vector3::Unit(d - 3)).cross(place));
  }
  return contact;
}

/// A rigid table of 100 N on legs in a circle, without any stiffness, turned, pushed and tipped: by
/// hand it holds M < f N r, F < f N, and a weight above the polygon of its legs.
void a_rigid_table() {
  const double f = 0.3, r = 0.5, pi = std::acos(-1.);
  for (const int n : {3, 4, 7}) {
    std::vector<contact::Contact> legs;
    for (int i = 0; i < n; ++i)
      legs.push_back(at_place({r * std::cos(2. * pi * i / n), r * std::sin(2. * pi * i / n), 0.},
                              {0., 0., -1.}, f));
    const double nearest = r * std::cos(pi / n); // edge, in the direction pi / n
    for (const double part : {0.2, 0.999, 1.001, 1.5}) {
      Vector turned = Vector::Zero(6), pushed, tipped;
      turned[2] = -100.;
      pushed = tipped = turned;
      turned[5] = part * f * 100. * r;
      pushed.head<2>() = part * f * 100. * Eigen::Vector2d(0.6, 0.8);
      tipped.segment<3>(3) =
          Vector3(part * nearest * Vector3(std::cos(pi / n), std::sin(pi / n), 0.))
              .cross(Vector3(0., 0., -100.));
      for (const Vector &load : {turned, pushed, tipped}) {
        contact::SparseMatrix none(6, 6);
        contact::Solver solver(contact::system_of(none), legs);
        contact::ContactMemory memory = solver.initial_memory();
        Vector u;
        const contact::Report report = solver.solve(load, memory, u, memory);
        CHECK(part < 1. ? report.converged : report.no_equilibrium);
      }
    }
  }
}

/// Rigid plane bodies on contacts anywhere, under loads that forces inside the cones can hold: they
/// are held, wherever the path of the loads would lead; and under any loads: either forces that
/// balance them, or a motion that no friction resists.
void rigid_bodies_anywhere() {
  std::mt19937 random(2);
  const auto between = [&](const double a, const double b) {
    return a + (b - a) * random() / static_cast<double>(random.max());
  };
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<contact::Contact> contacts;
    std::vector<double> friction;
    Vector load = Vector::Zero(6);
    const int n = 1 + random() % 5;
    const bool is_held = trial % 2 == 0;
    for (int i = 0; i < n; ++i) {
      const double angle = between(0., 6.28), f = random() % 5 == 0 ? 0. : between(0., 1.2);
      const Vector3 place(between(-1., 1.), between(-1., 1.), 0.),
          normal(std::cos(angle), std::sin(angle), 0.), across(-normal[1], normal[0], 0.);
      contacts.push_back(at_place(place, normal, f));
      friction.push_back(f);
      const double N = between(0.1, 1.), T = between(-0.9, 0.9) * f * N;
      for (unsigned int d = 0; d < 6; ++d)
        load[d] -= contacts.back().rows[d].dot(N * normal - T * across);
    }
    if (!is_held)
      load << between(-1., 1.), between(-1., 1.), 0., 0., 0., between(-1., 1.);
    contact::SparseMatrix none(6, 6);
    contact::Solver solver(contact::system_of(none), contacts);
    contact::ContactMemory memory = solver.initial_memory();
    Vector u;
    const contact::Report report = solver.solve(load, memory, u, memory);
    CHECK(report.converged || (!is_held && report.no_equilibrium));
    Vector left = load;
    double least = 0.;
    for (int i = 0; i < n && report.no_equilibrium; ++i) {
      Vector3 d = Vector3::Zero();
      for (unsigned int k = 0; k < 6; ++k)
        d += contacts[i].rows[k] * report.free_motion[k];
      const double opens = d.dot(contacts[i].normal),
                   slides = (d - opens * contacts[i].normal).norm();
      least = std::min(least, opens - friction[i] * slides);
    }
    if (report.no_equilibrium)
      CHECK(load.dot(report.free_motion) > 0. && least > -1e-3 * report.free_motion.norm());
    for (int i = 0; i < n && report.converged; ++i)
      for (unsigned int k = 0; k < 6; ++k)
        left[k] -= contacts[i].rows[k].dot(report.contacts[i].force);
    if (report.converged)
      CHECK(left.norm() < 1e-8);
  }
}

} // namespace

int main() {
  laws.load_builtin();
  a_rigid_table();
  rigid_bodies_anywhere();
  return check::report();
}
