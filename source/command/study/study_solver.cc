// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/study_solver.h"

#include "command/line/run_line.h"
#include "command/study/condensed_runs.h"
#include "command/study/quick_line.h"

#include "analysis/contact/undetermined_forces.h"
#include "analysis/sequence/load_sequence.h"
#include "base/user_error.h"
#include "mesh/build_line_mesh.h"
#include "model/line_model.h"
#include "results/text.h"
#include "scene/read_scene.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::study {

namespace {

/// Hangers whose springs are sized keep them.
void keep_sized_hangers(const Scene &from, Scene &scene) {
  for (Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0.) {
      for (const unsigned int s : hanger.springs)
        if (s < from.springs.size()) {
          scene.springs[s].stiffness = from.springs[s].stiffness;
          scene.springs[s].preload = from.springs[s].preload;
        }
      for (const Hanger &sized : from.hangers)
        if (sized.name == hanger.name)
          hanger.items = sized.items;
    }
}

LineMesh mesh_of(const StudyCase &of, const Scene &scene) {
  const std::lock_guard<std::mutex> lock(of.meshing);
  return build_line_mesh(scene);
}

/// Whether the model of one scene serves the other with other parameters for its supports' laws: it
/// does not where the exact method is not taken, which makes no stiffness of them, where platens
/// are put in place by them, or where a time step keeps more than its state.
bool can_share_model(const Scene &scene) {
  return scene.solver.is_exact() && scene.kinematics == Kinematics::linear && !scene.yields() &&
         !has_transient_step(scene) &&
         std::all_of(scene.supports.begin(), scene.supports.end(),
                     [](const FrictionSupport &support) { return support.normal_force == 0.; });
}

/// Whether the supports are the same but for their laws' parameters.
bool has_same_supports(const Scene &one, const Scene &other) {
  return one.restraints.size() == other.restraints.size() &&
         std::equal(one.supports.begin(), one.supports.end(), other.supports.begin(),
                    other.supports.end(), [](const FrictionSupport &a, const FrictionSupport &b) {
                      return a.name == b.name && a.law == b.law;
                    });
}

/// Of the law of these parameters: whether friction grows when slip begins, which is refused.
bool grows(const LawDescription &law, const std::vector<double> &parameters) {
  double fixed = 0., dynamic = 0.;
  for (int i = 0; i < law.n_parameters; ++i)
    if (const std::string name = law.parameters[i].name; name == "Friction coefficient")
      fixed = parameters[i];
    else if (name == "Dynamic friction coefficient")
      dynamic = parameters[i];
  return dynamic > fixed;
}

/**
 * Set a parameter of a support's law as reading the file again would, which takes longer than
 * solving a line.
 * @param heading "Support rests", or "Support rests.3" for its third place
 * @return false where more than that follows from it: the file has to be read
 */
bool set_parameter(const std::string &heading, const std::string &entry, const double value,
                   const Scene &scene, const LawLibrary &laws,
                   std::vector<FrictionSupport> &supports) {
  if (value == 0.) // a guide may hold exactly then
    return false;
  bool found = false;
  for (FrictionSupport &support : supports) {
    const std::string name = "Support " + part_name(support);
    const bool is_place = heading.rfind(name + '.', 0) == 0;
    if (heading != name && !is_place)
      continue;
    const LawDescription &law = laws.find(support.law);
    int i = 0;
    while (i < law.n_parameters && law.parameters[i].name != entry)
      ++i;
    if (i == law.n_parameters || (!is_place && !support.parameters_at.empty()))
      return false;
    std::vector<double> *parameters = &support.parameters;
    if (is_place) {
      const std::string number = heading.substr(name.size() + 1);
      if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
        return false;
      parameters = &support.parameters_at.try_emplace(std::stoul(number) - 1, support.parameters)
                        .first->second;
    }
    (*parameters)[i] = value * scene.units.factor(law.parameters[i].unit);
    if (grows(law, *parameters))
      return false;
    found = true;
  }
  return found;
}

/// What a run has come to.
Run run_of(const StudyCase &of, const std::vector<StepReport> &steps, const bool converged,
           const Results &results) {
  Run run;
  if (!converged) {
    const bool slides = !steps.empty() && steps.back().no_equilibrium;
    run.outcome = slides ? Outcome::no_equilibrium : Outcome::failed;
    if (!steps.empty())
      run.reason = "step " + steps.back().step + ": " + steps.back().remark;
    return run;
  }
  if (!has_names(results, of.names)) {
    run.outcome = Outcome::refused;
    run.reason = "it has other supports, steps or quantities than the case";
    return run;
  }
  run.outcome = Outcome::converged;
  run.numbers = numbers_of(results);
  return run;
}

} // namespace

Scene read_variant(const StudyCase &of, const std::vector<std::string> &settings,
                   LawLibrary &laws) {
  std::vector<std::string> overrides = of.options.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  Scene scene = read_scene(of.options.parameter_file, overrides, laws);
  scene.output.directory.clear();
  scene.output.vtu = scene.output.report = scene.output.contact_problems = false;
  scene.output.every_increment = scene.output.resume = false;
  scene.output.quiet = true;
  keep_sized_hangers(of.scene, scene);
  return scene;
}

Results solve_variant(const StudyCase &of, const Scene &scene, const LawLibrary &laws) {
  const LineModel line(scene, mesh_of(of, scene), laws);
  LoadSequence sequence(line.model());
  Results results;
  solve_sequence(line.model(), sequence, results);
  return results;
}

/// A line whose supports get other parameters from run to run, with the factors of its stiffness.
class StudySolver::SharedLine {
public:
  SharedLine(const StudyCase &of, const Scene &like, const LawLibrary &laws)
      : scene(like), line(scene, mesh_of(of, scene), laws), statics(line.model()),
        asks_what_carries(share_unknowns(line.model().contacts)) {
    if (QuickLine::can_do(scene))
      quick.emplace(line.model());
  }

  /// @param supports those of the scene, with other parameters for their laws
  Run solve(const StudyCase &of, const std::vector<FrictionSupport> &supports) {
    take_laws_of(supports);
    if (quick && statics.begin() && solve_quickly())
      return run_of(of, {}, true, quick->conclude());
    statics.begin_alone();
    LoadSequence sequence(line.model(), statics);
    sequence.leave_out_judgement();
    if (!quick) {
      Results results;
      solve_sequence(line.model(), sequence, results);
      return run_of(of, results.steps, results.status == RunStatus::converged, results);
    }
    if (!run(sequence))
      return run_of(of, sequence.reports(), false, {});
    return run_of(of, {}, true, quick->conclude());
  }

private:
  void take_laws_of(const std::vector<FrictionSupport> &supports) {
    for (unsigned int i = 0; i < supports.size(); ++i) {
      scene.supports[i].parameters = supports[i].parameters;
      scene.supports[i].parameters_at = supports[i].parameters_at;
    }
    line.take_laws_of(scene);
  }

  bool solve_quickly() {
    LoadSequence sequence(line.model(), statics);
    sequence.leave_out_judgement();
    return run(sequence);
  }

  /// @return whether all steps have an answer; if not alone, one whose forces balance on the whole
  /// line and are determined
  bool run(LoadSequence &sequence) {
    bool holds = true;
    const bool converged = sequence.run(
        [&](const Progress &progress, const LineState &state) {
          if (progress.n_increments == 0 || progress.increment < progress.n_increments)
            return;
          LineState whole = state;
          holds = statics.complete(whole) && holds;
          quick->observe(progress.step, whole);
        },
        [&](const Progress &, const LineState &state) {
          if (asks_what_carries && !statics.is_alone() && holds)
            holds = contacts_with_undetermined_forces(line.model().contacts, state).empty();
        });
    return converged && holds;
  }

  Scene scene; ///< that the line knows
  LineModel line;
  CondensedRuns statics;
  const bool asks_what_carries;
  std::optional<QuickLine> quick;
};

StudySolver::StudySolver(const StudyCase &of) : of(of) { laws.load_builtin(); }

StudySolver::~StudySolver() = default;

Run StudySolver::solve(const Scene &scene) {
  if (!of.varies_laws || !can_share_model(scene) || !has_same_supports(scene, of.scene)) {
    const Results results = solve_variant(of, scene, laws);
    return run_of(of, results.steps, results.status == RunStatus::converged, results);
  }
  if (!shared)
    shared = std::make_unique<SharedLine>(of, scene, laws);
  return shared->solve(of, scene.supports);
}

std::optional<std::vector<FrictionSupport>>
StudySolver::supports_with(const std::vector<std::string> &settings) const {
  std::vector<FrictionSupport> supports = of.scene.supports;
  for (const std::string &setting : settings) {
    const auto slash = setting.find('/'), equal = setting.find('=');
    double value = 0.;
    if (!to_number(tidy(setting.substr(equal + 1)), value) ||
        !set_parameter(setting.substr(0, slash), tidy(setting.substr(slash + 1, equal - slash - 1)),
                       value, of.scene, laws, supports))
      return {};
  }
  return supports;
}

Run StudySolver::solve(const std::vector<std::string> &settings) {
  Run run;
  try {
    if (shared)
      if (const auto supports = supports_with(settings))
        return shared->solve(of, *supports);
    return solve(read_variant(of, settings, laws));
  } catch (const UserError &error) {
    run.outcome = Outcome::refused;
    run.reason = error.what();
  } catch (const dealii::ExceptionBase &error) { // our own mistake, which must not end the others
    run.outcome = Outcome::error;
    run.reason = error.what();
  }
  return run;
}

} // namespace frictionbeam::study
