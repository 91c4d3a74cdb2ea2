// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/**
 * The law of a kind that entry Law of the current section names, which need not be declared yet.
 * @param otherwise its name if the entry is not there
 * @throws UserError that says which laws there are, and of a law of the other kind that it is one.
 */
const LawDescription &find_law(const ParameterReader &in, const LawLibrary &laws,
                               const LawKind kind, const std::string &otherwise);

/// The method exact believes a law's closed form, the others its integrate(): they must agree.
void check_closed_form(const ParameterReader &in, const LawDescription &law,
                       const std::vector<double> &parameters);

/// Load the shared libraries that entry Law libraries names.
void load_laws(const ParameterReader &in, LawLibrary &laws);

} // namespace frictionbeam
