// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/bend_models.h"
#include "accuracy/bend_flexibility_table.h"
#include "accuracy/pipes/bend_variants.h"
#include "accuracy/pipes/pressed_bend.h"

#include "mesh/places_on_pipe.h"
#include "mesh/solid/solid_stretches.h"
#include "model/unknowns/discretization.h"
#include "results/stress/inner_pressure.h"
#include "results/text.h"
#include "scene/solid/wall_refusal.h"

#include <algorithm>
#include <cmath>

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
  return std::max(1., ratio * bend_flexibility(pipe, scene.sections[pipe.section],
                                               scene.materials[pipe.material], radius));
}

/// Largest pressure from inside that stiffens the walls of a pipe [Pa].
double stiffening_pressure(const Scene &scene, const unsigned int pipe) {
  double pressure = 0.;
  if (scene.solid.pressure_stiffening)
    for (const LoadStep &step : scene.steps)
      pressure = std::max(pressure, pressure_bounds(scene, step.name, pipe).largest);
  return pressure;
}

/// A pipe whose bends have the code's rule without pressure.
Pipe with_rule(Pipe pipe) {
  pipe.bend_flexibility = {};
  return pipe;
}

/// Pressure of a pipe's entry, of which the code's rule knows [Pa].
double pressure_of_entry(const Pipe &pipe) {
  return pipe.bend_flexibility.rule == BendFlexibility::Rule::code ? pipe.bend_flexibility.pressure
                                                                   : 0.;
}

/// Finds what stands beside the bends of a scene.
class Neighbours {
public:
  explicit Neighbours(const Scene &scene) : scene(scene) {
    for (const Pipe &pipe : scene.pipes)
      paths.emplace_back(pipe, scene.units);
  }

  std::vector<PipePath> paths;

  Tangent::Until at(const unsigned int pipe, const double s) const {
    const Point3 place = paths[pipe].point(s);
    if (is_anchor(pipe, s))
      return Tangent::Until::anchor;
    if (s > same(pipe) && s < paths[pipe].length() - same(pipe))
      return Tangent::Until::bend;
    for (unsigned int p = 0; p < paths.size(); ++p)
      if (p != pipe && !paths[p].all_places(place, same(p)).empty())
        return Tangent::Until::pipe;
    return Tangent::Until::end;
  }

private:
  double same(const unsigned int pipe) const {
    return 1e-3 * scene.sections[scene.pipes[pipe].section].outer_radius;
  }
  bool is_anchor(const unsigned int pipe, const double s) const {
    const std::vector<double> anchors = places_of_anchors(scene, paths[pipe], same(pipe));
    return std::any_of(anchors.begin(), anchors.end(),
                       [&](const double at) { return std::abs(at - s) <= same(pipe); });
  }

  const Scene &scene;
};

BendModel model_of(const Scene &scene, const Neighbours &neighbours, const SolidStretch &room,
                   const PipePath::Segment &bend, const unsigned int number) {
  const Pipe &pipe = scene.pipes[room.pipe];
  const Section &section = scene.sections[pipe.section];
  const Material &material = scene.materials[pipe.material];
  const double r = section.outer_radius - section.wall / 2.;
  BendModel model;
  model.pipe = room.pipe;
  model.number = number;
  model.name = room.name;
  model.h = section.wall * bend.radius / (r * r);
  model.r_over_t = r / section.wall;
  model.angle = bend.length / bend.radius;
  model.decay_length = section.decay_length();
  model.tangents = {{{neighbours.at(room.pipe, room.from), bend.start - room.from},
                     {neighbours.at(room.pipe, room.to), room.to - bend.start - bend.length}}};
  const double diameter = 2. * section.outer_radius;
  model.tangent = std::min(model.tangents[0].length, model.tangents[1].length) / diameter;
  model.ends = {{bend.begin, bend.end}};
  // Measured: r/t = 10 to 40, R/r = 3 to 10, nu = 0 to 0.45 (doc/solid.md, "Pressure in bends").
  constexpr double of_bending = 0.45;
  model.more_turn = of_bending * r * r / (bend.radius * bend.radius);
  model.turn_by_pressure = r * section.inertia / (2. * section.wall * bend.radius) *
                           cross_product_3d(bend.inward, bend.first_tangent);
  const BendRatios ratios = ratios_of_walls({model.h, bend.radius / r, model.angle, model.tangent});
  model.by_rule = bend_flexibility(pipe, section, material, bend.radius);
  const auto stiffer = [&](const double pressure) {
    return stiffer_by_pressure({model.h, bend.radius / r, material.poissons_ratio},
                               pressure / material.youngs_modulus);
  };
  const double of_loads = stiffer(stiffening_pressure(scene, room.pipe)),
               of_wall = std::max(of_loads, stiffer(pressure_of_entry(pipe)));
  const auto wall = [&](const double ratio) {
    return std::max(1., flexibility_of_wall(scene, with_rule(pipe), model.h, bend.radius, ratio) /
                            of_wall);
  };
  model.in_plane = wall(ratios.in_plane);
  model.across = wall(ratios.across);
  model.stiffening = of_wall / of_loads;
  model.off = ratios.off;
  // Flanges in place of legs leave a bend the part h^(1/3) of its flexibility; what is beside it
  // within the shortest tangents of the table is between the two.
  for (const Tangent &tangent : model.tangents)
    if (tangent.until != Tangent::Until::end)
      model.off +=
          std::max(0., 1. - tangent.length / diameter) * std::max(0., -std::log(model.h)) / 6.;
  return model;
}

/// A bend, and what a quantity changes by if it alone is as flexible as its wall.
struct Alone {
  const BendModel *bend;
  Difference change;
  bool is_solid = false;
};

/// Make as few solid as leave no more than a tolerance by the others together.
/// @return what they leave
double choose_solids(const BendVariants &variants, const double tolerance, const double all,
                     std::vector<Alone> &bends) {
  std::stable_sort(bends.begin(), bends.end(),
                   [](const Alone &a, const Alone &b) { return a.change.value > b.change.value; });
  double left = all;
  for (std::size_t n = 1; n <= bends.size() && left > tolerance; ++n) {
    bends[n - 1].is_solid = true;
    BendVariants::Bends others;
    for (std::size_t i = n; i < bends.size(); ++i)
      others.push_back(bends[i].bend);
    const std::string what = "bends but " + std::to_string(n) + " as flexible as walls";
    left = 0.;
    if (!others.empty())
      left = std::max(variants.change(others, &BendModel::in_plane, what).value,
                      variants.change(others, &BendModel::across, what + " across").value);
  }
  return left;
}

/// The next bend of the pipe, if a solid of this one reaches it; null: it does not.
template <typename List>
auto reached(const BendModel &bend, const bool behind, List &bends) -> decltype(bends.data()) {
  const Tangent &tangent = bend.tangents[behind];
  if (tangent.until == Tangent::Until::bend && tangent.length < longest_cut * bend.decay_length)
    for (auto &other : bends)
      if (other.bend->pipe == bend.pipe && other.bend->number + !behind == bend.number + behind)
        return &other;
  return nullptr;
}

/// A solid is not cut at the next bend, which is solid, too.
void join_near(std::vector<Alone> &bends) {
  for (std::size_t n = 0; n < bends.size(); ++n) // what is reached reaches further
    for (const Alone &one : bends)
      for (const bool behind : {false, true})
        if (Alone *const next = one.is_solid ? reached(*one.bend, behind, bends) : nullptr)
          next->is_solid = true;
}

/// Of the flexibility of a bend, what a solid that ends with its straight pipe leaves or adds.
double error_of_joint(const Alone &bend, const std::vector<Alone> &all) {
  double error = 0.;
  for (const bool behind : {false, true}) {
    const Tangent &tangent = bend.bend->tangents[behind];
    const Alone *const next = reached(*bend.bend, behind, all);
    const bool is_near = tangent.length < longest_cut * bend.bend->decay_length;
    const bool is_whole = next != nullptr ? next->is_solid
                                          : is_near && (tangent.until == Tangent::Until::anchor ||
                                                        tangent.until == Tangent::Until::end);
    if (!is_whole)
      error += added_by_cut(tangent.length / bend.bend->decay_length, bend.bend->angle);
  }
  return error;
}

/// The bends that are to be solid, and what they leave.
void take_solids(const BendVariants &variants, const std::vector<Alone> &bends,
                 ModelOfPipes &answer) {
  BendVariants::Bends solid;
  double stiffest = 1.;
  for (const Alone &one : bends)
    if (one.is_solid) {
      solid.push_back(one.bend);
      answer.solid.push_back(one.bend->name);
      answer.r_over_t = std::max(answer.r_over_t, one.bend->r_over_t);
      answer.of_joints = std::max(answer.of_joints, error_of_joint(one, bends));
      stiffest = std::max(stiffest, one.bend->stiffening);
    }
  using Off = BendVariants::Off;
  answer.per_part = variants.change_per_part(solid, Off::with_turn_by_pressure);
  if (stiffest > 1.) // by a pressure that strains a pipe by itself no more for that
    answer.by_pressure = std::log(stiffest) * variants.change_per_part(solid, Off::flexibility);
}

} // namespace

Scene with_arcs(Scene scene) {
  scene.mesh.arcs = true;
  return scene;
}

BendModels bend_models(const Scene &scene) {
  const Neighbours neighbours(scene);
  const std::vector<SolidStretch> rooms = rooms_of_bends(scene, neighbours.paths);
  BendModels result;
  std::size_t next = 0; // the rooms are in the order of the bends
  for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
    Pipe shape = scene.pipes[p];
    shape.total_mass.reset(); // which no bend's flexibility knows of
    unsigned int number = 0;
    for (const PipePath::Segment &bend : neighbours.paths[p].segments()) {
      if (bend.radius == 0.)
        continue;
      const SolidStretch &room = rooms[next++];
      if (const auto refusal = wall_refusal(scene, shape, bend.radius))
        result.unknown.push_back("Bend " + room.name + " is not judged: no solid is made of " +
                                 refusal->read + ".");
      else
        result.judged.push_back(model_of(scene, neighbours, room, bend, number));
      ++number;
    }
  }
  return result;
}

std::string in_words(const BendModel &bend) {
  return "Bend " + bend.name + ": h = " + rounded_number(bend.h, 2) + ", tangents of " +
         rounded_number(bend.tangent, 2) + " diameters; " + rounded_number(bend.by_rule, 3) +
         " times as flexible as a straight pipe as beams, " + rounded_number(bend.in_plane, 3) +
         " (across its plane " + rounded_number(bend.across, 3) +
         ") times as a solid by doc/solid.md";
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
  if (any(scene.hangers, [](const Hanger &hanger) { return hanger.cold_load == 0.; }))
    return "hangers are chosen";
  if (scene.continuum || !scene.mesh.file.empty() || scene.pipes.empty())
    return "its pipes have no routes";
  if (any(scene.loads, [](const Load &load) { return load.kind == Load::Kind::wind; }))
    return "there is wind";
  return "";
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
  const BendVariants variants(scene, beams, models, solve);
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
  for (const BendModel &bend : models.judged)
    alone.push_back({&bend, {}});
  const bool is_known = std::isfinite(largest.value),
             needs_solids = is_known && largest.value > tolerance;
  if (needs_solids) {
    for (Alone &one : alone)
      one.change = alone.size() == 1
                       ? largest
                       : variants.change({one.bend}, by,
                                         "bend " + one.bend->name + " as flexible as its wall");
    answer.left = choose_solids(variants, tolerance, largest.value, alone);
    join_near(alone);
    take_solids(variants, alone, answer);
  }
  for (const Alone &one : alone)
    if (answer.in_words.size() < most_in_words)
      answer.in_words.push_back(
          in_words(*one.bend) +
          (needs_solids
               ? (variants.is_alone(*one.bend) ? "; its being so changes "
                                               : "; the bends of its pipe being so change ") +
                     one.change.name + " by " + rounded_number(one.change.value, 2)
               : "") +
          (one.is_solid ? ": a solid is needed." : ": beams answer for it."));
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
