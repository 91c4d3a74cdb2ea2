// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/cell/line_cells.h"
#include "model/line_state.h"

namespace frictionbeam {

/// The pose of a state that has been committed, which must outlive it.
inline Pose pose_of(const LineState &state) { return {state.dofs, state.turns, &state.sections}; }

} // namespace frictionbeam
