// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/why_walls_differ.h"

#include "accuracy/bend_models.h"
#include "accuracy/support_models.h"
#include "results/stress/inner_pressure.h"
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

/// Largest pressure at the end of a step, from inside or outside, which a wall has all along [Pa].
double largest_pressure(const Scene &scene) {
  double largest = 0.;
  for (const LoadStep &step : scene.steps)
    if (const double pressure = pressure_in(scene, step.name, 0);
        std::abs(pressure) > std::abs(largest))
      largest = pressure;
  return largest;
}

/// The scene, all bends stiffened by a pressure and by nothing else.
Scene stiffened_by(Scene scene, const double pressure) {
  scene.solid.pressure_stiffening = false; // by loads
  for (Pipe &pipe : scene.pipes)
    pipe.bend_flexibility.pressure = pressure;
  return scene;
}

/// What pressure makes of the walls of bends, and of beams; empty: nothing.
std::string of_pressure(const Scene &scene) {
  const double of_loads = scene.solid.pressure_stiffening ? largest_pressure(scene) : 0.;
  double stiffer = 1., of_beams = 0.;
  for (const BendModel &bend : bend_models(stiffened_by(scene, std::max(0., of_loads))).judged) {
    stiffer = std::max(stiffer, bend.stiffening);
    of_beams = std::max(of_beams, scene.pipes[bend.pipe].bend_flexibility.pressure);
  }
  const auto shown = [&](const double pressure) { return in_units(scene.units, pressure, "Pa"); };
  if (of_loads < 0.)
    return "The pressure from outside, up to " + shown(-of_loads) +
           ", lets the walls of bends become more oval than that, which beams do not know.";
  if (of_loads == 0. && of_beams == 0.)
    return "";
  return "That is without pressure: by von Karman's energy " + shown(of_loads) +
         " make the walls of these bends up to " + rounded_number(stiffer, 3) +
         " times stiffer; those of beams have a Stiffening pressure of " + shown(of_beams) + ".";
}

} // namespace

std::vector<std::string> why_walls_differ(const Scene &scene, const Results &line) {
  std::vector<std::string> sentences;
  const BendModels bends = bend_models(stiffened_by(scene, 0.));
  for (const BendModel &bend : bends.judged)
    if (sentences.size() < most_of_a_kind)
      sentences.push_back(in_words(bend) + ".");
  if (bends.judged.size() > most_of_a_kind)
    sentences.push_back("So it is with " + std::to_string(bends.judged.size() - most_of_a_kind) +
                        " more bends.");
  if (const std::string text = of_pressure(scene); !bends.judged.empty() && !text.empty())
    sentences.push_back(text);
  if (!bends.judged.empty())
    sentences.push_back("A bend of the wall becomes oval, and what follows it hinders that; a "
                        "beam's section keeps its shape, and a rule stands for the oval.");
  const WallsAtSupports walls = walls_at_supports(scene);
  for (std::size_t i = 0; i < std::min(walls.walls.size(), most_of_a_kind); ++i)
    sentences.push_back(of_support(scene, walls.walls[i], line));
  return sentences;
}

} // namespace frictionbeam::accuracy
