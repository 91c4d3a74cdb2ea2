// SPDX-License-Identifier: LGPL-2.1-or-later
#include "alpha_scheme.h"
#include "corotational_motion.h"
#include "event_integrator.h"
#include "moreau_jean.h"

#include <frictionbeam/scene/parameter_reader.h>
#include <frictionbeam/scene/user_error.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

std::unique_ptr<TimeIntegrator> make_time_integrator(const Model &model,
                                                     const PieceObserver &observer) {
  using Integrator = TimeSettings::Integrator;
  const TimeSettings &time = model.scene.time;
  if (model.corotational)
    return std::make_unique<CorotationalMotion>(model);
  switch (time.integrator) {
  case Integrator::newmark:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::newmark(time));
  case Integrator::generalized_alpha:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::generalized_alpha(time));
  case Integrator::moreau_jean:
    return std::make_unique<MoreauJean>(model);
  case Integrator::nonsmooth_alpha:
    return std::make_unique<AlphaScheme>(model, AlphaScheme::nonsmooth(time));
  default:
    return std::make_unique<EventIntegrator>(model, observer);
  }
}

double time_step(const Model &model) {
  if (model.scene.time.step > 0.)
    return model.scene.time.step;
  double shortest = 1e300;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i) {
    const auto cell = model.discretization.pipe_cell(i);
    const Profile &profile = model.discretization.profiles()[cell->material_id()];
    if (profile.mass > 0.)
      shortest = std::min(shortest, 0.7 * cell->diameter() / std::sqrt(profile.EA / profile.mass));
  }
  if (shortest < 1e300)
    return shortest;
  const SparseMatrix &K = model.linear.stiffness(), &M = model.linear.mass();
  for (int i = 0; i < K.rows(); ++i)
    if (K.coeff(i, i) > 0. && M.coeff(i, i) > 0.)
      shortest = std::min(shortest, 6.283185 / 40. * std::sqrt(M.coeff(i, i) / K.coeff(i, i)));
  return shortest < 1e300 ? shortest : 0.01;
}

void check_time_steps(const Model &model) {
  // Of a step that the program chose; of the user's own, Time/Most steps says.
  const double most = model.scene.time.step > 0. ? 2e9 : 1e11 / (1. + model.space.n_unknowns());
  for (const LoadStep &step : model.scene.steps)
    if (step.transient && !(step.duration <= most * time_step(model)))
      throw UserError("Step '" + step.name + "' would take too many time steps.\n  read:    " +
                      to_text(step.duration) + " s in steps of " + to_text(time_step(model)) +
                      " s\n  allowed: " + to_text(most) +
                      " time steps, which take hours\n  try:     a longer Time/Step, or this one "
                      "given in the file if it is meant, or a shorter Duration");
}

std::vector<bool> unknowns_with_mass(const SparseMatrix &mass) {
  std::vector<bool> result(mass.rows());
  for (int i = 0; i < mass.rows(); ++i)
    result[i] = mass.coeff(i, i) > 0.;
  return result;
}

SparseMatrix regular_mass(const SparseMatrix &mass) {
  SparseMatrix result = mass;
  for (int i = 0; i < result.rows(); ++i)
    if (result.coeff(i, i) == 0.)
      result.coeffRef(i, i) = 1.;
  return result;
}

void commit_contacts(ContactResponse &response, const LineState &before, LineState &after) {
  std::swap(after.contacts, response.state);
  after.contact_stress = response.stress;
  after.contact_status = response.status;
  after.events.clear();
  for (unsigned int i = 0; i < before.contact_status.size(); ++i)
    if (after.contact_status[i] != before.contact_status[i])
      after.events.push_back({after.time, i, after.contact_status[i]});
}

void add_histories(const Contacts &contacts, const LineState &before, LineState &after) {
  const double step = after.time - before.time;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    const double normal = -contact.weight / contact.length / 2. *
                          (before.contact_stress[i][0] + after.contact_stress[i][0]);
    after.contacts.impulse[i] = before.contacts.impulse[i] + step * normal;
    after.contacts.wear[i] = before.contacts.wear[i];
    if (contact.law->threshold == nullptr || after.contact_status[i] == ContactStatus::open)
      continue;
    FrictionThreshold law{};
    contact.law->threshold(contact.parameters->data(), law);
    const auto slip = [&](const int place) {
      return after.contacts.internal[contact.state_offset + place] -
             before.contacts.internal[contact.state_offset + place];
    };
    after.contacts.wear[i] +=
        normal * contact.length * std::hypot(slip(law.slip_y), slip(law.slip_z));
  }
}

} // namespace frictionbeam
