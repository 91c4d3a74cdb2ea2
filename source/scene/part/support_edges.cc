// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

namespace frictionbeam::parts {

namespace {

constexpr const char *entry = "Stands on";
constexpr Word<bool> footings[] = {
    {"point", false, "the pipe turns on it freely"},
    {"edges", true,
     "both edges of its Width, each with half of it, of which one may lift off: they hold the pipe "
     "by up to fn Width/2"}};

} // namespace

void declare_edges(ParameterReader &in) {
  in.declare_choice(entry, false, footings,
                    "Of a line's rest, guide, stop or friction across the pipe.");
}

void parse_edges(const ParameterReader &in, const Scene &scene, FrictionSupport &support) {
  support.on_edges = in.choice(entry, footings);
  if (!support.on_edges)
    return;
  const auto refuse = [&](const bool is_there, const std::string &allowed) {
    if (is_there)
      in.fail(entry, allowed, "point");
  };
  refuse(support.kind == "rod" || support.kind == "snubber" ||
             (support.kind == "line stop" && !in.given("Normal")),
         "edges of rest, guide, stop and friction that push across the pipe, not of a " +
             support.kind);
  refuse(support.placement.continuous,
         "edges of supports At points or Every so often, not of a bed");
  refuse(!support.ground.empty(), "edges on the ground, not on another pipe");
  refuse(support.normal_force > 0.,
         "edges of a ground that stands still: a platen that is pressed on tilts with the pipe");
  refuse(
      scene.kinematics != Kinematics::linear,
      "edges with Kinematics = linear: those of a shoe would go along with a pipe that moves far");
}

} // namespace frictionbeam::parts
