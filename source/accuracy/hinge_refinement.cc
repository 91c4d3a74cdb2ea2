// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/hinge_refinement.h"

#include "accuracy/difference.h"
#include "base/number_text.h"
#include "base/user_error.h"
#include "results/file/vtu_writer.h"

namespace frictionbeam {

namespace {
constexpr double usual_tolerance = 1e-3;
constexpr unsigned int most_levels = 10;
} // namespace

Results refine_hinges(Scene scene, const SolveScene &solve) {
  if (scene.quantities.empty())
    throw UserError("Section Mesh: 'Refine hinges' ends when the quantities are known.\n  read:    "
                    "no Quantities\n  allowed: one or more\n  try:     set peak = max |ux| at a "
                    "point, in section Quantities");
  const double tolerance = scene.accuracy > 0. ? scene.accuracy : usual_tolerance;
  Results results = solve(scene);
  for (unsigned int level = 1; results.status == RunStatus::converged; ++level) {
    if (results.yielded.empty()) {
      results.remarks.push_back("Refine hinges: nothing has yielded, no cell was halved.");
      break;
    }
    scene.mesh.hinge_nodes.insert(scene.mesh.hinge_nodes.end(), results.yielded.begin(),
                                  results.yielded.end());
    remove_frames(scene.output.directory);
    Results finer = solve(scene);
    finer.cost.add_work(results.cost);
    const auto change = accuracy::largest(accuracy::differences(scene, results, finer));
    results = std::move(finer);
    const std::string levels =
        "Refine hinges: cells that yield were halved " + std::to_string(level) + " times, to " +
        std::to_string(results.cost.cells) + " cells in all; the last time changed " +
        (change.name.empty() ? "quantities" : change.name) + " by " +
        rounded_number(change.value, 2) + " of itself";
    if (results.status != RunStatus::converged || change.value <= tolerance) {
      results.remarks.push_back(levels + ".");
      break;
    }
    if (level == most_levels) {
      results.remarks.push_back(levels + ", more than the " + rounded_number(tolerance, 2) +
                                " that was to be reached.");
      break;
    }
  }
  return results;
}

} // namespace frictionbeam
