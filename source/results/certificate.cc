// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/energy_judgement.h"
#include "results/results.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

void Results::certify(const Scene &scene, const bool contacts_are_judged) {
  double residual = 0., imbalance = 0.;
  contact::Check contact;
  PipeSections::Check sections;
  EnergyAccount account;
  for (const StepReport &step : steps) {
    residual = std::max(residual, step.residual);
    const double turnover = std::max(step.energy.turnover, least_turnover(steps));
    if (step.energy.at_hand == 0. && turnover > 0.)
      imbalance = std::max(imbalance, left_over_beyond_rounding(step.energy) / turnover);
    contact.include(step.contact);
    sections.include(step.sections);
    account += step.energy;
  }
  for (StepReport &step : steps)
    if (!contacts_are_judged)
      step.contact.natural_map = std::numeric_limits<double>::quiet_NaN();
  certificate = {{"equilibrium", "-", "largest force left over, of the largest force", residual}};
  const auto add = [&](const std::string &name, const std::string &unit, const std::string &meaning,
                       const double value) {
    certificate.push_back({name, unit, meaning,
                           contacts_are_judged ? value : std::numeric_limits<double>::quiet_NaN(),
                           contacts_are_judged});
  };
  if (scene.solver.is_exact()) {
    add("contact", "-", "natural map, each contact on its own scale", contact.natural_map);
    add("penetration", "m", "largest", contact.penetration);
    add("cone_violation", "-", "friction above f N, of N", contact.cone_violation);
    add("slip_angle", "rad", "between slip and friction force", contact.slip_angle);
    add("least_dissipation", "J", "of one contact in one increment", contact.least_dissipation);
  }
  if (std::any_of(scene.sections.begin(), scene.sections.end(),
                  [](const Section &section) { return section.is_inelastic(); })) {
    certificate.push_back({"yield_violation", "-",
                           "equivalent stress above the yield stress, of it",
                           sections.yield_violation});
    certificate.push_back({"cell_equilibrium", "-",
                           "of sections that yield or creep with the forces on their cell",
                           sections.imbalance});
  }
  if (account.turnover == 0.)
    return;
  if (account.at_hand > 0.) {
    account.least_scale = 1e6 * energy_of_rounding(*this); // below it nothing moves
    imbalance = account.imbalance();
  }
  certificate.push_back({"energy", "-", "imbalance of the account below", imbalance});
  energy = account;
}

} // namespace frictionbeam
