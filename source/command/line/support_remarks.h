// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/// What the user should know about how supports are modelled, before the run.
void add_remarks_on_model(const Model &model, Results &results);

/// Laws of supports that the exact method evaluates by Newton's.
void remark_on_laws(const Model &model, Results &results);

/// What a run has shown about supports: how far rigid ones gave in methods that need a stiffness,
/// and which were torn off while they stuck.
void add_remarks_on_supports(const Model &model, Results &results);

} // namespace frictionbeam
