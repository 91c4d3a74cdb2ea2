// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/how_well_known.h"
#include "results/page/html.h"
#include "results/report/report_tables.h"
#include "results/text.h"

#include <cmath>

namespace frictionbeam {

namespace {

std::string energy_table(const Results &results) {
  if (!results.energy)
    return "";
  const EnergyAccount &energy = *results.energy;
  const auto joule = [](const double value) { return optional_number(value, 4) + " J"; };
  return "<h3>Energy</h3>\n" +
         HtmlTable()
             .text("all steps",
                   {"work of loads and imposed motions", "kinetic", "stored",
                    "dissipated by friction", "by pipes that yield or creep", "by damping",
                    "by impact", "along gaps that open or close", "left over",
                    "largest at hand in motion", "friction work missed by static steps"})
             .right("", {joule(energy.external), joule(energy.kinetic), joule(energy.stored),
                         joule(energy.dissipated), joule(energy.inelastic), joule(energy.damping),
                         joule(energy.impact), joule(energy.gaps), joule(energy.left_over()),
                         joule(energy.at_hand), joule(energy.missed_friction)})
             .str();
}

std::string known_table(const Results &results) {
  const HowWellKnown &known = results.known;
  return "<h3>How well known</h3>\n" +
         HtmlTable()
             .text("displacements", {"load increments", "time step", "cells"})
             .right("error",
                    {in_words(known.increments), in_words(known.time_step), in_words(known.cells)})
             .text("", {known.increments.reason, known.time_step.reason, known.cells.reason})
             .str();
}

std::string solved_steps_table(const Results &results) {
  std::vector<std::string> steps, increments, halvings, iterations, factorizations, residuals,
      contact, converged, remarks;
  bool any_contact = false;
  for (const StepReport &step : results.steps) {
    steps.push_back(step.step);
    increments.push_back(std::to_string(step.increments));
    halvings.push_back(std::to_string(step.halvings));
    iterations.push_back(std::to_string(step.iterations));
    factorizations.push_back(std::to_string(step.factorizations));
    residuals.push_back(optional_number(step.residual, 2));
    contact.push_back(optional_number(step.contact.natural_map, 2));
    any_contact = any_contact || step.contact.natural_map != 0.;
    converged.push_back(step.converged ? "yes" : "no");
    remarks.push_back(step.remark);
  }
  HtmlTable table(results.units);
  table.text("step", steps)
      .text("converged", converged)
      .right("increments", increments)
      .right("halvings", halvings)
      .right("iterations", iterations)
      .right("factorizations", factorizations)
      .right("residual", residuals);
  if (any_contact)
    table.right("contact residual", contact);
  return table.text("remark", remarks).str();
}

std::string certificate_table(const Results &results) {
  std::vector<std::string> checks, meanings, values;
  for (const Check &check : results.certificate) {
    checks.push_back(check.name);
    meanings.push_back(check.meaning);
    const bool has_unit = check.unit != "-" && std::isfinite(check.value);
    values.push_back(optional_number(check.value, 2) + (has_unit ? " " + check.unit : ""));
  }
  return "<h3>Certificate</h3>\n" +
         HtmlTable().text("check", checks).text("", meanings).right("worst", values).str();
}

std::string cost_table(const Cost &cost) {
  const auto seconds = [](const double value) { return rounded_number(value, 3) + " s"; };
  return "<h3>Cost</h3>\n" +
         HtmlTable()
             .text("time", {"all", "mesh", "setup", "solution"})
             .right("", {seconds(cost.wall_seconds), seconds(cost.mesh_seconds),
                         seconds(cost.setup_seconds), seconds(cost.solve_seconds)})
             .text("size", {"unknowns", "cells", "contacts", "peak memory"})
             .right("",
                    {std::to_string(cost.unknowns), std::to_string(cost.cells),
                     std::to_string(cost.contacts), rounded_number(cost.peak_memory_mb, 3) + " MB"})
             .text("work", {"steps", "iterations", "factorizations", ""})
             .right("", {std::to_string(cost.steps), std::to_string(cost.iterations),
                         std::to_string(cost.factorizations), ""})
             .str();
}

} // namespace

std::string solver_tables(const Results &results) {
  return solved_steps_table(results) + "<div class=\"columns\">\n<div>" +
         certificate_table(results) + energy_table(results) + known_table(results) +
         "</div>\n<div>" + cost_table(results.cost) + "</div>\n</div>\n";
}

} // namespace frictionbeam
