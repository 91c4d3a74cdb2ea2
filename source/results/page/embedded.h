// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

/// @file Files that stand beside this one, put into the program when it is built (embed.cmake).
namespace frictionbeam::embedded {

extern const char *const page_css, *const page_js, *const turnable_js;

/// three.js and its OrbitControls, packed by gzip; empty if they were not there at build time.
extern const std::string three_js;

} // namespace frictionbeam::embedded
