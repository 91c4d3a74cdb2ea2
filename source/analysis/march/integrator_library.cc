// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/integrator_library.h"

#include "analysis/event/event_integrator.h"
#include "analysis/time/alpha_scheme.h"
#include "analysis/time/moreau_jean.h"
#include "analysis/time/nonlinear_motion.h"
#include "model/cell/line_cells.h"

#include <iterator>

namespace frictionbeam {

namespace {

using Made = std::unique_ptr<TimeIntegrator>;

/// An alpha scheme, which observes nothing within a step.
template <AlphaScheme::Parameters (*parameters)(const Scene &)>
Made alpha_scheme(const Model &model, const PieceObserver &) {
  return std::make_unique<AlphaScheme>(model, parameters(model.scene));
}

/// What makes an integrator, whose word and meaning stand in `integrators`.
struct Maker {
  Integrator value;
  Made (*make)(const Model &, const PieceObserver &);
};

constexpr Maker makers[] = {
    {Integrator::newmark, &alpha_scheme<&AlphaScheme::newmark>},
    {Integrator::generalized_alpha, &alpha_scheme<&AlphaScheme::generalized_alpha>},
    {Integrator::nonsmooth_alpha, &alpha_scheme<&AlphaScheme::nonsmooth>},
    {Integrator::moreau_jean,
     [](const Model &model, const PieceObserver &) -> Made {
       return std::make_unique<MoreauJean>(model);
     }},
    {Integrator::event, [](const Model &model, const PieceObserver &observer) -> Made {
       return std::make_unique<EventIntegrator>(model, observer);
     }}};

static_assert(std::size(makers) == std::size(integrators), "each integrator is made by one row");

} // namespace

std::unique_ptr<TimeIntegrator> make_time_integrator(const Model &model,
                                                     const PieceObserver &observer) {
  if (!model.cells.is_linear() && model.scene.time.integrator == Integrator::moreau_jean)
    return std::make_unique<NonlinearMotion>(model);
  return row_of(makers, model.scene.time.integrator).make(model, observer);
}

} // namespace frictionbeam
