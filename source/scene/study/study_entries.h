// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/study/study.h"

/// @file Sections Study and Vary of a parameter file.
namespace frictionbeam::parts {

/// Heading of the sections that say what varies; they stand beside scenes of all kinds.
inline constexpr const char *variation_kind = "Vary";

/// Section Study and one section Vary, for the reference documentation.
void declare_study(ParameterReader &in);
/// Read all of them. What the entries that vary allow is asked when the study begins.
void read_study(ParameterReader &in, StudySettings &study);

} // namespace frictionbeam::parts
