// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

/// Run a case and hold it against what the words after it say (see the list in case_checks.cc).
/// @throws std::exception for words that are none, and for answers that are not there
void check_case(const std::string &program, const std::string &file,
                const std::vector<std::string> &options_and_checks);
