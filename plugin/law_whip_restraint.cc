// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

/**
 * A whip restraint: nothing across a gap, then an elastic-plastic resistance along the normal,
 * given as a power of the deflection. With d the deflection beyond the gap and d_p what of it
 * remains,
 *
 *   F = k (d - d_p) >= 0,   but at most  C d^n  (and d_p grows then),
 *
 * so that it unloads along k and is met again where it was left. k applies alone until the two
 * curves cross; with n = 1 and C < k it is never alone. It pushes only and has no friction.
 */
namespace {

using namespace frictionbeam;

enum Parameter { gap, stiffness, coefficient, exponent, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Gap", "m", 0., 0., 1e300, "distance to travel before it resists"},
    {"Elastic stiffness", "N/m", 1.3134512643485728e8, 1e-300, 1e300,
     "k, of loading at first and of unloading"},
    {"Plastic coefficient", "N/m^(Plastic exponent)", 1.36780426020509e5, 0., 1e300,
     "C, of the plastic branch F = C d^n"},
    {"Plastic exponent", "-", 0.235, 0., 1., "n, of the plastic branch"}};

enum State { remaining, n_states }; // d_p [m]

/// The deflection from which on it has more than @p left remaining: d - C d^n/k = left, the larger
/// root, by Newton's method from @p d beyond it.
double deflection_of_flow(const double *const p, const double left, double d) {
  for (int i = 0; i < 60; ++i) {
    const double elastic = p[coefficient] * std::pow(d, p[exponent]) / p[stiffness],
                 step = (d - elastic - left) / (1. - p[exponent] * elastic / d);
    d -= step;
    if (!(d > 0.)) // the curves cross at zero: n = 1
      return 0.;
    if (!(step > 1e-15 * d))
      break;
  }
  return d;
}

/// Integral of F dd_p on the power's branch up to the deflection @p d, but for a constant [J].
double plastic_work(const double *const p, const double d) {
  const double limit = p[coefficient] * std::pow(d, p[exponent]);
  return limit * d / (p[exponent] + 1.) - limit * limit / (2. * p[stiffness]);
}

class WhipRestraint final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    const double l = in.length, k = p[stiffness], old = in.old_state[remaining];
    std::fill(out.stress, out.stress + n_support_strains, 0.);
    if (in.tangent != LawTangent::none)
      std::fill(out.tangent, out.tangent + n_support_strains * n_support_strains, 0.);
    if (in.tangent == LawTangent::elastic)
      out.tangent[0] = k * l;
    out.new_state[remaining] = old;
    out.dissipation = 0.;
    out.contact = ContactStatus::open;

    const double d = -l * in.strain[0] - p[gap];
    if (d <= old)
      return LawStatus::ok;
    out.contact = ContactStatus::closed;
    double force = k * (d - old), slope = k;
    // The elastic branch is below the power's until they cross, where the power is the lower one.
    const double limit = p[coefficient] * std::pow(d, p[exponent]),
                 crossing = std::pow(p[coefficient] / k, 1. / (1. - p[exponent]));
    if (d > crossing && force > limit) {
      force = limit;
      slope = p[exponent] * limit / d;
      out.new_state[remaining] = d - force / k;
      out.dissipation =
          std::max(0., plastic_work(p, d) - plastic_work(p, deflection_of_flow(p, old, d))) / l;
    }
    out.stress[0] = -force;
    if (in.tangent == LawTangent::consistent)
      out.tangent[0] = slope * l;
    return LawStatus::ok;
  }
};

constexpr WhipRestraint law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::support,
    frictionbeam::n_support_strains,
    n_states,
    true,
    "whip_restraint",
    "Form after Esswein and others, 1978; the defaults are its 750000 lb/in and F = 12971 d^0.235 "
    "lb, d in "
    "inches",
    n_parameters,
    parameters,
    &law,
    nullptr};
