// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of plastic pipe sections shall have the figures of exact solutions: limit surface,
// bending beyond yield and back, axial force with moment, stretch then twist, thermal cycles,
// ratchets; and none of them shall change when the pipe is turned.
#include "section_probe.h"

#include <algorithm>
#include <random>

using namespace frictionbeam;

namespace {

using P = SectionProbe;

/// One implicit step from zero, of isotropic hardening, axial force, moments, torsion and pressure
/// together.
void one_step(const LawDescription &fibre) {
  const Tube tube;
  P probe(fibre, tube.values({{"Isotropic modulus", 2e9}, {"Fibres", 255.}}));
  probe.increment.pressure = tube.pressure(6e7);
  probe.strain = {4e-4 + tube.nu * 6e7 / tube.E, 0., 0., 0.01, 0.02, 0.005};
  CHECK(probe.evaluate());
  near("one step, N", probe.stress[P::N], 1.568668e5, 2e-4);
  near("one step, M_y", probe.stress[P::My], 3.310984e4, 2e-5);
  near("one step, M_z", probe.stress[P::Mz], 8.277251e3, 6e-5);
  near("one step, T", probe.stress[P::T], 1.402136e4, 3e-5);
  const auto errors = probe.tangent_errors(1e-9);
  near("one step, tangent", errors[0], 0., 1e-5);
  near("one step, symmetry", errors[1], 0., 1e-14);
}

/// Limit moment of a thin tube under n, tau/sy and hoop stress over sy.
double limit_moment(const double n, const double tau, const double hs) {
  const double s = std::sqrt(1. - 3. * tau * tau - 0.75 * hs * hs);
  return s * std::cos(pi * (n - hs / 2.) / (2. * s));
}

/// Driven far along some direction of the strains a section comes to a point of its limit surface.
void limit_surface(const LawDescription &fibre, const LawDescription &whole) {
  CHECK_NEAR(limit_moment(0., .3, 0.), .85440037, 1e-8);
  CHECK_NEAR(limit_moment(.25, 0., .5), .90138782, 1e-8);
  CHECK_NEAR(limit_moment(.25, .3, .5), .73654599, 1e-8);
  CHECK_NEAR(limit_moment(.3, 0., .6), std::sqrt(1. - .75 * .36), 1e-15); // a closed pipe
  const Tube tube;
  for (const double hs : {0., .5, -.6})
    for (const double axial : {0., .2, -.5, .9})
      for (const double twist : {0., .5, 2.}) {
        P probe(fibre, tube.values()), one(whole, tube.of_the_whole());
        probe.increment.pressure = one.increment.pressure = tube.pressure(hs * tube.sy);
        for (const double k : {1., 3., 10., 100., 1000., 3000.}) {
          const double size = k * tube.ky();
          const P::Six to{axial * size * tube.r, 0., 0., twist * size, .8 * size, .6 * size};
          CHECK(probe.move(to) && one.move(to));
        }
        const auto reached = [&](const P &of, double &n, double &tau) {
          n = of.stress[P::N] / tube.Np();
          tau = of.stress[P::T] / (tube.A() * tube.r * tube.sy);
          return std::hypot(of.stress[P::My], of.stress[P::Mz]) / tube.Mp();
        };
        double n, tau;
        const double m = reached(probe, n, tau);
        std::cout << "n " << n << ", tau/sy " << tau << ", hs " << hs << ": ";
        near("limit moment", m, limit_moment(n, tau, hs), 6e-4);
        const double of_one = reached(one, n, tau);
        CHECK_NEAR(n * n + 3. * tau * tau + of_one * of_one, 1., 1e-12);
      }
  // The global law's surface is too large: by 7 and 11 % in the moment at two of the points above.
  CHECK_NEAR(std::sqrt(1. - .0625) / limit_moment(.25, 0., .5), 1.0742, 1e-4);
  CHECK_NEAR(std::sqrt(1. - .0625 - .27) / limit_moment(.25, .3, .5), 1.1093, 1e-4);
}

double moment_of_thin_tube(const double k) {
  const double b = std::asin(1. / k);
  return (b / std::sin(b) + std::cos(b)) / 2.;
}

void bending(const LawDescription &fibre, const LawDescription &whole) {
  const Tube tube;
  for (const auto &[k, m] :
       {std::pair(1.25, .87955951), std::pair(2., .95661148), std::pair(5., .99329275)}) {
    P probe(fibre, tube.values());
    CHECK(probe.move({0., 0., 0., 0., k * tube.ky(), 0.}));
    near("M(k)/Mp", probe.stress[P::My] / tube.Mp(), m, 5e-4);
    CHECK_NEAR(moment_of_thin_tube(k), m, 1e-8);
    if (k == 2.) {
      CHECK(probe.reach({{P::My, 0.}}));
      near("residual curvature", probe.strain[P::My] / tube.ky(), .782004, 5e-4);
    }
    P one(whole, tube.of_the_whole()); // elastic up to Mp at 4/pi ky
    CHECK(one.move({0., 0., 0., 0., k * tube.ky(), 0.}));
    CHECK_NEAR(one.stress[P::My] / tube.Mp(), std::min(1., k * pi / 4.), 1e-12);
  }
  P probe(fibre, tube.values());
  CHECK(probe.move({0.8 * tube.ey(), 0., 0., 0., 2. * tube.ky(), 0.}));
  near("N with M, n", probe.stress[P::N] / tube.Np(), .27927127, 1.5e-3);
  near("N with M, m", probe.stress[P::My] / tube.Mp(), .85586829, 6e-4);

  // SSNL106, a tube of .1 and .099 m, and the limit moment of a thick one.
  const auto thick = [&](const double ro, const double ri, const double sy, const double radii) {
    return P(fibre, {{"Outside diameter", 2. * ro},
                     {"Wall thickness", ro - ri},
                     {"Yield stress", sy},
                     {"Radii", radii}});
  };
  P ssnl106 = thick(.1, .099, 1.5e8, 2.);
  CHECK(ssnl106.move({0., 0., 0., 0., .0075, 0.}));
  near("SSNL106, M(.0075)", ssnl106.stress[P::My], 4642.173, 5e-4);
  CHECK(ssnl106.move({0., 0., 0., 0., .0375, 0.}));
  near("SSNL106, M(.0375)", ssnl106.stress[P::My], 5899.954, 5e-4);
  for (const double ri : {.09, .08}) {
    const double Mp = 4. / 3. * (1e-3 - ri * ri * ri) * 2e8;
    for (const double radii : {1., 2.}) {
      P tube = thick(.1, ri, 2e8, radii);
      CHECK(tube.move({0., 0., 0., 0., 100., 0.}));
      near("thick Mp", tube.stress[P::My], Mp, radii == 2. ? 2e-4 : ri == .09 ? 6e-4 : 2.2e-3);
    }
  }
}

void elastic(const LawDescription &fibre) {
  const double ro = .1, ri = .08, E = 2e11, G = E / 2.6;
  const double A = pi * (ro * ro - ri * ri), I = pi / 4. * (std::pow(ro, 4) - std::pow(ri, 4));
  for (const double radii : {1., 2.})
    for (const double fibres : {5., 16., 63.}) {
      P probe(fibre, {{"Wall thickness", .02}, {"Fibres", fibres}, {"Radii", radii}});
      probe.strain = {1e-4, 1e-4, -2e-4, 1e-3, 2e-3, -1e-3};
      probe.evaluate();
      const double exact[6] = {E * A, 1e8, 1e8, 2. * G * I, E * I, E * I};
      for (int i = 0; i < 6; ++i) {
        CHECK_NEAR(probe.stress[i], exact[i] * probe.strain[i], 1e-13);
        CHECK_NEAR(probe.tangent[7 * i], exact[i], 1e-13);
      }
      CHECK(probe.law.elastic_bound(probe.strain.data(), 1., {}) < 1.);
      // The same of fibres that are asked one by one: of a section that has flowed before.
      const P::Six strain = probe.strain;
      probe.move({.02, 0., 0., .3, .1, .05});
      probe.strain = strain;
      probe.reach({{0, 0.}, {3, 0.}, {4, 0.}, {5, 0.}});
      probe.evaluate();
      for (int i = 0; i < 6; ++i)
        CHECK_NEAR(probe.tangent[7 * i], exact[i], 1e-12);
    }
}

/// Stretch to yield, then twist with the length held; backward Euler's own figures, of order 1.
void stretch_then_twist(const LawDescription &fibre) {
  Tube tube;
  tube.nu = 0.5;
  const double exact = 1. / std::cosh(1.);
  double last = 0.;
  for (const auto &[steps, figure] :
       {std::pair(10, .658013), std::pair(100, .649117), std::pair(1000, .648161)}) {
    P probe(fibre, tube.values({{"Fibres", 5.}}));
    const double gamma = tube.sy / std::sqrt(3.) / (tube.E / 3.);
    for (int i = 0; i <= steps; ++i)
      CHECK(probe.move({tube.ey(), 0., 0., gamma / tube.r * i / steps, 0., 0.}));
    const double s = probe.stress[P::N] / tube.Np();
    near("stretch then twist", s, figure, 1e-6);
    const double tau = std::sqrt(3.) * probe.stress[P::T] / (tube.A() * tube.r * tube.sy);
    CHECK_NEAR(s * s + tau * tau, 1., 1e-12);
    if (last != 0.)
      CHECK_NEAR((last - exact) / (s - exact), 10., 0.1);
    last = s;
  }
  CHECK_NEAR(exact, .64805427, 1e-7);
}

/// Torsion alone, at the apex of the limit surface, and what is bent there; and an elbow's limit.
void torsion(const LawDescription &fibre, const LawDescription &whole) {
  const Tube tube;
  const double Tp = tube.A() * tube.r * tube.sy / std::sqrt(3.);
  for (const char *const modulus : {"Isotropic modulus", "Kinematic modulus"})
    for (const double H : {0., 2e9}) {
      P probe(fibre, tube.values({{modulus, H}}));
      CHECK(probe.move({0., 0., 0., .1, 0., 0.}));
      // T/A/r = (sy + H g/sqrt3)/sqrt3, g the plastic shear strain r chi - tau/G
      const double G = tube.E / 2.6;
      CHECK_NEAR(probe.stress[P::T] / Tp,
                 (1. + H * tube.r * .1 / (std::sqrt(3.) * tube.sy)) / (1. + H / (3. * G)), 1e-12);
      CHECK(probe.move({0., 0., 0., .2, 0., 0.}));
      if (H == 0.)
        CHECK_NEAR(probe.stress[P::T] / Tp, 1., 1e-12);
      CHECK(probe.move({0., 0., 0., .2, 1e-9, 0.})); // what is left of Q is as small
      CHECK_NEAR(probe.stress[P::T] / Tp, H == 0. ? 1. : probe.stress[P::T] / Tp, 1e-9);
      CHECK(probe.move({0., 0., 0., .3, .1, .05}));
      const double m = std::hypot(probe.stress[P::My], probe.stress[P::Mz]) / tube.Mp();
      if (H == 0.)
        CHECK_NEAR(m * m + std::pow(probe.stress[P::T] / Tp, 2), 1., 3e-3);
      CHECK(probe.stress[P::My] > 0. && probe.stress[P::Mz] > 0.);
    }
  P::Values values = tube.of_the_whole();
  const double lambda = .2;
  values["Bend radius"] = lambda * tube.r * tube.r / tube.t;
  P elbow(whole, values);
  CHECK(elbow.move({0., 0., 0., 0., 1., 0.}));
  CHECK_NEAR(elbow.stress[P::My] / tube.Mp(), 1.125 * std::pow(lambda, 2. / 3.), 1e-12);
}

/// SSNL112: a clamped bar, thermal cycles.
void thermal_cycles(const LawDescription &fibre, const LawDescription &whole) {
  const double E = 2e11, Et = 2e9, A = 5e-4, D = 0.05, t = D / 2. - std::sqrt(D * D / 4. - A / pi);
  const P::Values common{{"Outside diameter", D},
                         {"Wall thickness", t},
                         {"Yield stress", 2e8},
                         {"Isotropic modulus", E * Et / (E - Et)}};
  P::Values of_fibres = common, of_whole = common;
  of_fibres["Young's modulus"] = E;
  of_whole["Axial rigidity"] = E * A;
  P fibres(fibre, of_fibres), one(whole, of_whole);
  const double T[] = {-50., -300., -100., 50., -150., -350., -200.},
               N[] = {1e5, 1.025e5, -9.75e4, -1.0395e5, 9.605e4, 1.05871e5, -4.4129e4};
  for (int i = 0; i < 7; ++i)
    for (P *probe : {&fibres, &one}) {
      CHECK(probe->move({1e-5 * (50. - T[i]), 0., 0., 0., 0., 0.}));
      near("SSNL112, N", probe->stress[P::N], N[i], 1e-5);
    }
}

/// Strain per cycle, perfectly plastic: (a) axial force held, bending strain cycled; (b) moment
/// held, axial strain cycled.
void ratchets(const LawDescription &fibre) {
  const Tube tube;
  const auto per_cycle = [&](const int held, const double stress, const int cycled,
                             const double range) {
    P probe(fibre, tube.values());
    const std::map<int, double> holds{{held, stress}};
    CHECK(probe.reach(holds));
    double at = 0., gain = 0.;
    for (int i = 0; i < 20; ++i) {
      // In parts: what flows is not all that flows when the range is made in one.
      for (const double to : {1., 0.})
        for (int j = 1; j <= 20; ++j) {
          probe.strain[cycled] = range * (to == 1. ? j / 20. : 1. - j / 20.);
          CHECK(probe.reach(holds));
        }
      gain = probe.strain[held] - at;
      at = probe.strain[held];
    }
    return gain;
  };
  near("ratchet (a)", per_cycle(P::N, .8 * tube.Np(), P::My, tube.ky()) / tube.ey(), .51582660,
       3e-3);
  near("ratchet (b)", per_cycle(P::My, .5 * tube.Mp(), P::N, 1.5 * tube.ey()) / tube.ky(),
       1.27323954, 3e-3);
  // Below the bounds n = 1 - Y/pi and Y = 2 (1 - m): it shakes down.
  near("no ratchet (a)", per_cycle(P::N, .67 * tube.Np(), P::My, tube.ky()) / tube.ey(), 0., 1e-6);
  near("no ratchet (b)", per_cycle(P::My, .5 * tube.Mp(), P::N, 0.8 * tube.ey()) / tube.ky(), 0.,
       1e-6);
}

/// Nothing changes by more than the quadrature's error when the pipe is turned about its axis.
void directions(const LawDescription &fibre) {
  const Tube tube;
  for (const auto &[fibres, tolerance] : {std::pair(15., 3.7e-3), std::pair(16., 2e-2),
                                          std::pair(31., 8.6e-4), std::pair(63., 2.1e-4)}) {
    double least = 1e300, most = 0.;
    for (int i = 0; i < 200; ++i) {
      const double turn = 2. * pi * i / 200., k = 100. * tube.ky();
      P probe(fibre, tube.values({{"Fibres", fibres}}));
      CHECK(probe.move({0., 0., 0., 0., k * std::cos(turn), k * std::sin(turn)}));
      const double m =
          (probe.stress[P::My] * std::cos(turn) + probe.stress[P::Mz] * std::sin(turn)) / tube.Mp();
      least = std::min(least, m);
      most = std::max(most, m);
    }
    near("least moment of all directions", least, 1., tolerance + 1e-4);
    near("largest moment of all directions", most, 1., tolerance + 1e-4);
  }
}

/// Work of the stress less dissipation and gain of stored energy, under a large pressure that
/// stays, over the work; half of it remains with increments half as long.
double lost_energy(const LawDescription &law, const P::Values &values, const double pressure,
                   const int n_steps) {
  P probe(law, values);
  probe.increment.pressure = pressure;
  CHECK(probe.evaluate());
  double work = 0., kept = 0., begin = probe.stored;
  P::Six last_stress = probe.stress, last_strain{};
  for (int step = 1; step <= n_steps; ++step) {
    const double place = 4. * step / n_steps, bend = std::sin(2. * place), pull = std::sin(place);
    const P::Six strain{2e-3 * pull, 0., 0., 4e-2 * bend, 3e-2 * pull, 1e-2 * bend};
    CHECK(probe.move(strain) && probe.dissipation >= 0.);
    double one = 0.;
    for (int i = 0; i < 6; ++i)
      one += (probe.stress[i] + last_stress[i]) / 2. * (strain[i] - last_strain[i]);
    work += std::abs(one);
    kept += one - probe.dissipation;
    last_stress = probe.stress;
    last_strain = strain;
  }
  return (kept - (probe.stored - begin)) / work;
}

void energies(const LawDescription &fibre, const LawDescription &whole) {
  const Tube tube;
  for (const double hoop : {0., .5, -.5})
    for (const P::Values &hardening :
         {P::Values{{"Isotropic modulus", 4e10}}, P::Values{{"Kinematic modulus", 4e10}},
          P::Values{{"Hardening strain 1", 1e-3}, {"Hardening stress 1", 3e8}}})
      for (const LawDescription *const law : {&fibre, &whole}) {
        P::Values values = law == &fibre ? tube.values({{"Fibres", 15.}}) : tube.of_the_whole();
        values.insert(hardening.begin(), hardening.end());
        if (law == &whole)
          values["Pressure coefficient"] = .9;
        const double pressure = tube.pressure(hoop * tube.sy);
        const double once = lost_energy(*law, values, pressure, 1000),
                     twice = lost_energy(*law, values, pressure, 2000);
        near("energy, extrapolated", 2. * twice - once, 0., 5e-5);
        CHECK(std::abs(twice) < 1e-2);
        // Pulled and twisted, all fibres alike: what is lost is sy dp, whatever hardens.
        P probe(*law, values);
        probe.increment.pressure = pressure;
        double lost = 0.;
        for (int i = 1; i <= 4000; ++i) {
          const double place = std::sin(4. * i / 4000.);
          CHECK(probe.move({4e-3 * place, 0., 0., 3e-2 * place, 0., 0.}));
          lost += probe.dissipation;
        }
        const double p =
            probe.law.report(probe.strain.data(), 1., probe.increment, probe.state.data())
                .plastic_strain;
        near("dissipation over A sy p", lost / (tube.A() * tube.sy * p), 1., 1e-3);
      }
}

/// The return of the global law ends on the yield surface whatever it is given.
void always_returns(const LawDescription &whole) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const Tube tube;
  for (int draw = 0; draw < 3000; ++draw) {
    P::Values values = tube.of_the_whole();
    if (draw % 3 == 1)
      values["Isotropic modulus"] = std::pow(10., 10. + 2. * uniform(random));
    if (draw % 3 == 2)
      values["Kinematic modulus"] = std::pow(10., 9. + 4. * uniform(random));
    values["Pressure coefficient"] = 1.;
    P probe(whole, values);
    probe.increment.pressure = tube.sy * tube.t / tube.r * 0.95 * uniform(random);
    for (int step = 0; step < 3; ++step) {
      const double size = std::pow(10., -3. + 3. * uniform(random));
      P::Six to;
      for (double &e : to)
        e = size * uniform(random);
      CHECK(probe.move(to));
      if (probe.dissipation == 0.)
        continue;
      // s - H e of the stress, over R: on the surface.
      const double H = probe.law.parameters()[parameter_index(whole, "Kinematic modulus")],
                   h = probe.law.parameters()[parameter_index(whole, "Isotropic modulus")];
      const double I = pi * std::pow(tube.r, 3) * tube.t;
      const double a[4] = {1. / tube.A(), std::sqrt(3.) * tube.r / (2. * I), pi / 4. * tube.r / I,
                           pi / 4. * tube.r / I};
      const int place[4] = {P::N, P::T, P::My, P::Mz};
      double sum = std::pow(probe.increment.pressure * tube.r / tube.t - H * probe.state[4], 2);
      for (int i = 0; i < 4; ++i)
        sum += std::pow(a[i] * probe.stress[place[i]] - H * probe.state[i], 2);
      const double R = tube.sy + h * probe.state[5], back = H * 1e-16 * probe.state[5] / R;
      CHECK_NEAR(std::sqrt(sum) / R, 1., 1e-13 + 10. * back);
    }
  }
}

} // namespace

int main() {
  LawLibrary library;
  library.load_builtin();
  const LawDescription &fibre = library.find("fibre_pipe"), &whole = library.find("global_plastic");
  elastic(fibre);
  one_step(fibre);
  limit_surface(fibre, whole);
  bending(fibre, whole);
  stretch_then_twist(fibre);
  thermal_cycles(fibre, whole);
  torsion(fibre, whole);
  ratchets(fibre);
  directions(fibre);
  energies(fibre, whole);
  always_returns(whole);
  return check::report();
}
