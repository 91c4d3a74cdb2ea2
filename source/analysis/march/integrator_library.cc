// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/integrator_library.h"

#include "analysis/event/event_integrator.h"
#include "analysis/time/alpha_scheme.h"
#include "analysis/time/corotational_motion.h"
#include "analysis/time/moreau_jean.h"

namespace frictionbeam {

std::unique_ptr<TimeIntegrator> make_time_integrator(const Model &model,
                                                     const PieceObserver &observer) {
  using Integrator = TimeSettings::Integrator;
  if (model.corotational)
    return std::make_unique<CorotationalMotion>(model);
  switch (model.scene.time.integrator) {
  case Integrator::newmark:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::newmark(model.scene));
  case Integrator::generalized_alpha:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::generalized_alpha(model.scene));
  case Integrator::moreau_jean:
    return std::make_unique<MoreauJean>(model);
  case Integrator::nonsmooth_alpha:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::nonsmooth(model.scene));
  default:
    return std::make_unique<EventIntegrator>(model, observer);
  }
}

} // namespace frictionbeam
