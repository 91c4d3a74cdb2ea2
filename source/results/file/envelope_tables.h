// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// @file
/// Envelopes of transient steps as tables: least and largest values, each with its instant.

/**
 * Write `envelope.csv`, if there is a transient step: step, part, name, s, what, least,
 * time_of_least, largest, time_of_largest. Parts are support (fn, ft1, ft2, gap, slip1, slip2, the
 * sizes force and friction, and the impulse of an impact on a rigid contact), restraint (fx .. mz,
 * force), point (ux .. rz), and pipe, with s along it (N .. Mz). In the units of the results,
 * radians.
 */
void write_envelopes(const Scene &scene, const Results &results, const std::string &folder);

/// Tables of the report, as HTML.
std::string support_envelope_table(const Results &results, const StepEnvelope &envelope);
std::string reaction_envelope_table(const Results &results, const StepEnvelope &envelope);
std::string displacement_envelope_table(const Results &results, const StepEnvelope &envelope);

/// Over which instants an envelope is taken, in a sentence.
std::string instants_of(const StepEnvelope &envelope);

/// Say where an envelope is not all that one would expect.
void add_envelope_remarks(const Scene &scene, Results &results);

/// Places of the rows to show in a table: all, or the 250 with the largest weights, in their order.
std::vector<std::size_t> rows_to_show(const std::vector<double> &weight);

} // namespace frictionbeam
