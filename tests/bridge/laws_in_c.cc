// A law in C shall pass the same door as one in C++ and do the same: coulomb_in_c.c is the built-in
// law coulomb along a path, with its closed form; a law that has a state to begin with begins with
// it; a malformed one (broken_law_c.c) is refused with what was found, expected, and what to try.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_c.h>
#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_conformance.h>

#include "../check.h"
#include "../plugin/probe.h"

#include <random>
#include <stdexcept>

using namespace frictionbeam;

namespace {

std::string folder; ///< of the laws

std::string file_of(const std::string &fault) { return folder + "/broken_c_" + fault + ".so"; }

void refused(const std::string &fault, std::vector<std::string> words) {
  std::string message;
  LawLibrary library;
  try {
    library.load(file_of(fault));
  } catch (const std::runtime_error &error) {
    message = error.what();
  }
  words.push_back("The law library '" + file_of(fault) + "' cannot be used: ");
  for (const std::string &word : words)
    if (message.find(word) == std::string::npos) {
      std::cerr << "no '" << word << "' in '" << message << "'\n";
      CHECK(false);
    } else
      CHECK(true);
  CHECK(library.names(LawKind::support).empty());
}

void malformed() {
  refused("SYMBOL_MISSING", {"does not export the object 'frictionbeam_law'",
                             "or the function 'frictionbeam_law_c' of frictionbeam/law_c.h"});
  refused("NOTHING_AT_ALL", {"frictionbeam_law_c() returns null", "address of"});
  refused("VERSION_WRONG", {"version 2 of the law interface in C", "this program has version 1",
                            "Compile it again", "frictionbeam/law_c.h"});
  refused("SIZE_WRONG", {"has 12 bytes, expected " + std::to_string(sizeof(frictionbeam_c_law)),
                         "sizeof(frictionbeam_c_law)"});
  refused("FAULT", {"the table of stiffnesses is missing"});
  refused("INTEGRATE_MISSING", {"no integrate()", "frictionbeam_c_law::integrate"});
  refused("KIND_WRONG", {"kind is 5", "FRICTIONBEAM_SUPPORT (0)", "frictionbeam_c_law::kind"});
  refused("STATES_WRONG", {"1000 internal variables, expected 0 to 999"});
  refused("LIST_TOO_LONG", {"announces 2000000000 parameters, expected 0 to 1000"});
  refused("LIST_MISSING", {"announces 1 parameters without a list"});
  refused("NAME", {"no name"});
  refused("REFERENCE", {"no reference"});
  refused("PARAMETER_NAME", {"parameter number 0 lacks a name"});
  refused("UNIT", {"parameter 'Start' lacks", "'-' if it has no unit"});
  refused("DEFAULT_NAN", {"the default nan", "of its parameter 'Start' is not finite"});
  refused("MINIMUM_INFINITE", {"-inf to", "'Start' is not finite", "1e300 or -1e300"});
  refused("MAXIMUM_NAN", {"to nan", "'Start' is not finite"});
  refused("DEFAULT_OUTSIDE", {"default -5", "outside its bounds"});
  refused("BEGUN_AND_CLOSED", {"a first state and a closed form", "initialize or threshold"});
  refused("PLACE_OUTSIDE", {"place slip_y outside of the state, which has 1 internal variables"});
}

/// The state begins with the parameter and grows by one; one variable more says that it has begun.
void begins() {
  LawLibrary library;
  const LawDescription &law = library.load(file_of("NOTHING"));
  CHECK(&library.load(file_of("NOTHING")) == &law); // again: the same
  CHECK(&library.find("counter") == &law);
  CHECK(law.n_internal_variables == 2 && law.n_strains == 4 && law.symmetric_tangent);
  CHECK(law.interface_version == law_interface_version && law.threshold == nullptr);
  CHECK(default_parameters(law) == std::vector<double>{7.});
  CHECK(std::string(law.parameters[0].unit) == "N" && law.parameters[0].maximum == 1e300);
  Probe probe(law, {{"Start", 40.}});
  probe.move({0., 0., 0., 0.});
  CHECK(probe.stress[3] == 41. && probe.state == (std::vector<double>{41., 1.}));
  probe.move({0., 0., 0., 0.});
  CHECK(probe.stress[0] == 42. && probe.state == (std::vector<double>{42., 1.}));

  LawLibrary another; // of the same file at the same time
  CHECK(another.load(file_of("NOTHING")).law != law.law);
  Probe wrong(another.load(file_of("CONTACT_WRONG")), {});
  wrong.evaluate({0., 0., 0., 0.});
  CHECK(wrong.status == LawStatus::failed);
}

bool agree(const double a, const double b, const double scale) {
  return std::abs(a - b) <= 1e-12 * scale;
}

void same_as_cpp() {
  LawLibrary library;
  library.load_builtin();
  const LawDescription &in_c = library.load(folder + "/coulomb_in_c.so"),
                       &in_cpp = library.find("coulomb");
  const Probe::Values values = {
      {"Axial rigidity", 3e6}, {"Shear rigidity", 2e6}, {"Friction coefficient", 0.4}};
  Probe c(in_c, values, 0.7), cpp(in_cpp, values, 0.7);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  int n_slip = 0, n_stick = 0, n_open = 0;
  for (unsigned int i = 0; i < 300; ++i) {
    Probe::Strain strain = {uniform(random) - 5e-4, 0.3 * uniform(random), 0.3 * uniform(random),
                            0.};
    for (const LawTangent tangent : {LawTangent::elastic, LawTangent::consistent}) {
      c.evaluate(strain, tangent);
      cpp.evaluate(strain, tangent);
      bool same = c.status == LawStatus::ok && c.contact == cpp.contact &&
                  agree(c.dissipation, cpp.dissipation, 1.);
      for (unsigned int k = 0; k < 4; ++k)
        same = same && agree(c.stress[k], cpp.stress[k], 3e3) &&
               agree(c.new_state[k], cpp.new_state[k], k == 3 ? 1. : 1e-3);
      for (unsigned int k = 0; k < 16; ++k)
        same = same && agree(c.tangent[k], cpp.tangent[k], 3e6);
      CHECK(same);
    }
    n_slip += c.contact == ContactStatus::slip;
    n_stick += c.contact == ContactStatus::stick;
    n_open += c.contact == ContactStatus::open;
    c.commit();
    cpp.commit();
  }
  CHECK(n_slip > 20 && n_stick > 20 && n_open > 20);

  const FrictionThreshold form = closed_form_at_rest(in_c, c.parameters);
  CHECK(form.static_friction == 0.4 && form.dynamic_friction == 0.4 && form.gap == 0.);
  CHECK(form.axial_rigidity == 3e6 && form.shear_rigidity_z == 2e6 && form.was_slipping == 3);
  CHECK(!form.varies);
  CHECK(closed_form_faults(in_c, c.parameters).empty());
  CHECK(check_law(in_c, c.parameters).empty());
}

} // namespace

int main(int, char **argv) {
  folder = argv[1];
  malformed();
  begins();
  same_as_cpp();
  return check::report();
}
