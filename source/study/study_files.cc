// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/study_files.h"

#include "results/file/csv_writer.h"
#include "results/file/hdf5_file.h"
#include "results/file/output_file.h"
#include "results/file/summary.h"
#include "results/text.h"
#include "study/statistics.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::study {

namespace {

using Json = nlohmann::ordered_json; // numbers that are not finite become null

std::string word_of(const Run &run) { return row_of(outcomes, run.outcome).word; }

/// In the units of the case; a quantity is in its own already.
double shown(const StudyResults &study, const ResultName &name, const double number) {
  return name.of == ResultName::Of::quantity || name.unit == "-"
             ? number
             : number / study.units.factor(name.unit);
}

std::string unit_of(const StudyResults &study, const ResultName &name) {
  return name.of == ResultName::Of::quantity ? name.unit : study.units.name(name.unit);
}

/// A number as a field: empty if there is none.
std::string field(const double number) { return std::isfinite(number) ? exact_number(number) : ""; }

void write_runs(const StudyResults &study, const std::string &folder) {
  OutputFile file(folder + "/runs.csv");
  std::string row = "run,outcome";
  for (const std::string &variable : study.variables)
    row += ',' + csv_field(variable);
  for (const ResultName &name : study.names)
    if (name.is_of_the_run())
      row += ',' + csv_field(column_name(name));
  file.stream() << row << '\n';
  for (std::size_t run = 0; run < study.runs.size(); ++run) {
    row = std::to_string(run + 1) + ',' + word_of(study.runs[run]);
    for (const std::string &text : study.texts[run])
      row += ',' + csv_field(text);
    for (std::size_t i = 0; i < study.names.size(); ++i)
      if (study.names[i].is_of_the_run())
        row += ',' + (study.runs[run].numbers.empty()
                          ? std::string()
                          : field(shown(study, study.names[i], study.runs[run].numbers[i])));
    file.stream() << row << '\n';
  }
  file.flush();
}

/// A name that is a part of a path in an HDF5 file.
std::string path_part(std::string name) {
  std::replace(name.begin(), name.end(), '/', '|');
  return name;
}

void write_hdf5(const StudyResults &study, const std::string &folder) {
  Hdf5File file(folder + "/runs.h5", Hdf5File::Mode::create);
  const std::size_t n = study.runs.size();
  std::vector<int> outcome;
  for (const Run &run : study.runs)
    outcome.push_back(static_cast<int>(run.outcome));
  file.write("/outcome", outcome);
  std::string words;
  for (const auto &row : outcomes)
    words += std::to_string(static_cast<int>(row.value)) + " " + row.word + "\n";
  file.write("/outcomes", words);
  file.make_group("/variables");
  file.make_group("/results");
  Eigen::VectorXd column(n);
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    for (std::size_t run = 0; run < n; ++run)
      column[run] = study.values[run][i];
    file.write("/variables/" + path_part(study.variables[i]), column);
  }
  for (std::size_t i = 0; i < study.names.size(); ++i) {
    for (std::size_t run = 0; run < n; ++run)
      column[run] = study.runs[run].numbers.empty()
                        ? std::numeric_limits<double>::quiet_NaN()
                        : shown(study, study.names[i], study.runs[run].numbers[i]);
    file.write("/results/" + path_part(column_name(study.names[i])), column);
  }
  file.flush();
}

std::string bound(const StudyResults &study, const ResultName &name,
                  const std::optional<double> &number) {
  return number ? field(shown(study, name, *number)) : "";
}

void write_spread(const StudyResults &study, const std::string &folder) {
  std::string text = "result,unit,runs,nominal,least";
  for (const double probability : study.settings.quantiles) {
    const std::string q = "q" + rounded_number(probability);
    text += ',' + q + ',' + q + " low," + q + " high";
  }
  text += ",largest,mean,deviation,largest in run,stick,slip,open,closed\n";
  for (std::size_t i = 0; i < study.names.size(); ++i) {
    const ResultName &name = study.names[i];
    const Spread spread = spread_of(study, i);
    const auto number = [&](const double value) { return ',' + field(shown(study, name, value)); };
    text += csv_field(column_name(name)) + ',' + csv_field(unit_of(study, name)) + ',' +
            std::to_string(spread.n);
    if (name.is_a_word()) {
      const StatusShares shares = shares_of(study, i);
      text += std::string(3 * study.settings.quantiles.size() + 6, ',') + ',' +
              exact_number(shares.stick) + ',' + exact_number(shares.slip) + ',' +
              exact_number(shares.open) + ',' + exact_number(shares.closed) + '\n';
      continue;
    }
    text += number(study.nominal[i]);
    if (spread.n == 0) {
      text += std::string(3 * study.settings.quantiles.size() + 9, ',') + '\n';
      continue;
    }
    text += number(spread.least);
    for (const Quantile &quantile : spread.quantiles)
      text += number(quantile.value) + ',' + bound(study, name, quantile.low) + ',' +
              bound(study, name, quantile.high);
    text += number(spread.largest) + number(spread.mean) + number(spread.deviation) + ',' +
            std::to_string(spread.largest_run + 1) + ",,,,\n";
  }
  write_file(folder + "/spread.csv", text);
}

void write_sensitivities(const StudyResults &study, const std::vector<Sensitivity> &effects,
                         const std::string &folder) {
  std::string text = "result,variable,rank correlation,first,first low,first high,total,total "
                     "low,total high,mean effect,mean size of effects,deviation of effects\n";
  for (const Sensitivity &of : effects)
    for (std::size_t i = 0; i < of.effects.size(); ++i) {
      const Effect &effect = of.effects[i];
      const ResultName &name = study.names[of.name];
      text += csv_field(column_name(name)) + ',' + csv_field(study.variables[i]) + ',' +
              field(effect.rank_correlation.value_or(std::nan("")));
      for (const std::optional<Effect::Share> &share : {effect.first, effect.total})
        text += share
                    ? ',' + field(share->value) + ',' + field(share->low) + ',' + field(share->high)
                    : ",,,";
      if (effect.elementary)
        for (const double number :
             {effect.elementary->mean, effect.elementary->mean_size, effect.elementary->deviation})
          text += ',' + field(shown(study, name, number));
      else
        text += ",,,";
      text += '\n';
    }
  write_file(folder + "/sensitivities.csv", text);
}

void write_failed(const StudyResults &study, const std::string &folder) {
  std::string text = "run,outcome,reason";
  for (const std::string &variable : study.variables)
    text += ',' + csv_field(variable);
  text += '\n';
  for (std::size_t run = 0; run < study.runs.size(); ++run) {
    if (study.runs[run].outcome == Outcome::converged)
      continue;
    text += std::to_string(run + 1) + ',' + word_of(study.runs[run]) + ',' +
            csv_field(study.runs[run].reason);
    for (const std::string &value : study.texts[run])
      text += ',' + csv_field(value);
    text += '\n';
  }
  write_file(folder + "/failed.csv", text);
}

Json summary_of(const StudyResults &study, const std::size_t i) {
  const Spread spread = spread_of(study, i);
  const ResultName &name = study.names[i];
  const auto in_unit = [&](const double value) { return shown(study, name, value); };
  const auto bound = [&](const std::optional<double> &value) {
    return value ? Json(in_unit(*value)) : Json();
  };
  Json result{{"result", column_name(name)},
              {"unit", unit_of(study, name)},
              {"runs", spread.n},
              {"nominal", in_unit(study.nominal[i])}};
  if (spread.n == 0)
    return result;
  result.update({{"least", in_unit(spread.least)},
                 {"largest", in_unit(spread.largest)},
                 {"mean", in_unit(spread.mean)},
                 {"deviation", in_unit(spread.deviation)},
                 {"least_in_run", spread.least_run + 1},
                 {"largest_in_run", spread.largest_run + 1}});
  Json &quantiles = result["quantiles"] = Json::array();
  for (std::size_t q = 0; q < spread.quantiles.size(); ++q)
    quantiles.push_back({{"probability", study.settings.quantiles[q]},
                         {"value", in_unit(spread.quantiles[q].value)},
                         {"low", bound(spread.quantiles[q].low)},
                         {"high", bound(spread.quantiles[q].high)}});
  return result;
}

Json summary_of(const StudyResults &study, const ResultName &name, const Effect &effect) {
  Json result = Json::object();
  if (effect.rank_correlation)
    result["rank_correlation"] = *effect.rank_correlation;
  if (effect.first)
    result["first"] = {
        {"value", effect.first->value}, {"low", effect.first->low}, {"high", effect.first->high}};
  if (effect.total)
    result["total"] = {
        {"value", effect.total->value}, {"low", effect.total->low}, {"high", effect.total->high}};
  if (effect.elementary)
    result["elementary"] = {{"mean", shown(study, name, effect.elementary->mean)},
                            {"mean_size", shown(study, name, effect.elementary->mean_size)},
                            {"deviation", shown(study, name, effect.elementary->deviation)},
                            {"n", effect.elementary->n}};
  return result;
}

void write_summary(const StudyResults &study, const std::vector<Sensitivity> &effects,
                   const std::string &case_name, const std::string &folder) {
  Json summary{{"case", case_name},
               {"program", {{"version", program_version()}, {"deal_ii", deal_ii_version()}}},
               {"method", study.settings.row().word},
               {"seed", study.settings.seed},
               {"runs", study.runs.size()}};
  Json &counts = summary["outcomes"] = Json::object();
  for (const auto &row : outcomes)
    counts[row.word] = study.count(row.value);
  Json &variables = summary["variables"] = Json::array();
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    variables.push_back({{"name", study.variables[i]}, {"varies", study.described[i]}});
  Json &results = summary["results"] = Json::array();
  for (std::size_t i = 0; i < study.names.size(); ++i)
    if (study.names[i].is_of_the_run())
      results.push_back(summary_of(study, i));
  Json &sensitivities = summary["sensitivities"] = Json::array();
  for (const Sensitivity &of : effects) {
    Json by_variable = Json::object();
    for (std::size_t i = 0; i < of.effects.size(); ++i)
      by_variable[study.variables[i]] = summary_of(study, study.names[of.name], of.effects[i]);
    sensitivities.push_back(
        {{"result", column_name(study.names[of.name])}, {"effects", by_variable}});
  }
  Json &convergence = summary["convergence"] = Json::array();
  for (std::size_t i = 0; i < study.names.size(); ++i)
    if (study.names[i].of == ResultName::Of::quantity)
      for (const std::size_t n : convergence_runs(study)) {
        std::vector<double> numbers = study.column(i, n);
        std::sort(numbers.begin(), numbers.end());
        Json quantiles = Json::array();
        for (const double probability : study.settings.quantiles)
          quantiles.push_back(numbers.empty() ? Json()
                                              : Json(quantile(numbers, probability).value));
        convergence.push_back(
            {{"result", column_name(study.names[i])}, {"runs", n}, {"quantiles", quantiles}});
      }
  summary["cost"] = {{"seconds", study.seconds},
                     {"processes", study.n_processes},
                     {"threads", study.n_threads},
                     {"resumed", study.n_resumed}};
  summary["remarks"] = study.remarks;
  write_file(folder + "/study.json",
             summary.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

} // namespace

void write_study_files(const StudyResults &study, const std::vector<Sensitivity> &effects,
                       const std::string &case_name, const std::string &folder) {
  write_runs(study, folder);
  write_hdf5(study, folder);
  write_spread(study, folder);
  write_sensitivities(study, effects, folder);
  write_failed(study, folder);
  write_summary(study, effects, case_name, folder);
}

} // namespace frictionbeam::study
