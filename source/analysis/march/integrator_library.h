// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/time/time_integrator.h"

namespace frictionbeam {

/// The integrator that Time/Integrator names. @param observer of smooth pieces, where it has them
std::unique_ptr<TimeIntegrator> make_time_integrator(const Model &model,
                                                     const PieceObserver &observer = {});

} // namespace frictionbeam
