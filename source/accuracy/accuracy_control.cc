// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/accuracy_control.h"

#include "accuracy/account_remarks.h"
#include "accuracy/convergence.h"
#include "accuracy/difference.h"
#include "accuracy/pipe_model.h"
#include "accuracy/refinable.h"
#include "accuracy/resolution.h"

#include "base/processes.h"
#include "base/user_error.h"
#include "results/file/csv_writer.h"
#include "results/file/vtu_writer.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {

constexpr double margin = 1.1;        ///< by which an estimate must be below what is demanded
constexpr double first_share = 1e-3;  ///< of the tolerance, that one difference alone must be below
constexpr double early_share = 0.2;   ///< of what is demanded, for what is chosen before others
constexpr double most_of_model = 0.7; ///< of what is demanded, that the line model may use up
constexpr unsigned int highest_level = 14, most_levels_for_events = 5;

/// A run at some level of what is being refined.
struct Trial {
  unsigned int level = 0;
  Results results;
};

class AccuracyControl {
public:
  AccuracyControl(const RunOptions &options, Scene as_read, const ReadScene &read,
                  const SolveScene &solve)
      : read(read), solve(solve), scene(std::move(as_read)), demanded(scene.accuracy),
        model(scene.model), file(options.parameter_file) {
    for (const std::string &option : options.overrides)
      file.apply(option);
  }

  SolvedScene run();

private:
  /// The line, if what it leaves out is estimated to be small enough, with its settings.
  ModelKind choose_model();
  /// The line, with a solid in place of bends that beams do not answer for.
  ModelKind choose_bends();
  Results run_line();
  /// The line with the settings that it needs, and these bends as solids.
  /// @param line as it is without them
  Results solve_solid_bends(Results line);
  /// Its own refinement stops where the quantities change by no more than is demanded.
  Results run_continuum();
  Trial solve_at(const std::size_t what, const unsigned int level);
  Results solve_with(const std::vector<std::string> &settings);
  /// The scene at hand. @param what it is, in words
  Results solve_scene(const std::string &what);
  /// Refine one thing until its part of the error is estimated below @p tolerance, the others being
  /// as fine as they are.
  Trial refine(const std::size_t what, const double tolerance);
  /// Refine two things that depend on each other, a time step and something else, by what the last
  /// level of either has changed.
  Trial refine_together(const std::array<std::size_t, 2> &both, const double tolerance);
  /// Sum of what the parts are estimated to contribute, without one of them.
  double estimate_without(const std::size_t what) const;

  const ReadScene &read;
  const SolveScene &solve;
  Scene scene; ///< of the last run
  const double demanded;
  ModelKind model;                 ///< that is solved
  ParameterFile file;              ///< with the options
  std::vector<std::string> chosen; ///< once for all
  std::vector<accuracy::Refinable> list;
  std::vector<unsigned int> levels; ///< of the list
  std::vector<double> estimates;    ///< of the errors that they leave
  /// Whether the finer of two answers may be taken for the last: an event that both may have missed
  /// wants some more levels first.
  bool sees_events(const Results &coarse, const Results &fine);

  unsigned int n_missed = 0;     ///< levels that were added for such an event
  std::string missed;            ///< the event, if the last level may still have missed it
  bool coarsest_will_do = false; ///< of what was refined last: finer ones change next to nothing
  double model_error = 0.;
  accuracy::PipeModel pipes;
  std::map<std::string, Results> solved; ///< runs that may be asked for again
  AccuracyAccount account;
  Cost cost; ///< of all runs
};

Results AccuracyControl::solve_with(const std::vector<std::string> &settings) {
  scene = read(settings);
  return solve_scene(accuracy::settings_in_words(settings));
}

Results AccuracyControl::solve_scene(const std::string &what) {
  scene.model = model;
  if (this_process() == 0)
    remove_frames(scene.output.directory); // of coarser levels
  Results results = solve(scene);
  cost.add_work(results.cost);
  account.runs.push_back(
      {what, results.cost.seconds(), {}, results.status == RunStatus::converged});
  return results;
}

Trial AccuracyControl::solve_at(const std::size_t what, const unsigned int level) {
  levels[what] = level;
  std::vector<std::string> settings = chosen;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (const std::string &setting : list[i].settings(levels[i]))
      settings.push_back(setting);
  const std::string name = accuracy::settings_in_words(settings);
  if (const auto found = solved.find(name); found != solved.end())
    return {level, found->second};
  Trial trial{level, solve_with(settings)};
  if (list.size() > 1)
    solved[name] = trial.results;
  return trial;
}

double AccuracyControl::estimate_without(const std::size_t what) const {
  double sum = model_error;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (i != what)
      sum += estimates[i];
  return sum;
}

bool AccuracyControl::sees_events(const Results &coarse, const Results &fine) {
  if (scene.time.is_exact())
    return true; // which steps over none
  missed = accuracy::nearly_missed(coarse, fine);
  return missed.empty() || n_missed++ >= most_levels_for_events;
}

Trial AccuracyControl::refine(const std::size_t what, const double tolerance) {
  accuracy::Convergence convergence(list[what].order);
  Trial before = solve_at(what, 0);
  // One increment and two agree where something slips and turns within both.
  unsigned int level = list[what].coarsest_may_be_exact ? 2 : 1;
  coarsest_will_do = false;
  while (true) {
    Trial now = solve_at(what, level);
    const bool converged = now.results.status == RunStatus::converged,
               usable = converged && before.results.status == RunStatus::converged;
    bool wants_proof = false;
    if (usable) {
      const auto differences = accuracy::differences(scene, before.results, now.results);
      account.runs.back().change = accuracy::largest(differences).value;
      convergence.add(before.level, level, differences);
      const double estimate = convergence.estimate(),
                   hidden = list[what].hidden_in(scene, now.results),
                   most = convergence.knows_orders() ? tolerance : first_share * tolerance;
      estimates[what] = std::max(estimate, hidden);
      const bool agrees = margin * estimate <= most && margin * hidden <= tolerance;
      wants_proof = agrees && !list[what].proves(level, estimate, now.results);
      if (agrees && !wants_proof && sees_events(before.results, now.results)) {
        coarsest_will_do = list[what].coarsest_will_do(before.level, estimate);
        return now;
      }
    }
    if (!converged && before.results.status == RunStatus::converged) { // too fine to be solved?
      const unsigned int on = (level - before.level) / 2;
      level = on > 0 ? before.level + on : highest_level + 1;
    } else {
      before = std::move(now);
      const unsigned int next = level + (usable ? convergence.levels_to(tolerance / margin) : 1);
      level = wants_proof ? list[what].level_of_proof : next;
    }
    if (level > highest_level) {
      account.reached = false;
      if (converged)
        return before; // which is the last
      solved.clear();
      return solve_at(what, before.level); // once more, so that the files are its own
    }
  }
}

Trial AccuracyControl::refine_together(const std::array<std::size_t, 2> &both,
                                       const double tolerance) {
  std::array<accuracy::Convergence, 2> convergence = {accuracy::Convergence(list[both[0]].order),
                                                      accuracy::Convergence(list[both[1]].order)};
  for (const std::size_t what : both)
    levels[what] = 1;
  while (true) {
    const std::array<unsigned int, 2> level = {levels[both[0]], levels[both[1]]};
    std::array<Trial, 2> coarser;
    for (unsigned int i = 0; i < 2; ++i) {
      coarser[i] = solve_at(both[i], level[i] - 1);
      levels[both[i]] = level[i];
    }
    const Trial base = solve_at(both[0], level[0]); // the last, to which files belong
    std::array<bool, 2> usable;
    double sum = 0., largest = 0.;
    for (unsigned int i = 0; i < 2; ++i) {
      usable[i] = base.results.status == RunStatus::converged &&
                  coarser[i].results.status == RunStatus::converged;
      if (!usable[i])
        continue;
      const auto differences = accuracy::differences(scene, coarser[i].results, base.results);
      convergence[i].add(level[i] - 1, level[i], differences);
      estimates[both[i]] = convergence[i].estimate();
      sum += estimates[both[i]];
      largest = std::max(largest, accuracy::largest(differences).value);
      account.runs.back().change = largest;
    }
    const bool known = convergence[0].knows_orders() && convergence[1].knows_orders();
    if (usable[0] && usable[1] && margin * sum <= (known ? tolerance : first_share * tolerance)) {
      if (sees_events(coarser[0].results, base.results))
        return base;
      ++levels[both[0]];
      continue;
    }
    const double share = tolerance / (2. * margin);
    for (unsigned int i = 0; i < 2; ++i)
      if (base.results.status != RunStatus::converged) // for which a shorter time step may help
        levels[both[i]] += i == 0;
      else if (!usable[i] || !known)
        ++levels[both[i]];
      else if (estimates[both[i]] > share)
        levels[both[i]] += convergence[i].levels_to(share);
    if (std::max(levels[both[0]], levels[both[1]]) > highest_level) {
      account.reached = false;
      for (unsigned int i = 0; i < 2; ++i)
        levels[both[i]] = level[i]; // of the answer
      return base;
    }
  }
}

ModelKind AccuracyControl::choose_model() {
  if (scene.steps.empty()) {
    account.model_reason = "the scene has no line";
    return ModelKind::continuum;
  }
  if (!scene.continuum)
    return choose_bends();
  model = ModelKind::line;
  const accuracy::LineForms forms = accuracy::line_forms(scene, file);
  const Results less = solve_with(forms.without_last_correction), best = solve_with(forms.best);
  const accuracy::Difference change = accuracy::largest(accuracy::differences(scene, less, best));
  const bool known = less.status == RunStatus::converged && best.status == RunStatus::converged;
  account.runs.back().change = change.value;
  if (known)
    account.line_error = change.value;
  if (!known || !(change.value <= most_of_model * demanded)) {
    account.model_reason = known ? "the last correction of the line, shear lag, changes " +
                                       change.name + " by " + rounded_number(change.value, 2)
                                 : "the line has no answer";
    return ModelKind::continuum;
  }
  account.model_reason = "the last correction of the line, shear lag, changes no quantity by more";
  model_error = change.value;
  chosen = {"Slab/Poisson squeeze = true", "Slab/Shear lag = 3"};
  return ModelKind::line;
}

ModelKind AccuracyControl::choose_bends() {
  model = ModelKind::line;
  if (const std::string why = accuracy::why_not_mixed(scene); !why.empty()) {
    account.model_reason = "what beams leave out of bends is not estimated where " + why;
    if (!scene.pipes.empty())
      account.left_out.push_back("what walls of pipes change in bends and at supports: it is not "
                                 "estimated where " +
                                 why);
    return model;
  }
  if (this_process() > 0)
    return model; // a line is the first one's
  pipes = accuracy::choose_pipe_model(accuracy::with_arcs(scene),
                                      {demanded, most_of_model, early_share},
                                      [this](const Scene &one, const std::string &what) {
                                        scene = one;
                                        return solve_scene(what);
                                      });
  chosen = pipes.line;
  account.model_reason = pipes.reason;
  account.line_error = pipes.line_error;
  account.left_out = pipes.left_out;
  model_error = pipes.error;
  return model;
}

Results AccuracyControl::run_line() {
  list = accuracy::refinables(scene, file);
  const auto append = [](auto &all, const auto &more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  append(chosen, accuracy::exact_settings(scene));
  append(account.left_out, accuracy::left_out(scene));
  levels.assign(list.size(), 0); // what is chosen later is coarse as yet
  estimates.assign(list.size(), 0.);
  Results results;
  if (list.empty())
    results = solve_with(chosen);
  for (std::size_t i = 0; i < list.size() && account.reached; ++i) {
    const bool together = list[i].depends_on_next && i + 1 < list.size(),
               is_last = i + (together ? 2 : 1) == list.size();
    const double tolerance = is_last ? demanded - estimate_without(i) : early_share * demanded;
    results = (together ? refine_together({i, i + 1}, tolerance) : refine(i, tolerance)).results;
    if (coarsest_will_do && !is_last)
      levels[i] = 0;
    i += together;
  }
  account.estimate = model_error + pipes.beyond;
  for (const double estimate : estimates)
    account.estimate += estimate;
  for (std::size_t i = 0; i < list.size(); ++i)
    append(chosen, list[i].settings(levels[i]));
  return results;
}

Results AccuracyControl::solve_solid_bends(Results line) {
  std::vector<std::string> settings = chosen;
  settings.insert(settings.end(), pipes.solid.begin(), pipes.solid.end());
  const Scene as_line = scene;
  try {
    Results results = solve_with(settings);
    chosen = settings;
    account.model = "line with solid bends";
    account.left_out.push_back(accuracy::left_out_of_walls());
    return results;
  } catch (const UserError &error) { // what only the walls' own scene shows
    scene = as_line;
    account.reached = false;
    account.estimate += pipes.line_error;
    pipes.judged.push_back(
        std::string("Solid bends are needed, which this scene does not allow: ") + error.what());
    return line;
  }
}

Results AccuracyControl::run_continuum() {
  chosen = accuracy::continuum_settings(scene, demanded);
  Results results = solve_with(chosen);
  account.estimate = std::nan("");
  for (const Check &check : results.certificate)
    if (check.name == "refinement")
      account.estimate = check.value;
  account.reached = results.status == RunStatus::converged;
  return results;
}

SolvedScene AccuracyControl::run() {
  account.demanded = demanded;
  account.reached = true;
  const bool choose = model == ModelKind::automatic;
  if (choose) {
    model = choose_model();
    if (n_processes() > 1) { // the first one has solved the line
      unsigned int solved = static_cast<unsigned int>(model);
      MPI_Bcast(&solved, 1, MPI_UNSIGNED, 0, MPI_COMM_WORLD);
      model = static_cast<ModelKind>(solved);
    }
    account.model = row_of(model_kinds, model).word;
    if (model == ModelKind::continuum && this_process() == 0)
      remove_line_tables(scene.output.directory); // of the line that was tried
    for (const std::string &one : accuracy::left_out_by(model, scene))
      account.left_out.push_back(one);
  }
  Results results = model == ModelKind::continuum ? run_continuum() : run_line();
  if (!pipes.solid.empty() && account.reached)
    results = solve_solid_bends(std::move(results));
  account.reached = account.reached && pipes.beyond == 0.;
  account.chosen = chosen;
  accuracy::include_walls(choose, results.known.cells, account);
  for (const QuantityResult &quantity : results.quantities)
    if (quantity.of_impact)
      account.left_out.push_back(
          quantity.name + ": the force of an impact on a rigid support has no largest value");
  cost.unknowns = results.cost.unknowns;
  cost.cells = results.cost.cells;
  cost.contacts = results.cost.contacts;
  results.cost = cost; // of all runs, but for the size of the last one
  if (!account.reached && results.status == RunStatus::converged)
    results.status = RunStatus::failed;
  accuracy::add_remarks({account, margin, choose, missed, pipes.judged}, results);
  results.accuracy = account;
  return {std::move(scene), std::move(results)};
}

} // namespace

SolvedScene solve_to_accuracy(const RunOptions &options, Scene scene, const ReadScene &read,
                              const SolveScene &solve) {
  return AccuracyControl(options, std::move(scene), read, solve).run();
}

} // namespace frictionbeam
