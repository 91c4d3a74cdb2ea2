// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb, to be made another one of: its functions, and the description under another
// name.
#define frictionbeam_law frictionbeam_law_itself
#include "../plugin/law_coulomb.cc"
#undef frictionbeam_law

namespace {

/// @param other_threshold its closed form, or null
constexpr LawDescription coulomb_called(const char *const name, const LawBase *const other,
                                        void (*const other_threshold)(const LawInput &,
                                                                      FrictionThreshold &)) {
  return {
      law_interface_version, LawKind::support, n_support_strains, n_states, false,          name,
      "a law of the tests",  n_parameters,     parameters,        other,    other_threshold};
}

/// Integrate it with another friction coefficient. @param factor of the law's own
[[maybe_unused]] LawStatus integrate_with_friction(const double factor, const LawInput &in,
                                                   LawOutput &out) {
  double now[n_parameters];
  std::copy(in.parameters, in.parameters + n_parameters, now);
  now[f_static] *= factor;
  LawInput own = in;
  own.parameters = now;
  return law.integrate(own, out);
}

} // namespace
