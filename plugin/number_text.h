// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sstream>
#include <string>

namespace frictionbeam {

/// A number of a message, to six digits.
inline std::string text_of(const double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

} // namespace frictionbeam
