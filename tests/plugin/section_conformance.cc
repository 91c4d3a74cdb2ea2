// check_law shall name the fault of each law of sections that is made wrong here on purpose, in
// what a law of sections tells besides its stress; and BoundLaw shall ask a law for it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>
#include <frictionbeam/law_conformance.h>

#include "section_probe.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

using namespace frictionbeam;

namespace {

enum class Fault {
  none,
  bound_too_low,
  elastic_tangent_halved,
  state_not_kept,
  hardening_not_stored,
  dissipation_forgotten,
  writes_behind,
  other_in_company,
  not_told
};

constexpr LawParameter parameters[] = {{"Yield force", "N", 1e3, 0., 1e300, "of N"}};
constexpr double EA = 1e6, H = 2e5, rigidity[6] = {EA, 4e5, 4e5, 7e5, 9e5, 9e5};

/// Elastic but for an axial force that yields with linear kinematic hardening; announces three
/// internal variables and needs two.
template <Fault fault>
class Section final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double trial = EA * (in.strain[0] - in.old_state[0]) - H * in.old_state[0];
    const double flow = std::max(0., std::abs(trial) - in.parameters[0]) / (EA + H);
    const double slip = in.old_state[0] + std::copysign(flow, trial);
    double stored = H * slip * slip / 2.;
    if (fault == Fault::hardening_not_stored)
      stored = 0.;
    for (int i = 0; i < 6; ++i) {
      const double elastic = in.strain[i] - (i == 0 ? slip : 0.);
      out.stress[i] = rigidity[i] * elastic;
      stored += rigidity[i] * elastic * elastic / 2.;
    }
    if (in.tangent != LawTangent::none) {
      std::fill(out.tangent, out.tangent + 36, 0.);
      for (int i = 0; i < 6; ++i)
        out.tangent[7 * i] = rigidity[i];
      if (fault == Fault::elastic_tangent_halved && in.tangent == LawTangent::elastic)
        out.tangent[0] /= 2.;
      if (in.tangent == LawTangent::consistent && flow > 0.)
        out.tangent[0] = EA * H / (EA + H);
    }
    out.new_state[0] = slip;
    out.new_state[1] = in.old_state[1] + flow;
    if (fault == Fault::state_not_kept)
      out.new_state[1] = std::max(in.old_state[1], std::abs(in.strain[0]));
    if (fault == Fault::writes_behind)
      out.new_state[2] = 1.;
    out.dissipation = in.parameters[0] * flow * (fault == Fault::dissipation_forgotten ? 0.9 : 1.);
    if (fault != Fault::not_told)
      out.stored_energy = stored;
    return LawStatus::ok;
  }
};

template <Fault fault>
double bound(const LawInput &in) {
  if (fault == Fault::elastic_tangent_halved) // tells none
    return std::numeric_limits<double>::infinity();
  return EA * std::abs(in.strain[0]) / in.parameters[0] *
         (fault == Fault::bound_too_low ? 0.5 : 1.);
}

template <Fault fault>
LawStatus all(const int n, const LawInput *in, LawOutput *out) {
  const Section<fault> law;
  for (int k = 0; k < n; ++k) {
    law.integrate(in[k], out[k]);
    if (fault == Fault::other_in_company && k > 0)
      out[k].stress[0] += 1e-3;
  }
  return LawStatus::ok;
}

int needed(const double *) { return 2; }

void told(const LawInput &in, const double *state, SectionReport &report) {
  report.utilization = EA * std::abs(in.strain[0] - state[0]) / in.parameters[0];
  report.plastic_strain = state[1];
}

template <Fault fault>
LawDescription description() {
  static constexpr Section<fault> law;
  return {law_interface_version,
          LawKind::section,
          n_section_strains,
          3,
          true,
          "section",
          "a test",
          1,
          parameters,
          &law,
          nullptr,
          &needed,
          &bound<fault>,
          &all<fault>,
          &told};
}

template <Fault fault>
void found(const std::string &words) {
  const auto violations = check_law(description<fault>(), {1e3});
  CHECK(violations.size() == 1);
  if (violations.empty() || violations[0].find(words) == std::string::npos) {
    std::cerr << "not said: " << words << '\n';
    CHECK(false);
  }
}

void faults() {
  for (const double yield : {1e3, 1., 1e300})
    for (const std::string &violation : check_law(description<Fault::none>(), {yield})) {
      std::cerr << violation << '\n';
      CHECK(false);
    }
  CHECK(check_law(description<Fault::not_told>(), {1e3}).empty());
  found<Fault::bound_too_low>("its elastic bound is below 1");
  found<Fault::elastic_tangent_halved>("at rest its elastic tangent");
  found<Fault::state_not_kept>("its elastic bound is below 1");
  found<Fault::hardening_not_stored>("the work of the stress");
  found<Fault::dissipation_forgotten>("the work of the stress");
  found<Fault::writes_behind>("more internal variables are written");
  found<Fault::other_in_company>("many at once");
  LawDescription greedy = description<Fault::none>();
  greedy.n_internal_variables = 1;
  const auto violations = check_law(greedy, {1e3});
  CHECK(violations.size() == 1 && violations[0] == "it needs 2 internal variables and announces 1");
}

void bound_law() {
  const LawDescription law = description<Fault::none>();
  const BoundLaw of_law(law, {1e3});
  CHECK(of_law.n_internal_variables() == 2);
  const double strain[6] = {2e-3}, state[2] = {5e-4, 5e-4};
  CHECK_NEAR(of_law.elastic_bound(strain, 1., {}), 2., 1e-15);
  const SectionReport report = of_law.report(strain, 1., {}, state);
  CHECK_NEAR(report.utilization, 1.5, 1e-15);
  CHECK(report.plastic_strain == 5e-4);
  // A law of version 1 ends before all this: it is not read.
  LawDescription old = law;
  old.interface_version = 1;
  const BoundLaw of_old(old, {1e3});
  CHECK(of_old.n_internal_variables() == 3);
  CHECK(std::isinf(of_old.elastic_bound(strain, 1., {})));
  CHECK(std::isnan(of_old.report(strain, 1., {}, state).plastic_strain)); // it does not tell
  LawDescription silent = law;
  silent.n_states = nullptr;
  silent.elastic_bound = nullptr;
  CHECK(BoundLaw(silent, {1e3}).n_internal_variables() == 3);
  CHECK(std::isinf(BoundLaw(silent, {1e3}).elastic_bound(strain, 1., {})));
}

void conforms(const LawDescription &law, const SectionProbe::Values &values,
              const bool dissipates = true) {
  LawReach reached;
  for (const std::string &violation : check_law(law, law_parameters(law, values), reached)) {
    std::cerr << law.name;
    for (const auto &[name, value] : values)
      std::cerr << ", " << name << " = " << value;
    std::cerr << ": " << violation << '\n';
    CHECK(false);
  }
  CHECK(reached.increments == 480);
  CHECK((reached.dissipating > 100) == dissipates);
}

using Values = SectionProbe::Values;

const Values isotropic{{"Isotropic modulus", 2e9}}, kinematic{{"Kinematic modulus", 2e9}},
    curve{{"Hardening strain 1", .01},
          {"Hardening stress 1", 2.5e8},
          {"Hardening strain 2", .05},
          {"Hardening stress 2", 2.6e8}},
    creep{{"Creep coefficient", 1e-39}, {"Creep exponent", 4.}},
    primary{{"Primary creep coefficient", 1e-33},
            {"Primary creep exponent", 3.5},
            {"Primary time exponent", .4}},
    by_strain{{"Primary hardening", 1.}}, no_yield{{"Yield stress", 1e30}};

Values all_of(const std::vector<Values> &parts) {
  Values result;
  for (const Values &part : parts)
    for (const auto &[name, value] : part)
      result[name] = value;
  return result;
}

void built_in(const LawDescription &fibre, const LawDescription &whole,
              const LawDescription &rectangle) {
  const Values size = Tube().of_the_whole();
  conforms(whole, {}, false);
  conforms(whole, size);
  conforms(whole, all_of({size, isotropic}));
  conforms(whole, all_of({size, kinematic, curve, {{"Pressure coefficient", .8}}}));
  conforms(whole, all_of({size, {{"Bend radius", .3}, {"Pressure coefficient", .8}}}));
  conforms(whole, all_of({size, no_yield}), false);

  const Values few{{"Fibres", 9.}, {"Radii", 1.}}, thick{{"Fibres", 7.}, {"Wall thickness", .03}};
  conforms(fibre, few);
  conforms(fibre, thick);
  conforms(fibre, {{"Fibres", 12.}});
  conforms(fibre, all_of({few, isotropic}));
  conforms(fibre, all_of({few, kinematic}));
  conforms(fibre, all_of({few, curve}));
  conforms(fibre, all_of({thick, kinematic, curve, isotropic}));
  conforms(fibre, all_of({few, creep, no_yield}));
  conforms(fibre, all_of({few, creep}));
  conforms(fibre, all_of({few, creep, kinematic, curve}));
  conforms(fibre, all_of({few, creep, primary, isotropic}));
  conforms(fibre, all_of({few, primary, by_strain, no_yield}));
  conforms(fibre, all_of({few, creep, primary, by_strain, kinematic, isotropic}));
  const Values strips{{"Fibres along the height", 8.}, {"Fibres along the width", 6.}};
  conforms(rectangle, strips);
  conforms(rectangle, all_of({strips, isotropic}));
  conforms(rectangle, all_of({strips, kinematic, curve}));
  conforms(rectangle, all_of({strips, no_yield}), false);
  CHECK(BoundLaw(rectangle, law_parameters(rectangle, strips)).n_internal_variables() == 2 * 8 * 6);
  const auto needed = [&](const Values &values) {
    return BoundLaw(fibre, law_parameters(fibre, values)).n_internal_variables();
  };
  CHECK(needed({{"Fibres", 63.}, {"Radii", 1.}}) == 3 + 63 * 2);
  CHECK(needed(all_of({{{"Fibres", 255.}}, creep, primary, by_strain, kinematic})) <= 4000);
}

void ovalising(const LawDescription &oval) {
  const Values bend{{"Bend radius", .3}, {"Modes", 3.}, {"Points round", 9.}, {"Layers", 1.}},
      held{{"Bend length", .5}, {"Place in bend", .2}};
  conforms(oval, {{"Points round", 9.}, {"Modes", 3.}});
  conforms(oval, {{"Bend radius", .3}});
  conforms(oval, bend);
  conforms(oval, all_of({bend, isotropic}));
  conforms(oval, all_of({bend, kinematic, held}));
  conforms(oval, all_of({bend, kinematic, curve, held, {{"Layers", 2.}}}));
  conforms(oval, all_of({bend, curve, held, {{"Wall thickness", .001}}}));
  conforms(oval, all_of({bend, no_yield}), false);
}

/// Microseconds of a warm increment with tangent; of the elastic bound.
void speed(const LawDescription &law, const char *what, const Values &values, const double scale,
           const double dt, const double most) {
  SectionProbe probe(law, values);
  probe.increment.pressure = scale < 1. ? 0. : 1e6;
  probe.strain = {4e-4 * scale, 0., 0., .01 * scale, .02 * scale, .005 * scale};
  probe.evaluate(dt);
  if (scale >= 1.)
    probe.commit();
  const auto seconds = [](const auto &&call) {
    constexpr int n = 2000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < n; ++i)
      call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / n;
  };
  double sum = 0.;
  const double one = 1e6 * seconds([&] {
                       for (double &e : probe.strain)
                         e *= 1. + 1e-6;
                       probe.evaluate(dt);
                     });
  const double bound = 1e6 * seconds([&] {
                         probe.strain[0] *= 1. + 1e-12;
                         sum += probe.law.elastic_bound(probe.strain.data(), 1., probe.increment);
                       });
  std::cout << what << ": " << one << " us, elastic bound " << bound << " us\n";
  CHECK(one < most && bound < 10. && sum > 0.);
}

void speeds(const LawDescription &fibre, const LawDescription &whole, const LawDescription &oval) {
  const Values thin{{"Radii", 1.}};
  speed(whole, "the whole, yielding", Tube().of_the_whole(), 1., 0., 100.);
  speed(fibre, "63 fibres, elastic", thin, 1e-2, 0., 100.);
  speed(fibre, "63 fibres, perfectly plastic", thin, 1., 0., 1000.);
  speed(fibre, "63 fibres, isotropic", all_of({thin, isotropic}), 1., 0., 2000.);
  speed(fibre, "63 fibres, kinematic", all_of({thin, kinematic}), 1., 0., 2000.);
  speed(fibre, "63 fibres, creep", all_of({thin, creep, no_yield}), 1., 1e-6, 10000.);
  speed(fibre, "2 x 63 fibres, perfectly plastic", {}, 1., 0., 2000.);
  const Values bend{{"Bend radius", .3}};
  speed(oval, "ovalising, 31 x 4 points, elastic", bend, 1e-2, 0., 1000.);
  speed(oval, "ovalising, 31 x 4 points, perfectly plastic", bend, 1., 0., 20000.);
  speed(oval, "ovalising, 31 x 4 points, isotropic", all_of({bend, isotropic}), 1., 0., 20000.);
}

} // namespace

int main() {
  LawLibrary library;
  library.load_builtin();
  const LawDescription &fibre = library.find("fibre_pipe"), &whole = library.find("global_plastic"),
                       &oval = library.find("ovalising_pipe");
  built_in(fibre, whole, library.find("fibre_rectangle"));
  ovalising(oval);
  speeds(fibre, whole, oval);
  faults();
  bound_law();
  return check::report();
}
