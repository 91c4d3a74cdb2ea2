// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// By which a rigid pipe is stiffer than its section.
inline constexpr double rigid_part = 1000.;

} // namespace frictionbeam
