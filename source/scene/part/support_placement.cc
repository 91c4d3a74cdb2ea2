// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include <algorithm>

namespace frictionbeam::parts {

void declare_placement(ParameterReader &in) {
  in.declare_text("At", "", "names of points, separated by commas", "Where the support stands.");
  in.declare_text("Pipe", "", "name of a pipe", "Repeated along this pipe, instead of At.");
  in.declare_number("Every", 0., "m", 0., 1e300,
                    "Distance along the pipe; the first one at this distance from From, none at "
                    "From and To themselves.");
  in.declare_text("From", "", "name of a point of that pipe", "Empty: its first point.");
  in.declare_text("To", "", "name of a point of that pipe", "Empty: its last point.");
  in.declare_flag("Continuous", false,
                  "A bed from From to To instead of Every; the law's rigidities and Normal force "
                  "are then per metre of pipe.");
}

Placement parse_placement(const ParameterReader &in, Scene &scene) {
  Placement placement;
  placement.points = in.list("At");
  placement.pipe = in.text("Pipe");
  if (placement.points.empty() == placement.pipe.empty())
    in.fail_section(placement.pipe.empty() ? "neither 'At' nor 'Pipe'" : "both 'At' and 'Pipe'",
                    "either At, or Pipe with Every, or Pipe with Continuous = true",
                    "set At = <name of a point>");
  for (const std::string &point : placement.points) {
    check_point(in, "At", point, scene);
    if (std::count(placement.points.begin(), placement.points.end(), point) > 1)
      in.fail("At", "every point once", "removing one '" + point + "'");
  }
  placement.every = in.number("Every");
  placement.continuous = in.flag("Continuous");
  placement.from = in.text("From");
  placement.to = in.text("To");
  if (placement.pipe.empty()) {
    for (const char *entry : {"Every", "From", "To", "Continuous"})
      if (in.given(entry))
        in.fail(entry, "this entry beside 'Pipe' only", "Pipe = <name of a pipe> instead of At");
    return placement;
  }
  const Pipe &pipe = scene.pipes[in.find("Pipe", placement.pipe, names(scene.pipes), "pipe")];
  if ((placement.every > 0.) == placement.continuous)
    in.fail_section(placement.continuous ? "both 'Every' and 'Continuous'"
                                         : "'Pipe' without 'Every' and 'Continuous'",
                    "Pipe with Every = <distance in m>, or Pipe with Continuous = true",
                    "set Every = 6");
  for (const char *entry : {"From", "To"})
    if (const std::string point = in.text(entry); !point.empty()) {
      check_point(in, entry, point, scene);
      const std::vector<std::string> free = names(scene.points);
      const bool on_pipe = pipe.route.empty() ||
                           std::any_of(pipe.route.begin(), pipe.route.end(),
                                       [&](const RoutePoint &p) { return p.name == point; }) ||
                           std::count(free.begin(), free.end(), point) > 0;
      if (!on_pipe)
        in.fail(entry, "a point of pipe '" + pipe.name + "'", "a point of its route");
    }
  return placement;
}

} // namespace frictionbeam::parts
