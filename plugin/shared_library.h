// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/**
 * Open a shared library of the user's.
 * @param origin of it, as a message begins: "The law library 'file'"
 * @param how to compile one, as the message ends
 * @throws std::runtime_error with the system's own words
 */
void *open_shared_library(const std::string &file, const std::string &origin,
                          const std::string &how);

/// The shared libraries in a folder, in alphabetical order.
std::vector<std::string> shared_libraries_in(const std::string &folder);

/// A folder beside the library that this very function is in.
std::string folder_beside_library(const std::string &name);

} // namespace frictionbeam
