// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/bend_models.h"
#include "accuracy/bend_flexibility_table.h"
#include "accuracy/difference.h"

#include "base/processes.h"
#include "mesh/solid/solid_stretches.h"
#include "model/unknowns/discretization.h"
#include "results/text.h"
#include "scene/solid/wall_refusal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam::accuracy {

namespace {

constexpr std::size_t most_in_words = 20;

/// Flexibility of a wall by its part of 1.65/h.
double flexibility_of_wall(const Scene &scene, const Pipe &pipe, const double h,
                           const double radius, const double ratio) {
  constexpr double highest = 1.; // h that was measured
  if (h > highest) {
    const auto excess = [](const double x) { return 9. / (1. + 12. * x * x); };
    return std::max(1., 1. + (ratio * 1.65 / highest - 1.) * excess(h) / excess(highest));
  }
  Pipe by_code = pipe; // with the pressure that stiffens it, if it says so
  if (by_code.bend_flexibility.rule != BendFlexibility::Rule::code)
    by_code.bend_flexibility = {};
  return std::max(1., ratio * bend_flexibility(by_code, scene.sections[pipe.section],
                                               scene.materials[pipe.material], radius));
}

BendModel model_of(const Scene &scene, const SolidStretch &room, const PipePath::Segment &bend) {
  const Pipe &pipe = scene.pipes[room.pipe];
  const Section &section = scene.sections[pipe.section];
  const double r = section.outer_radius - section.wall / 2.;
  BendModel model;
  model.pipe = room.pipe;
  model.name = room.name;
  model.h = section.wall * bend.radius / (r * r);
  model.r_over_t = r / section.wall;
  model.tangent = std::min(bend.start - room.from, room.to - bend.start - bend.length) /
                  (2. * section.outer_radius);
  const BendRatios ratios =
      ratios_of_walls({model.h, bend.radius / r, bend.length / bend.radius, model.tangent});
  model.by_rule = bend_flexibility(pipe, section, scene.materials[pipe.material], bend.radius);
  model.in_plane = flexibility_of_wall(scene, pipe, model.h, bend.radius, ratios.in_plane);
  model.across = flexibility_of_wall(scene, pipe, model.h, bend.radius, ratios.across);
  return model;
}

std::string in_words(const BendModel &bend) {
  return "Bend " + bend.name + ": h = " + rounded_number(bend.h, 2) + ", tangents of " +
         rounded_number(bend.tangent, 2) + " diameters; " + rounded_number(bend.by_rule, 3) +
         " times as flexible as a straight pipe as beams, " + rounded_number(bend.in_plane, 3) +
         " (across its plane " + rounded_number(bend.across, 3) +
         ") times as a solid by doc/solid.md";
}

using Flexibility = double BendModel::*;

/// How far the rule of a bend is off.
double error(const BendModel &bend, const Flexibility by) {
  return std::abs(std::log(bend.*by / bend.by_rule));
}

/// The scene with some of its bends as flexible as walls: a pipe has one flexibility, that of the
/// one that its rule misses most.
class Variants {
public:
  Variants(const Scene &scene, const Results &beams, const SolveAs &solve)
      : scene(scene), beams(beams), solve(solve) {}

  /// What walls change in the quantities.
  Difference change(const std::vector<const BendModel *> &walls, const Flexibility by,
                    const std::string &what) const {
    std::map<unsigned int, const BendModel *> worst;
    for (const BendModel *const wall : walls) {
      const BendModel *&of_pipe = worst[wall->pipe];
      if (of_pipe == nullptr || error(*wall, by) > error(*of_pipe, by))
        of_pipe = wall;
    }
    Scene variant = scene;
    for (const auto &[pipe, wall] : worst)
      variant.pipes[pipe].bend_flexibility = {BendFlexibility::Rule::given, wall->*by};
    const Results results = solve(variant, what);
    if (beams.status != RunStatus::converged || results.status != RunStatus::converged)
      return {std::numeric_limits<double>::infinity(), "equilibrium"};
    return largest(differences(variant, beams, results));
  }

private:
  const Scene &scene;
  const Results &beams;
  const SolveAs &solve;
};

/// A bend, and what a quantity changes by if it alone is as flexible as its wall.
struct Alone {
  const BendModel *bend;
  Difference change;
  bool is_solid = false;
};

/// Make as few solid as leave no more than a tolerance by the others together.
/// @return what they leave
double choose_solids(const Variants &variants, const Flexibility by, const double tolerance,
                     const double all, std::vector<Alone> &bends) {
  std::stable_sort(bends.begin(), bends.end(),
                   [](const Alone &a, const Alone &b) { return a.change.value > b.change.value; });
  double left = all;
  for (std::size_t n = 1; n <= bends.size() && left > tolerance; ++n) {
    bends[n - 1].is_solid = true;
    std::vector<const BendModel *> others;
    for (std::size_t i = n; i < bends.size(); ++i)
      others.push_back(bends[i].bend);
    left = others.empty()
               ? 0.
               : variants
                     .change(others, by,
                             "bends but " + std::to_string(n) + " as flexible as solid walls")
                     .value;
  }
  return left;
}

} // namespace

Scene with_arcs(Scene scene) {
  scene.mesh.arcs = true;
  return scene;
}

BendModels bend_models(const Scene &scene) {
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  const std::vector<SolidStretch> rooms = rooms_of_bends(scene, paths);
  BendModels result;
  std::size_t next = 0; // the rooms are in the order of the bends
  for (unsigned int p = 0; p < paths.size(); ++p) {
    Pipe shape = scene.pipes[p];
    shape.total_mass.reset(); // which no bend's flexibility knows of
    for (const PipePath::Segment &bend : paths[p].segments()) {
      if (bend.radius == 0.)
        continue;
      const SolidStretch &room = rooms[next++];
      if (const auto refusal = wall_refusal(scene, shape, bend.radius))
        result.unknown.push_back("Bend " + room.name + " is not judged: no solid is made of " +
                                 refusal->read + ".");
      else
        result.judged.push_back(model_of(scene, room, bend));
    }
  }
  return result;
}

std::string why_not_mixed(const Scene &scene) {
  const auto any = [](const auto &parts, const auto &is) {
    return std::any_of(parts.begin(), parts.end(), is);
  };
  if (scene.kinematics != Kinematics::linear)
    return "displacements are large";
  if (any(scene.steps, [](const LoadStep &step) { return step.transient || step.finds_limit; }) ||
      scene.modal.n_modes > 0)
    return "it moves or is brought to its limit";
  if (scene.yields())
    return "sections yield";
  if (!scene.hangers.empty())
    return "hangers are chosen";
  if (scene.continuum || !scene.mesh.file.empty() || scene.pipes.empty())
    return "its pipes have no routes";
  if (any(scene.loads, [](const Load &load) { return load.kind == Load::Kind::wind; }))
    return "there is wind";
  return n_processes() > 1 ? "there are several processes" : "";
}

ModelOfPipes model_of_pipes(const Scene &scene, const Results &beams, const double tolerance,
                            const SolveAs &solve) {
  ModelOfPipes answer;
  const BendModels models = bend_models(scene);
  answer.in_words = models.unknown;
  if (models.judged.empty()) {
    answer.reason = "no bend of the scene can be a solid";
    return answer;
  }
  const Variants variants(scene, beams, solve);
  std::vector<const BendModel *> all;
  for (const BendModel &bend : models.judged)
    all.push_back(&bend);
  const Difference in_plane =
                       variants.change(all, &BendModel::in_plane, "bends as flexible as walls"),
                   across = variants.change(all, &BendModel::across,
                                            "bends as flexible as walls across their planes");
  const bool is_across = across.value > in_plane.value;
  const Flexibility by = is_across ? &BendModel::across : &BendModel::in_plane;
  const Difference &largest = is_across ? across : in_plane;
  answer.change = answer.left = largest.value;
  std::vector<Alone> alone;
  double most_off = 0.;
  for (const BendModel &bend : models.judged) {
    alone.push_back({&bend, {}});
    most_off = std::max(most_off, error(bend, by));
  }
  const bool is_known = std::isfinite(largest.value);
  if (most_off > 0. && is_known)
    answer.per_part = largest.value / most_off;
  const bool needs_solids = is_known && largest.value > tolerance;
  if (needs_solids) {
    for (Alone &one : alone)
      one.change = alone.size() == 1
                       ? largest
                       : variants.change({one.bend}, by,
                                         "bend " + one.bend->name + " as flexible as its wall");
    answer.left = choose_solids(variants, by, tolerance, largest.value, alone);
  }
  for (const Alone &one : alone) {
    if (one.is_solid) {
      answer.solid.push_back(one.bend->name);
      answer.r_over_t = std::max(answer.r_over_t, one.bend->r_over_t);
    }
    if (answer.in_words.size() < most_in_words)
      answer.in_words.push_back(in_words(*one.bend) +
                                (needs_solids ? "; the bends of its pipe being so change " +
                                                    one.change.name + " by " +
                                                    rounded_number(one.change.value, 2)
                                              : "") +
                                (one.is_solid ? ": a solid is needed." : ": beams answer for it."));
  }
  if (alone.size() + models.unknown.size() > most_in_words)
    answer.in_words.push_back("Of the other " +
                              std::to_string(alone.size() + models.unknown.size() - most_in_words) +
                              " bends those that are solid are named by Solid/At.");
  answer.reason = !is_known      ? "the line has no answer"
                  : needs_solids ? "bends as flexible as their walls change " + largest.name +
                                       " by " + rounded_number(largest.value, 2)
                                 : "bends as flexible as their walls change no quantity by more";
  return answer;
}

} // namespace frictionbeam::accuracy
