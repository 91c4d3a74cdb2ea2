// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include <frictionbeam/law_library.h>

#include <functional>

namespace frictionbeam {

/**
 * The law of a kind that entry Law of the current section names, which need not be declared yet.
 * @param otherwise its name if the entry is not there
 * @throws UserError that says which laws there are, and of a law of the other kind that it is one.
 */
const LawDescription &find_law(const ParameterReader &in, const LawLibrary &laws,
                               const LawKind kind, const std::string &otherwise);

/// Names of a law's parameters, which are entries of the support or section.
std::vector<std::string> law_entries(const LawDescription &law);

/**
 * A law's parameters, as entries of the current section after those of its own.
 * @param defaults if there are any, in place of the law's
 * @throws UserError where one is called as an entry is that the section has already: one number
 * would be read for both.
 */
void declare_parameters(ParameterReader &in, const LawDescription &law,
                        const std::vector<double> &defaults = {});

/// The method exact believes a law's closed form, the others its integrate(): they must agree.
void check_closed_form(const ParameterReader &in, const LawDescription &law,
                       const std::vector<double> &parameters);

/// Say of a law's given parameters which ones Units does not convert.
/// @param part whose law it is, such as "Support rest"
void remark_on_units(const ParameterReader &in, const std::string &part, const LawDescription &law,
                     std::vector<std::string> &remarks);

/// What the law itself says of its parameters together.
/// @throws UserError about the current section if it cannot take them
void check_together(const ParameterReader &in, const LawDescription &law,
                    const std::vector<double> &parameters);

/// Load the shared libraries that an entry names. @param what each exports, for messages
void load_libraries(const ParameterReader &in, const std::string &entry, const std::string &what,
                    const std::function<void(const std::string &)> &load);

/// Load the shared libraries that entry Law libraries names.
void load_laws(const ParameterReader &in, LawLibrary &laws);

} // namespace frictionbeam
