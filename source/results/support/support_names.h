// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Whether @p where names a friction support, or the guide, line stop or stop of which it is a
/// half: `name` of `name.plus` and `name.minus`, `name.1` of `name.plus.1` and `name.minus.1`.
bool is_part_of(const SupportInfo &support, const std::string &where);
/// The same, or all places where it stands: `name` of `name.1` and `name.plus.1`.
bool is_one_of(SupportInfo support, const std::string &where);

} // namespace frictionbeam
