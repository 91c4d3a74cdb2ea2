// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/// What stands above the entries that --print-parameters lists: how a file is made, and all
/// quantities.
std::string parameter_notes();

} // namespace frictionbeam
