// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

/// Laws of sections that only tests need.
namespace section_laws {

using namespace frictionbeam;

/**
 * Axial force and both moments yield by themselves, with hardening that saturates,
 *   |S| <= y + Q (1 - exp(-b p)),  p the plastic strain that has accumulated,
 * on top of the elastic section; a dashpot c along the axis; no answer beyond |eps| = limit.
 */
enum Parameter { EA, GA, GJ, EI, N_yield, N_hardening, M_yield, M_hardening, rate, damping, limit };
constexpr LawParameter parameters[] = {
    {"Axial rigidity", "N", 1., 0., 1e300, "EA"},
    {"Shear rigidity", "N", 1., 0., 1e300, "GA"},
    {"Torsional rigidity", "N m2", 1., 0., 1e300, "GJ"},
    {"Bending rigidity", "N m2", 1., 0., 1e300, "EI"},
    {"Yield force", "N", 1e300, 0., 1e300, "y of N"},
    {"Force of hardening", "N", 0., 0., 1e300, "Q of N"},
    {"Yield moment", "N m", 1e300, 0., 1e300, "y of M_y and M_z"},
    {"Moment of hardening", "N m", 0., 0., 1e300, "Q of M_y and M_z"},
    {"Rate of hardening", "-", 1., 0., 1e300, "b"},
    {"Damping", "N s", 0., 0., 1e300, "c"},
    {"Largest strain", "-", 1e300, 0., 1e300, "limit"}};
constexpr int n_parameters = sizeof(parameters) / sizeof(parameters[0]);

/// Returns stress, tangent and plastic work of one component.
struct Yielding {
  double stress, tangent, work;

  Yielding(const double E, const double y, const double Q, const double b, const double strain,
           const double *const old_state, double *const new_state) {
    const double trial = E * (strain - old_state[0]), p = old_state[1];
    const auto limit = [&](const double dp) { return y + Q * (1. - std::exp(-b * (p + dp))); };
    double dp = 0.;
    const bool yields = std::fabs(trial) > limit(0.) * (1. + 1e-14);
    for (int k = 0; yields && k < 60; ++k) {
      const double excess = std::fabs(trial) - E * dp - limit(dp);
      const double step = excess / (E + Q * b * std::exp(-b * (p + dp)));
      dp += step;
      if (step <= 1e-16 * dp)
        break;
    }
    const double sign = trial < 0. ? -1. : 1., hardening = Q * b * std::exp(-b * (p + dp));
    stress = trial - sign * E * dp;
    tangent = yields ? E * hardening / (E + hardening) : E;
    work = std::fabs(stress) * dp;
    new_state[0] = old_state[0] + sign * dp;
    new_state[1] = p + dp;
  }
};

class Plastic final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    if (std::fabs(in.strain[0]) > p[limit])
      return LawStatus::failed;
    double C[6] = {0., p[GA], p[GA], p[GJ], 0., 0.};
    for (const int s : {1, 2, 3})
      out.stress[s] = C[s] * in.strain[s];
    out.dissipation = 0.;
    const int place[3] = {0, 4, 5};
    for (int k = 0; k < 3; ++k) {
      const Yielding one(p[k == 0 ? EA : EI], p[k == 0 ? N_yield : M_yield],
                         p[k == 0 ? N_hardening : M_hardening], p[rate], in.strain[place[k]],
                         in.old_state + 2 * k, out.new_state + 2 * k);
      out.stress[place[k]] = one.stress;
      C[place[k]] = in.tangent == LawTangent::elastic ? p[k == 0 ? EA : EI] : one.tangent;
      out.dissipation += one.work;
    }
    out.stress[0] += p[damping] * in.strain_rate[0];
    if (in.time_increment > 0.)
      C[0] += p[damping] / in.time_increment;
    if (in.tangent != LawTangent::none) {
      std::fill(out.tangent, out.tangent + 36, 0.);
      for (int s = 0; s < 6; ++s)
        out.tangent[7 * s] = C[s];
    }
    out.contact = ContactStatus::none;
    return LawStatus::ok;
  }
};

inline constexpr Plastic plastic_law;
inline constexpr LawDescription plastic = {law_interface_version,
                                           LawKind::section,
                                           n_section_strains,
                                           6,
                                           true,
                                           "plastic_section",
                                           "the test's own",
                                           n_parameters,
                                           parameters,
                                           &plastic_law,
                                           nullptr};

} // namespace section_laws
