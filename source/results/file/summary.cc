// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/summary.h"
#include "results/file/output_file.h"
#include "results/inelastic/yielding.h"
#include "results/remarks.h"
#include "results/text.h"

#include <deal.II/base/config.h>

#include <nlohmann/json.hpp>

#ifndef FRICTIONBEAM_VERSION
#define FRICTIONBEAM_VERSION "unknown"
#endif

namespace frictionbeam {

namespace {

using Json = nlohmann::ordered_json; // numbers that are not finite become null

Json number(const std::optional<double> &value) { return value ? Json(*value) : Json(); }

Json summary_of(const AccuracyAccount &account) {
  Json result{{"demanded", number(account.demanded)}, {"estimate", number(account.estimate)}};
  if (!account.model.empty())
    result.update({{"model", account.model},
                   {"line_error", number(account.line_error)},
                   {"model_reason", account.model_reason}});
  result["reached"] = account.reached;
  result["chosen"] = account.chosen;
  result["left_out"] = account.left_out;
  Json &runs = result["runs"] = Json::array();
  for (const AccuracyAccount::Run &run : account.runs)
    runs.push_back({{"settings", run.settings},
                    {"seconds", run.seconds},
                    {"change", number(run.change)},
                    {"converged", run.converged}});
  return result;
}

Json summary_of(const ReductionAccount &account) {
  Json trials = Json::array();
  for (const ReductionAccount::Trial &trial : account.trials)
    trials.push_back({{"modes", trial.n_modes},
                      {"seconds", trial.seconds},
                      {"change_of_forces", number(trial.forces)},
                      {"change_of_motions", number(trial.motions)},
                      {"converged", trial.converged}});
  return {{"reduced", account.is_reduced},
          {"line_unknowns", account.n_line},
          {"unknowns", account.n_reduced},
          {"kept", account.n_kept},
          {"modes", account.n_modes},
          {"static_shapes", account.n_static_shapes},
          {"modes_left_out", account.n_left_out},
          {"highest_frequency", account.highest_frequency},
          {"next_frequency", account.next_frequency},
          {"demanded", number(account.demanded)},
          {"estimate", number(account.estimate)},
          {"trials", trials},
          {"remark", account.remark}};
}

/// The worst of each stress case, with its instant: null where it is the end of a step.
Json summary_of_stresses(const Scene &scene, const Results &results) {
  Json result = Json::array();
  for (const StressCase &one : results.stresses)
    if (!one.stress.empty())
      result.push_back({{"case", one.name},
                        {"kind", one.kind},
                        {"pipe", scene.pipes[one.frame.line[one.worst].pipe].name},
                        {"s", one.frame.line[one.worst].s},
                        {"stress", one.stress[one.worst]},
                        {"allowed", one.allowed[one.worst]},
                        {"utilization", one.stress[one.worst] / one.allowed[one.worst]},
                        {"time", one.time.empty() ? Json() : Json(one.time[one.worst])}});
  return result;
}

Json summary_of_nozzles(const Results &results) {
  Json result = Json::array();
  for (const NozzleUse &one : results.nozzles)
    result.push_back({{"limit", one.name},
                      {"support", one.support},
                      {"step", one.step},
                      {"utilization", one.utilization},
                      {"time", number(one.time)}});
  return result;
}

/// What pipes have yielded and crept by the end of the run.
Json summary_of_yield(const Scene &scene, const Results &results) {
  const auto worst = [](const WorstSection &one) {
    return Json{{"value", number(one.value)}, {"s", one.s}, {"step", one.step}};
  };
  Json pipes = Json::array(), hinges = Json::array();
  for (const PipeYield &pipe : yield_of_pipes(results))
    pipes.push_back({{"pipe", scene.pipes[pipe.pipe].name},
                     {"plastic_strain", worst(pipe.plastic)},
                     {"creep_strain", worst(pipe.creep)},
                     {"utilization", worst(pipe.utilization)},
                     {"dissipated", pipe.dissipated}});
  for (const Hinge &hinge : hinges_of(frames_of_sections(results)))
    hinges.push_back({{"pipe", scene.pipes[hinge.worst.pipe].name},
                      {"from", hinge.from},
                      {"to", hinge.to},
                      {"s", hinge.worst.s},
                      {"plastic_strain", number(hinge.worst.plastic_strain)},
                      {"since", hinge.since},
                      {"flows", hinge.flows}});
  return {{"pipes", pipes}, {"hinges", hinges}};
}

/// The largest forces of a transient step, each with its instant.
Json summary_of(const StepEnvelope &envelope, const Scene &scene, const Results &results) {
  Json supports = Json::array(), restraints = Json::array();
  for (std::size_t i = 0; i < envelope.supports.size(); ++i) {
    const SupportEnvelope &support = envelope.supports[i];
    supports.push_back({{"support", results.supports[i].name},
                        {"force", support.force.largest},
                        {"time", support.force.largest_at},
                        {"impulse", support.impulse},
                        {"impacts", support.n_impacts}});
  }
  for (std::size_t i = 0; i < envelope.restraints.size(); ++i)
    restraints.push_back({{"restraint", results.restraints[i].name},
                          {"force", envelope.restraints[i].force.largest},
                          {"time", envelope.restraints[i].force.largest_at}});
  return {{"step", scene.steps[envelope.step].name},
          {"instants", envelope.n_instants},
          {"line_instants", envelope.n_line_instants},
          {"displacement", envelope.displacement.largest},
          {"time", envelope.displacement.largest_at},
          {"supports", supports},
          {"restraints", restraints}};
}

/// The units of the tables, by those of SI.
Json summary_of(const UnitSystem &units) {
  Json result;
  for (const char *const si : {"m", "N", "N m", "Pa", "kg", "K", "J"})
    result[si] = {{"name", units.name(si)}, {"in_si", units.factor(si)}};
  return result;
}

Json summary_of(const EnergyAccount &energy) {
  return {{"external", energy.external},
          {"stored", energy.stored},
          {"dissipated", energy.dissipated},
          {"inelastic", energy.inelastic},
          {"gaps", energy.gaps},
          {"kinetic", energy.kinetic},
          {"damping", energy.damping},
          {"impact", energy.impact},
          {"left_over", energy.left_over()},
          {"at_hand", energy.at_hand},
          {"missed_friction", energy.missed_friction},
          {"imbalance", energy.imbalance()}};
}

Json summary_of(const HowWellKnown &known) {
  Json result, reasons;
  for (const auto &[name, one] :
       {std::make_pair("increments", &known.increments),
        std::make_pair("time_step", &known.time_step), std::make_pair("cells", &known.cells)}) {
    result[name] = one->error ? Json(*one->error) : Json("not estimated");
    reasons[name] = one->reason;
  }
  result["reasons"] = reasons;
  return result;
}

Json summary_of(const Cost &cost) {
  return {{"wall_seconds", cost.wall_seconds},
          {"mesh_seconds", cost.mesh_seconds},
          {"setup_seconds", cost.setup_seconds},
          {"solve_seconds", cost.solve_seconds},
          {"unknowns", cost.unknowns},
          {"cells", cost.cells},
          {"contacts", cost.contacts},
          {"steps", cost.steps},
          {"iterations", cost.iterations},
          {"factorizations", cost.factorizations},
          {"back_substitutions", cost.back_substitutions},
          {"peak_memory_mb", cost.peak_memory_mb}};
}

Json summary_of(const StepReport &step) {
  Json result{{"step", step.step},
              {"increments", step.increments},
              {"halvings", step.halvings},
              {"iterations", step.iterations},
              {"factorizations", step.factorizations},
              {"residual", step.residual},
              {"contact", step.contact.natural_map},
              {"converged", step.converged},
              {"remark", step.remark}};
  if (step.limit)
    result["limit"] = {{"reached", step.limit->reached},
                       {"bound", number(step.limit->bound)},
                       {"mechanism", step.limit->mechanism}};
  if (step.cycle)
    result["cycle"] = {{"number", step.cycle->number},         {"of", step.cycle->of},
                       {"growth", step.cycle->growth},         {"flow", step.cycle->flow},
                       {"dissipated", step.cycle->dissipated}, {"verdict", step.cycle->words}};
  if (step.reduction)
    result["reduction"] = summary_of(*step.reduction);
  return result;
}

} // namespace

std::string program_version() { return FRICTIONBEAM_VERSION; }

std::string deal_ii_version() { return DEAL_II_PACKAGE_VERSION; }

void write_summary(const Scene &scene, const Results &results, const std::string &folder) {
  Json summary{{"case", scene.name},
               {"program", {{"version", program_version()}, {"deal_ii", deal_ii_version()}}},
               {"status", status_word(results.status)},
               {"units", summary_of(scene.units)}};
  Json &quantities = summary["quantities"] = Json::array();
  for (const auto &quantity : results.quantities)
    quantities.push_back({{"name", quantity.name},
                          {"value", number(quantity.value)},
                          {"unit", quantity.unit},
                          {"in_si", quantity.in_si > 0. ? Json(quantity.in_si) : Json()},
                          {"reference", number(quantity.reference)},
                          {"error", number(quantity.error)},
                          {"source", quantity.source}});
  Json &certificate = summary["certificate"] = Json::object();
  for (const Check &check : results.certificate)
    certificate[check.name] = number(check.value);
  Json &verdicts = summary["verdicts"] = Json::array();
  for (const Verdict &verdict : results.verdicts)
    verdicts.push_back({{"check", verdict.check},
                        {"of", verdict.of},
                        {"step", verdict.step},
                        {"value", number(verdict.value)},
                        {"allowed", number(verdict.allowed)},
                        {"unit", verdict.unit},
                        {"passes", verdict.passes}});
  if (results.energy)
    summary["energy"] = summary_of(*results.energy);
  summary["known"] = summary_of(results.known);
  summary["cost"] = summary_of(results.cost);
  if (results.accuracy)
    summary["accuracy"] = summary_of(*results.accuracy);
  if (!results.stresses.empty())
    summary["stresses"] = summary_of_stresses(scene, results);
  if (!results.nozzles.empty())
    summary["nozzles"] = summary_of_nozzles(results);
  if (!frames_of_sections(results).empty())
    summary["yield"] = summary_of_yield(scene, results);
  for (const StepEnvelope &envelope : results.envelopes)
    summary["envelopes"].push_back(summary_of(envelope, scene, results));
  summary["method"] = results.method;
  summary["integrator"] = results.integrator;
  Json &steps = summary["steps"] = Json::array();
  for (std::size_t s = 0; s < results.steps.size(); ++s) {
    steps.push_back(summary_of(results.steps[s]));
    if (s < scene.steps.size() && scene.steps[s].from)
      steps.back()["from"] = scene.steps[*scene.steps[s].from].name;
  }
  summary["remarks"] = all_remarks(scene, results);
  // Bytes that are no UTF-8 become the character that says so.
  write_file(folder + "/summary.json",
             summary.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

} // namespace frictionbeam
