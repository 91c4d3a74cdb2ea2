// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"

#include "scene/law_entries.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cctype>

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
  placement.points = points_at(in, scene);
  placement.pipe = in.text("Pipe");
  if (placement.points.empty() == placement.pipe.empty())
    in.fail_section(placement.pipe.empty() ? "neither 'At' nor 'Pipe'" : "both 'At' and 'Pipe'",
                    "either At, or Pipe with Every, or Pipe with Continuous = true",
                    "set At = <name of a point>");
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

std::pair<std::string, unsigned int> repeated_support(const std::string &heading) {
  const auto dot = heading.rfind('.');
  const std::string number = dot == std::string::npos ? "" : heading.substr(dot + 1);
  constexpr std::size_t most_digits = 8;
  if (number.empty() || number.size() > most_digits || number[0] == '0' ||
      !std::all_of(number.begin(), number.end(),
                   [](const unsigned char c) { return std::isdigit(c) != 0; }))
    return {};
  return {heading.substr(0, dot), std::stoul(number)};
}

namespace {

std::vector<double> parse_place(const ParameterReader &in, const LawDescription &law) {
  std::vector<double> parameters;
  for (const std::string &entry : law_entries(law))
    parameters.push_back(in.number(entry));
  check_together(in, law, parameters);
  check_closed_form(in, law, parameters);
  return parameters;
}

} // namespace

bool is_support_place(const ParameterFile &file, const ParameterFile::Section &section) {
  const std::string support = repeated_support(section.heading).first;
  return support.rfind("Support ", 0) == 0 && file.find(support) != nullptr &&
         section.find("At") == nullptr && section.find("Pipe") == nullptr;
}

void parse_support_places(ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  for (const ParameterFile::Section &section : in.file().sections()) {
    if (!is_support_place(in.file(), section))
      continue;
    in.enter(section.heading);
    const auto [heading, place] = repeated_support(section.heading);
    const std::string name = heading.substr(heading.find(' ') + 1);
    bool found = false;
    for (FrictionSupport &support : scene.supports) {
      if (part_name(support) != name)
        continue;
      const LawDescription &law = laws.find(support.law);
      if (!found) {
        declare_parameters(in, law, support.parameters); // as the support says, unless given
        in.take();
      }
      found = true;
      support.parameters_at[place - 1] = parse_place(in, law);
    }
    if (!found)
      in.fail_section("a place of '" + heading + "', which holds exactly and has no law",
                      "places of supports with friction, a gap or a stiffness",
                      "a Friction coefficient or a Gap for '" + heading + "'");
  }
}

} // namespace frictionbeam::parts
