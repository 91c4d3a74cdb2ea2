// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/part/parts.h"

/**
 * @file
 * What an entry of section Quantities may say (doc/quantities.md), as text; whether there is such a
 * place or step is looked at elsewhere.
 */
namespace frictionbeam::parts {

/// The subject, then `[, along X Y Z][, step NAME][, pipe NAME][, time T][, from T][, to T]`.
/// @throws UserError
void parse_definition(const ParameterReader &in, const std::string &text, const Scene &scene,
                      Quantity &quantity);

/// `[scale F][; unit U][; reference R][; limit L][; source TEXT]`, the pieces from @p first on.
/// @throws UserError
void parse_attributes(const ParameterReader &in, const std::vector<std::string> &pieces,
                      const unsigned int first, Quantity &quantity);

/// Throw a UserError that says the grammar.
[[noreturn]] void fail_form(const ParameterReader &in, const std::string &entry,
                            const std::string &read);

} // namespace frictionbeam::parts
