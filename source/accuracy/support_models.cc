// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/support_models.h"

#include "base/numbers.h"
#include "mesh/places_on_pipe.h"
#include "results/text.h"
#include "scene/steps/history_origins.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace frictionbeam::accuracy {

std::vector<const SupportInfo *> places_of(const FrictionSupport &support, const Results &results) {
  std::vector<const SupportInfo *> places;
  for (const SupportInfo &info : results.supports)
    if (is_place_of(info.name, support.name))
      places.push_back(&info);
  return places;
}

namespace {

/// Mean motion of a section per force on a patch of its wall [m/N].
double compliance_of_wall(const Scene &scene, const Pipe &pipe, const double width) {
  constexpr double factor = 6.8, reference = 10., power = 1.65, power_of_width = 0.3;
  const Section &section = scene.sections[pipe.section];
  const double r = section.outer_radius - section.wall / 2., t = section.wall,
               part = width > 0. ? width / (2. * section.outer_radius) : 1.;
  return factor * std::pow(r / t / reference, power) * std::pow(part, -power_of_width) /
         (scene.materials[pipe.material].youngs_modulus * t);
}

constexpr unsigned int axial_rigidity = 0; // of the law coulomb

/// Pipes that a support may stand on.
std::vector<unsigned int> pipes_of(const Scene &scene, const std::vector<PipePath> &paths,
                                   const Placement &placement) {
  std::vector<unsigned int> result;
  for (unsigned int p = 0; p < paths.size(); ++p) {
    const double tolerance = 1e-3 * scene.sections[scene.pipes[p].section].outer_radius;
    if (scene.pipes[p].name == placement.pipe ||
        std::any_of(placement.points.begin(), placement.points.end(), [&](const std::string &one) {
          return !places_of(scene, paths[p], one, tolerance).empty();
        }))
      result.push_back(p);
  }
  return result;
}

/// How many times stiffer than its formula a wall may be at places of a pipe: near what holds its
/// section, the more the nearer.
double stiffer_near_anchors(const Scene &scene, const PipePath &path, const double diameter,
                            const Placement &placement) {
  constexpr double anywhere = 1.25, reach = 2., power = 1.1, nearest = 0.1; // diameters
  const double tolerance = 1e-3 * diameter;
  const std::vector<double> held = places_of_anchors(scene, path, tolerance);
  std::vector<double> places;
  for (const std::string &point : placement.points)
    for (const double s : places_of(scene, path, point, tolerance))
      places.push_back(s);
  if (placement.every > 0.) {
    const std::vector<double> from = places_of(scene, path, placement.from, tolerance);
    for (double s = (from.empty() ? 0. : from.front()) + placement.every; s < path.length();
         s += placement.every)
      places.push_back(s);
  }
  double distance = reach * diameter;
  for (const double at : held)
    for (const double s : places)
      distance = std::min(distance, std::abs(s - at));
  return anywhere * std::pow(reach * diameter / std::max(distance, nearest * diameter), power);
}

/// The wall under a support, of the pipe where it is softest; none: it cannot be judged.
std::optional<WallAtSupport> wall_under(const Scene &scene, const std::vector<PipePath> &paths,
                                        const FrictionSupport &support) {
  std::optional<WallAtSupport> wall;
  if (support.law != "coulomb" || support.placement.continuous || !support.ground.empty() ||
      support.parameters[axial_rigidity] != 0.)
    return {};
  for (const unsigned int p : pipes_of(scene, paths, support.placement)) {
    const Pipe &pipe = scene.pipes[p];
    const Section &section = scene.sections[pipe.section];
    if (pipe.rigid || section.wall == 0.)
      return {};
    const double stiffness = 1. / compliance_of_wall(scene, pipe, support.width);
    if (wall && wall->stiffness <= stiffness)
      continue;
    wall.emplace();
    wall->stiffness = stiffness;
    wall->radius = section.outer_radius;
    wall->softer = 4. / 3.;
    wall->stiffer =
        stiffer_near_anchors(scene, paths[p], 2. * section.outer_radius, support.placement);
    wall->strains = hoop_strains(scene, pipe);
    wall->slides_outside = support.rotations == FrictionSupport::Rotations::none;
  }
  return wall;
}

/// The normal that all places of a support have.
std::optional<Vector3> normal_of(const std::vector<const SupportInfo *> &places) {
  constexpr double same = 1e-6;
  for (const SupportInfo *const place : places)
    if ((place->normal - places.front()->normal).norm() > same)
      return {};
  return places.empty() ? std::nullopt : std::optional<Vector3>(places.front()->normal);
}

/// How much a pipe's radius has grown at the ends of steps, by instant [s, m]; in order unless
/// steps start from others than the one before.
using Growth = std::vector<std::pair<double, double>>;

Growth growth_of(const Scene &scene, const WallAtSupport &wall, const Results &results) {
  Growth growth = {{0., 0.}};
  for (const Frame &frame : results.frames) {
    if (!frame.end_of_step || frame.step >= scene.steps.size())
      continue;
    const double strain = strain_in(scene, wall.strains, frame),
                 elsewhere = HistoryOrigins(scene, frame.step).elsewhere;
    growth.emplace_back(frame.time - elsewhere, strain * wall.radius);
  }
  return growth;
}

double value_at(const Growth &growth, const double time) {
  for (std::size_t i = 1; i < growth.size(); ++i)
    if (time < growth[i].first) {
      const auto &[t0, a] = growth[i - 1];
      const auto &[t1, b] = growth[i];
      return a + (b - a) * std::clamp((time - t0) / (t1 - t0), 0., 1.);
    }
  return growth.back().second;
}

} // namespace

std::vector<double> hoop_strains(const Scene &scene, const Pipe &pipe) {
  const Section &section = scene.sections[pipe.section];
  const Material &material = scene.materials[pipe.material];
  const double by_pressure = ((section.outer_radius - section.wall / 2.) / section.wall -
                              material.poissons_ratio * section.bore_area() / section.area) /
                             material.youngs_modulus;
  std::vector<double> strains;
  for (const Load &load : scene.loads) {
    const bool acts = load.is_on(pipe.name);
    strains.push_back(
        acts && load.kind == Load::Kind::temperature
            ? material.thermal_strain(load.installation, load.installation + load.value)
        : acts && load.kind == Load::Kind::pressure ? load.value * by_pressure
                                                    : 0.);
  }
  return strains;
}

std::vector<double> factors_in(const Scene &scene, const Frame &frame) {
  const HistoryOrigins origins(scene, frame.step);
  std::vector<double> factors(scene.loads.size(), 0.);
  for (const auto &[load, factor] : scene.steps[frame.step].loads) {
    const TimeFunction &history = scene.loads[load].history;
    factors[load] += factor * (history.is_given() ? history(frame.time - origins.loads[load]) : 1.);
  }
  return factors;
}

double strain_in(const Scene &scene, const std::vector<double> &strains, const Frame &frame) {
  const std::vector<double> factors = factors_in(scene, frame); // some were added since
  return std::inner_product(strains.begin(), strains.end(), factors.begin(), 0.);
}

WallsAtSupports walls_at_supports(const Scene &scene) {
  WallsAtSupports result;
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  std::set<std::string> unknown;
  for (unsigned int i = 0; i < scene.supports.size(); ++i) {
    const FrictionSupport &support = scene.supports[i];
    if (support.kind == "rod" || support.kind == "snubber")
      continue; // hold the section
    if (support.kind == "line stop" || support.normal.kind == Direction::Kind::along) {
      result.has_collar = true;
      continue;
    }
    if (std::optional<WallAtSupport> wall = wall_under(scene, paths, support)) {
      wall->support = i;
      result.walls.push_back(*wall);
    } else
      unknown.insert(part_name(support));
  }
  result.unknown.assign(unknown.begin(), unknown.end());
  return result;
}

Scene with_walls(Scene scene, const WallsAtSupports &walls, const WallsAre as) {
  for (const WallAtSupport &wall : walls.walls) {
    FrictionSupport &support = scene.supports[wall.support];
    if (wall.slides_outside) {
      support.rotations = FrictionSupport::Rotations::pipe;
      support.length = wall.radius;
    }
    const double rigidity = wall.stiffness * support.length *
                            (as == WallsAre::softer    ? 1. / wall.softer
                             : as == WallsAre::stiffer ? wall.stiffer
                                                       : 1.);
    support.parameters[axial_rigidity] = rigidity;
    for (auto &[place, parameters] : support.parameters_at)
      parameters[axial_rigidity] = rigidity;
  }
  return scene;
}

std::vector<GrowingSupport> growing_supports(const Scene &scene, const WallsAtSupports &walls,
                                             const Results &results,
                                             std::vector<std::string> &left_out) {
  std::vector<GrowingSupport> result;
  std::set<std::string> unknown;
  for (const WallAtSupport &wall : walls.walls) {
    const FrictionSupport &support = scene.supports[wall.support];
    const Growth growth = growth_of(scene, wall, results);
    if (std::all_of(growth.begin(), growth.end(), [](const auto &at) { return at.second == 0.; }))
      continue;
    const std::optional<Vector3> normal = normal_of(places_of(support, results));
    if (normal && !support.ground_moves() && std::is_sorted(growth.begin(), growth.end()))
      result.push_back({wall.support, *normal, growth, !is_of_a_pair(support.kind)});
    else
      unknown.insert(part_name(support));
  }
  left_out.assign(unknown.begin(), unknown.end());
  return result;
}

Scene with_growth(Scene scene, const std::vector<GrowingSupport> &supports) {
  for (const GrowingSupport &one : supports)
    for (unsigned int d = 0; d < 3; ++d) {
      TimeFunction &motion = scene.supports[one.support].ground_motion[d];
      motion.text = "growth of the pipe";
      motion.clock = TimeFunction::Clock::run;
      motion.course = [growth = one.growth, part = one.normal[d]](const double time) {
        return part * value_at(growth, time);
      };
      for (const auto &at : one.growth)
        motion.breaks.push_back(at.first);
    }
  return scene;
}

namespace {

/// Settings of Ground motion.
void add_growth(const Scene &scene, const GrowingSupport &growing,
                std::vector<std::string> &settings) {
  constexpr unsigned int digits = 6;
  const std::string heading = "Support " + part_name(scene.supports[growing.support]) + "/";
  std::string courses;
  for (unsigned int d = 0; d < 3; ++d) {
    std::string table;
    for (const auto &[time, radius] : growing.growth)
      table += (table.empty() ? "table " : ", ") + exact_number(time) + " " +
               rounded_number(growing.normal[d] * radius / scene.units.factor("m"), digits);
    courses += (d > 0 ? "; " : "") + (std::abs(growing.normal[d]) > no_component ? table : "0");
  }
  settings.push_back(heading + "Ground motion = " + courses);
  settings.push_back(heading + "Ground motion time = run");
}

} // namespace

std::vector<std::string> settings_of(const Scene &scene, const WallsAtSupports &walls,
                                     const std::vector<GrowingSupport> &growing,
                                     const std::vector<unsigned int> &edges) {
  std::vector<std::string> settings;
  const Scene elastic = with_walls(scene, walls, WallsAre::as_measured);
  std::set<std::string> done; // the halves of pairs have one section
  for (const WallAtSupport &wall : walls.walls) {
    const FrictionSupport &support = elastic.supports[wall.support];
    const std::string heading = "Support " + part_name(support) + "/";
    if (!done.insert(heading).second)
      continue;
    settings.push_back(
        heading + "Axial rigidity = " +
        rounded_number(support.parameters[axial_rigidity] / scene.units.factor("N"), 3));
    if (wall.slides_outside) {
      settings.push_back(heading + "Rotations = pipe");
      settings.push_back(heading +
                         "Length = " + exact_number(support.length / scene.units.factor("m")));
    }
  }
  for (const unsigned int support : edges)
    settings.push_back("Support " + part_name(scene.supports[support]) + "/Stands on = edges");
  for (const GrowingSupport &one : growing)
    if (one.is_an_entry)
      add_growth(scene, one, settings);
  return settings;
}

} // namespace frictionbeam::accuracy
