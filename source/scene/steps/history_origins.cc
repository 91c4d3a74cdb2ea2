// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include "scene/steps/history_origins.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

bool acts(const LoadStep &step, const unsigned int load) {
  return std::any_of(step.loads.begin(), step.loads.end(),
                     [&](const auto &one) { return one.first == load && one.second != 0.; });
}

namespace {

/// Of the size of a ground's motion: rounding of what a table or a formula of long times is at its
/// end.
constexpr double no_jump = 1e-9;

/// The run's times at which steps begin [s], as the run itself adds them up.
std::vector<double> beginnings(const Scene &scene) {
  std::vector<double> result = {0.};
  for (const LoadStep &step : scene.steps)
    result.push_back(result.back() + step.duration);
  return result;
}

/// The same, each without the steps that do not lead to it.
std::vector<double> beginnings_on_paths(const Scene &scene) {
  std::vector<double> result;
  for (unsigned int s = 0; s < scene.steps.size(); ++s) {
    const auto before = step_before(scene, s);
    result.push_back(before ? result[*before] + scene.steps[*before].duration : 0.);
  }
  return result;
}

/// The first of the steps that lead to @p step in all of which a load acts; a cycle begins anew.
unsigned int first_step(const Scene &scene, unsigned int step, const unsigned int load,
                        const bool of_one_kind) {
  for (auto before = step_before(scene, step);
       before && !(of_one_kind && scene.steps[step].cycle.begins) &&
       acts(scene.steps[*before], load) &&
       !(of_one_kind && scene.steps[*before].transient != scene.steps[step].transient);
       before = step_before(scene, step))
    step = *before;
  return step;
}

/// Run's time, of a step that a user reads about.
std::string beginning(const Scene &scene, const unsigned int step) {
  return "step " + scene.steps[step].name + " begins at " +
         to_text(beginnings_on_paths(scene)[step]) + " s of the run";
}

[[noreturn]] void fail(const Scene &scene, const std::string &message) {
  throw UserError(with_place(scene, message));
}

/// The largest size of a motion, as far as some instants of an interval know it [m].
double largest(const TimeFunction &motion, const double from, const double to) {
  constexpr unsigned int n_samples = 64;
  double result = 0.;
  for (unsigned int i = 0; i < n_samples; ++i)
    result = std::max(result, std::abs(motion(from + (i + 0.5) / n_samples * (to - from))));
  return result;
}

/// Whether a motion with the run's time is under way in a step.
bool moves_in(const Scene &scene, const TimeFunction &motion, const unsigned int step) {
  const double begin = beginnings_on_paths(scene)[step], end = begin + scene.steps[step].duration,
               size = std::max(std::abs(motion.after(begin)), largest(motion, begin, end));
  constexpr unsigned int n_samples = 64;
  for (unsigned int i = 0; i < n_samples; ++i)
    if (const double time = begin + (i + 0.5) / n_samples * (end - begin);
        std::abs(motion(time) - motion.after(begin)) > no_jump * size)
      return true;
  return false;
}

/// Where a transient step goes on with a motion that a static one has begun, its inertia is not in
/// the beginning.
void remark_on_ground(Scene &scene, const FrictionSupport &support) {
  for (const TimeFunction &motion : support.ground_motion)
    for (unsigned int s = 1; s < scene.steps.size() && motion.is_given(); ++s) {
      const auto before = step_before(scene, s);
      if (motion.clock != TimeFunction::Clock::run || !before || !scene.steps[s].transient ||
          scene.steps[*before].transient || !moves_in(scene, motion, *before) ||
          !moves_in(scene, motion, s))
        continue;
      scene.remarks.push_back("Support " + support.name + ": the static step " +
                              scene.steps[*before].name +
                              " has played the beginning of its ground's motion, without inertia: "
                              "step " +
                              scene.steps[s].name + " goes on with it from " +
                              to_text(beginnings_on_paths(scene)[s]) + " s of the run.");
      return;
    }
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
    // That of the run has the same time before and after, and jumps by itself only.
    for (unsigned int s = 1; s < scene.steps.size() && motion.clock == TimeFunction::Clock::step;
         ++s) {
      const unsigned int last = *step_before(scene, s);
      const double before = HistoryOrigins(scene, last).of_ground(motion),
                   now = HistoryOrigins(scene, s).of_ground(motion);
      if (before == now)
        continue;
      const double last_time = begin[last + 1] - before, ends = motion.before(last_time),
                   starts = motion.after(begin[s] - now);
      const double of_step = largest(motion, last_time - scene.steps[last].duration, last_time);
      if (std::abs(starts - ends) > no_jump * std::max({of_step, std::abs(starts), std::abs(ends)}))
        fail(scene,
             "Support " + support.name + ": its ground would jump by " + to_text(starts - ends) +
                 " m where step " + scene.steps[s].name + " begins.\n  read:    Ground motion '" +
                 motion.text +
                 "', whose time begins again with that step; the steps before have played "
                 "it, too\n  allowed: a motion that is the same at the end of the step before"
                 "\n  try:     'Ground motion time = run' and a motion that begins at " +
                 to_text(beginnings_on_paths(scene)[s]) + " s, where step " + scene.steps[s].name +
                 " does");
    }
  }
}

} // namespace

HistoryOrigins::HistoryOrigins(const Scene &scene, const unsigned int step)
    : loads(scene.loads.size(), 0.) {
  const std::vector<double> on_path = beginnings_on_paths(scene);
  elsewhere = beginnings(scene)[step] - on_path[step];
  for (unsigned int l = 0; l < loads.size(); ++l) {
    loads[l] = elsewhere;
    if (scene.loads[l].history.clock == TimeFunction::Clock::run)
      continue;
    const auto before = step_before(scene, step);
    const bool goes_back = !acts(scene.steps[step], l) && before && acts(scene.steps[*before], l);
    loads[l] = elsewhere + on_path[first_step(scene, goes_back ? *before : step, l, true)];
  }
  unsigned int from = step;
  for (auto before = step_before(scene, from);
       before && !scene.steps[from].cycle.begins &&
       scene.steps[*before].transient == scene.steps[step].transient;
       before = step_before(scene, from))
    from = *before;
  ground = elsewhere + on_path[from];
}

} // namespace frictionbeam

void frictionbeam::parts::check_histories(Scene &scene) {
  const std::vector<double> begin = beginnings_on_paths(scene);
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (!load.history.is_given())
      continue;
    const bool of_step = load.history.clock == TimeFunction::Clock::step;
    bool told = false;
    for (unsigned int s = 0; s < scene.steps.size(); ++s) {
      if (!acts(scene.steps[s], l) || first_step(scene, s, l, of_step) != s)
        continue;
      const double on_path = begin[s], starts = of_step ? 0. : on_path;
      if (std::isfinite(load.history.begins) &&
          load.history.begins < starts - same_instant_of_step * on_path)
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
      if (of_step && on_path > 0. && !told)
        scene.remarks.push_back("Load " + load.name +
                                ": the time of its History begins with step " +
                                scene.steps[s].name + ", at " + to_text(on_path) +
                                " s of the run; with 'History time = run' it would be the run's.");
      told = told || (of_step && on_path > 0.);
    }
  }
  for (const FrictionSupport &support : scene.supports) {
    check_ground(scene, support);
    remark_on_ground(scene, support);
  }
}
