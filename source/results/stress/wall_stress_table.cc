// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/wall_stress_table.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/stress/wall_stress.h"
#include "results/text.h"

#include <algorithm>

namespace frictionbeam {

namespace {

/// Call @p take with frame, station and stresses of every station that has some.
template <typename Take>
void for_each_station(const Scene &scene, const Results &results, const Take &take) {
  for (const Frame &frame : results.frames) {
    if (frame.step >= scene.steps.size())
      continue;
    for (const Station &station : frame.line)
      if (const auto stress = elastic_wall_stress(scene, station))
        take(frame, station, *stress);
  }
}

bool asks_for_wall_stresses(const Scene &scene) {
  return !scene.stress.code.empty() ||
         std::any_of(scene.quantities.begin(), scene.quantities.end(), [](const Quantity &one) {
           return one.is(QuantityKind::Of::fibre) &&
                  one.kind().component >= static_cast<unsigned int>(Fibre::most);
         });
}

} // namespace

std::string wall_stress_section(const Scene &scene, const Results &results) {
  struct Worst {
    const Frame *frame;
    const Station *station;
    WallStress stress;
  };
  std::vector<Worst> worst; // of each step
  for_each_station(scene, results,
                   [&](const Frame &frame, const Station &station, const WallStress &stress) {
                     if (worst.empty() || worst.back().frame != &frame)
                       worst.push_back({&frame, &station, stress});
                     else if (stress.von_mises > worst.back().stress.von_mises)
                       worst.back() = {&frame, &station, stress};
                   });
  if (worst.empty())
    return "";
  const auto column = [&](const auto &value) {
    std::vector<decltype(value(worst.front()))> values;
    for (const Worst &one : worst)
      values.push_back(value(one));
    return values;
  };
  HtmlTable table(results.units);
  table.text("step", column([](const Worst &one) { return one.frame->name; }))
      .text("pipe", column([&](const Worst &one) { return scene.pipes[one.station->pipe].name; }))
      .numbers("s", "m", column([](const Worst &one) { return one.station->s; }))
      .numbers("von Mises", "Pa", column([](const Worst &one) { return one.stress.von_mises; }))
      .numbers("Tresca", "Pa", column([](const Worst &one) { return one.stress.tresca; }))
      .numbers("largest principal", "Pa", column([](const Worst &one) { return one.stress.most; }))
      .numbers("least principal", "Pa", column([](const Worst &one) { return one.stress.least; }));
  return table.str() +
         html_note("Where each step has the largest equivalent stress at its end, of a straight "
                   "elastic wall under section forces and pressure; what bends and tees have more "
                   "is left to the stress code. wall_stresses.csv has every station "
                   "where the line is not very long, or the case asks for stresses.");
}

void write_wall_stresses(const Scene &scene, Results &results, const std::string &folder) {
  constexpr std::size_t most_rows = 100000; // some 10 MB
  std::size_t n_rows = 0;
  bool has_walls = false;
  for (const Frame &frame : results.frames)
    if (frame.step < scene.steps.size()) {
      n_rows += frame.line.size();
      has_walls = has_walls ||
                  std::any_of(frame.line.begin(), frame.line.end(), [&](const Station &station) {
                    return elastic_wall_stress(scene, station).has_value();
                  });
    }
  if (n_rows > most_rows && has_walls && !asks_for_wall_stresses(scene)) {
    results.remarks.push_back(
        "wall_stresses.csv is left out: " + std::to_string(n_rows) + " stations, where " +
        std::to_string(most_rows) +
        " are the most that are written unasked. A stress code, or a quantity of a wall's stress "
        "such as von_mises, asks for it.");
    return;
  }
  if (!has_walls)
    return;
  const double stress_unit = results.units.factor("Pa"), length = results.units.factor("m");
  OutputFile file(folder + "/wall_stresses.csv");
  file.stream() << "step,pipe,s,principal_most,principal_least,von_mises,tresca\n";
  for (const Frame &frame : results.frames) {
    if (frame.step >= scene.steps.size())
      continue;
    const auto add_row = [&](const std::size_t i, std::string &text) {
      const Station &station = frame.line[i];
      const std::optional<WallStress> stress = elastic_wall_stress(scene, station);
      if (!stress)
        return;
      text += csv_field(frame.name) + ',' + csv_field(scene.pipes[station.pipe].name) + ',';
      append_exact_number(station.s / length, text);
      for (const double value : {stress->most, stress->least, stress->von_mises, stress->tresca}) {
        text += ',';
        append_exact_number(value / stress_unit, text);
      }
      text += '\n';
    };
    write_rows(frame.line.size(), add_row, file);
  }
}

} // namespace frictionbeam
