// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <algorithm>

namespace frictionbeam::parts {

namespace {

/// Entries of Time that belong to other integrators than the one that is taken.
void remark_on_integrator(ParameterReader &in, Scene &scene) {
  in.enter("Time");
  const IntegratorRow &taken = scene.time.row();
  for (const IntegratorRow &row : integrators)
    for (const char *const entry : row.entries)
      if (entry != nullptr && in.given(entry) &&
          std::none_of(taken.entries.begin(), taken.entries.end(), [&](const char *const own) {
            return own != nullptr && std::string(own) == entry;
          }))
        scene.remarks.push_back("Time/" + std::string(entry) + " is of " + row.word +
                                " and is not used with Integrator = " + taken.word + ".");
  const bool maps_back =
      taken.value == Integrator::newmark || taken.value == Integrator::generalized_alpha;
  if (!maps_back || scene.solver.is_exact())
    return;
  for (const FrictionSupport &support : scene.supports)
    if (support.restitution > 0.)
      scene.remarks.push_back("Support " + support.name +
                              ": its Restitution is not used with Integrator = " + taken.word +
                              " and Solver/Method = " + scene.solver.row().word +
                              ", which know no impulses; Method = exact does.");
}

/// What an Initial wants in directions that Free motions holds.
void remark_on_initial(Scene &scene) {
  for (const InitialCondition &initial : scene.initial)
    for (unsigned int c = 0; c < 6 && initial.about.empty(); ++c)
      if (!scene.free_motions[c] && (initial.velocity[c] != 0. || initial.displacement[c] != 0.)) {
        const std::string &where =
            initial.points.empty() ? initial.pipes.front() : initial.points.front();
        scene.remarks.push_back("The Initial of " + where + " has a part along " + motions[c] +
                                ", which is not one of the Free motions: it does nothing.");
      }
}

} // namespace

void remark_on_unused(ParameterReader &in, Scene &scene) {
  if (std::any_of(scene.steps.begin(), scene.steps.end(),
                  [](const LoadStep &step) { return step.transient; }))
    remark_on_integrator(in, scene);
  remark_on_initial(scene);
  for (unsigned int l = 0; l < scene.loads.size(); ++l)
    if (std::none_of(scene.steps.begin(), scene.steps.end(), [&](const LoadStep &step) {
          return std::any_of(step.loads.begin(), step.loads.end(),
                             [&](const auto &load) { return load.first == l; });
        }))
      scene.remarks.push_back("Load " + scene.loads[l].name +
                              " is in the Loads of no step, and does nothing.");
}

} // namespace frictionbeam::parts
