// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipe_model.h"

#include "accuracy/account_remarks.h"
#include "accuracy/difference.h"
#include "accuracy/pipes/held_sections.h"
#include "accuracy/pipes/patch_edges.h"
#include "accuracy/support_models.h"
#include "mesh/solid/wall_cells.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"
#include "scene/solid/mixed_entries.h"

#include <algorithm>
#include <utility>

namespace frictionbeam::accuracy {

namespace {

constexpr unsigned int degree_of_walls = 3, cells_along_walls = 6;
constexpr double most_of_all = 0.9;     ///< of what is demanded, that a model may leave
constexpr double off_by_of_rings = 0.1; ///< part that a held ring's elasticity may be off
constexpr double off_by = 1. / 3.; ///< part that the elasticity of walls at supports may be off
constexpr double off_by_of_growth = 0.1; ///< part that their growth by heat and pressure may be off
constexpr double off_by_of_edges = 0.2; ///< part that what the edges of their patches do may be off
constexpr double formula_of_cells = 1.5; ///< times as much as it says may be left by cells
constexpr double nothing_known = 1.;     ///< error of a quantity

/// Whether a line stop carries something at the end of a step.
bool is_collar_pressed(const Results &beams) {
  for (const Frame &frame : beams.frames)
    for (std::size_t i = 0; i < std::min(frame.supports.size(), beams.supports.size()); ++i)
      if (frame.supports[i].fn > 0. && beams.supports[i].kind == "line stop")
        return true;
  return false;
}

struct Change {
  double value;
  std::string in_words;
};
Change change_between(const Scene &scene, const Results &from, const Results &to) {
  if (from.status != RunStatus::converged || to.status != RunStatus::converged)
    return {nothing_known, "leaves no equilibrium"};
  const Difference difference = largest(differences(scene, from, to));
  return {difference.value, difference.value == 0. ? "changes no quantity"
                                                   : "changes " + difference.name + " by " +
                                                         rounded_number(difference.value, 2)};
}

/// What guides and stops without gap, and anchors, hold of their sections.
void judge_held_sections(const Scene &scene, const Results &beams, const SolveAs &solve,
                         PipeModel &model) {
  if (scene.restraints.empty() || beams.status != RunStatus::converged)
    return;
  const auto changed_by = [&](const HeldAs as, const std::string &what) {
    return change_between(scene, beams, solve(with_held_sections(scene, beams, as), what));
  };
  const Change all = changed_by(HeldAs::sections, "sections held as a solid's");
  const double off = off_by_of_rings * changed_by(HeldAs::rings, "rings of guides").value;
  model.error += all.value + off;
  model.judged.push_back("Guides and anchors: that they hold the mean of a section, whose ring "
                         "gives way and whose shape changes as it is bent, " +
                         all.in_words + "; beside that " + rounded_number(off, 2) +
                         " is not known of it.");
}

/// What sections do at the points whose motions are asked for.
void judge_points(const Scene &scene, const Results &beams, PipeModel &model) {
  const Change change = change_between(scene, with_sections_at_points(scene, beams), beams);
  if (beams.status != RunStatus::converged || change.value == 0.)
    return;
  model.error += change.value;
  model.judged.push_back(
      "Points: that a bent section changes its shape and a ring of the wall gives "
      "way under a force " +
      change.in_words + " (Model = solid has it).");
}

/// The scene with these places solid.
Scene in_mixed_model(Scene scene, const std::vector<std::string> &places) {
  for (const std::string &place : places)
    scene.asked_points.push_back({solid_at, place});
  return scene;
}

/// What walls at supports change, and how supports as elastic as walls would do.
class SupportsJudge {
public:
  SupportsJudge(const Scene &scene, const Results &beams, const SolveAs &solve)
      : scene(scene), beams(beams), solve(solve), walls(walls_at_supports(scene)) {}

  /// @param most that the model may leave with rigid supports @param most_left at all
  void judge(const double most, const double most_left, PipeModel &model);

private:
  /// What supports are besides elastic, as entries.
  struct Entries {
    std::vector<GrowingSupport> growth;
    std::vector<unsigned int> edges; ///< supports that stand on them
  };
  Results elastic(const WallsAre as, const Entries &with, const std::string &what) const {
    return solve(on_edges(with_growth(with_walls(scene, walls, as), with.growth), with.edges),
                 what);
  }

  /// What elastic supports leave: where they are off themselves, what they leave out, and what is
  /// not known of that.
  struct Left {
    double by_formula, left_out, unknown;
    double all() const { return by_formula + left_out + unknown; }
  };
  /// Growth and edges of patches may undo each other: each is among the entries only where less is
  /// left with it. @param full with both
  Left left_by_elastic(const Results &full);

  const Scene &scene;
  const Results &beams;
  const SolveAs &solve;
  const WallsAtSupports walls;
  Entries entries; ///< all that there may be, and then those that help
};

SupportsJudge::Left SupportsJudge::left_by_elastic(const Results &full) {
  const std::string elastically = "supports as elastic as walls";
  const Entries possible = std::exchange(entries, {});
  Results as_walls = elastic(WallsAre::as_measured, entries, elastically);
  Left left{0., change_between(scene, as_walls, full).value, 0.};
  double by_growth = 0., by_edges = left.left_out;
  const auto try_with = [&](const Entries &with, const std::string &what) {
    Results results = elastic(WallsAre::as_measured, with, elastically + what);
    const double left_out = change_between(scene, results, full).value;
    if (with.edges.empty()) {
      by_growth = change_between(scene, as_walls, results).value;
      by_edges = left_out;
    }
    return std::pair(std::move(results), left_out);
  };
  std::vector<std::pair<Entries, std::string>> tries;
  if (!possible.growth.empty())
    tries.push_back({{possible.growth, {}}, " that grow"});
  if (!possible.edges.empty())
    tries.push_back({{{}, possible.edges}, " on edges"});
  if (!possible.growth.empty() && !possible.edges.empty())
    tries.push_back({possible, " on edges that grow"});
  Results nearest = as_walls;
  for (const auto &[with, what] : tries)
    if (auto [results, left_out] = try_with(with, what); left_out < left.left_out) {
      left.left_out = left_out;
      nearest = std::move(results);
      entries = with;
    }
  left.unknown = off_by_of_growth * by_growth + off_by_of_edges * by_edges;
  as_walls = std::move(nearest);
  const Results softer = elastic(WallsAre::softer, entries, "supports softer than walls"),
                stiffer = elastic(WallsAre::stiffer, entries, "supports stiffer than walls");
  left.by_formula = std::max(change_between(scene, as_walls, softer).value,
                             change_between(scene, as_walls, stiffer).value);
  return left;
}

/// What the entries leave out.
std::string left_by(const bool of_growth, const bool of_edges) {
  return of_growth && of_edges ? "growth and the edges of patches"
         : of_edges            ? "the edges of patches, and growth within guides"
         : of_growth           ? "growth, and the edges of guides"
                               : "growth within guides and their edges";
}

void SupportsJudge::judge(const double most, const double most_left, PipeModel &model) {
  for (const std::string &one : walls.unknown)
    model.judged.push_back("Support " + one + ": how its pipe's wall gives way is not judged.");
  if (walls.has_collar && is_collar_pressed(beams)) {
    model.error += nothing_known;
    model.judged.push_back(
        "A line stop is pressed: the collar of a solid pipe holds the rotation of its section, "
        "which a "
        "beam's stop does not, and what that changes is not known (Model = solid has it).");
  }
  if (walls.walls.empty() || beams.status != RunStatus::converged)
    return;
  std::vector<std::string> do_not_grow;
  const std::vector<GrowingSupport> growing = growing_supports(scene, walls, beams, do_not_grow);
  for (const GrowingSupport &one : growing)
    if (one.is_an_entry)
      entries.growth.push_back(one);
  entries.edges = supports_with_edges(in_mixed_model(scene, model.solid_at), walls);
  const Scene of_walls = with_walls(scene, walls, WallsAre::as_measured),
              grown = with_edges(with_growth(of_walls, growing), walls, beams);
  for (const std::string &one : do_not_grow)
    model.left_out.push_back("that a hot pipe grows thicker at support " + one);
  const Results full = solve(grown, "supports as patches of walls");
  const Change by_walls = change_between(scene, beams, full);
  const std::string what = "Supports: the wall of the pipe, which gives way under their patches, "
                           "grows when it is hot and is rubbed on its outside, " +
                           by_walls.in_words;
  const double as_rigid = (1. + off_by) * by_walls.value;
  if (model.error + as_rigid <= most) {
    model.error += as_rigid;
    model.judged.push_back(what + ": beams answer for them.");
    return;
  }
  const Left left = left_by_elastic(full);
  const bool helps = left.all() < as_rigid;
  const double total = model.error + std::min(left.all(), as_rigid);
  model.judged.push_back(
      what +
      (!helps ? ", which beams and solid bends leave out; as elastic supports they leave "
              : ". They are made as elastic as it is" +
                    std::string(entries.edges.empty() ? "" : ", rests stand on edges,") +
                    (entries.growth.empty() ? "" : " and come nearer by as much as it grows") +
                    ", which leaves ") +
      rounded_number(left.by_formula, 2) +
      " since that is known within a third (near anchors less), " +
      rounded_number(left.left_out, 2) + " by " +
      left_by(entries.growth.empty(), entries.edges.empty()) + ", and " +
      rounded_number(left.unknown, 2) + " by what is not known of both" +
      (total > most_left
           ? ". With all else that is left this makes " + rounded_number(total, 2) +
                 ", a bound, and more than what was asked, which no mixed model mends, for its "
                 "rests are those of the line. Proposed: Model = solid, which has all this, Model "
                 "= both, which shows how much of it there is, or a larger Accuracy."
           : "."));
  if (helps)
    model.line = settings_of(scene, walls, entries.growth, entries.edges);
  model.error = total;
}

/// @param most_by_bends that those which stay beams may leave
PipeModel pipe_model(const Scene &scene, const Results &beams, const double most_by_bends,
                     const ModelShares &shares, const SolveAs &solve) {
  const ModelOfPipes bends = model_of_pipes(scene, beams, most_by_bends, solve);
  PipeModel model;
  model.reason = bends.reason;
  model.line_error = bends.change;
  model.error = model.by_bends = bends.left;
  model.judged = bends.in_words;
  if (!bends.solid.empty()) {
    // Finer cells than the joints are worth are in vain.
    const double part = shares.of_walls *
                        std::max(shares.demanded / bends.per_part, bends.of_joints) /
                        formula_of_cells;
    const unsigned int n_around = cells_around_for(part, bends.r_over_t);
    const double of_cells =
        formula_of_cells * *flexibility_error(degree_of_walls, n_around, bends.r_over_t);
    model.error += bends.per_part * (bends.of_joints + of_cells) + bends.by_pressure;
    model.solid_at = bends.solid;
    model.solid = {"Model = line", "Solid/At = " + join(bends.solid),
                   "Solid/Degree = " + std::to_string(degree_of_walls),
                   "Solid/Cells around = " + std::to_string(n_around),
                   "Solid/Cells per bend = " + std::to_string(cells_along_walls)};
    model.judged.push_back(
        "Solid bends leave " + rounded_number(bends.per_part * bends.of_joints, 2) +
        " where they are joined to beams, and " + rounded_number(bends.per_part * of_cells, 2) +
        " by their cells" +
        (bends.by_pressure > 0.
             ? "; the Stiffening pressure above that of the loads does not stiffen them, " +
                   rounded_number(bends.by_pressure, 2) + "."
             : "."));
  }
  judge_held_sections(scene, beams, solve, model);
  judge_points(scene, beams, model);
  SupportsJudge(scene, beams, solve)
      .judge(shares.of_model * shares.demanded, most_of_all * shares.demanded, model);
  if (!(model.error <= most_of_all * shares.demanded)) {
    model.beyond = model.error;
    model.error = 0.;
  }
  return model;
}

} // namespace

PipeModel choose_pipe_model(const Scene &scene, const ModelShares &shares, const SolveAs &solve) {
  const Results beams = solve(scene, "bends by their pipes' rules");
  const PipeModel model =
      pipe_model(scene, beams, shares.of_model * shares.demanded, shares, solve);
  const double room_for_bends = model.by_bends + most_of_all * shares.demanded - model.beyond;
  if (model.beyond == 0. || model.by_bends == 0. || !(room_for_bends > 0.))
    return model;
  PipeModel more_solid = pipe_model(scene, beams, room_for_bends, shares, solve);
  return more_solid.beyond == 0. ? more_solid : model;
}

} // namespace frictionbeam::accuracy
