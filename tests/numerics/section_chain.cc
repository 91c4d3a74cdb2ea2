// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections along a cell that are in equilibrium with its ends: elastic they are the beam element, a
// hinge at an end carries its limit moment and no more, and the stiffness is the derivative.
#include "../check.h"

#include "model/cell/section_chain.h"

#include <algorithm>

using namespace frictionbeam;
using Chain = SectionChain;

namespace {

constexpr double length = 2., EA = 4e3, GA = 6e2, GJ = 30., EI = 50., limit = 7.;

Chain::Matrix6 elastic() {
  Chain::Vector6 diagonal;
  diagonal << EA, GA, GA, GJ, EI, EI;
  return diagonal.asDiagonal();
}

/// Of force and moment on the second end, seen @p arm before it.
Chain::Matrix6 stress_at(const double arm) {
  Chain::Matrix6 b = Chain::Matrix6::Identity();
  b(4, 2) = -arm;
  b(5, 1) = arm;
  return b;
}

Chain straight() {
  const double place[] = {-1., -0.6546536707079771, 0., 0.6546536707079771, 1.},
               weight[] = {0.1, 49. / 90., 32. / 45., 49. / 90., 0.1};
  std::vector<Chain::Point> points;
  for (int q = 0; q < 5; ++q) {
    const double arm = length * (1. - place[q]) / 2.;
    Eigen::Matrix<double, 6, 3> load = Eigen::Matrix<double, 6, 3>::Zero();
    load.topRows<3>() = arm * Eigen::Matrix3d::Identity();
    load(4, 2) = -arm * arm / 2.;
    load(5, 1) = arm * arm / 2.;
    points.push_back({stress_at(arm), load, weight[q] * length / 2., elastic()});
  }
  Eigen::Matrix<double, 6, 12> G = Eigen::Matrix<double, 6, 12>::Zero();
  G.leftCols<6>() = -Chain::Matrix6::Identity();
  G.rightCols<6>() = Chain::Matrix6::Identity();
  G(1, 5) = -length; // a turn of the first end carries the second along
  G(2, 4) = length;
  return Chain(points, G);
}

/// Each moment by itself yields at `limit`, perfectly.
bool yields(const unsigned int, const Chain::Vector6 &strain, Chain::Vector6 &stress,
            Chain::Matrix6 &tangent) {
  tangent = elastic();
  stress = tangent * strain;
  for (const int i : {4, 5})
    if (std::abs(stress[i]) > limit) {
      stress[i] = std::copysign(limit, stress[i]);
      tangent(i, i) = 0.;
    }
  return true;
}

Chain::Solution solve(const Chain &chain, const Chain::Vector12 &motions,
                      const Eigen::Vector3d &load = Eigen::Vector3d::Zero()) {
  Chain::Solution solution;
  solution.strain.assign(chain.size(), Chain::Vector6::Zero());
  chain.solve(&yields, motions, std::vector<Chain::Vector6>(chain.size(), Chain::Vector6::Zero()),
              load, solution);
  CHECK(solution.solved);
  return solution;
}

} // namespace

int section_chain(int, char **) {
  const Chain chain = straight();
  const Chain::Matrix12 &K = chain.elastic_stiffness();
  const double phi = 12. * EI / (GA * length * length);
  CHECK_NEAR(K(0, 0), EA / length, 1e-12);
  CHECK_NEAR(K(3, 3), GJ / length, 1e-12);
  CHECK_NEAR(K(7, 7), 12. * EI / (length * length * length * (1. + phi)), 1e-12);
  CHECK_NEAR(K(11, 11), (4. + phi) * EI / (length * (1. + phi)), 1e-12);

  Chain::Vector12 motions;
  motions << 1e-3, -2e-3, 3e-3, 1e-2, 2e-2, -1e-2, 2e-3, 1e-3, 0., -2e-2, 1e-2, 3e-2;
  const Chain::Solution small = solve(chain, motions);
  CHECK((small.forces - K * motions).norm() < 1e-12 * small.forces.norm());
  CHECK((small.stiffness - K).norm() < 1e-6 * K.norm()); // which has the least stiffness

  // The same by a change from another elastic state, and under load.
  const Eigen::Vector3d load(0.3, -0.5, 0.7);
  const std::vector<Chain::Vector6> none(chain.size(), Chain::Vector6::Zero());
  const Chain::Vector12 changed = chain.elastic_change(motions, none, load);
  CHECK((solve(chain, motions, load).forces - changed).norm() < 1e-11 * changed.norm());
  Chain::Solution elastically;
  chain.solve_elastically(motions, none, load, elastically);
  CHECK((elastically.forces - changed).norm() < 1e-12 * changed.norm());

  // Clamped at both ends under a load across: half of it and q l^2/12.
  const Chain::Vector12 held = solve(chain, Chain::Vector12::Zero(), {0., 1.5, 0.}).forces;
  CHECK_NEAR(held[7], -1.5 * length / 2., 1e-11);
  CHECK_NEAR(std::abs(held[11]), 1.5 * length * length / 12., 1e-11);

  // A rigid motion strains nothing, whatever yields.
  Chain::Vector12 rigid = Chain::Vector12::Zero();
  rigid[1] = rigid[7] = 3.;
  rigid[5] = rigid[11] = 0.4;
  rigid[7] += 0.4 * length;
  CHECK(solve(chain, rigid).forces.norm() < 1e-12 * EI);

  // Pushed far at its end, a cantilever carries limit / length, by a hinge at its root.
  for (const double far : {1., 10., 1000.}) {
    Chain::Vector12 pushed = Chain::Vector12::Zero();
    pushed[7] = far;
    double low = 0., high = 2. * far; // turns of the end between which it is free of moment
    for (int k = 0; k < 60; ++k) {
      pushed[11] = (low + high) / 2.;
      (solve(chain, pushed).forces[11] < 0. ? low : high) = pushed[11];
    }
    const Chain::Vector12 forces = solve(chain, pushed).forces;
    CHECK_NEAR(forces[7], limit / length, 1e-9);
    CHECK_NEAR(std::abs(forces[5]), limit, 1e-9);
  }

  // The stiffness is the derivative of the forces, where sections yield and where they do not.
  Chain::Vector12 bent = 5. * motions;
  bent[11] = 0.6;
  const Chain::Solution at = solve(chain, bent);
  for (int j = 0; j < 12; ++j) {
    const double h = 1e-6;
    Chain::Vector12 up = bent, down = bent;
    up[j] += h;
    down[j] -= h;
    const Chain::Vector12 column = (solve(chain, up).forces - solve(chain, down).forces) / (2. * h);
    CHECK((column - at.stiffness.col(j)).norm() < 1e-5 * K.norm());
  }
  CHECK((at.stiffness - K).norm() > 1e-2 * K.norm());
  return check::report();
}
