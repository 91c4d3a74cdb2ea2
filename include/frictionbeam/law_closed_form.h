// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Check of a law's closed form (LawDescription::threshold) against its own integrate(): the exact
 * contact method believes the one, methods of return mapping the other, and both must be the same
 * law. Its places lie within the state, each once; its figures are possible ones; and on a grid of
 * strains (open and closed, from a tenth of the limit of sticking to ten times the limit, at rest
 * and slipping before, at two temperatures and two rates) stress, irreversible strains and the flag
 * of slip agree to 1e-9. Of a rigid contact, whose stiffness is the method's own affair,
 * integrate()'s normal force and elastic tangent are taken as they are.
 *
 * @param parameters values in the order of the law's list.
 * @return what is wrong, in plain words; empty if nothing is, or if the law has no closed form.
 */
std::vector<std::string> closed_form_faults(const LawDescription &law,
                                            const std::vector<double> &parameters);

} // namespace frictionbeam
