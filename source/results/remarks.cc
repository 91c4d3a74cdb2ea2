// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/remarks.h"

#include <algorithm>

namespace frictionbeam {

std::vector<std::string> all_remarks(const Scene &scene, const Results &results) {
  std::vector<std::string> remarks;
  for (const auto *list : {&scene.doubts, &results.doubts, &scene.remarks, &results.remarks})
    for (const auto &remark : *list)
      if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end())
        remarks.push_back(remark);
  return remarks;
}

} // namespace frictionbeam
