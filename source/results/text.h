// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/number_text.h"
#include "results/results.h"

/**
 * @file
 * Names and units as text, the same in every output file.
 */
namespace frictionbeam {

/// @p text for HTML and SVG, as content or within quotes. Control characters become spaces.
std::string escape_xml(const std::string &text);

/// @p text as part of a file's name: letters, digits, dot, minus; anything else becomes _.
std::string file_name_part(const std::string &text);

/// stick, slip, open, closed; none for a law without contact.
std::string status_word(const ContactStatus status);

/// converged, failed, no_equilibrium.
std::string status_word(const RunStatus status);

/// Whether a frame is the end of a step that converged, and not the last state reached in one.
bool is_finished(const Results &results, const Frame &frame);

/// Size of the friction force [N].
double friction_force(const SupportState &state);

/// A multiple of an SI unit in which numbers are pleasant to read.
struct DisplayUnit {
  double factor = 1.; ///< displayed number = factor times number in SI
  std::string name;
};

/// Unit in which to show a column or chart of numbers in @p si_unit (N, N m, m, rad, J, Pa; any
/// other is left as it is) that are no larger than @p largest.
DisplayUnit display_unit(const std::string &si_unit, const double largest);
/// The same, but in the units that the user has asked for, if these are not SI.
DisplayUnit display_unit(const UnitSystem &units, const std::string &si_unit, const double largest);

/// A frame with all its numbers in the units asked for: itself if they are SI, a large copy spared.
/// @param converted where it stands otherwise
const Frame &in_units(const UnitSystem &units, const Frame &frame, Frame &converted);

/// The same of a section.
SectionState in_units(const UnitSystem &units, const SectionState &section);

/// Keeps the largest size of the finite numbers given to it.
class Largest {
public:
  void operator()(const double value);
  double value() const { return largest; }

private:
  double largest = 0.;
};

} // namespace frictionbeam
