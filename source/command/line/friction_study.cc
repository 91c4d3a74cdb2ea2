// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/friction_study.h"

#include "base/peak_memory.h"
#include "base/user_error.h"
#include "command/line/run_line.h"
#include "results/file/output_file.h"
#include "results/file/summary.h"
#include "results/report/report_study.h"
#include "results/text.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <set>

namespace frictionbeam {

namespace {

/// The scene with all friction coefficients multiplied.
Scene with_friction(Scene scene, const LawLibrary &laws, const double multiplier) {
  for (FrictionSupport &support : scene.supports) {
    const LawDescription &law = laws.find(support.law);
    for (int i = 0; i < law.n_parameters; ++i) {
      const std::string name = law.parameters[i].name;
      if (name != "Friction coefficient" && name != "Dynamic friction coefficient")
        continue;
      const auto multiply = [&](double &value) { value *= value > 0. ? multiplier : 1.; };
      multiply(support.parameters[i]);
      for (auto &[place, parameters] : support.parameters_at)
        multiply(parameters[i]);
    }
  }
  return scene;
}

} // namespace

std::string study_folder(const std::string &folder, const double multiplier) {
  return folder + "/friction_" + rounded_number(multiplier);
}

void study_friction(const Scene &scene, const LawLibrary &laws, Results &results) {
  if (scene.friction_multipliers.empty())
    return;
  FrictionStudy &study = results.friction_study;
  std::set<std::string> other_laws;
  for (const FrictionSupport &support : scene.supports)
    if (support.law != "coulomb")
      other_laws.insert(support.law);
  for (const std::string &law : other_laws)
    results.remarks.push_back("The study multiplies parameters called 'Friction coefficient' and "
                              "'Dynamic friction coefficient'; the law '" +
                              law + "' is left as it is unless it has them.");
  if (const Scene twice = with_friction(scene, laws, 2.); std::equal(
          scene.supports.begin(), scene.supports.end(), twice.supports.begin(),
          [](const FrictionSupport &one, const FrictionSupport &other) {
            return one.parameters == other.parameters && one.parameters_at == other.parameters_at;
          }))
    results.remarks.push_back("Friction multipliers do nothing: no support has a friction "
                              "coefficient above 0.");
  for (const SupportInfo &support : results.supports)
    study.names.push_back(support.name);
  for (const RestraintInfo &restraint : results.restraints)
    study.names.push_back(restraint.name);
  std::set<double> multipliers(scene.friction_multipliers.begin(),
                               scene.friction_multipliers.end());
  multipliers.insert(1.); // the scene as it is
  for (const double multiplier : multipliers) {
    if (multiplier == 1.) {
      include_in_study(multiplier, results, study);
      continue;
    }
    Scene variant = with_friction(scene, laws, multiplier);
    variant.output.directory = study_folder(scene.output.directory, multiplier);
    variant.output.vtu = false;
    prepare_output_folder(variant.output.directory);
    Results other;
    const dealii::Timer wall;
    try {
      other = solve_scene(variant, laws);
    } catch (const UserError &error) { // without friction, something may move freely
      results.remarks.push_back("With friction times " + rounded_number(multiplier) +
                                " there is no run: " + error.what());
      continue;
    }
    other.cost.peak_memory_mb = peak_memory_mb();
    other.cost.wall_seconds = wall.wall_time();
    write_summary(variant, other, variant.output.directory);
    if (other.status != RunStatus::converged)
      results.remarks.push_back("With friction times " + rounded_number(multiplier) +
                                " the run is not converged: its row of the study is what it "
                                "reached.");
    include_in_study(multiplier, other, study);
  }
}

} // namespace frictionbeam
