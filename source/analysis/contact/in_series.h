// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// Stiffness of a contact's elastic part and the proximal term in series; an infinite one is rigid.
inline double in_series(const double elastic, const double proximal) {
  return 1. / (1. / elastic + 1. / proximal);
}

} // namespace frictionbeam
