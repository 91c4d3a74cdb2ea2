// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include "scene/history_origins.h"

#include "base/numbers.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

bool acts(const LoadStep &step, const unsigned int load) {
  return std::any_of(step.loads.begin(), step.loads.end(),
                     [&](const auto &one) { return one.first == load && one.second != 0.; });
}

namespace {

/// The run's times at which steps begin [s], as the run itself adds them up.
std::vector<double> beginnings(const Scene &scene) {
  std::vector<double> result = {0.};
  for (const LoadStep &step : scene.steps)
    result.push_back(result.back() + step.duration);
  return result;
}

/// The first of the steps up to @p step in all of which a load acts; a cycle begins anew.
unsigned int first_step(const Scene &scene, unsigned int step, const unsigned int load,
                        const bool of_one_kind) {
  while (step > 0 && !(of_one_kind && scene.steps[step].cycle.begins) &&
         acts(scene.steps[step - 1], load) &&
         !(of_one_kind && scene.steps[step - 1].transient != scene.steps[step].transient))
    --step;
  return step;
}

/// Run's time, of a step that a user reads about.
std::string beginning(const Scene &scene, const unsigned int step) {
  return "step " + scene.steps[step].name + " begins at " + to_text(beginnings(scene)[step]) +
         " s of the run";
}

[[noreturn]] void fail(const Scene &scene, const std::string &message) {
  throw UserError(with_place(scene, message));
}

void check_ground(const Scene &scene, const FrictionSupport &support) {
  const std::vector<double> begin = beginnings(scene);
  for (const TimeFunction &motion : support.ground_motion) {
    if (!motion.is_given())
      continue;
    if (std::isfinite(motion.begins) && motion.begins < 0.)
      fail(scene, "Support " + support.name +
                      ": the beginning of the record of its ground's motion would be lost.\n"
                      "  read:    '" +
                      motion.text + "', which begins at " + to_text(motion.begins) +
                      " s\n  allowed: records that begin at 0 s or later\n  try:     shifting its "
                      "times");
    for (unsigned int s = 1; s < scene.steps.size(); ++s) {
      const double before = HistoryOrigins(scene, s - 1).of_ground(motion),
                   now = HistoryOrigins(scene, s).of_ground(motion);
      if (before == now)
        continue;
      const double ends = motion.before(begin[s] - before), starts = motion.after(begin[s] - now);
      if (std::abs(starts - ends) > 1e-12 * std::max(std::abs(starts), std::abs(ends)))
        fail(scene, "Support " + support.name + ": its ground would jump by " +
                        to_text(starts - ends) + " m where step " + scene.steps[s].name +
                        " begins.\n  read:    Ground motion '" + motion.text +
                        "', whose time begins again with that step\n  allowed: a motion that is "
                        "the same at "
                        "the end of the step before\n  try:     'Ground motion time = run', so "
                        "that its time "
                        "is the run's");
    }
  }
}

} // namespace

HistoryOrigins::HistoryOrigins(const Scene &scene, const unsigned int step)
    : loads(scene.loads.size(), 0.) {
  const std::vector<double> begin = beginnings(scene);
  for (unsigned int l = 0; l < loads.size(); ++l) {
    if (scene.loads[l].history.clock == TimeFunction::Clock::run)
      continue;
    unsigned int from = step;
    if (!acts(scene.steps[step], l) && step > 0 && acts(scene.steps[step - 1], l))
      --from;
    loads[l] = begin[first_step(scene, from, l, true)];
  }
  unsigned int from = step;
  while (from > 0 && !scene.steps[from].cycle.begins &&
         scene.steps[from - 1].transient == scene.steps[step].transient)
    --from;
  ground = begin[from];
}

} // namespace frictionbeam

void frictionbeam::parts::check_histories(Scene &scene) {
  const std::vector<double> begin = beginnings(scene);
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (!load.history.is_given())
      continue;
    const bool of_step = load.history.clock == TimeFunction::Clock::step;
    bool told = false;
    for (unsigned int s = 0; s < scene.steps.size(); ++s) {
      if (!acts(scene.steps[s], l) || first_step(scene, s, l, of_step) != s)
        continue;
      const double starts = of_step ? 0. : begin[s];
      if (std::isfinite(load.history.begins) &&
          load.history.begins < starts - same_instant_of_step * begin[s])
        fail(scene, "Load " + load.name +
                        ": the beginning of its History would be lost.\n  read:    '" +
                        load.history.text + "', a record that begins at " +
                        to_text(load.history.begins) + " s, and " + beginning(scene, s) +
                        (of_step ? ", where its time is 0"
                                 : ", which is its time with 'History time = run'") +
                        "\n  allowed: a record that begins with the step or later\n  try:     " +
                        (of_step ? "shifting its times"
                                 : "'History time = step', which counts from the step's "
                                   "beginning"));
      if (of_step && begin[s] > 0. && !told)
        scene.remarks.push_back("Load " + load.name +
                                ": the time of its History begins with step " +
                                scene.steps[s].name + ", at " + to_text(begin[s]) +
                                " s of the run; with 'History time = run' it would be the run's.");
      told = told || (of_step && begin[s] > 0.);
    }
  }
  for (const FrictionSupport &support : scene.supports)
    check_ground(scene, support);
}
