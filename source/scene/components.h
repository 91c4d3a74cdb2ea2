// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/stress_code_library.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/**
 * @file
 * Parts of a piping line beyond pipes and supports. Plain data in SI units.
 */
namespace frictionbeam {

/// A row of a steel's table; linear in between, level beyond its ends.
struct MaterialPoint {
  double temperature = 0.;    ///< [degC]
  double youngs_modulus = 0.; ///< [Pa]
  double expansion = 0.;      ///< mean from 20 degC to this temperature [1/K]
};

/// A flexible place of a pipe: expansion joint, hinge, the foot of a branch. It has no length and
/// stands between the point and the pipe's cell that begins (or, at the pipe's end, ends) there.
struct Joint {
  static constexpr double rigid = std::numeric_limits<double>::infinity();

  std::string name, kind; ///< kind as the user called it: joint, tee
  std::string point, pipe;
  double axial = rigid, lateral = rigid;   ///< [N/m]
  double torsion = rigid;                  ///< [N m/rad]
  double bending = rigid;                  ///< about either axis [N m/rad], unless the next two
  double in_plane = 0., out_of_plane = 0.; ///< of a tee: about its plane's normal, and in it; 0: no
  double thrust_area = 0.;                 ///< pressure times this pushes its two sides apart [m2]
};

/// What the stress code asks of a branch.
struct Tee {
  TeeKind kind = TeeKind::welding;
  std::string name, point, branch;
  double pad = 0.;           ///< thickness of reinforcement [m]
  double crotch_radius = 0.; ///< of extruded ones [m]
};

/// A spring hanger of a catalogue.
struct HangerItem {
  std::string name;
  double stiffness = 0.;                  ///< [N/m]; 0: of a constant hanger
  double least_load = 0., most_load = 0.; ///< that it is made for [N]
  double travel = 0.;                     ///< that a constant one has, up and down together [m]
};

/// A rigid part of a catalogue: a valve, a flange.
struct ComponentItem {
  std::string name;
  double length = 0., mass = 0.; ///< [m], [kg]
};

/// The user's own tables, in the order of their rows.
struct Catalogue {
  std::vector<HangerItem> hangers, constant_hangers;
  std::vector<ComponentItem> components;
};

/// A spring hanger or a constant one: a spring along one direction with a force of its own.
struct Hanger {
  std::string name;
  std::vector<std::string> points;
  bool constant = false;
  double stiffness = 0.;             ///< [N/m]; of a variable one that is to be sized: 0
  double cold_load = 0.;             ///< upward, at no displacement [N]; sized if 0
  double largest_variation = 0.25;   ///< of the load between hot and cold, when sized
  std::string weight_step, hot_step; ///< steps that size it
  std::vector<unsigned int> springs; ///< in Scene::springs, one for each point
  bool picks_item = false;           ///< of the catalogue, when sized, for each point its own
  std::vector<HangerItem> items;     ///< of the catalogue, one for each point; empty: none
};

/// Loads that an anchor or nozzle can take: absolute values in global axes; 0: no limit.
struct NozzleLimit {
  std::string name, support;
  std::array<double, 6> allowed{}; ///< [N] (3), [N m] (3)
};

/// What the stress code is applied to.
struct StressSettings {
  std::string code;                                           ///< empty: none
  std::shared_ptr<const StressCodeLibrary> codes;             ///< that has it
  std::vector<std::string> sustained, occasional;             ///< steps
  std::vector<std::pair<std::string, std::string>> expansion; ///< from one step to another
  double cycles_factor = 1.;                                  ///< f
  bool liberal = false;                                       ///< what SL leaves of Sh is added
  double occasional_factor = 1.33;
};

} // namespace frictionbeam
