// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sys/resource.h>

namespace frictionbeam {

/// The most that this process has held so far [MB].
inline double peak_memory_mb() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.;
}

} // namespace frictionbeam
