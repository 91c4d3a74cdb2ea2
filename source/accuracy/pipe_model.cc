// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipe_model.h"

#include "accuracy/account_remarks.h"
#include "accuracy/difference.h"
#include "accuracy/refinable.h"
#include "accuracy/support_models.h"
#include "mesh/solid/wall_cells.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

namespace frictionbeam::accuracy {

namespace {

/// Of the flexibility of a bend, what a solid that ends twice r sqrt(r/t) from it leaves out
/// (doc/solid.md, "Mixed models").
constexpr double left_of_oval = 0.002;
constexpr unsigned int degree_of_walls = 3, cells_along_walls = 6;

void judge_supports(const Scene &scene, const Results &beams, const double most,
                    const SolveWith &solve_with, PipeModel &model) {
  const ElasticSupports supports = elastic_supports(scene);
  for (const std::string &one : supports.unknown)
    model.judged.push_back("Support " + one + ": how its pipe's wall gives way is not judged.");
  if (supports.settings.empty() || beams.status != RunStatus::converged)
    return;
  std::vector<std::string> settings = exact_settings(scene);
  settings.insert(settings.end(), supports.settings.begin(), supports.settings.end());
  const Results elastic = solve_with(settings);
  const Difference change = largest(differences(scene, beams, elastic));
  const bool known = elastic.status == RunStatus::converged,
             is_small = known && model.error + change.value <= most;
  const std::string changes =
      !known               ? "leaves no equilibrium"
      : change.value == 0. ? "changes no quantity"
                           : "changes " + change.name + " by " + rounded_number(change.value, 2);
  model.judged.push_back("Supports: the wall of the pipe that gives way under them, as about " +
                         settings_in_words(supports.settings) + " has it, " + changes +
                         (is_small
                              ? ": beams answer for them."
                              : ", which beams and solid bends leave out; Model = solid has it."));
  if (is_small)
    model.error += change.value;
  else if (known)
    model.beyond = change.value;
  else
    model.left_out.push_back("the wall of the pipe that gives way at supports, which " + changes);
}

/// What a hot wall does at supports, of which a line knows nothing.
void mention_growth(const Scene &scene, PipeModel &model) {
  if (scene.supports.empty())
    return;
  for (const Load &load : scene.loads)
    if (load.kind == Load::Kind::temperature) {
      model.left_out.push_back("that hot pipes grow thicker, which lifts their axes off rests by "
                               "their expansion times r");
      return;
    }
}

} // namespace

PipeModel choose_pipe_model(const Scene &scene, const ModelShares &shares, const SolveAs &solve_as,
                            const SolveWith &solve_with) {
  const Results beams = solve_as(scene, "bends by their pipes' rules");
  const ModelOfPipes bends =
      model_of_pipes(scene, beams, shares.of_model * shares.demanded, solve_as);
  PipeModel model;
  model.reason = bends.reason;
  model.line_error = bends.change;
  model.error = bends.left;
  model.judged = bends.in_words;
  if (!bends.solid.empty()) {
    const double part = shares.of_walls * shares.demanded / bends.per_part;
    const unsigned int n_around = cells_around_for(part, bends.r_over_t);
    model.error += bends.per_part *
                   (left_of_oval + *flexibility_error(degree_of_walls, n_around, bends.r_over_t));
    model.solid = {"Model = line", "Solid/At = " + join(bends.solid),
                   "Solid/Degree = " + std::to_string(degree_of_walls),
                   "Solid/Cells around = " + std::to_string(n_around),
                   "Solid/Cells per bend = " + std::to_string(cells_along_walls)};
  }
  judge_supports(scene, beams, shares.of_model * shares.demanded, solve_with, model);
  mention_growth(scene, model);
  return model;
}

} // namespace frictionbeam::accuracy
