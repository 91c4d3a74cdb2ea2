// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>

namespace frictionbeam {

/// Something the user can put right: what was read, what is allowed, what to try. The program
/// prints the text without decoration and ends with exit status 1.
class UserError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace frictionbeam
