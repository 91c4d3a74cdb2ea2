// SPDX-License-Identifier: LGPL-2.1-or-later
// A cell that turns with its ends: a rigid motion deforms nothing, a stretch is a stretch in any
// direction, B is the derivative of the deformations by spins of the ends, no axes across the cell
// are better than others, and the geometric stiffness is that of B^T s.
#include "../check.h"

#include "model/cell/corotational_beam.h"

#include <Eigen/Geometry>

using namespace frictionbeam;
using Beam = CorotationalBeam;

namespace {

const Eigen::Vector3d chord(2., 0., 0.);

/// EA/l, GJ/l and EI/l of 1e3, 20, 50 (both planes), Euler and Bernoulli.
Beam::Matrix12 stiffness() {
  Beam::Matrix12 K = Beam::Matrix12::Zero();
  const double l = chord.norm(), a = 1e3, t = 20., b = 50.;
  const auto add = [&](const Eigen::Matrix<double, 12, 1> &mode, const double k) {
    K += k * mode * mode.transpose();
  };
  const auto unit = [](const int i) { return Beam::Vector12(Beam::Vector12::Unit(i)); };
  add(unit(6) - unit(0), a);
  add(unit(9) - unit(3), t);
  for (const auto &[u, r, sign] : {std::array<int, 3>{1, 5, 1}, std::array<int, 3>{2, 4, -1}}) {
    const Beam::Vector12 chord_turn = sign * (unit(6 + u) - unit(u)) / l;
    const Beam::Vector12 one = unit(r) - chord_turn, two = unit(6 + r) - chord_turn;
    add(one - two, b);      // symmetric bending, EI/l
    add(one + two, 3. * b); // antisymmetric, 3 EI/l
  }
  return K;
}

Eigen::Quaterniond turn(const Eigen::Vector3d &vector) {
  return vector.norm() == 0.
             ? Eigen::Quaterniond::Identity()
             : Eigen::Quaterniond(Eigen::AngleAxisd(vector.norm(), vector.normalized()));
}

/// Ends moved on by a translation or a spin, 12 of them.
Beam::Ends moved(Beam::Ends ends, const Beam::Vector12 &by) {
  ends.relative += by.segment<3>(6) - by.head<3>();
  ends.turn[0] = turn(by.segment<3>(3)) * ends.turn[0];
  ends.turn[1] = turn(by.segment<3>(9)) * ends.turn[1];
  return ends;
}

} // namespace

int corotational_beam(int, char **) {
  const Beam beam(chord, Eigen::Matrix3d::Identity(), stiffness());
  const Eigen::Quaterniond R = turn({0.4, -1.1, 2.});
  const auto rigid = beam.deform({R * chord - chord, {R, R}});
  CHECK_NEAR(rigid.d.norm(), 0., 1e-14);
  CHECK_NEAR((rigid.axes - R.toRotationMatrix()).norm(), 0., 1e-14);
  CHECK_NEAR(beam.deform({1.1 * (R * chord) - chord, {R, R}}).d[0], 0.2, 1e-13);

  const Beam::Ends ends{{0.1, 0.5, -0.3}, {turn({0.1, 0.2, 0.3}), turn({-0.1, 0.1, 0.4})}};
  const Beam::Deformed at = beam.deform(ends);
  const auto turned =
      beam.deform({R * (chord + ends.relative) - chord, {R * ends.turn[0], R * ends.turn[1]}});
  CHECK_NEAR((turned.d - at.d).norm(), 0., 1e-14); // objective

  const double h = 1e-6;
  const auto B = beam.derivative(at, at.length);
  const Beam::Vector7 s = beam.stiffness() * at.d;
  for (int i = 0; i < 12; ++i) {
    const Beam::Vector12 by = h * Beam::Vector12::Unit(i);
    const auto after = beam.deform(moved(ends, by)), before = beam.deform(moved(ends, -by));
    CHECK_NEAR(((after.d - before.d) / (2. * h) - B.col(i)).norm(), 0., 1e-8);
  }
  // B^T and B without making B.
  const Beam::Vector12 motion = Beam::Vector12::LinSpaced(-0.3, 0.8);
  for (const double length : {at.length, 1.1 * at.length}) {
    const auto scaled = beam.derivative(at, length);
    CHECK_NEAR((beam.on_ends(at, length, s) - scaled.transpose() * s).norm() / s.norm(), 0., 1e-14);
    CHECK_NEAR((beam.of_motion(at, length, motion) - scaled * motion).norm(), 0., 1e-14);
  }
  CHECK_NEAR((B.transpose() * s).head<3>().dot(Eigen::Vector3d::Ones()) +
                 (B.transpose() * s).segment<3>(6).dot(Eigen::Vector3d::Ones()),
             0., 1e-11); // forces on the ends are in equilibrium

  // The same forces whatever axes a round section has across its own, however far its ends turn.
  const Beam other(chord, turn({0.7, 0., 0.}).toRotationMatrix(), stiffness());
  for (const Beam::Ends &far :
       {ends, Beam::Ends{{-0.4, 0.9, -0.8}, {turn({0.6, -0.9, 1.2}), turn({-0.5, 1.1, -0.4})}}}) {
    const auto one = beam.deform(far), two = other.deform(far);
    const Beam::Vector12 forces =
        beam.derivative(one, one.length).transpose() * (beam.stiffness() * one.d);
    CHECK_NEAR(
        (other.derivative(two, two.length).transpose() * (other.stiffness() * two.d) - forces)
                .norm() /
            forces.norm(),
        0., 1e-13);
  }

  // The tangent of the forces, all ends moved by themselves; without what a frame does that twists
  // against its ends, so nearly undeformed.
  const Beam::Ends near{{0.01, 0.02, -0.03}, {turn({0.01, 0.02, 0.01}), turn({-0.01, 0.01, 0.02})}};
  const Beam::Ends carried{R * (chord + near.relative) - chord,
                           {R * near.turn[0], R * near.turn[1]}};
  const Beam::Deformed there = beam.deform(carried);
  const auto by_ends = beam.derivative(there, there.length);
  const Beam::Matrix12 tangent =
      by_ends.transpose() * beam.stiffness() * by_ends +
      Beam::of_ends(beam.geometric_stiffness(there, beam.stiffness() * there.d));
  for (int i = 0; i < 12; ++i) {
    const auto force = [&](const double by) -> Beam::Vector12 {
      const auto moved_on = beam.deform(moved(carried, by * Beam::Vector12::Unit(i)));
      return beam.on_ends(moved_on, moved_on.length, beam.stiffness() * moved_on.d);
    };
    CHECK_NEAR(((force(h) - force(-h)) / (2. * h) - tangent.col(i)).norm() / tangent.norm(), 0.,
               1e-4);
  }

  // A straight cell under tension P: translations across feel P/l.
  Beam::Vector7 tension = Beam::Vector7::Zero();
  tension[0] = 7.;
  const auto G = Beam::of_ends(beam.geometric_stiffness(
      beam.deform({Eigen::Vector3d::Zero(), {turn({0, 0, 0}), turn({0, 0, 0})}}), tension));
  CHECK_NEAR(G(1, 1), 7. / 2., 1e-12);
  CHECK_NEAR(G(1, 7), -7. / 2., 1e-12);
  return check::report();
}
