// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

/// @file What the report shows of a large model; the csv files have the rest.
namespace frictionbeam {

constexpr std::size_t n_rows_at_most = 250;   ///< of a table
constexpr std::size_t n_pictures_at_most = 6; ///< of a section

} // namespace frictionbeam
