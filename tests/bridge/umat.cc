// A UMAT shall be a law: of a support, the built-in law coulomb where it says the same of tractions
// (pad_umat.c); of a section, that of a tube of its material (fibre_umat.c): elastic rigidities of
// the ring to rounding, the plastic moment of a thin ring 2/pi A r sigma_y to 1 %, stress by
// heating where it is held. SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>
#include <frictionbeam/law_conformance.h>

#include "../check.h"
#include "../plugin/probe.h"

#include <cmath>
#include <random>

using namespace frictionbeam;

namespace {

LawLibrary library;

std::vector<double> parameters_of(const LawDescription &law, const Probe::Values &values) {
  return Probe(law, values).parameters;
}

void support() {
  const LawDescription &pad = library.find("pad"), &coulomb = library.find("coulomb");
  CHECK(pad.kind == LawKind::support && pad.n_parameters == 5 && pad.n_internal_variables == 13);
  const double area = 0.02, thickness = 0.1, length = 0.7, K_n = 4e8, K_t = 3e8;
  Probe umat(pad,
             {{"Contact area", area},
              {"Thickness", thickness},
              {"Normal stiffness", K_n},
              {"Shear stiffness", K_t},
              {"Friction coefficient", 0.4}},
             length);
  // N = area K_n (length / thickness) eps.
  const double by = area * length / thickness;
  Probe law(
      coulomb,
      {{"Axial rigidity", by * K_n}, {"Shear rigidity", by * K_t}, {"Friction coefficient", 0.4}},
      length);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  double dissipated = 0.;
  for (unsigned int i = 0; i < 300; ++i) {
    const Probe::Strain strain = {uniform(random) - 5e-4, 0.3 * uniform(random),
                                  0.3 * uniform(random), uniform(random)};
    for (const LawTangent tangent : {LawTangent::elastic, LawTangent::consistent}) {
      umat.evaluate(strain, tangent);
      law.evaluate(strain, tangent);
      const double force = by * K_n * 1e-3;
      bool same = umat.status == LawStatus::ok &&
                  std::abs(umat.dissipation - law.dissipation) <= 1e-12 * force * 1e-3;
      for (unsigned int k = 0; k < 4; ++k)
        same = same && std::abs(umat.stress[k] - law.stress[k]) <= 1e-12 * force;
      for (unsigned int k = 0; k < 16; ++k)
        same = same && std::abs(umat.tangent[k] - law.tangent[k]) <= 1e-12 * by * K_n;
      CHECK(same);
      CHECK(umat.contact == (strain[0] < 0. ? ContactStatus::closed : ContactStatus::open));
    }
    dissipated += umat.dissipation;
    umat.commit();
    law.commit();
  }
  CHECK(dissipated > 0.);
  umat.evaluate({1e4, 0., 0., 0.}); // it asks for a shorter increment
  CHECK(umat.status == LawStatus::failed);
  CHECK(check_law(pad, umat.parameters).empty());
}

/// A section law, driven.
class Section {
public:
  Section(const LawDescription &law, const Probe::Values &values)
      : law(law, parameters_of(law, values)), state(law.n_internal_variables), next(state) {}

  void move(const std::vector<double> &strain, const double temperature = 20.,
            const LawTangent kind = LawTangent::consistent) {
    const double rate[6] = {};
    LawOutput output{stress, tangent, next.data(), 0., ContactStatus::stick};
    CHECK(law.integrate(strain.data(), rate, 1., {0., 0., temperature}, state.data(), kind,
                        output) == LawStatus::ok);
    CHECK(output.contact == ContactStatus::none);
    dissipation = output.dissipation;
    std::swap(state, next);
  }

  BoundLaw law;
  std::vector<double> state, next;
  double stress[6], tangent[36], dissipation = 0.;
};

void section() {
  const LawDescription &fibre = library.find("fibre");
  CHECK(fibre.kind == LawKind::section && fibre.n_internal_variables == 16 * (2 + 1 + 1 + 3) + 2);
  const double pi = std::acos(-1.), D = 0.3, d = 0.28, E = 2e11, G = 8e10, yield = 2e8;
  const double A = pi / 4. * (D * D - d * d), I = pi / 64. * (std::pow(D, 4) - std::pow(d, 4));
  const Probe::Values values = {{"Outside diameter", D}, {"Wall thickness", (D - d) / 2.},
                                {"Shear modulus", G},   {"Shear area ratio", 0.53},
                                {"Young's modulus", E}, {"Yield stress", yield},
                                {"Expansion", 1.2e-5}};
  const double rigidity[6] = {E * A, 0.53 * G * A, 0.53 * G * A, 2. * G * I, E * I, E * I};
  Section elastic(fibre, values);
  const std::vector<double> strain = {1e-4, 2e-4, -3e-4, 1e-3, 2e-3, -1e-3};
  elastic.move(strain);
  for (unsigned int i = 0; i < 6; ++i) {
    CHECK_NEAR(elastic.stress[i], rigidity[i] * strain[i], 1e-12);
    for (unsigned int j = 0; j < 6; ++j)
      CHECK(std::abs(elastic.tangent[6 * i + j] - (i == j ? rigidity[i] : 0.)) <=
            1e-6 * rigidity[4]);
  }
  CHECK(elastic.dissipation == 0.);

  // Bent far beyond the limit about an axis between y and z, in steps.
  Section bent(fibre, values);
  const double radius = std::sqrt((D * D + d * d) / 8.), angle = 0.3;
  double work = 0., dissipated = 0., M = 0., kappa = 0.;
  for (unsigned int i = 1; i <= 400; ++i) {
    const double next = i * 1e-3, before = M;
    bent.move({0., 0., 0., 0., next * std::cos(angle), next * std::sin(angle)}, 20.,
              i % 2 == 0 ? LawTangent::consistent : LawTangent::none);
    M = bent.stress[4] * std::cos(angle) + bent.stress[5] * std::sin(angle);
    work += (before + M) / 2. * (next - kappa);
    dissipated += bent.dissipation;
    kappa = next;
  }
  CHECK_NEAR(M, 2. / pi * A * radius * yield, 1e-2);
  CHECK(std::abs(bent.stress[0]) < 1e-9 * yield * A);
  // Work is stored in the fibres, at most sigma_y^2 / 2E each, or lost.
  CHECK(dissipated < work && dissipated > work - 1.01 * A * yield * yield / (2. * E));
  std::vector<double> tangent_before(bent.tangent, bent.tangent + 36);
  bent.move({0., 0., 0., 0., kappa * std::cos(angle), kappa * std::sin(angle)}, 20.,
            LawTangent::elastic);
  CHECK(tangent_before[28] < 0.05 * rigidity[4]);
  CHECK_NEAR(bent.tangent[28], rigidity[4], 1e-12);

  // Held and heated by 50 K after an increment at 20 degC: N = -E A alpha 50; the first increment
  // has no temperature before it.
  Section held(fibre, values);
  const std::vector<double> zero(6, 0.);
  held.move(zero, 20.);
  CHECK(held.stress[0] == 0.);
  held.move(zero, 70.);
  CHECK_NEAR(held.stress[0], -E * A * 1.2e-5 * 50., 1e-12);
  held.move(zero, 70.);
  CHECK_NEAR(held.stress[0], -E * A * 1.2e-5 * 50., 1e-12);
  CHECK(check_law(fibre, elastic.law.parameters()).empty());
}

} // namespace

int main(int, char **argv) {
  library.load_builtin();
  library.load(std::string(argv[1]) + "/pad.so");
  library.load(std::string(argv[1]) + "/fibre.so");
  support();
  section();
  return check::report();
}
