// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

/// @file Numbers and lists as text, the same in every message and file. None of it depends on a
/// locale.
namespace frictionbeam {

/// The shortest text that reads back as the same number; nan, inf, -inf where it is none.
std::string exact_number(const double value);
/// The same behind a text.
void append_exact_number(const double value, std::string &text);

/// @p value with @p digits significant digits, for a reader's eye.
std::string rounded_number(const double value, const unsigned int digits = 4);

/// @p value with @p decimals digits after the point and no negative zero.
std::string fixed_number(const double value, const unsigned int decimals);

/// "a, b, c, d, e and 3 more": the first of @p names.
std::string first_of(const std::vector<std::string> &names);

/// Number of decimals that shows @p largest with four significant digits.
unsigned int decimals_for(const double largest);

} // namespace frictionbeam
