// check_law shall name the fault of each law of sections that is made wrong here on purpose, in
// what a law of sections tells besides its stress; and BoundLaw shall ask a law for it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>
#include <frictionbeam/law_conformance.h>

#include "../check.h"

#include <algorithm>
#include <cmath>

using namespace frictionbeam;

namespace {

enum class Fault {
  none,
  bound_too_low,
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
  CHECK(of_old.report(strain, 1., {}, state).plastic_strain == 0.);
  LawDescription silent = law;
  silent.n_states = nullptr;
  silent.elastic_bound = nullptr;
  CHECK(BoundLaw(silent, {1e3}).n_internal_variables() == 3);
  CHECK(std::isinf(BoundLaw(silent, {1e3}).elastic_bound(strain, 1., {})));
}

} // namespace

int main() {
  faults();
  bound_law();
  return check::report();
}
