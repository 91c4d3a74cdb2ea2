// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart/measurement.h"

#include "base/process.h"
#include "base/temporary_folder.h"

#include "base/user_error.h"
#include "scene/file/parameter_file.h"

#include <boost/algorithm/string/replace.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace frictionbeam::chart {

namespace {

/// One run.
struct Run {
  std::string problem;
  bool timed_out = false;
  std::vector<Value> values;
  std::optional<double> error; ///< that another program has found itself
  double seconds = 0., process_seconds = 0., peak_memory_mb = 0.;
  std::size_t unknowns = 0;
};

/// The last lines of what a program said, in one.
std::string last_words(const std::string &output) {
  std::string words = tidy(output.substr(output.size() > 600 ? output.size() - 600 : 0));
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words.size() > 200 ? "... " + words.substr(words.size() - 200) : words;
}

std::string problem_of(const ProcessResult &process, const double time_limit) {
  if (process.timed_out)
    return "not finished in " + std::to_string(static_cast<long>(time_limit)) + " s";
  if (process.exit_status == 2)
    return "not converged";
  if (process.exit_status != 0)
    return "exit status " + std::to_string(process.exit_status) + ": " + last_words(process.output);
  return "";
}

void read_summary(const std::string &folder, const bool whole_process, Run &run) {
  std::ifstream in(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(in);
  for (const nlohmann::json &entry : summary.at("quantities")) {
    const auto number = [&](const char *name) {
      return entry.at(name).is_null() ? std::nullopt : std::optional<double>(entry.at(name));
    };
    // In SI units, as other runs and references are; a unit with an offset has no such factor.
    const double si = number("in_si").value_or(1.);
    Value value{entry.at("name"), entry.at("unit"), si * number("value").value_or(std::nan("")),
                number("reference")};
    if (value.reference)
      *value.reference *= si;
    run.values.push_back(value);
  }
  const nlohmann::json &cost = summary.at("cost");
  if (!whole_process)
    run.seconds = 0.;
  for (const char *const part : {"mesh_seconds", "setup_seconds", "solve_seconds"})
    if (!whole_process)
      run.seconds += cost.at(part).get<double>();
  run.unknowns = cost.at("unknowns");
}

Run run_case(const ChartList &list, const std::string &case_file,
             const std::vector<std::string> &settings) {
  const TemporaryFolder folder;
  if (folder.path.empty())
    throw UserError("No temporary folder can be made for the results of the runs.");
  std::vector<std::string> words = {own_path(), case_file, "--output-directory", folder.path};
  for (const auto &group : {std::vector<std::string>{"Output/VTU = false", "Output/Report = false"},
                            list.settings, settings})
    for (const std::string &setting : group)
      words.insert(words.end(), {"--set", setting});
  const ProcessResult process = run_process(words, "", list.time_limit);
  Run run;
  run.problem = problem_of(process, list.time_limit);
  run.timed_out = process.timed_out;
  run.process_seconds = process.seconds;
  run.seconds =
      list.time == ChartList::Time::processor ? process.processor_seconds : process.seconds;
  run.peak_memory_mb = process.peak_memory_mb;
  if (run.problem.empty())
    read_summary(folder.path, list.time != ChartList::Time::solution, run);
  return run;
}

/// Run another program, which prints lines `name = value`.
Run run_command(const ChartList &list, std::string command,
                const std::vector<std::string> &values) {
  boost::replace_all(command, "{program}", own_path());
  boost::replace_all(command, "{value}", values.empty() ? "" : values[0]);
  const ProcessResult process =
      run_process({"sh", "-c", "exec " + command}, list.folder, list.time_limit);
  Run run;
  run.problem = problem_of(process, list.time_limit);
  run.timed_out = process.timed_out;
  run.process_seconds = process.seconds;
  run.seconds =
      list.time == ChartList::Time::processor ? process.processor_seconds : process.seconds;
  run.peak_memory_mb = process.peak_memory_mb;
  std::istringstream lines(process.output);
  for (std::string line; std::getline(lines, line);) {
    const auto sign = line.find('=');
    if (sign == std::string::npos)
      continue;
    const std::string name = tidy(line.substr(0, sign)), text = tidy(line.substr(sign + 1));
    double value = 0.;
    if (!to_number(text.substr(0, text.find(' ')), value))
      continue;
    if (name == "error")
      run.error = value;
    else if (name == "seconds")
      run.seconds = list.time == ChartList::Time::solution ? value : run.seconds;
    else if (name == "unknowns")
      run.unknowns = static_cast<std::size_t>(value);
    else
      run.values.push_back({name, "", value, {}});
  }
  return run;
}

Run run_curve(const ChartList &list, const Curve &curve, const std::vector<std::string> &values) {
  if (!curve.command.empty())
    return run_command(list, curve.command, values);
  std::vector<std::string> settings = curve.settings;
  for (std::size_t i = 0; i < values.size(); ++i)
    settings.push_back(curve.varied[i] + " = " + values[i]);
  return run_case(list, curve.case_file, settings);
}

/// References by quantity, and what errors are divided by.
struct References {
  std::map<std::string, double> values, scales;
};

bool counts(const ChartList &list, const std::string &quantity) {
  return list.quantities.empty() ||
         std::count(list.quantities.begin(), list.quantities.end(), quantity) > 0;
}

References reference_of(const ChartList &list, const std::vector<Value> &values) {
  References references;
  std::map<std::string, double> largest; // by unit
  for (const Value &value : values) {
    const auto given = list.references.find(value.name);
    if (given == list.references.end() && !value.reference)
      continue;
    const double reference = given == list.references.end() ? *value.reference : given->second;
    if (counts(list, value.name))
      largest[value.unit] = std::max(largest[value.unit], std::abs(reference));
    references.values[value.name] = reference;
  }
  for (const Value &value : values)
    if (references.values.count(value.name) > 0) {
      const double scale =
          std::max(std::abs(references.values[value.name]), list.floor * largest[value.unit]);
      references.scales[value.name] = scale > 0. ? scale : 1.;
    }
  return references;
}

/// Values and error of a configuration from one of its runs.
void evaluate(const ChartList &list, const bool other_program, const Run &run, References &common,
              Measurement &measurement) {
  // The references of a generated scene may follow what varies; other programs know none.
  if (!other_program && !list.has_reference_run && run.problem.empty())
    common = reference_of(list, run.values);
  const References &references = common;
  measurement.unknowns = run.unknowns;
  if (run.error) {
    measurement.error = *run.error;
    return;
  }
  std::size_t n = 0;
  double largest = -1.;
  for (Value value : run.values) {
    const auto reference = references.values.find(value.name);
    if (!counts(list, value.name) || reference == references.values.end())
      continue;
    ++n;
    value.reference = reference->second;
    const double error =
        std::abs(value.value - reference->second) / references.scales.at(value.name);
    if (!(error <= largest)) { // nan counts as the largest
      largest = error;
      measurement.worst = value.name;
    }
    measurement.values.push_back(value);
  }
  if (n == 0 || (!list.quantities.empty() && n < list.quantities.size()))
    measurement.problem = n == 0 ? "no quantity with a reference" : "a quantity is missing";
  else if (!std::isfinite(largest))
    measurement.problem = "the quantity " + measurement.worst + " is no number";
  else
    measurement.error = largest;
}

/// References for programs that know none.
References common_references(const ChartList &list) {
  References references;
  if (list.has_reference_run) {
    std::cout << "Reference run" << std::endl;
    ChartList patient = list;
    patient.time_limit = 20. * list.time_limit;
    Run run = run_case(patient, list.curves[0].case_file, list.reference_run);
    if (!run.problem.empty())
      throw UserError("The reference run of " + list.name + " has no answer: " + run.problem);
    for (Value &value : run.values)
      value.reference = value.value;
    return reference_of(list, run.values);
  }
  for (const auto &[name, value] : list.references) {
    references.values[name] = value;
    references.scales[name] = value != 0. ? std::abs(value) : 1.;
  }
  return references;
}

/// All configurations of a list, run again and again.
class Rounds {
public:
  explicit Rounds(const ChartList &list) : list(list), references(common_references(list)) {
    for (std::size_t c = 0; c < list.curves.size(); ++c)
      for (const std::vector<std::string> &values : list.curves[c].values) {
        measurements.emplace_back();
        measurements.back().curve = c;
        for (const std::string &word : values)
          measurements.back().setting += (measurements.back().setting.empty() ? "" : " ") + word;
      }
    process_seconds.resize(measurements.size());
  }

  void run(const bool is_first) {
    std::size_t next = 0;
    for (const Curve &curve : list.curves) {
      bool too_slow = false;
      for (const std::vector<std::string> &values : curve.values) {
        const std::size_t i = next++;
        double spent = 0.;
        for (const double time : process_seconds[i])
          spent += time;
        if (!measurements[i].solved() || (!is_first && spent > list.time_limit))
          continue;
        if (too_slow)
          measurements[i].problem = "not begun, since the one before was too slow";
        else
          too_slow = measure_once(curve, values, i, is_first);
      }
    }
  }

  std::vector<Measurement> result() {
    for (std::size_t i = 0; i < measurements.size(); ++i) {
      std::sort(measurements[i].seconds.begin(), measurements[i].seconds.end());
      measurements[i].process_seconds = median_of(process_seconds[i]);
    }
    return measurements;
  }

private:
  /// @return whether it took too long
  bool measure_once(const Curve &curve, const std::vector<std::string> &values, const std::size_t i,
                    const bool is_first) {
    Measurement &measurement = measurements[i];
    const Run run = run_curve(list, curve, values);
    process_seconds[i].push_back(run.process_seconds);
    measurement.peak_memory_mb = std::max(measurement.peak_memory_mb, run.peak_memory_mb);
    measurement.problem = run.problem;
    measurement.seconds.push_back(run.seconds);
    if (is_first && run.problem.empty())
      evaluate(list, !curve.command.empty(), run, references, measurement);
    if (is_first)
      std::cout << curve.label << ' ' << measurement.setting << ": "
                << (measurement.solved() ? "error " + std::to_string(measurement.error)
                                         : measurement.problem)
                << ", " << run.seconds << " s" << std::endl;
    return run.timed_out;
  }

  const ChartList &list;
  References references;
  std::vector<Measurement> measurements;
  std::vector<std::vector<double>> process_seconds; ///< of each, by round
};

} // namespace

double median_of(std::vector<double> &numbers) {
  if (numbers.empty())
    return std::nan("");
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[half] : 0.5 * (numbers[half - 1] + numbers[half]);
}

double Measurement::median() const {
  std::vector<double> copy = seconds;
  return median_of(copy);
}

std::vector<Measurement> measure(const ChartList &list) {
  Rounds rounds(list);
  for (unsigned int round = 0; round < list.n_runs; ++round)
    rounds.run(round == 0);
  const std::vector<Measurement> measurements = rounds.result();
  if (std::none_of(measurements.begin(), measurements.end(),
                   [](const Measurement &one) { return one.solved(); }))
    throw UserError("No configuration of " + list.name +
                    " has an answer that can be compared with a reference. The first one: " +
                    measurements.front().problem);
  return measurements;
}

} // namespace frictionbeam::chart
