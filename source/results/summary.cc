// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/output_file.h>
#include <frictionbeam/results/report.h>
#include <frictionbeam/results/summary.h>
#include <frictionbeam/results/text.h>

#include <deal.II/base/config.h>

#include <cmath>

#ifndef FRICTIONBEAM_VERSION
#define FRICTIONBEAM_VERSION "unknown"
#endif

namespace frictionbeam {

namespace {

/// Whether @p text at @p i begins a well-formed UTF-8 sequence, and of how many bytes.
unsigned int utf8_length(const std::string &text, const std::size_t i) {
  const auto byte = [&](const std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const unsigned int first = byte(i), second = byte(i + 1);
  const unsigned int length = first >= 0xc2 && first < 0xe0   ? 2
                              : first >= 0xe0 && first < 0xf0 ? 3
                              : first >= 0xf0 && first < 0xf5 ? 4
                                                              : 0;
  for (unsigned int k = 1; k < length; ++k)
    if ((byte(i + k) & 0xc0) != 0x80)
      return 0;
  // overlong forms, surrogates, beyond the last code point
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
      (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90))
    return 0;
  return length;
}

std::string json(const std::string &text) {
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = text[i];
    if (c == '"' || c == '\\')
      (quoted += '\\') += text[i];
    else if (c == '\n')
      quoted += "\\n";
    else if (c == '\t')
      quoted += "\\t";
    else if (c < 0x20 || c == 0x7f) {
      const char *digits = "0123456789abcdef";
      ((quoted += "\\u00") += digits[c >> 4]) += digits[c & 15];
    } else if (c < 0x80)
      quoted += text[i];
    else if (const unsigned int length = utf8_length(text, i)) {
      quoted += text.substr(i, length);
      i += length - 1;
    } else
      quoted += "\\ufffd";
  }
  return quoted + '"';
}

std::string json(const double value) {
  return std::isfinite(value) ? rounded_number(value, 17) : "null";
}

std::string json(const std::optional<double> &value) { return value ? json(*value) : "null"; }

std::string json(const std::size_t value) { return std::to_string(value); }

std::string json(const unsigned int value) { return std::to_string(value); }

/// The members of an object or array, each on a line of its own if @p indent is given.
class List {
public:
  List(const char open, const char close, const std::string &indent = "")
      : close(close), indent(indent), text(1, open) {}

  List &add(const std::string &member) {
    text += empty ? "" : (indent.empty() ? ", " : ",");
    text += indent.empty() ? "" : "\n" + indent + "  ";
    text += member;
    empty = false;
    return *this;
  }

  template <typename Value>
  List &add(const std::string &name, const Value &value) {
    return add(json(name) + ": " + json(value));
  }

  List &add_list(const std::string &name, const List &list) {
    return add(json(name) + ": " + list.str());
  }

  std::string str() const { return text + (empty || indent.empty() ? "" : "\n" + indent) + close; }

private:
  char close;
  std::string indent, text;
  bool empty = true;
};

std::string accuracy_text(const AccuracyAccount &account) {
  List chosen('[', ']'), left_out('[', ']'), runs('[', ']', "    ");
  for (const std::string &setting : account.chosen)
    chosen.add(json(setting));
  for (const std::string &quantity : account.left_out)
    left_out.add(json(quantity));
  for (const AccuracyAccount::Run &run : account.runs)
    runs.add(List('{', '}')
                 .add("settings", run.settings)
                 .add("seconds", run.seconds)
                 .add("change", run.change)
                 .add(json("converged") + (run.converged ? ": true" : ": false"))
                 .str());
  List list('{', '}', "  ");
  list.add("demanded", account.demanded).add("estimate", account.estimate);
  if (!account.model.empty())
    list.add("model", account.model)
        .add("line_error", account.line_error)
        .add("model_reason", account.model_reason);
  return list.add(json("reached") + (account.reached ? ": true" : ": false"))
      .add_list("chosen", chosen)
      .add_list("left_out", left_out)
      .add_list("runs", runs)
      .str();
}

std::string reduction_text(const ReductionAccount &account) {
  List trials('[', ']');
  for (const ReductionAccount::Trial &trial : account.trials)
    trials.add(List('{', '}')
                   .add("modes", trial.n_modes)
                   .add("seconds", trial.seconds)
                   .add("change_of_forces", trial.forces)
                   .add("change_of_motions", trial.motions)
                   .add(json("converged") + (trial.converged ? ": true" : ": false"))
                   .str());
  return List('{', '}')
      .add(json("reduced") + (account.is_reduced ? ": true" : ": false"))
      .add("line_unknowns", account.n_line)
      .add("unknowns", account.n_reduced)
      .add("kept", account.n_kept)
      .add("modes", account.n_modes)
      .add("static_shapes", account.n_static_shapes)
      .add("modes_left_out", account.n_left_out)
      .add("highest_frequency", account.highest_frequency)
      .add("next_frequency", account.next_frequency)
      .add("demanded", account.demanded)
      .add("estimate", account.estimate)
      .add_list("trials", trials)
      .add("remark", account.remark)
      .str();
}

/// The worst of each stress case and of each nozzle limit, and the largest forces of transient
/// steps, each with its instant: null where it is the end of a step.
void add_envelopes(const Scene &scene, const Results &results, List &stresses, List &nozzles,
                   List &envelopes) {
  for (const StressCase &one : results.stresses)
    if (!one.stress.empty())
      stresses.add(
          List('{', '}')
              .add("case", one.name)
              .add("kind", one.kind)
              .add("pipe", scene.pipes[one.frame.line[one.worst].pipe].name)
              .add("s", one.frame.line[one.worst].s)
              .add("stress", one.stress[one.worst])
              .add("allowed", one.allowed[one.worst])
              .add("utilization", one.stress[one.worst] / one.allowed[one.worst])
              .add("time", one.time.empty() ? std::optional<double>() : one.time[one.worst])
              .str());
  for (const NozzleUse &one : results.nozzles)
    nozzles.add(List('{', '}')
                    .add("limit", one.name)
                    .add("support", one.support)
                    .add("step", one.step)
                    .add("utilization", one.utilization)
                    .add("time", one.time)
                    .str());
  for (const StepEnvelope &envelope : results.envelopes) {
    List supports('[', ']'), restraints('[', ']');
    for (std::size_t i = 0; i < envelope.supports.size(); ++i) {
      const SupportEnvelope &support = envelope.supports[i];
      supports.add(List('{', '}')
                       .add("support", results.supports[i].name)
                       .add("force", support.force.largest)
                       .add("time", support.force.largest_at)
                       .add("impulse", support.impulse)
                       .add("impacts", support.n_impacts)
                       .str());
    }
    for (std::size_t i = 0; i < envelope.restraints.size(); ++i)
      restraints.add(List('{', '}')
                         .add("restraint", results.restraints[i].name)
                         .add("force", envelope.restraints[i].force.largest)
                         .add("time", envelope.restraints[i].force.largest_at)
                         .str());
    envelopes.add(List('{', '}')
                      .add("step", scene.steps[envelope.step].name)
                      .add("instants", envelope.n_instants)
                      .add("line_instants", envelope.n_line_instants)
                      .add("displacement", envelope.displacement.largest)
                      .add("time", envelope.displacement.largest_at)
                      .add_list("supports", supports)
                      .add_list("restraints", restraints)
                      .str());
  }
}

} // namespace

std::string program_version() { return FRICTIONBEAM_VERSION; }

std::string deal_ii_version() { return DEAL_II_PACKAGE_VERSION; }

void write_summary(const Scene &scene, const Results &results, const std::string &folder) {
  List quantities('[', ']', "  ");
  for (const auto &quantity : results.quantities)
    quantities.add(List('{', '}')
                       .add("name", quantity.name)
                       .add("value", quantity.value)
                       .add("unit", quantity.unit)
                       .add("reference", quantity.reference)
                       .add("error", quantity.error)
                       .add("source", quantity.source)
                       .str());

  List certificate('{', '}');
  for (const Check &check : results.certificate)
    certificate.add(check.name, check.value);
  List energy('{', '}');
  if (results.energy)
    energy.add("external", results.energy->external)
        .add("stored", results.energy->stored)
        .add("dissipated", results.energy->dissipated)
        .add("gaps", results.energy->gaps)
        .add("kinetic", results.energy->kinetic)
        .add("damping", results.energy->damping)
        .add("impact", results.energy->impact)
        .add("left_over", results.energy->left_over())
        .add("at_hand", results.energy->at_hand)
        .add("missed_friction", results.energy->missed_friction)
        .add("imbalance", results.energy->imbalance());

  List known('{', '}', "  "), reasons('{', '}', "    ");
  for (const auto &[name, one] : {std::make_pair("increments", &results.known.increments),
                                  std::make_pair("time_step", &results.known.time_step),
                                  std::make_pair("cells", &results.known.cells)}) {
    if (one->error)
      known.add(name, *one->error);
    else
      known.add(name, std::string("not estimated"));
    reasons.add(name, one->reason);
  }
  known.add_list("reasons", reasons);

  const Cost &cost = results.cost;
  List costs('{', '}', "  ");
  costs.add("wall_seconds", cost.wall_seconds)
      .add("mesh_seconds", cost.mesh_seconds)
      .add("setup_seconds", cost.setup_seconds)
      .add("solve_seconds", cost.solve_seconds)
      .add("unknowns", cost.unknowns)
      .add("cells", cost.cells)
      .add("contacts", cost.contacts)
      .add("steps", cost.steps)
      .add("iterations", cost.iterations)
      .add("factorizations", cost.factorizations)
      .add("back_substitutions", cost.back_substitutions)
      .add("peak_memory_mb", cost.peak_memory_mb);

  List steps('[', ']', "  ");
  for (const auto &step : results.steps) {
    List one('{', '}');
    one.add("step", step.step)
        .add("increments", step.increments)
        .add("halvings", step.halvings)
        .add("iterations", step.iterations)
        .add("factorizations", step.factorizations)
        .add("residual", step.residual)
        .add("contact", step.contact.natural_map)
        .add(json("converged") + (step.converged ? ": true" : ": false"))
        .add("remark", step.remark);
    if (step.reduction)
      one.add(json("reduction") + ": " + reduction_text(*step.reduction));
    steps.add(one.str());
  }

  List remarks('[', ']', "  ");
  for (const auto &remark : all_remarks(scene, results))
    remarks.add(json(remark));

  std::string text = "{\n";
  const auto member = [&](const std::string &name, const std::string &value) {
    text += (text.size() > 2 ? ",\n  " : "  ") + json(name) + ": " + value;
  };
  member("case", json(scene.name));
  member("program",
         List('{', '}').add("version", program_version()).add("deal_ii", deal_ii_version()).str());
  member("status", json(status_word(results.status)));
  member("quantities", quantities.str());
  member("certificate", certificate.str());
  if (results.energy)
    member("energy", energy.str());
  member("known", known.str());
  member("cost", costs.str());
  if (results.accuracy)
    member("accuracy", accuracy_text(*results.accuracy));
  List stresses('[', ']', "  "), nozzles('[', ']', "  "), envelopes('[', ']', "  ");
  add_envelopes(scene, results, stresses, nozzles, envelopes);
  if (!results.stresses.empty())
    member("stresses", stresses.str());
  if (!results.nozzles.empty())
    member("nozzles", nozzles.str());
  if (!results.envelopes.empty())
    member("envelopes", envelopes.str());
  member("method", json(results.method));
  member("integrator", json(results.integrator));
  member("steps", steps.str());
  member("remarks", remarks.str());
  write_file(folder + "/summary.json", text + "\n}\n");
}

} // namespace frictionbeam
