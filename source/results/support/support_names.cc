// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/support/support_names.h"

#include "scene/support_pair.h"

namespace frictionbeam {

bool is_part_of(const SupportInfo &support, const std::string &where) {
  if (support.name == where)
    return true;
  if (is_of_a_pair(support.kind))
    for (const std::string half : {plus_half, minus_half})
      if (const auto at = support.name.rfind(half); at != std::string::npos)
        return support.name.substr(0, at) + support.name.substr(at + half.size()) == where;
  return false;
}

bool is_one_of(SupportInfo support, const std::string &where) {
  if (is_part_of(support, where))
    return true;
  support.name = support.name.substr(0, support.name.rfind('.'));
  return is_part_of(support, where);
}

} // namespace frictionbeam
