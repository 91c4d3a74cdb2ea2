// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <string>
#include <vector>

namespace frictionbeam {

/// Increments of the conformance test in which a law came to each of its branches: what was never
/// reached, was not checked.
struct LawReach {
  int increments = 0; ///< in which it gave an answer
  int failed = 0;     ///< in which it gave none
  int stick = 0, slip = 0, open = 0, closed = 0;
  int elastic = 0;     ///< with stress, and without dissipation
  int dissipating = 0; ///< with dissipation
};

/**
 * The conformance test that every law passes. Along seeded random strain paths of several
 * magnitudes, in compression and in traction, it is checked that
 *  - equal calls give equal results,
 *  - the consistent tangent equals the difference quotient away from kinks, and is symmetric if the
 *    law says so,
 *  - evaluating again after a commit reproduces the stress, and if nothing moves and no time
 * passes, dissipates nothing and drives no internal variable on,
 *  - dissipation is never negative,
 *  - stress and state do not depend on the tangent asked for, and none is written unasked,
 *  - the old state is not written, and all results are written and finite,
 *  - no more internal variables are written than these parameters need,
 *  - it does not fail everywhere,
 *  - of a law of supports: on a way from where it is open back to there the work of the stress is
 * the dissipation, to the first order of the increment and to a tenth, what sticks dissipates
 * nothing, and the elastic tangent is symmetric and nowhere negative,
 *  - of a law of sections: where its elastic bound is below 1 it answers by its elastic tangent and
 *    keeps a state of zero; if it tells what it stores, then the work of the stress is what that
 *    gains and the dissipation, to the first order of the increment; many at once are what each is,
 *  - its closed form, if it has one, is the same law (closed_form_faults()).
 *
 * @param parameters values in the order of the law's list.
 * @return what was violated, in plain words; empty if the law conforms.
 */
std::vector<std::string> check_law(const LawDescription &law,
                                   const std::vector<double> &parameters);

/// The same, and what was reached.
std::vector<std::string> check_law(const LawDescription &law, const std::vector<double> &parameters,
                                   LawReach &reached);

} // namespace frictionbeam
