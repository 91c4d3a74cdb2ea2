// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A host of laws that is no program of deal.II: it presses a support, pushes it aside until it
// slips, and puts the law to the conformance test. law_host [LAW.so]; without one, the law is
// coulomb.
#include <frictionbeam/law_conformance.h>
#include <frictionbeam/law_library.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

using namespace frictionbeam;

/// @return whether the law conforms with its default parameters; if not, says why.
bool conforms(const LawDescription &law) {
  const std::vector<std::string> violations = check_law(law, default_parameters(law));
  for (const std::string &violation : violations)
    std::cerr << law.name << ": " << violation << '\n';
  return violations.empty();
}

/// A step of Coulomb's law that slips: |T| = f |N|, and what it dissipates is the friction's work.
bool slips_as_it_should(const LawDescription &law) {
  const double ES = 4e6, GS = 1e6, f = 0.25, eps = -1e-3, gamma = 5e-3;
  // [a step of a law]
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Axial rigidity")] = ES;
  parameters[parameter_index(law, "Shear rigidity")] = GS;
  parameters[parameter_index(law, "Friction coefficient")] = f;
  const std::vector<double> old_state(law.n_internal_variables, 0.);
  std::vector<double> new_state(old_state);
  const double strain[n_support_strains] = {eps, gamma, 0., 0.}, rate[n_support_strains] = {};
  const double l = 0.2, displacement[3] = {eps * l, gamma * l, 0.};
  double stress[n_support_strains];

  LawInput input{};
  input.parameters = parameters.data();
  input.strain = strain;
  input.strain_rate = rate;
  input.displacement = displacement;
  input.length = l;
  input.temperature = 20.;
  input.old_state = old_state.data();
  LawOutput output{};
  output.stress = stress;
  output.new_state = new_state.data();
  if (law.law->integrate(input, output) != LawStatus::ok)
    throw std::runtime_error("The law has no answer.");
  // [end of a step]
  std::cout << law.name << ": N = " << stress[0] << " N, T = " << stress[1] << " N, dissipates "
            << output.dissipation * l << " J\n";
  const double N = ES * eps, T = -f * N, slip = gamma - T / GS;
  const auto is = [](const double value, const double expected) {
    return std::abs(value - expected) < 1e-12 * std::abs(expected);
  };
  return output.contact == ContactStatus::slip && is(stress[0], N) && is(stress[1], T) &&
         is(output.dissipation, T * slip);
}

int main(int argc, char **argv) {
  try {
    LawLibrary library;
    if (argc > 1)
      return conforms(library.load(argv[1])) ? 0 : 1;
    library.load_builtin();
    const LawDescription &coulomb = library.find("coulomb");
    return slips_as_it_should(coulomb) && conforms(coulomb) ? 0 : 1;
  } catch (const std::runtime_error &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
