// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../cases/run_program.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Options = std::vector<std::string>;

/// What a study has said and written.
struct Study {
  int exit_status = -1;
  std::string output;
  Json json;                        ///< study.json
  std::string runs, spread, failed; ///< the tables

  const Json &result(const std::string &name) const {
    for (const Json &one : json.at("results"))
      if (one.at("result") == name)
        return one;
    throw std::runtime_error("There is no result " + name);
  }
  double quantile(const std::string &name, const std::size_t i) const {
    return result(name).at("quantiles").at(i).at("value");
  }
  const Json &effect(const std::string &name, const std::string &variable) const {
    for (const Json &one : json.at("sensitivities"))
      if (one.at("result") == name)
        return one.at("effects").at(variable);
    throw std::runtime_error("There is no sensitivity of " + name);
  }
};

/// Run the program on a file. @param start words in front of it, such as mpirun and its options
inline Study run_study(const std::string &program_path, const std::string &file,
                       const Options &settings, const fs::path &into, const Options &start = {},
                       const Options &more = {}) {
  Options words = start;
  words.insert(words.end(), {program_path, "study", file, "--output-directory", into.string()});
  for (const std::string &setting : settings)
    words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), more.begin(), more.end());
  const program::Run run = program::execute(words);
  Study result;
  result.exit_status = run.exit_status;
  result.output = run.output;
  if (fs::exists(into / "study.json"))
    result.json = Json::parse(program::text_of(into / "study.json"));
  result.runs = program::text_of(into / "runs.csv");
  result.spread = program::text_of(into / "spread.csv");
  result.failed = program::text_of(into / "failed.csv");
  return result;
}

/// The two sliders of two_sliders.prm.
inline constexpr double P1 = 1000., P2 = 2000., F1 = 900., k = 1e5;

inline std::string program_path, mpirun, folder;

inline Study study(const std::string &file, const Options &settings, const fs::path &into,
                   const Options &start = {}, const Options &more = {}) {
  return run_study(program_path, file, settings, into, start, more);
}

inline Study study(const Options &settings) {
  const program::TemporaryFolder into;
  return study(folder + "/sliders.prm", settings, into.path / "results");
}

inline const Options independent = {"Vary friction/Independent = true"};

inline Options operator+(Options all, const Options &more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// What is known of their studies exactly (known.cc).
void check_quantiles();
void check_samples();
void check_ranks_of_lists();
void check_sobol_indices();
void check_morris();
void check_places();
void check_units();
