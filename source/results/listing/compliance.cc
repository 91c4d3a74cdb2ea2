// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/listing/compliance.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {

/// First name of each vertex that has one.
std::map<unsigned int, std::string> names_of_vertices(const Results &results) {
  std::map<unsigned int, std::string> names;
  for (const PointInfo &point : results.points)
    names.emplace(point.vertex, point.name);
  return names;
}

double ratio(const StressCase &one, const std::size_t station) {
  return one.stress[station] / one.allowed[station];
}

/// The stations of a case that are nodes, along the pipes; of both sides of a node in one pipe the
/// one with the larger stress.
std::vector<std::size_t> nodes_of(const StressCase &one) {
  std::vector<std::size_t> nodes;
  std::map<std::pair<unsigned int, unsigned int>, std::size_t> place; // by pipe and vertex
  for (std::size_t i = 0; i < one.stress.size(); ++i) {
    const Station &station = one.frame.line[i];
    if (!station.is_node())
      continue;
    const auto [known, is_new] = place.try_emplace({station.pipe, station.vertex}, nodes.size());
    if (is_new)
      nodes.push_back(i);
    else if (ratio(one, i) > ratio(one, nodes[known->second]))
      nodes[known->second] = i;
  }
  return nodes;
}

/// Those to show: with a name, and the worst; of very many, those that use most.
std::vector<std::size_t> nodes_to_show(const StressCase &one,
                                       const std::map<unsigned int, std::string> &names) {
  std::vector<std::size_t> nodes = nodes_of(one);
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(),
                             [&](const std::size_t i) {
                               return i != one.worst && names.count(one.frame.line[i].vertex) == 0;
                             }),
              nodes.end());
  if (std::count(nodes.begin(), nodes.end(), one.worst) == 0)
    nodes.push_back(one.worst); // between two nodes
  if (nodes.size() > n_rows_at_most) {
    std::stable_sort(nodes.begin(), nodes.end(), [&](const std::size_t a, const std::size_t b) {
      return ratio(one, a) > ratio(one, b);
    });
    nodes.resize(n_rows_at_most);
    std::sort(nodes.begin(), nodes.end());
  }
  return nodes;
}

std::string table_of(const Scene &scene, const Results &results, const StressCase &one,
                     const std::map<unsigned int, std::string> &names) {
  const std::vector<std::size_t> nodes = nodes_to_show(one, names);
  const auto column = [&](const auto &value) {
    std::vector<decltype(value(std::size_t()))> values;
    for (const std::size_t i : nodes)
      values.push_back(value(i));
    return values;
  };
  const auto of_forces = [&](double StressForces::*const component) {
    return column([&](const std::size_t i) { return one.forces[i].*component; });
  };
  const auto of_factors = [&](double StressFactors::*const component) {
    return column([&](const std::size_t i) { return fixed_number(one.factors[i].*component, 2); });
  };
  HtmlTable table(results.units);
  table
      .text("node", column([&](const std::size_t i) {
              const auto name = names.find(one.frame.line[i].vertex);
              return name == names.end() ? dash : name->second;
            }))
      .text("pipe", column([&](const std::size_t i) -> std::string {
              return scene.pipes[one.frame.line[i].pipe].name;
            }))
      .numbers("s", "m", column([&](const std::size_t i) { return one.frame.line[i].s; }))
      .right("i in", of_factors(&StressFactors::in_plane))
      .right("i out", of_factors(&StressFactors::out_of_plane))
      .right("i axial", of_factors(&StressFactors::axial))
      .numbers("axial", "N", of_forces(&StressForces::axial))
      .numbers("M in plane", "N m", of_forces(&StressForces::in_plane))
      .numbers("M out of plane", "N m", of_forces(&StressForces::out_of_plane))
      .numbers("torsion", "N m", of_forces(&StressForces::torsion))
      .numbers("stress", "Pa", column([&](const std::size_t i) { return one.stress[i]; }))
      .numbers("allowed", "Pa", column([&](const std::size_t i) { return one.allowed[i]; }))
      .right("ratio", column([&](const std::size_t i) {
               return (ratio(one, i) > 1. ? "\u2717 " : "") + fixed_number(ratio(one, i), 3);
             }));
  return table.str();
}

} // namespace

std::string compliance_section(const Scene &scene, const Results &results) {
  const auto names = names_of_vertices(results);
  std::vector<std::pair<std::string, std::string>> panels;
  std::string code;
  for (const StressCase &one : results.stresses)
    if (!one.stress.empty() && !one.factors.empty()) {
      panels.emplace_back(one.kind + " " + one.name, table_of(scene, results, one, names));
      code = one.code;
    }
  if (panels.empty())
    return "";
  return "<details><summary>Compliance of each node, " + escape_xml(code) + "</summary>\n" +
         html_tabs("compliance-of", panels) +
         html_note(
             "Named nodes and the worst one, of two sides of a node the one with more stress; "
             "\u2717: more than is allowed. Of a range, forces are those of the difference. "
             "Of transient steps the largest stress counts, with the forces of its instant. "
             "compliance.csv has every node.") +
         "</details>\n";
}

void write_compliance(const Scene &scene, const Results &results, const std::string &folder) {
  const auto names = names_of_vertices(results);
  const auto unit = [&](const std::string &si) { return results.units.factor(si); };
  std::string text = "case,kind,step,code,node,pipe,s,i_in,i_out,i_axial,axial,m_in,m_out,torsion,"
                     "pressure,stress,allowed,ratio,time\n";
  bool any = false;
  for (const StressCase &one : results.stresses) {
    if (one.factors.empty())
      continue;
    for (const std::size_t i : nodes_of(one)) {
      any = true;
      const Station &station = one.frame.line[i];
      const auto name = names.find(station.vertex);
      text += csv_field(one.name) + ',' + one.kind + ',' + csv_field(one.step) + ',' +
              csv_field(one.code) + ',' + (name == names.end() ? "" : csv_field(name->second)) +
              ',' + csv_field(scene.pipes[station.pipe].name) + ',' +
              exact_number(station.s / unit("m"));
      const StressFactors &factors = one.factors[i];
      for (const double factor : {factors.in_plane, factors.out_of_plane, factors.axial})
        text += ',' + exact_number(factor);
      const StressForces &f = one.forces[i];
      text += ',' + exact_number(f.axial / unit("N"));
      for (const double moment : {f.in_plane, f.out_of_plane, f.torsion})
        text += ',' + exact_number(moment / unit("N m"));
      text += ',' + exact_number(f.pressure / unit("Pa"));
      text += ',' + exact_number(one.stress[i] / unit("Pa")) + ',' +
              exact_number(one.allowed[i] / unit("Pa")) + ',' + exact_number(ratio(one, i)) + ',' +
              (one.time.empty() ? "" : exact_number(one.time[i])) + '\n';
    }
  }
  if (any)
    write_file(folder + "/compliance.csv", text);
}

} // namespace frictionbeam
