// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/why_walls_differ.h"

#include "accuracy/bend_models.h"
#include "accuracy/support_models.h"
#include "results/text.h"
#include "scene/in_units.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::accuracy {

namespace {

constexpr std::size_t most_of_a_kind = 6;

std::string of_support(const Scene &scene, const WallAtSupport &wall, const Results &line) {
  constexpr double kN = 1e3;
  double rise = 0.;
  for (const Frame &frame : line.frames)
    if (frame.end_of_step)
      rise = std::max(rise, std::abs(strain_in(scene, wall.strains, frame)) * wall.radius);
  const auto length = [&](const double value) {
    return in_units(scene.units, std::stod(rounded_number(value, 2)), "m");
  };
  return "Support " + scene.supports[wall.support].name +
         ": the wall gives way under it by about " + length(kN / wall.stiffness) + " for each " +
         in_units(scene.units, kN, "N") +
         (rise > 0. ? ", and its axis moves up to " + length(rise) + " as it widens" : "") +
         "; a beam's axis does neither. Friction acts on the wall's outside, and the patch's edges "
         "hold its rotation.";
}

} // namespace

std::vector<std::string> why_walls_differ(const Scene &scene, const Results &line) {
  std::vector<std::string> sentences;
  const BendModels bends = bend_models(scene);
  for (const BendModel &bend : bends.judged)
    if (sentences.size() < most_of_a_kind)
      sentences.push_back(in_words(bend) + ".");
  if (bends.judged.size() > most_of_a_kind)
    sentences.push_back("So it is with " + std::to_string(bends.judged.size() - most_of_a_kind) +
                        " more bends.");
  if (!bends.judged.empty())
    sentences.push_back("A bend of the wall becomes oval, and what follows it hinders that; a "
                        "beam's section keeps its shape, and a rule stands for the oval.");
  const WallsAtSupports walls = walls_at_supports(scene);
  for (std::size_t i = 0; i < std::min(walls.walls.size(), most_of_a_kind); ++i)
    sentences.push_back(of_support(scene, walls.walls[i], line));
  return sentences;
}

} // namespace frictionbeam::accuracy
