// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <optional>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Check of a law's closed form (LawDescription::threshold) against its own integrate(): the exact
 * contact method believes the one, methods of return mapping the other, and both must be the same
 * law. Its places lie within the state, each once; its figures are possible ones; what depends on
 * more than the parameters are coefficients alone, and it says so (FrictionThreshold::varies); and
 * on a grid of strains (open and closed, from a tenth of the limit of sticking to ten times the
 * limit, at rest and slipping before, at two temperatures and two rates) stress, irreversible
 * strains and the flag of slip agree to 1e-9, and other internal variables do not change unless it
 * varies. Of a rigid contact, whose stiffness is the method's own affair, integrate()'s normal
 * force and elastic tangent are taken as they are.
 *
 * @param parameters values in the order of the law's list.
 * @return what is wrong, in plain words; empty if nothing is, or if the law has no closed form.
 */
std::vector<std::string> closed_form_faults(const LawDescription &law,
                                            const std::vector<double> &parameters);

/// What a law says of parameters that it cannot take together.
struct LawFault {
  std::string allowed, attempt;
};
/// What the law itself says of these (LawDescription::fault).
std::optional<LawFault> fault_of(const LawDescription &law, const std::vector<double> &parameters);

/// What is wrong with the places of a closed form in the law's state; empty if nothing is.
std::string place_faults(const LawDescription &law, const FrictionThreshold &form);

/// A law's closed form at 20 degC, at rest, from internal variables of zero.
FrictionThreshold closed_form_at_rest(const LawDescription &law,
                                      const std::vector<double> &parameters);

} // namespace frictionbeam
