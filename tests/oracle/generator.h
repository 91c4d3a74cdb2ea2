// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "random_scene.h"

#include <map>
#include <set>

namespace oracle {

/// Draws a scene part by part: first the line, then what stands on it, then loads and steps.
class Generator {
public:
  Generator(const std::uint64_t seed, const Kinds &kinds)
      : seed(seed), random(seed), kinds(kinds) {}
  Scene make();

private:
  void materials();
  void sections();
  void pipes();
  void add_pipe(const std::string &from, const Vec &start, Vec direction, bool only_one_leg);
  void points_on(const Pipe &pipe);
  void hold_ends();
  void supports();
  void contacts();
  void repeated();
  void components();
  void loads();
  void steps();

  // Further features, in random_more.cc and random_motion.cc.
  void extras();
  void more();
  void figures_instead_of_diameters();
  void ground_on_pipe(Support &support);
  void bed();
  void size_a_hanger();
  void histories(double end);
  void ground_motion(Support &support, double from, double end);
  void moving();
  void special_law();
  void snubber();
  void large();
  void response();
  void judged();
  std::string new_name(const std::string &letter) { return letter + std::to_string(++n_names); }
  std::string free_point(); ///< a point where nothing stands yet; empty: none

  const std::uint64_t seed;
  Random random;
  const Kinds kinds;
  Scene scene;
  int n_names = 0;
  std::vector<std::string> candidates; ///< points where supports may stand
  std::set<std::string> taken, vertical, on_straight;
  std::map<std::string, Vec> places;             ///< of those on straight runs
  std::vector<std::pair<std::string, Vec>> ends; ///< far ends of pipes
};

} // namespace oracle
