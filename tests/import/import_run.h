// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../cases/run_program.h"
#include "../check.h"

#include <cmath>
#include <iostream>

/// Runs of `frictionbeam import`, and what they leave behind.
namespace fs = std::filesystem;

inline std::string program_path, folder;
inline std::vector<std::string> usual_options() {
  return {"--attributes", "caesar", "--support-map", folder + "/supports.txt"};
}

/// What an import left behind.
struct Imported {
  program::Run run;
  std::string parameters; ///< text of the parameter file
};

inline Imported import_text(const std::string &text, const std::vector<std::string> &options,
                            const fs::path &place) {
  const std::string file = (place / "line.pcf").string(), output = (place / "line.prm").string();
  std::ofstream(file, std::ios::binary) << text;
  std::vector<std::string> words{program_path, "import", file, "-o", output, "--overwrite"};
  words.insert(words.end(), options.begin(), options.end());
  Imported result{program::execute(words), ""};
  if (result.run.exit_status == 0)
    result.parameters = program::text_of(output);
  return result;
}

inline Imported import_text(const std::string &text, const std::vector<std::string> &options) {
  const program::TemporaryFolder place;
  return import_text(text, options, place.path);
}

/// A check with what there was instead.
inline void expect(const std::string &what, const bool holds, const std::string &instead = "") {
  if (!check::count(holds, "import", 0))
    std::cerr << what << " does not hold\n" << instead << '\n';
}

/// Forces of supports and restraints by name and step [N, N m], of a run of a parameter file.
inline std::map<std::string, std::vector<double>> forces_of(const std::string &file) {
  const program::TemporaryFolder place;
  const program::Run run = program::run(program_path, file, {"--quiet"}, place.path / "results");
  expect("the run of " + file + " converges", run.exit_status == 0, run.output);
  std::map<std::string, std::vector<double>> result;
  std::istringstream rows(program::text_of(place.path / "results" / "restraint_forces.csv"));
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    std::vector<std::string> fields;
    std::istringstream in(row);
    for (std::string field; std::getline(in, field, ',');)
      fields.push_back(field);
    std::vector<double> &numbers = result[fields.at(2) + ", " + fields.at(0)];
    for (std::size_t i = 4; i < fields.size(); ++i)
      numbers.push_back(std::stod(fields[i]));
  }
  return result;
}

/// Largest difference over the largest force. @param factor of the second one's forces, then of its
/// moments
inline double difference(const std::map<std::string, std::vector<double>> &one,
                         const std::map<std::string, std::vector<double>> &other,
                         const double force = 1., const double moment = 1.) {
  expect("both have the same supports", one.size() == other.size() && !one.empty());
  double largest = 0., most = 0.;
  for (const auto &[name, numbers] : one) {
    const auto found = other.find(name);
    expect(name + " is in both", found != other.end());
    if (found == other.end())
      continue;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      largest = std::max(largest, std::abs(numbers[i]));
      most = std::max(most, std::abs(numbers[i] - (i < 3 ? force : moment) * found->second.at(i)));
    }
  }
  return most / largest;
}

inline std::string line_in(const std::string &unit) {
  return program::text_of(folder + "/line_" + unit + ".pcf");
}

inline std::string replaced(std::string text, const std::string &what, const std::string &by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos)
    throw std::runtime_error("There is no '" + what + "' in the text.");
  return text.replace(at, what.size(), by);
}
