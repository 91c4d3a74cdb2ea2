// Behaviours of MFront, as MGIS gives them, shall be laws: a cohesive zone model of a support, a
// general behaviour of six strains of a section. Here MGIS is the stand-in of mgis_stand_in/, whose
// behaviours are the built-in law coulomb of tractions and a section with closed forms; what no law
// can be is refused in words.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>
#include <frictionbeam/law_conformance.h>

#include "../check.h"
#include "../plugin/probe.h"

#include <cmath>
#include <random>
#include <stdexcept>

using namespace frictionbeam;

namespace {

std::string folder;
LawLibrary library;

void refused(const std::string &law, const std::vector<std::string> &words) {
  std::string message;
  try {
    library.load(folder + "/mgis_" + law + ".so");
  } catch (const std::runtime_error &error) {
    message = error.what();
  }
  for (const std::string &word : words)
    if (message.find(word) == std::string::npos) {
      std::cerr << "no '" << word << "' in '" << message << "'\n";
      CHECK(false);
    } else
      CHECK(true);
}

void cohesive() {
  const LawDescription &law = library.find("mgis_cohesive"), &coulomb = library.find("coulomb");
  CHECK(law.kind == LawKind::support && law.n_parameters == 4);
  CHECK(law.n_internal_variables == 2 + 3 + 3 + 2);
  CHECK(std::string(law.parameters[1].name) == "NormalStiffness");
  CHECK(law.parameters[1].minimum == 1. && law.parameters[1].maximum == 1e300);
  CHECK(law.parameters[3].minimum == 0. && law.parameters[3].maximum == 10.);
  CHECK(default_parameters(law) == (std::vector<double>{1., 1e9, 2e9, 0.}));
  const double area = 0.02, length = 0.7, K_n = 4e8, K_t = 3e8, by = area * length;
  Probe probe(law,
              {{"Contact area", area},
               {"NormalStiffness", K_n},
               {"TangentialStiffness", K_t},
               {"FrictionCoefficient", 0.4}},
              length);
  Probe same_law(
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
      probe.evaluate(strain, tangent);
      same_law.evaluate(strain, tangent);
      const double force = by * K_n * 1e-3;
      bool same = probe.status == LawStatus::ok &&
                  std::abs(probe.dissipation - same_law.dissipation) <= 1e-12 * force * 1e-3;
      for (unsigned int k = 0; k < 4; ++k)
        same = same && std::abs(probe.stress[k] - same_law.stress[k]) <= 1e-12 * force;
      for (unsigned int k = 0; k < 16; ++k)
        same = same && std::abs(probe.tangent[k] - same_law.tangent[k]) <= 1e-12 * by * K_n;
      CHECK(same);
      CHECK(probe.contact == (strain[0] < 0. ? ContactStatus::closed : ContactStatus::open));
    }
    dissipated += probe.dissipation;
    probe.commit();
    same_law.commit();
  }
  CHECK(dissipated > 0.);
  for (const double strain : {1e4, -1e4}) { // the behaviour fails there, or calls it unreliable
    probe.evaluate({strain, 0., 0., 0.});
    CHECK(probe.status == LawStatus::failed);
  }
  CHECK(check_law(law, probe.parameters).empty());
}

void section(const std::string &name) {
  const LawDescription &law = library.find(name);
  CHECK(law.kind == LawKind::section && law.n_parameters == 3);
  const double EA = 3e8, EI = 2e6, c = 1e5;
  const BoundLaw bound(law, {EA, EI, c});
  std::vector<double> state(law.n_internal_variables, 0.), next(state);
  double stress[6], tangent[36];
  const double rate[6] = {}, rigidity[6] = {EA, EA, EA, EI, EI, EI};
  const auto move = [&](const std::vector<double> &strain, const double temperature,
                        const LawTangent kind) {
    LawOutput output{stress, tangent, next.data(), 0., ContactStatus::stick};
    CHECK(bound.integrate(strain.data(), rate, 1., {0., 0., temperature}, state.data(), kind,
                          output) == LawStatus::ok);
    CHECK(output.contact == ContactStatus::none && output.dissipation == 0.);
    std::swap(state, next);
  };
  // The first temperature is where it begins; then 50 K more give -EA 5e-4.
  const std::vector<double> strain = {1e-3, 2e-3, -1e-3, 3e-3, 4e-3, -2e-3};
  move(std::vector<double>(6, 1e-3), 30., LawTangent::none);
  move(strain, 80., LawTangent::consistent);
  for (unsigned int i = 0; i < 6; ++i)
    CHECK_NEAR(stress[i], rigidity[i] * strain[i] + (i == 0 ? c * 4e-3 - EA * 1e-5 * 50. : 0.),
               1e-12);
  for (const LawTangent kind : {LawTangent::consistent, LawTangent::elastic}) {
    std::fill(tangent, tangent + 36, -1.);
    move(strain, 80., kind);
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        CHECK(tangent[6 * i + j] == (i == j ? rigidity[i] : i == 0 && j == 4 ? c : 0.));
  }
  CHECK(check_law(law, {EA, EI, c}).empty());
}

} // namespace

int main(int, char **argv) {
  folder = argv[1];
  library.load_builtin();
  for (const char *name : {"cohesive", "section", "vectors"})
    library.load(folder + "/mgis_" + name + ".so");
  cohesive();
  section("mgis_section");
  section("mgis_vectors");
  refused("nothing", {"does not load the behaviour 'Nothing' from 'libStandIn.so'",
                      "the stand-in has no such behaviour", "mfront --interface=generic"});
  refused("strain", {"'Strain' is of MGIS' type 1 with 6 gradients, 6 forces and 36 entries",
                     "a general behaviour of six generalized strains", "type 0, 6, 6 and 36"});
  refused("swapped",
          {"'Section' is of MGIS' type 0", "a cohesive zone model", "type 3, 3, 3 and 9"});
  refused("field", {"'Field' wants the external state variable 'Porosity'", "Temperature alone"});
  refused("default", {"DEFAULTS names 'Rigidity', which is no material property of", "'Section'"});
  return check::report();
}
