// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/part/parts.h"

/**
 * @file
 * What of a parameter file concerns bodies of more than one dimension.
 */
namespace frictionbeam {

namespace parts {

/// Section Continuum.
void declare_continuum(ParameterReader &in);
void parse_continuum(const ParameterReader &in, Scene &scene);

/// Whether the entry Model suits the scene that has been read.
void check_model(const ParameterReader &in, const Scene &scene);
/// Whether the scene is solved as a line, or may be.
bool has_line(const Scene &scene);

/// Section Quantities of a scene that is solved as a continuum; where it is solved as a line as
/// well, only references of the quantities that the continuum has of itself.
void parse_continuum_quantities(const ParameterReader &in, Scene &scene);

} // namespace parts

namespace generated {

/// The continuum of section Slab: pressed on its frictional surface y = Height by a prescribed
/// pressure, on rollers at y = 0, pushed at x = 0 by a uniform traction.
void build_slab_continuum(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// A square plate on a foundation (section Long bar).
void declare_long_bar(ParameterReader &in);
void build_long_bar(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// A body on the user's own mesh (section Body), with the entries of its law of friction.
void declare_body(ParameterReader &in, const LawLibrary &laws);
void build_body(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

} // namespace generated

} // namespace frictionbeam
