// The law coulomb shall return the closed forms of its branches: stick, slip, opening, static and
// dynamic friction, unequal rigidities, torsion. References: closed forms, at each function.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_closed_form.h>

#include "../check.h"
#include "probe.h"

#include <algorithm>

using namespace frictionbeam;

namespace {

const LawDescription *coulomb = nullptr;

/// Node on springs of stiffness 1, contact of stiffness 1 and 0.5, gap 0.5, f = 0.5 (published
/// validation case SSND116-A): sticks, slips, unloads, slips back; solved by Newton's method.
void node_on_springs() {
  Probe probe(*coulomb, {{"Axial rigidity", 1.},
                         {"Shear rigidity", 0.5},
                         {"Friction coefficient", 0.5},
                         {"Gap", 0.5}});
  double u[2] = {0., 0.};
  unsigned int n_iterations_at_most = 0;
  for (unsigned int step = 1; step <= 40; ++step) {
    const double t = 0.05 * step;
    const double Fx = -std::min(t, 1.), Fy = t <= 1. ? 0. : t <= 1.5 ? 4 * (t - 1) : 4 * (2 - t);
    unsigned int iteration = 0;
    for (; iteration < 20; ++iteration) {
      // The element's axis points along -x to the ground; its first node is the moving one.
      probe.evaluate({u[0], -u[1], 0., 0.});
      const double residual[2] = {Fx - u[0] - probe.stress[0], Fy - u[1] + probe.stress[1]};
      if (std::hypot(residual[0], residual[1]) < 1e-13)
        break;
      const double K[2][2] = {{1. + probe.tangent[0], -probe.tangent[1]},
                              {-probe.tangent[4], 1. + probe.tangent[5]}};
      const double det = K[0][0] * K[1][1] - K[0][1] * K[1][0];
      u[0] += (K[1][1] * residual[0] - K[0][1] * residual[1]) / det;
      u[1] += (K[0][0] * residual[1] - K[1][0] * residual[0]) / det;
    }
    n_iterations_at_most = std::max(n_iterations_at_most, iteration);
    probe.commit();
    const auto check = [&](const unsigned int at, const double ux, const double uy,
                           const ContactStatus contact) {
      if (step != at)
        return;
      CHECK_NEAR(u[0], ux, 1e-13);
      CHECK_NEAR(u[1], uy, 1e-13);
      CHECK(probe.contact == contact);
    };
    check(5, -0.25, 0., ContactStatus::open);
    check(10, -0.5, 0., ContactStatus::open);
    check(20, -0.75, 0., ContactStatus::stick);
    check(21, -0.75, 0.2 / 1.5, ContactStatus::stick);
    check(30, -0.75, 2 - 0.125, ContactStatus::slip);
    check(31, -0.75, (1.8 + 0.5 * 1.625) / 1.5, ContactStatus::stick);
    check(40, -0.75, 0.125, ContactStatus::slip);
  }
  CHECK(n_iterations_at_most <= 2);
}

/// K_t = 1, f N = 1, displacement 0, 3, -1 in steps of 0.5: slip is kept when unloading.
void back_and_forth() {
  Probe probe(*coulomb,
              {{"Axial rigidity", 1.}, {"Shear rigidity", 1.}, {"Friction coefficient", 0.5}});
  const double exact[] = {0.5, 1, 1, 1, 1, 1, 0.5, 0, -0.5, -1, -1, -1, -1, -1};
  double work = 0., dissipated = 0., old_stress = 0.;
  for (unsigned int step = 0; step < 14; ++step) {
    const double v = step < 6 ? 0.5 * (step + 1) : 3. - 0.5 * (step - 5);
    probe.move({-2., 0., v, 0.});
    CHECK_NEAR(probe.stress[2], exact[step], 1e-15);
    CHECK_NEAR(probe.stress[0], -2., 1e-15);
    work += (step < 6 ? 0.5 : -0.5) * (old_stress + probe.stress[2]) / 2;
    dissipated += probe.dissipation;
    old_stress = probe.stress[2];
  }
  // Work done is dissipated or stored, T^2/(2 GS).
  CHECK_NEAR(dissipated, work - 0.5, 1e-14);
  CHECK_NEAR(dissipated, 2. + 2., 1e-14);
}

/// With a gap g, contact begins at eps = -g/l. Open: no stress, no tangent; slip follows the node,
/// so that closing again gives no shear force, and sliding counts from there.
void opening_and_closing() {
  const double l = 0.5, g = 0.1;
  Probe probe(*coulomb,
              {{"Axial rigidity", 10.},
               {"Shear rigidity", 4.},
               {"Friction coefficient", 0.3},
               {"Gap", g},
               {"Torsional rigidity", 2.}},
              l);
  probe.move({-0.19, 0.7, 0., 0.1});
  CHECK(probe.contact == ContactStatus::open);
  for (const double x : probe.stress)
    CHECK_NEAR(x, 0., 0.);
  CHECK(std::all_of(probe.tangent.begin(), probe.tangent.end(), [](double x) { return x == 0.; }));
  probe.move({-0.5, 0.7, 0., 0.1});
  CHECK(probe.contact == ContactStatus::stick);
  CHECK_NEAR(probe.stress[0], 10. * (-0.5 + g / l), 1e-14);
  CHECK_NEAR(probe.stress[1], 0., 0.);
  CHECK_NEAR(probe.stress[3], 0., 0.);
  probe.move({-0.5, 0.9, 0., 0.15});
  CHECK_NEAR(probe.stress[1], 4. * 0.2, 1e-14);
  CHECK_NEAR(probe.stress[3], 2. * 0.05, 1e-14);
  probe.move({-0.5, 5., 0., 0.15});
  CHECK(probe.contact == ContactStatus::slip);
  CHECK_NEAR(probe.stress[1], 0.9, 1e-14);
  CHECK_NEAR(probe.state[0], 5. - 0.9 / 4., 1e-14);
  probe.move({0.2, -3., 1., 0.}); // lifts off sideways
  probe.move({-0.5, -3., 1., 0.});
  CHECK(probe.contact == ContactStatus::stick);
  CHECK_NEAR(std::hypot(probe.stress[1], probe.stress[2]), 0., 0.);
}

/// Circle of radius R in the sliding plane, threshold g, stiffness k: in the steady state slip runs
/// on a circle of radius r = sqrt(R^2 - (g/k)^2), the force is tangent to that, its part along the
/// radius is g^2/(k R), and a turn dissipates 2 pi g r. The return mapping is first order in the
/// steps.
void curved_path() {
  const double R = 3., g = 2., k = 4., pi = std::acos(-1.);
  double error[2];
  for (unsigned int level = 0; level < 2; ++level) {
    const unsigned int n = 500 << level;
    Probe probe(*coulomb,
                {{"Axial rigidity", 1.}, {"Shear rigidity", k}, {"Friction coefficient", 0.4}});
    double dissipated = 0., radial = 0., largest = 0.;
    for (unsigned int step = 0; step <= 3 * n; ++step) {
      const double angle = 2 * pi * step / n, c = std::cos(angle), s = std::sin(angle);
      probe.move({-g / 0.4, R * c, R * s, 0.});
      largest = std::max(largest, std::abs(std::hypot(probe.stress[1], probe.stress[2]) - g));
      radial = probe.stress[1] * c + probe.stress[2] * s;
      dissipated += step > 2 * n ? probe.dissipation : 0.;
    }
    CHECK_NEAR(largest, 0., 1e-14);
    error[level] = std::abs(radial - g * g / k / R);
    CHECK_NEAR(dissipated, 2 * pi * g * std::sqrt(R * R - g * g / k / k), 1. / n);
  }
  CHECK(error[0] < 0.02 * g && error[1] < 0.55 * error[0]);
}

/// GS_y != GS_z: the nearest point of the circle in the norm of GS^-1, found here by trying 2e5
/// angles and refining; slip grows by GS^-1 (T* - T), and T.slip is dissipated.
void unequal_rigidities() {
  for (const double ratio : {0.2, 3., 1e3}) {
    const double k[2] = {2., 2. * ratio}, g = 0.6;
    for (const auto &direction : {std::array<double, 2>{1., 0.4}, {-0.3, 2.}, {0.8, -0.01}}) {
      Probe probe(*coulomb, {{"Axial rigidity", 1.},
                             {"Shear rigidity", k[0]},
                             {"Shear rigidity ratio", ratio},
                             {"Friction coefficient", 0.3}});
      const double trial[2] = {k[0] * direction[0], k[1] * direction[1]};
      probe.evaluate({-2., direction[0], direction[1], 0.});
      const auto distance = [&](const double angle) {
        const double d[2] = {g * std::cos(angle) - trial[0], g * std::sin(angle) - trial[1]};
        return d[0] * d[0] / k[0] + d[1] * d[1] / k[1];
      };
      double best = 0., width = std::acos(-1.);
      for (unsigned int pass = 0; pass < 4; ++pass, width /= 500.) {
        const double center = best;
        for (int i = -1000; i <= 1000; ++i)
          if (distance(center + width * i / 1000) < distance(best))
            best = center + width * i / 1000;
      }
      CHECK_NEAR(probe.stress[1], g * std::cos(best), 1e-6);
      CHECK_NEAR(probe.stress[2], g * std::sin(best), 1e-6);
      CHECK_NEAR(std::hypot(probe.stress[1], probe.stress[2]), g, 1e-13);
      double dissipated = 0.;
      for (int i = 0; i < 2; ++i) {
        CHECK_NEAR(probe.new_state[i], (trial[i] - probe.stress[1 + i]) / k[i], 1e-12);
        dissipated += probe.stress[1 + i] * probe.new_state[i];
      }
      CHECK_NEAR(probe.dissipation, dissipated, 1e-12);
    }
  }
}

/// Slip begins at the static coefficient, goes on at the dynamic one, and after sticking again
/// begins at the static one; torsion is elastic, or limited by f|N|r.
void coefficients_and_torsion() {
  Probe probe(*coulomb, {{"Axial rigidity", 1.},
                         {"Shear rigidity", 1.},
                         {"Friction coefficient", 0.5},
                         {"Dynamic friction coefficient", 0.2},
                         {"Torsional rigidity", 3.},
                         {"Patch radius", 0.4}});
  probe.move({-2., 0.99, 0., 0.1});
  CHECK(probe.contact == ContactStatus::stick);
  CHECK_NEAR(probe.stress[1], 0.99, 1e-14);
  CHECK_NEAR(probe.stress[3], 0.3, 1e-14);
  probe.move({-2., 1.01, 0., 0.1});
  CHECK(probe.contact == ContactStatus::slip);
  CHECK_NEAR(probe.stress[1], 0.4, 1e-14);
  CHECK_NEAR(probe.stress[3], 0.2 * 2. * 0.4, 1e-14); // f of a contact that slips
  probe.move({-2., 1.02, 0., 0.1}); // the trial force 0.41 is below the static limit
  CHECK(probe.contact == ContactStatus::slip);
  CHECK_NEAR(probe.stress[1], 0.4, 1e-14);
  probe.move({-2., 0.71, 0., 0.1});
  CHECK(probe.contact == ContactStatus::stick);
  CHECK_NEAR(probe.stress[1], 0.4 - 0.31, 1e-13);
  probe.move({-2., 1.51, 0., 0.1});
  CHECK_NEAR(probe.stress[1], 0.89, 1e-13);
  probe.move({-2., 1.51, 0., -9.}); // turns only
  CHECK(probe.contact == ContactStatus::stick);
  CHECK_NEAR(probe.stress[3], -0.5 * 2. * 0.4, 1e-14);
  CHECK(probe.dissipation > 0.4 * 8.);

  FrictionThreshold threshold = closed_form_at_rest(*coulomb, probe.parameters);
  CHECK(threshold.static_friction == 0.5 && threshold.dynamic_friction == 0.2);
  probe.parameters[parameter_index(*coulomb, "Dynamic friction coefficient")] = -1.;
  probe.parameters[parameter_index(*coulomb, "Shear rigidity ratio")] = 7.;
  threshold = closed_form_at_rest(*coulomb, probe.parameters);
  CHECK(threshold.dynamic_friction == 0.5);
  CHECK(threshold.shear_rigidity_y == 1. && threshold.shear_rigidity_z == 7.);
}

/// Without friction a closed contact has no shear force and no shear stiffness, not even at rest.
void frictionless() {
  Probe probe(*coulomb,
              {{"Axial rigidity", 1.}, {"Shear rigidity", 1.}, {"Friction coefficient", 0.}});
  for (const double v : {0., 0.3}) {
    probe.move({-2., v, 0., 0.});
    CHECK(probe.contact == ContactStatus::closed);
    CHECK_NEAR(probe.stress[0], -2., 1e-15);
    CHECK_NEAR(probe.stress[1], 0., 0.);
    CHECK_NEAR(probe.tangent[5], 0., 0.);
    CHECK_NEAR(probe.tangent[10], 0., 0.);
    CHECK_NEAR(probe.dissipation, 0., 0.);
  }
}

/// The elastic tangent is that of the closed, sticking contact in every state; LawTangent::none
/// leaves the caller's array alone.
void tangents_asked_for() {
  Probe probe(*coulomb, {{"Axial rigidity", 2.},
                         {"Shear rigidity", 3.},
                         {"Torsional rigidity", 5.},
                         {"Shear rigidity ratio", 4.}});
  for (const Probe::Strain &strain :
       {Probe::Strain{1., 0., 0., 0.}, {-1., 0., 0., 0.}, {-1., 9., 0., 0.}}) {
    probe.tangent.fill(-7.);
    probe.evaluate(strain, LawTangent::none);
    for (const double x : probe.tangent)
      CHECK(x == -7.);
    probe.evaluate(strain, LawTangent::elastic);
    const double diagonal[] = {2., 3., 12., 5.};
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        CHECK_NEAR(probe.tangent[4 * i + j], i == j ? diagonal[i] : 0., 1e-15);
  }
  // In slip along y, dT/deps = -f ES n, and only the direction across has stiffness.
  probe.evaluate({-1., 9., 0., 0.});
  CHECK_NEAR(probe.tangent[4], -0.3 * 2., 1e-14);
  CHECK_NEAR(probe.tangent[5], 0., 1e-14);
}

} // namespace

int main() {
  LawLibrary library;
  library.load_builtin();
  coulomb = &library.find("coulomb");
  node_on_springs();
  back_and_forth();
  opening_and_closing();
  curved_path();
  unequal_rigidities();
  coefficients_and_torsion();
  frictionless();
  tangents_asked_for();
  return check::report();
}
