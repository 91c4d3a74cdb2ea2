// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cctype>
#include <set>
#include <string>

namespace frictionbeam::import {

/// Names for parts of a parameter file, each given once: letters, digits, - and _ in small letters.
class UniqueNames {
public:
  std::string take(const std::string &wanted) {
    std::string name;
    for (const char c : wanted) {
      const unsigned char u = c;
      if (std::isalnum(u) != 0 && u < 0x80)
        name += static_cast<char>(std::tolower(u));
      else if (!name.empty() && name.back() != '_')
        name += c == '-' ? '-' : '_';
      if (name.size() >= longest)
        break;
    }
    while (!name.empty() && (name.back() == '_' || name.back() == '-'))
      name.pop_back();
    if (name.empty())
      name = "part";
    std::string result = name;
    for (unsigned int i = 2; !taken.insert(result).second; ++i)
      result = name + "_" + std::to_string(i);
    return result;
  }

private:
  static constexpr std::size_t longest = 40;
  std::set<std::string> taken;
};

} // namespace frictionbeam::import
