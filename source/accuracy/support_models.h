// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::accuracy {

/// What a pipe's circumference grows by by each load of the scene, nothing holding it: heat, and
/// pressure with the thrust of closed ends, p r/(E t) - nu p A_bore/(E A), r the mean radius.
std::vector<double> hoop_strains(const Scene &scene, const Pipe &pipe);
/// Factors of the loads at the end of a step.
std::vector<double> factors_in(const Scene &scene, const Frame &frame);
/// What of it there is at the end of a step.
double strain_in(const Scene &scene, const std::vector<double> &strains, const Frame &frame);

/// A support that pushes into the wall of its pipe.
struct WallAtSupport {
  unsigned int support = 0;    ///< in Scene::supports
  double stiffness = 0.;       ///< of the wall [N/m]
  double radius = 0.;          ///< outer, of the pipe [m]
  std::vector<double> strains; ///< hoop_strains() of its pipe
  /// By how many times the wall may be softer or stiffer than that; what holds the section round
  /// nearby stiffens it.
  double softer = 1., stiffer = 1.;
  bool slides_outside = false; ///< whether its friction is to act on the pipe's surface
};

struct WallsAtSupports {
  std::vector<WallAtSupport> walls;
  std::vector<std::string> unknown; ///< supports that cannot be judged
  bool has_collar = false;          ///< of a line stop, whose collar holds the section
};

/**
 * What a rigid support pushes into a pipe's wall, as the elasticity of the support: the mean motion
 * of the section per force on a patch of 30 degrees and Width along the pipe is
 * 6.8 (r/(10 t))^1.65 (Width/D)^-0.3/(E t), measured for r/t from 10 to 50 and widths of half, one
 * and two diameters (doc/solid.md) in the middle of a pipe between two anchors. A third softer and
 * a quarter stiffer at most, nearer than two diameters to an anchor up to 1.25 (2 D/distance)^1.1
 * times stiffer. Of rests, guides and stops across the pipe with Coulomb's law and no rigidity of
 * their own; the softest place of each counts.
 */
WallsAtSupports walls_at_supports(const Scene &scene);

enum class WallsAre { as_measured, softer, stiffer };
/// Supports as elastic as walls are, or may be at most, with friction on the pipes' outside.
Scene with_walls(Scene scene, const WallsAtSupports &walls, const WallsAre as);
/**
 * Supports whose ground comes nearer by as much as heat and pressure make the pipe's radius grow,
 * linear in time between the ends of steps.
 */
struct GrowingSupport {
  unsigned int support = 0; ///< in Scene::supports
  Vector3 normal;
  std::vector<std::pair<double, double>> growth; ///< by instant [s, m]
  /// Whether Ground motion says it, which the two halves of a guide or stop have in common.
  bool is_an_entry = true;
};
/// @param results of the scene, for these instants and the supports' normals
/// @param left_out supports whose growth cannot be said, whose places have several normals or whose
/// ground moves
std::vector<GrowingSupport> growing_supports(const Scene &scene, const WallsAtSupports &walls,
                                             const Results &results,
                                             std::vector<std::string> &left_out);
Scene with_growth(Scene scene, const std::vector<GrowingSupport> &supports);

/// Supports as elastic as walls that grow, and those on edges, as settings, as follow --set.
std::vector<std::string> settings_of(const Scene &scene, const WallsAtSupports &walls,
                                     const std::vector<GrowingSupport> &growing,
                                     const std::vector<unsigned int> &edges);

/// The places of a support.
std::vector<const SupportInfo *> places_of(const FrictionSupport &support, const Results &results);

} // namespace frictionbeam::accuracy
