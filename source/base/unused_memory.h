// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdlib> // tells of __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace frictionbeam {

/// Give memory that has been freed back to the system. By itself that never happens: as it is
/// loaded, SuperLU_DIST, which comes with deal.II, tells malloc() to keep all of it.
inline void give_back_unused_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace frictionbeam
