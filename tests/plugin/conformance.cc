// check_law() accepts built-in laws in each of their branches, and names the faults of wrong ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_conformance.h>

#include "../check.h"
#include "probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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
  conforms(library.find("snubber"), {});
  conforms(library.find("snubber"),
           {{"Locking velocity", 1e-3}, {"Drag", 100.}, {"Dead band", 1e-4}});
  conforms(library.find("snubber"), {{"Locking velocity", 0.1}, {"Locking acceleration", 1.}});
  conforms(library.find("whip_restraint"), {});
  conforms(library.find("whip_restraint"), {{"Gap", 0.01}});
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
  writes_unasked_tangent,
  drives,
  makes_energy,
  keeps_quiet,
  boasts,
  says_stick,
  no_stiffness,
  no_symmetry
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
    case Fault::drives: // the friction pushes on the way that it slips
      for (int i = 1; i < 3; ++i)
        out.stress[i] *= -1.;
      break;
    case Fault::makes_energy: // around a way in the plane
      if (out.contact != ContactStatus::open) {
        out.stress[1] += 0.5 * in.parameters[1] * in.strain[2];
        out.stress[2] -= 0.5 * in.parameters[1] * in.strain[1];
      }
      break;
    case Fault::keeps_quiet:
      out.dissipation = 0.;
      break;
    case Fault::boasts:
      out.dissipation *= 3.;
      break;
    case Fault::says_stick:
      if (out.contact == ContactStatus::slip)
        out.contact = ContactStatus::stick;
      break;
    case Fault::no_stiffness:
    case Fault::no_symmetry:
      if (in.tangent == LawTangent::elastic)
        out.tangent[fault == Fault::no_stiffness ? 0 : 6] = -7.;
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
    return check_law(description,
                     law_parameters(coulomb, {{"Axial rigidity", 1e6}, {"Shear rigidity", 1e6}}));
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
  named(violations(Fault::negative_dissipation), "its dissipation is too small");
  CHECK(violations(Fault::negative_dissipation).size() == 2);
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
  for (const Fault fault : {Fault::drives, Fault::makes_energy, Fault::boasts})
    named(violations(fault), "or it makes energy out of nothing");
  named(violations(Fault::keeps_quiet), "its dissipation is too small");
  named(violations(Fault::says_stick), "it says that it sticks, and dissipates");
  named(violations(Fault::no_stiffness), "the elastic tangent is no stiffness");
  named(violations(Fault::no_symmetry), "the elastic tangent is no stiffness");
}

/// The law coulomb with another closed form.
std::vector<std::string> closed_form(const LawDescription &coulomb, const Probe::Values &values,
                                     void (*other)(FrictionThreshold &, const LawInput &)) {
  static void (*honest)(const LawInput &, FrictionThreshold &) = nullptr;
  static void (*change)(FrictionThreshold &, const LawInput &) = nullptr;
  honest = coulomb.threshold;
  change = other;
  LawDescription description = coulomb;
  description.threshold = [](const LawInput &input, FrictionThreshold &form) {
    honest(input, form);
    change(form, input);
  };
  return check_law(description, Probe(coulomb, values).parameters);
}

const Probe::Values all_values = {{"Axial rigidity", 3e6},
                                  {"Shear rigidity", 2e6},
                                  {"Gap", 0.02},
                                  {"Dynamic friction coefficient", 0.2},
                                  {"Torsional rigidity", 70.},
                                  {"Patch radius", 0.2}};

void found(const std::vector<std::string> &violations, const std::string &words) {
  CHECK(violations.size() == 1);
  if (!violations.empty() && violations[0].find(words) == std::string::npos)
    std::cerr << "'" << words << "' is not in: " << violations[0] << '\n';
  CHECK(!violations.empty() && violations[0].find(words) != std::string::npos);
}

/// Each figure of a closed form matters: a change of it is found, and no change is none.
void closed_forms(const LawDescription &coulomb) {
  const Probe::Values &values = all_values;
  using Form = FrictionThreshold;
  CHECK(closed_form(coulomb, values, [](Form &, const LawInput &) {}).empty());
  const std::string differs = "disagrees with integrate()";
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.static_friction *= 5.; }),
        differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.dynamic_friction *= 0.99; }),
        differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.gap *= 1.001; }), differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.axial_rigidity *= 1.0001; }),
        differs);
  found(
      closed_form(coulomb, values, [](Form &f, const LawInput &) { f.shear_rigidity_y *= 1.0001; }),
      differs);
  found(
      closed_form(coulomb, values, [](Form &f, const LawInput &) { f.shear_rigidity_z *= 1.0001; }),
      differs);
  found(closed_form(coulomb, values,
                    [](Form &f, const LawInput &) { f.torsional_rigidity *= 1.0001; }),
        differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.patch_radius *= 1.0001; }),
        differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.slip_y = 77; }),
        "slip_y outside");
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.twist = -1; }),
        "twist outside");
  found(closed_form(coulomb, values,
                    [](Form &f, const LawInput &) { std::swap(f.slip_y, f.slip_z); }),
        differs);
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.slip_y = f.slip_z; }),
        "twice");
  found(closed_form(coulomb, values, [](Form &f, const LawInput &) { f.dynamic_friction = 7.; }),
        "outside of 0");
  found(
      closed_form(coulomb, values, [](Form &f, const LawInput &) { std::swap(f.twist, f.slip_z); }),
      differs);
}

/// A closed form that is right is right with any parameters, ordinary and absurd.
void any_parameters(const LawDescription &coulomb) {
  std::mt19937 random(1);
  const auto uniform = [&] { return 2. * random() / random.max() - 1.; };
  for (int n = 0; n < 1500; ++n) {
    std::vector<double> values = default_parameters(coulomb);
    const double decades = n % 3 == 0 ? 2. : n % 3 == 1 ? 9. : 280.;
    for (int i = 0; i < coulomb.n_parameters; ++i)
      if (uniform() > -0.2)
        values[i] = std::clamp(std::pow(10., decades * uniform()), coulomb.parameters[i].minimum,
                               coulomb.parameters[i].maximum);
    for (const std::string &fault : closed_form_faults(coulomb, values)) {
      std::cerr << "draw " << n << ": " << fault << '\n';
      CHECK(false);
    }
  }
  CHECK(true);
}

/// The law coulomb with a coefficient that depends on @p Share of what it is given.
template <double Share(const LawInput &)>
class Varying final : public LawBase {
public:
  explicit Varying(const LawDescription &coulomb) : coulomb(coulomb) {
    description = coulomb;
    description.law = this;
    description.n_internal_variables = coulomb.n_internal_variables + 1;
    honest = coulomb.threshold;
    description.threshold = [](const LawInput &input, FrictionThreshold &form) {
      honest(input, form);
      form.static_friction *= Share(input);
      form.dynamic_friction *= Share(input);
      form.varies = says_so;
    };
  }

  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    std::vector<double> p(in.parameters, in.parameters + coulomb.n_parameters);
    for (const char *const name : {"Friction coefficient", "Dynamic friction coefficient"})
      p[parameter_index(coulomb, name)] *= Share(in);
    LawInput now = in;
    now.parameters = p.data();
    const int memory = coulomb.n_internal_variables;
    out.new_state[memory] = in.old_state[memory] + (wears ? 1. : 0.);
    return coulomb.law->integrate(now, out);
  }

  /// What the check of its closed form says.
  std::vector<std::string> faults() const {
    return closed_form_faults(description, Probe(coulomb, all_values).parameters);
  }

  LawDescription description;
  bool wears = false;
  static inline bool says_so = true;

private:
  const LawDescription &coulomb;
  static inline void (*honest)(const LawInput &, FrictionThreshold &) = nullptr;
};

double by_temperature(const LawInput &in) { return 1. - 0.001 * (in.temperature - 20.); }
double by_rate(const LawInput &in) {
  return 0.5 + 0.5 * std::exp(-std::hypot(in.strain_rate[1], in.strain_rate[2]));
}
double by_state(const LawInput &in) { return 1. / (1. + std::abs(in.old_state[4])); }
double by_strain(const LawInput &in) { return 1. / (1. + std::abs(in.strain[0])); }
double by_nothing(const LawInput &) { return 1.; }
double too_cold(const LawInput &in) { return in.temperature < 100. ? 1. : -1.; }

/// Coefficients that depend on temperature, rate and state.
void varying_forms(const LawDescription &coulomb) {
  Varying<by_temperature> warm(coulomb);
  CHECK(warm.faults().empty());
  warm.says_so = false;
  found(warm.faults(), "does not say so: set FrictionThreshold::varies");
  Varying<by_rate> fast(coulomb);
  CHECK(fast.faults().empty());
  fast.says_so = false;
  found(fast.faults(), "rates of 1e-06 1/s) and does not say so");
  Varying<by_state> worn(coulomb);
  worn.wears = true; // the state changes: only a form that varies may have that
  CHECK(worn.faults().empty());
  worn.says_so = false;
  found(worn.faults(), "does not say so");
  Varying<by_strain> loaded(coulomb);
  found(loaded.faults(), "disagrees with integrate()");
  Varying<by_nothing> remembering(coulomb);
  remembering.says_so = false;
  CHECK(remembering.faults().empty());
  remembering.wears = true;
  found(remembering.faults(), "internal variable 4, which is none of its places");
  Varying<too_cold> cold(coulomb);
  found(cold.faults(), "static coefficient below 0 or not finite, read -0.3 (temperature 150 degC");
}

/// What the test came to.
void reach(const LawDescription &coulomb) {
  LawReach reached;
  CHECK(check_law(coulomb, default_parameters(coulomb), reached).empty());
  CHECK(reached.increments == 480 && reached.failed == 0);
  CHECK(reached.open > 50 && reached.stick > 50 && reached.slip > 50);
  CHECK(reached.open + reached.stick + reached.slip == 480 && reached.closed == 0);
  CHECK(reached.elastic == reached.stick && reached.dissipating == reached.slip);
}

} // namespace

int main() {
  LawLibrary library;
  library.load_builtin();
  built_in(library);
  faults(library.find("coulomb"));
  closed_forms(library.find("coulomb"));
  any_parameters(library.find("coulomb"));
  varying_forms(library.find("coulomb"));
  reach(library.find("coulomb"));
  return check::report();
}
