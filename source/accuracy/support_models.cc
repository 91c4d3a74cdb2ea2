// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/support_models.h"

#include "mesh/pipe_path.h"
#include "results/text.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace frictionbeam::accuracy {

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

/// Whether a point is on a pipe's axis.
bool is_on(const Scene &scene, const PipePath &path, const std::string &point,
           const double tolerance) {
  for (const PipePath::RoutePlace &place : path.route_points())
    if (place.name == point)
      return true;
  for (const NamedPoint &named : scene.points)
    if (named.name == point)
      return !path.all_places(named.position, tolerance).empty();
  return false;
}

/// Pipes that a support may stand on.
std::vector<unsigned int> pipes_of(const Scene &scene, const std::vector<PipePath> &paths,
                                   const Placement &placement) {
  std::vector<unsigned int> result;
  for (unsigned int p = 0; p < paths.size(); ++p) {
    const double tolerance = 1e-3 * scene.sections[scene.pipes[p].section].outer_radius;
    if (scene.pipes[p].name == placement.pipe ||
        std::any_of(placement.points.begin(), placement.points.end(),
                    [&](const std::string &one) { return is_on(scene, paths[p], one, tolerance); }))
      result.push_back(p);
  }
  return result;
}

} // namespace

ElasticSupports elastic_supports(const Scene &scene) {
  constexpr unsigned int axial_rigidity = 0; // of the law coulomb
  ElasticSupports result;
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  std::map<std::string, double> rigidity; // by section of the file
  std::set<std::string> unknown;
  for (const FrictionSupport &support : scene.supports) {
    const std::string name = part_name(support);
    if (support.kind == "rod" || support.kind == "line stop" || support.kind == "snubber" ||
        support.normal.kind == Direction::Kind::along)
      continue; // hold the section, or all around
    if (support.law != "coulomb" || support.placement.continuous || !support.ground.empty()) {
      unknown.insert(name);
      continue;
    }
    const bool is_rigid = support.parameters[axial_rigidity] == 0.;
    for (const unsigned int p : pipes_of(scene, paths, support.placement)) {
      const Pipe &pipe = scene.pipes[p];
      if (!is_rigid || pipe.rigid || scene.sections[pipe.section].wall == 0.) {
        unknown.insert(name);
        continue;
      }
      const double here = support.length / compliance_of_wall(scene, pipe, support.width);
      const auto known = rigidity.try_emplace(name, here).first;
      known->second = std::min(known->second, here);
    }
  }
  for (const auto &[name, value] : rigidity)
    result.settings.push_back("Support " + name + "/Axial rigidity = " +
                              rounded_number(value / scene.units.factor("N"), 3));
  result.unknown.assign(unknown.begin(), unknown.end());
  return result;
}

} // namespace frictionbeam::accuracy
