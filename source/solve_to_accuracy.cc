// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solve_to_accuracy.h"

#include "accuracy/difference.h"
#include "accuracy/refinable.h"

#include <frictionbeam/results/text.h>
#include <frictionbeam/scene/parameter_file.h>
#include <frictionbeam/scene/read_scene.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {

constexpr double margin = 1.2; ///< by which an estimate must be below what is demanded
constexpr double lowest_order = 0.8, highest_order = 2.;
constexpr unsigned int highest_level = 14, longest_jump = 5;

/// A run at some level of what is being refined.
struct Trial {
  unsigned int level = 0;
  Results results;
};

class AccuracyControl {
public:
  AccuracyControl(const RunOptions &options, LawLibrary &laws, Scene &scene,
                  const std::function<Results(Scene &)> &solve)
      : options(options), laws(laws), scene(scene), solve(solve), demanded(scene.accuracy) {}

  Results run();

private:
  Results run_line();
  /// Its own refinement stops where the quantities change by no more than is demanded.
  Results run_continuum();
  Trial solve_at(const std::size_t what, const unsigned int level);
  Results solve_with(const std::vector<std::string> &settings);
  /// Refine one thing until its part of the error is estimated below @p tolerance.
  Trial refine(const std::size_t what, const double tolerance);
  std::string describe(const std::vector<std::string> &settings) const;

  const RunOptions &options;
  LawLibrary &laws;
  Scene &scene;
  const std::function<Results(Scene &)> &solve;
  const double demanded;
  std::vector<accuracy::Refinable> list;
  std::vector<std::string> chosen;
  std::map<std::string, Results> solved; ///< coarse runs that may be asked for again
  AccuracyAccount account;
  Cost cost; ///< of all runs
};

std::string AccuracyControl::describe(const std::vector<std::string> &settings) const {
  std::string text;
  for (const std::string &setting : settings)
    text += (text.empty() ? "" : "; ") + setting;
  return text;
}

Results AccuracyControl::solve_with(const std::vector<std::string> &settings) {
  std::vector<std::string> overrides = options.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  const std::string directory = scene.output.directory;
  scene = read_scene(options.parameter_file, overrides, laws);
  scene.output.directory = directory;
  Results results = solve(scene);
  cost.mesh_seconds += results.cost.mesh_seconds;
  cost.setup_seconds += results.cost.setup_seconds;
  cost.solve_seconds += results.cost.solve_seconds;
  cost.iterations += results.cost.iterations;
  cost.factorizations += results.cost.factorizations;
  cost.back_substitutions += results.cost.back_substitutions;
  cost.steps += results.cost.steps;
  account.runs.push_back(
      {describe(settings),
       results.cost.mesh_seconds + results.cost.setup_seconds + results.cost.solve_seconds,
       {},
       results.status == RunStatus::converged});
  return results;
}

Trial AccuracyControl::solve_at(const std::size_t what, const unsigned int level) {
  std::vector<std::string> settings = chosen;
  for (std::size_t i = what; i < list.size(); ++i) // what is chosen later is coarse as yet
    for (const std::string &setting : list[i].settings(i == what ? level : 0))
      settings.push_back(setting);
  const std::string name = describe(settings);
  if (const auto found = solved.find(name); found != solved.end()) {
    Trial trial{level, std::move(found->second)};
    solved.erase(found);
    return trial;
  }
  Trial trial{level, solve_with(settings)};
  if (what + 1 < list.size())
    solved[name] = trial.results;
  return trial;
}

Trial AccuracyControl::refine(const std::size_t what, const double tolerance) {
  Trial before = solve_at(what, 0);
  double estimate = 0., order = highest_order, last = 0.;
  bool known = false; // whether there is an estimate
  unsigned int level = 1;
  while (true) {
    Trial now = solve_at(what, level);
    const bool usable =
        now.results.status == RunStatus::converged && before.results.status == RunStatus::converged;
    const unsigned int jump = level - before.level;
    if (usable) {
      const double d = accuracy::difference(scene, before.results, now.results).value;
      account.runs.back().change = d;
      if (known && last > 0. && d > 0. && jump == 1)
        order = std::clamp(std::log2(last / d), lowest_order, highest_order);
      // A difference may be small by chance: it is taken for no less than the one before allows.
      const double expected = known ? last * std::pow(2., -highest_order * jump) : 0.;
      estimate = std::max(d, expected) / (std::pow(2., order * jump) - 1.);
      const bool enough = known || d <= 0.25 * tolerance; // else two differences
      known = true;
      last = std::max(d, expected);
      if (jump > 1) // as if it were one level
        last *= (std::pow(2., order) - 1.) / (std::pow(2., order * jump) - 1.);
      if (enough && margin * estimate <= tolerance) {
        account.estimate += estimate;
        return now;
      }
    }
    before = std::move(now);
    const double wanted =
        known && usable && level >= 2 ? std::log2(margin * estimate / tolerance) / order : 1.;
    const unsigned int step =
        static_cast<unsigned int>(std::clamp(std::ceil(wanted), 1., 1. * longest_jump));
    if (level + step > highest_level) {
      account.estimate += known ? estimate : std::nan("");
      account.reached = false;
      return before;
    }
    level += step;
  }
}

Results AccuracyControl::run_line() {
  const ParameterFile file(options.parameter_file);
  const auto kind = file.sections().front().find("Scene");
  list = accuracy::refinables(scene, kind == nullptr ? "line" : kind->value);
  chosen = accuracy::exact_settings(scene);
  account.left_out = accuracy::left_out(scene);
  Results results;
  if (list.empty())
    results = solve_with(chosen);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool is_last = i + 1 == list.size();
    Trial last = refine(i, is_last ? demanded - account.estimate : 0.2 * demanded);
    // One increment is as good where two change next to nothing.
    const bool coarse = list[i].coarsest_may_be_exact && last.level == 1 && !is_last;
    for (const std::string &setting : list[i].settings(coarse ? 0 : last.level))
      chosen.push_back(setting);
    results = std::move(last.results);
  }
  return results;
}

Results AccuracyControl::run_continuum() {
  chosen = {"Continuum/Refinement = adaptive", "Continuum/Tolerance = " + exact_number(demanded)};
  Results results = solve_with(chosen);
  account.estimate = std::nan("");
  for (const Check &check : results.certificate)
    if (check.name == "refinement")
      account.estimate = check.value;
  account.reached = results.status == RunStatus::converged;
  return results;
}

Results AccuracyControl::run() {
  account.demanded = demanded;
  account.reached = true;
  Results results = scene.model == ModelKind::continuum ? run_continuum() : run_line();
  account.chosen = chosen;
  const Cost last = results.cost;
  results.cost = cost;
  results.cost.unknowns = last.unknowns;
  results.cost.cells = last.cells;
  results.cost.contacts = last.contacts;
  if (!account.reached && results.status == RunStatus::converged)
    results.status = RunStatus::failed;
  results.remarks.push_back(
      account.reached
          ? "Accuracy: the quantities are estimated to be known to " +
                rounded_number(account.estimate, 2) + ", " + rounded_number(demanded, 2) +
                " is demanded; chosen: " +
                (chosen.empty() ? "nothing, since there is nothing to choose" : describe(chosen)) +
                "."
          : "Accuracy: " + rounded_number(demanded, 2) + " is not reached; the estimate is " +
                rounded_number(account.estimate, 2) + " with " + describe(chosen) + ".");
  results.accuracy = account;
  return results;
}

} // namespace

Results solve_to_accuracy(const RunOptions &options, LawLibrary &laws, Scene &scene,
                          const std::function<Results(Scene &)> &solve) {
  return AccuracyControl(options, laws, scene, solve).run();
}

} // namespace frictionbeam
