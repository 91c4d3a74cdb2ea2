// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/listing/model_echo.h"

#include "results/page/html.h"
#include "results/text.h"
#include "scene/steps/history_origins.h"

#include <algorithm>
#include <map>

namespace frictionbeam {

namespace {

constexpr std::size_t n_echoed_at_most = 1000; ///< rows

/// A piece of a pipe from one named point, or end of the pipe, to the next.
struct Element {
  unsigned int pipe;
  std::string from, to;
  double begin, end;                                    ///< along the pipe [m]
  double bend_radius = 0.;                              ///< of the first bend in it [m]
  double least_temperature = 0., most_temperature = 0.; ///< at the ends of steps [degC]
};

/// Of a load at the end of a step, by its history.
double history_at_end(const Scene &scene, const unsigned int step, const unsigned int load) {
  const TimeFunction &history = scene.loads[load].history;
  if (!history.is_given())
    return 1.;
  double end = -HistoryOrigins(scene, step).loads[load];
  for (unsigned int s = 0; s <= step; ++s)
    end += scene.steps[s].duration;
  return history(end);
}

/// Of a pipe at the end of a step [degC].
double temperature_at_end(const Scene &scene, const unsigned int step, const std::string &pipe) {
  double temperature = scene.installation_temperature;
  for (const auto &[l, factor] : scene.steps[step].loads) {
    const Load &load = scene.loads[l];
    if (load.kind == Load::Kind::temperature && load.is_on(pipe))
      temperature += factor * history_at_end(scene, step, l) * load.value;
  }
  return temperature;
}

std::vector<Element> elements_of(const Scene &scene, const Results &results) {
  std::map<unsigned int, std::string> names;
  for (const PointInfo &point : results.points)
    names.emplace(point.vertex, point.name);
  std::vector<Element> elements;
  const std::vector<Station> &line = results.frames.front().line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Station &station = line[i];
    const bool begins = i == 0 || line[i - 1].pipe != station.pipe;
    const auto name = station.is_node() ? names.find(station.vertex) : names.end();
    const std::string here = name == names.end() ? dash : name->second;
    if (begins)
      elements.push_back({station.pipe, here, "", station.s, station.s});
    else {
      Element &element = elements.back();
      const bool ends = i + 1 == line.size() || line[i + 1].pipe != station.pipe;
      if (element.bend_radius == 0. && element.begin < station.s)
        element.bend_radius = station.bend_radius;
      element.end = station.s;
      element.to = here;
      if (name != names.end() && !ends && station.s > element.begin)
        elements.push_back({station.pipe, here, "", station.s, station.s});
    }
  }
  for (Element &element : elements) {
    element.least_temperature = element.most_temperature = scene.installation_temperature;
    for (unsigned int step = 0; step < scene.steps.size(); ++step) {
      const double t = temperature_at_end(scene, step, scene.pipes[element.pipe].name);
      element.least_temperature = std::min(element.least_temperature, t);
      element.most_temperature = std::max(element.most_temperature, t);
    }
  }
  elements.erase(
      std::remove_if(elements.begin(), elements.end(),
                     [](const Element &element) { return element.end <= element.begin; }),
      elements.end());
  return elements;
}

std::string folded(const std::string &title, const std::size_t n, const std::string &table) {
  return "<details><summary>" + std::to_string(n) + " " + title + "</summary>\n" + table +
         (n > n_echoed_at_most
              ? html_note("Shown are the first " + std::to_string(n_echoed_at_most) + ".")
              : "") +
         "</details>\n";
}

std::string node_table(const Results &results) {
  std::vector<std::string> names;
  std::array<std::vector<double>, 3> x;
  for (const PointInfo &point : results.points) {
    if (names.size() == n_echoed_at_most)
      break;
    names.push_back(point.name);
    for (unsigned int d = 0; d < 3; ++d)
      x[d].push_back(point.position[d]);
  }
  return folded("named nodes", results.points.size(),
                HtmlTable(results.units)
                    .text("node", names)
                    .numbers("x", "m", x[0])
                    .numbers("y", "m", x[1])
                    .numbers("z", "m", x[2])
                    .str());
}

std::string element_table(const Scene &scene, const Results &results) {
  std::vector<Element> elements = elements_of(scene, results);
  const std::size_t n = elements.size();
  elements.resize(std::min(n, n_echoed_at_most), Element{0, "", "", 0., 0.});
  const auto column = [&](const auto &value) {
    std::vector<decltype(value(elements.front()))> values;
    for (const Element &element : elements)
      values.push_back(value(element));
    return values;
  };
  const auto pipe = [&](const Element &element) -> const Pipe & {
    return scene.pipes[element.pipe];
  };
  const auto section = [&](const Element &element) -> const Section & {
    return scene.sections[pipe(element).section];
  };
  const auto material = [&](const Element &element) -> const Material & {
    return scene.materials[pipe(element).material];
  };
  const auto in_file = [&](const double celsius) { // a scale that may begin elsewhere
    const double zero = scene.units.celsius(0.), one = scene.units.celsius(1.);
    return rounded_number((celsius - zero) / (one - zero));
  };
  const auto or_none = [](const double value) {
    return value > 0. ? value : std::numeric_limits<double>::quiet_NaN();
  };
  HtmlTable table(results.units);
  table.text("pipe", column([&](const Element &e) { return pipe(e).name; }))
      .text("from", column([](const Element &e) { return e.from; }))
      .text("to", column([](const Element &e) { return e.to; }))
      .numbers("length", "m", column([](const Element &e) { return e.end - e.begin; }))
      .numbers("bend", "m", column([&](const Element &e) { return or_none(e.bend_radius); }))
      .text("section", column([&](const Element &e) {
              return section(e).name +
                     (pipe(e).end_section ? " to " + scene.sections[*pipe(e).end_section].name
                                          : "") +
                     (pipe(e).rigid ? ", rigid" : "");
            }))
      .numbers("diameter", "m",
               column([&](const Element &e) { return or_none(2. * section(e).outer_radius); }))
      .numbers("wall", "m", column([&](const Element &e) { return or_none(section(e).wall); }))
      .text("material", column([&](const Element &e) { return material(e).name; }))
      .numbers("E", "Pa", column([&](const Element &e) { return material(e).youngs_modulus; }))
      .right("from [" + scene.units.name("degC") + "]",
             column([&](const Element &e) { return in_file(e.least_temperature); }))
      .right("to [" + scene.units.name("degC") + "]",
             column([&](const Element &e) { return in_file(e.most_temperature); }));
  return folded("elements", n,
                table.str() +
                    html_note("From one named node to the next along each pipe; a pipe's ends need "
                              "no name. Temperatures are the least and the largest of the "
                              "installation and the ends of all steps."));
}

} // namespace

std::string model_echo(const Scene &scene, const Results &results) {
  if (results.frames.empty() || results.frames.front().line.empty())
    return "";
  return node_table(results) + element_table(scene, results);
}

} // namespace frictionbeam
