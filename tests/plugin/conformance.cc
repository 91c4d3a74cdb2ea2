// check_law shall accept every built-in law, with parameters for each of its branches, and name the
// fault of laws that are made wrong here on purpose.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_conformance.h>

#include "../check.h"
#include "probe.h"

#include <cmath>
#include <limits>

using namespace frictionbeam;

namespace {

void conforms(const LawDescription &law, const Probe::Values &values) {
  for (const std::string &violation : check_law(law, Probe(law, values).parameters)) {
    std::cerr << law.name;
    for (const auto &[name, value] : values)
      std::cerr << ", " << name << " = " << value;
    std::cerr << ": " << violation << '\n';
    CHECK(false);
  }
  CHECK(true);
}

void built_in(const LawLibrary &library) {
  const LawDescription &coulomb = library.find("coulomb");
  const Probe::Values base{{"Axial rigidity", 3.}, {"Shear rigidity", 2.}};
  const auto with = [&](const Probe::Values &more) {
    Probe::Values values = base;
    values.insert(values.end(), more.begin(), more.end());
    conforms(coulomb, values);
  };
  conforms(coulomb, {});
  with({});
  with({{"Shear rigidity ratio", 0.3}});
  with({{"Shear rigidity ratio", 40.}, {"Friction coefficient", 1.5}});
  with({{"Dynamic friction coefficient", 0.1}, {"Friction coefficient", 0.4}});
  with({{"Dynamic friction coefficient", 0.}});
  with({{"Dynamic friction coefficient", 0.5}, {"Friction coefficient", 0.4}});
  with({{"Dynamic friction coefficient", 0.5}, {"Friction coefficient", 0.}});
  with({{"Gap", 0.02}});
  with({{"Torsional rigidity", 0.7}});
  with({{"Torsional rigidity", 0.7}, {"Patch radius", 0.2}});
  with({{"Torsional rigidity", 0.7},
        {"Patch radius", 0.2},
        {"Dynamic friction coefficient", 0.1},
        {"Shear rigidity ratio", 0.3},
        {"Gap", 0.02}});
  with({{"Friction coefficient", 0.}});
  with({{"Friction coefficient", 0.}, {"Torsional rigidity", 0.7}, {"Patch radius", 0.2}});
  with({{"Shear rigidity", 0.}});
  conforms(library.find("elastic_section"), {});
  conforms(library.find("elastic_section"), {{"Axial rigidity", 2e9}, {"Bending rigidity", 3e5}});
  conforms(library.find("skeleton"), {});
  conforms(library.find("skeleton"), {{"Axial rigidity", 3.}, {"Drag", 0.2}});
}

enum class Fault {
  none,
  negative_dissipation,
  slip_of_wrong_sign,
  slip_not_kept,
  memory,
  no_coupling,
  kept_open,
  writes_old_state,
  not_finite,
  always_fails,
  writes_unasked_tangent
};

/// The law coulomb with one fault.
class Faulty final : public LawBase {
public:
  Faulty(const LawBase &law, const Fault fault) : law(law), fault(fault) {}

  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const LawStatus status = law.integrate(in, out);
    const int n = n_support_strains;
    const bool tangent = in.tangent != LawTangent::none;
    switch (fault) {
    case Fault::none:
      break;
    case Fault::negative_dissipation:
      out.dissipation *= -1.;
      break;
    case Fault::slip_of_wrong_sign:
      for (int i = 0; i < 2; ++i)
        out.new_state[i] = 2 * in.old_state[i] - out.new_state[i];
      break;
    case Fault::slip_not_kept: // in part
      for (int i = 0; i < 2; ++i)
        out.new_state[i] += 0.5 * in.strain[1];
      break;
    case Fault::memory:
      out.stress[0] *= 1. + 1e-3 * ++n_calls;
      break;
    case Fault::no_coupling: // dT/dN left out
      if (tangent)
        out.tangent[n] = out.tangent[2 * n] = 0.;
      break;
    case Fault::kept_open: // stiffness in traction
      if (tangent && out.contact == ContactStatus::open)
        out.tangent[0] = 1e9;
      break;
    case Fault::writes_old_state:
      const_cast<double *>(in.old_state)[0] += 1.;
      break;
    case Fault::not_finite:
      out.stress[3] = std::numeric_limits<double>::quiet_NaN();
      break;
    case Fault::always_fails:
      return LawStatus::failed;
    case Fault::writes_unasked_tangent:
      out.tangent[0] = 3.;
      break;
    }
    return status;
  }

private:
  const LawBase &law;
  const Fault fault;
  mutable int n_calls = 0;
};

void faults(const LawDescription &coulomb) {
  const auto violations = [&](const Fault fault, const bool symmetric = false) {
    const Faulty law(*coulomb.law, fault);
    LawDescription description = coulomb;
    description.law = &law;
    description.symmetric_tangent = symmetric;
    return check_law(description, default_parameters(coulomb));
  };
  const auto named = [&](const std::vector<std::string> &found, const std::string &words) {
    bool is_named = false;
    for (const std::string &violation : found)
      is_named = is_named || violation.find(words) != std::string::npos;
    if (!is_named)
      std::cerr << "no violation says '" << words << "', of " << found.size() << '\n';
    CHECK(is_named);
  };
  CHECK(violations(Fault::none).empty());
  named(violations(Fault::negative_dissipation), "dissipation is negative");
  CHECK(violations(Fault::negative_dissipation).size() == 1);
  named(violations(Fault::slip_of_wrong_sign), "is the slip of the wrong sign?");
  named(violations(Fault::slip_of_wrong_sign), "internal variable 0 goes on changing");
  named(violations(Fault::slip_not_kept), "stress 1 changes when evaluated again");
  named(violations(Fault::memory), "equal calls give different results");
  named(violations(Fault::no_coupling), "tangent (1, 0) is not the derivative");
  named(violations(Fault::no_coupling), "tangent (2, 0) is not the derivative");
  named(violations(Fault::kept_open), "tangent (0, 0) is not the derivative");
  named(violations(Fault::writes_old_state), "the old state is written");
  named(violations(Fault::not_finite), "not a finite number");
  named(violations(Fault::always_fails), "fails");
  named(violations(Fault::writes_unasked_tangent), "LawTangent::none");
  named(violations(Fault::none, true), "announced as symmetric");
}

/// The law coulomb with another closed form.
std::vector<std::string> closed_form(const LawDescription &coulomb, const Probe::Values &values,
                                     void (*other)(FrictionThreshold &)) {
  static void (*honest)(const double *, FrictionThreshold &) = nullptr;
  static void (*change)(FrictionThreshold &) = nullptr;
  honest = coulomb.threshold;
  change = other;
  LawDescription description = coulomb;
  description.threshold = [](const double *parameters, FrictionThreshold &form) {
    honest(parameters, form);
    change(form);
  };
  return check_law(description, Probe(coulomb, values).parameters);
}

/// Each figure of a closed form matters: a change of it is found, and no change is none.
void closed_forms(const LawDescription &coulomb) {
  const Probe::Values values = {{"Axial rigidity", 3e6},
                                {"Shear rigidity", 2e6},
                                {"Gap", 0.02},
                                {"Dynamic friction coefficient", 0.2},
                                {"Torsional rigidity", 70.},
                                {"Patch radius", 0.2}};
  const auto found = [&](const std::vector<std::string> &violations, const std::string &words) {
    CHECK(violations.size() == 1);
    if (!violations.empty() && violations[0].find(words) == std::string::npos)
      std::cerr << "'" << words << "' is not in: " << violations[0] << '\n';
    CHECK(!violations.empty() && violations[0].find(words) != std::string::npos);
  };
  using Form = FrictionThreshold;
  CHECK(closed_form(coulomb, values, [](Form &) {}).empty());
  const std::string differs = "disagrees with integrate()";
  found(closed_form(coulomb, values, [](Form &f) { f.static_friction *= 5.; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.dynamic_friction *= 0.99; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.gap *= 1.001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.axial_rigidity *= 1.0001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.shear_rigidity_y *= 1.0001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.shear_rigidity_z *= 1.0001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.torsional_rigidity *= 1.0001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.patch_radius *= 1.0001; }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.slip_y = 77; }), "slip_y outside");
  found(closed_form(coulomb, values, [](Form &f) { f.twist = -1; }), "twist outside");
  found(closed_form(coulomb, values, [](Form &f) { std::swap(f.slip_y, f.slip_z); }), differs);
  found(closed_form(coulomb, values, [](Form &f) { f.slip_y = f.slip_z; }), "twice");
  found(closed_form(coulomb, values, [](Form &f) { f.dynamic_friction = 7.; }), "outside of 0");
}

} // namespace

int main() {
  LawLibrary library;
  library.load_builtin();
  built_in(library);
  faults(library.find("coulomb"));
  closed_forms(library.find("coulomb"));
  return check::report();
}
