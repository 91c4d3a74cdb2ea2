// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/time_step.h"

#include "base/user_error.h"
#include "scene/file/parameter_reader.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

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
  // Of a step that the program chose; of the user's own, Time/Most steps says, up to what the list
  // of their ends takes in memory.
  constexpr double most_listed = 2e8;
  const double most = model.scene.time.step > 0.
                          ? most_listed
                          : std::min(most_listed, 1e11 / (1. + model.space.n_unknowns()));
  for (const LoadStep &step : model.scene.steps)
    if (step.transient && !(step.duration <= most * time_step(model)))
      throw UserError("Step '" + step.name + "' would take too many time steps.\n  read:    " +
                      to_text(step.duration) + " s in steps of " + to_text(time_step(model)) +
                      " s\n  allowed: " + to_text(most) +
                      " time steps, which take hours\n  try:     a longer Time/Step, or this one "
                      "given in the file if it is meant, or a shorter Duration");
}

} // namespace frictionbeam
