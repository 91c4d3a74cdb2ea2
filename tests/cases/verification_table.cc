// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes doc/verification.md: runs every case of prm/verification with the program and puts what
// the summary.json files say into tables. doc/verification.sh calls it.
//
// verification_table PROGRAM FOLDER
#include "run_program.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace {

using program::Quantity;
using program::Run;

/// Further runs of a case, beside the one without options.
const std::map<std::string, std::vector<std::string>> variants = {
    {"slab", {"Slab/GS = 1e2", "Slab/GS = 1e4", "Slab/GS = 1e9"}},
    {"oscillator",
     {"Time/Integrator = newmark", "Time/Integrator = generalized_alpha",
      "Time/Integrator = moreau_jean", "Time/Integrator = nonsmooth_alpha"}},
    {"rack_closed_form",
     {"Rack/Length ratio = 0.45", "Rack/Length ratio = 0.8", "Rack/Length ratio = 1.4"}}};

struct Case {
  std::string name, option;
  Run run;
};

std::string text(const double value, const int digits) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

/// The comment at the head of a parameter file.
std::string head_of(const std::filesystem::path &file) {
  std::ifstream in(file);
  std::string head;
  for (std::string line; std::getline(in, line) && !line.empty() && line[0] == '#';)
    head += line.substr(std::min<std::size_t>(line.size(), 2)) + '\n';
  return head;
}

/// The largest error of the figures above 1 % of the largest with the same unit.
std::optional<double> largest_error(const Run &run) {
  std::map<std::string, double> largest;
  for (const Quantity &q : run.quantities)
    largest[q.unit] = std::max(largest[q.unit], std::abs(q.reference.value_or(0.)));
  std::optional<double> result;
  for (const Quantity &q : run.quantities)
    if (q.error && (largest[q.unit] == 0. || std::abs(*q.reference) > 0.01 * largest[q.unit]))
      result = std::max(result.value_or(0.), *q.error);
  return result;
}

std::string sources(const Run &run) {
  std::string result;
  for (const Quantity &q : run.quantities)
    if (!q.source.empty() && result.find(q.source) == std::string::npos)
      result += (result.empty() ? "" : "; ") + q.source;
  return result;
}

void print(const std::filesystem::path &folder, const std::vector<Case> &cases) {
  std::cout
      << "# Verification\n\n"
         "What the program answers where the answer is known: closed forms, exact solutions of "
         "the discrete\nmodel, published cases. This page is written by `doc/verification.sh`, "
         "which runs the cases in\n`prm/verification` and reads their `summary.json`; each row "
         "can be had by itself with\n`./run prm/verification/<case>.prm`, the option after "
         "`--set`. The tests (`./test -R case/`) hold the\nerrors below their bounds.\n\n"
         "Errors are relative to the reference, absolute where that is 0. The first table shows "
         "the largest\nerror of a case over the figures above 1 % of the largest with the same "
         "unit.\n\n"
         "| case | option | figures | largest error | status | wall time [s] | source |\n"
         "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Case &one : cases) {
    const auto error = largest_error(one.run);
    std::cout << "| [" << one.name << "](#" << one.name << ") | "
              << (one.option.empty() ? "" : "`" + one.option + "`") << " | "
              << one.run.quantities.size() << " | " << (error ? text(*error, 2) : "") << " | "
              << one.run.status << " | " << text(one.run.wall_seconds, 2) << " | "
              << sources(one.run) << " |\n";
  }
  std::string last;
  for (const Case &one : cases) {
    if (one.name != last)
      std::cout << "\n## " << one.name << "\n\n```\n"
                << head_of(folder / (one.name + ".prm")) << "```\n";
    last = one.name;
    std::cout
        << '\n'
        << (one.option.empty() ? "As it stands:" : "`" + one.option + "`:") << "\n\n"
        << "| quantity | value | unit | reference | error |\n| --- | --- | --- | --- | --- |\n";
    for (const Quantity &q : one.run.quantities)
      std::cout << "| " << q.name << " | " << text(q.value, 8) << " | " << q.unit << " | "
                << (q.reference ? text(*q.reference, 8) : "") << " | "
                << (q.error ? text(*q.error, 2) : "") << " |\n";
  }
}

std::vector<Case> run_all(const std::string &binary, const std::filesystem::path &folder) {
  std::vector<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".prm")
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  std::vector<Case> cases;
  for (const std::string &name : names) {
    std::vector<std::string> options{""};
    if (const auto more = variants.find(name); more != variants.end())
      options.insert(options.end(), more->second.begin(), more->second.end());
    for (const std::string &option : options) {
      std::cerr << name << ' ' << option << '\n';
      const std::vector<std::string> words =
          option.empty() ? std::vector<std::string>{} : std::vector<std::string>{"--set", option};
      cases.push_back(
          {name, option, program::run(binary, (folder / (name + ".prm")).string(), words)});
      if (!cases.back().run.summary)
        throw std::runtime_error(name + " has not run:\n" + cases.back().run.output);
    }
  }
  return cases;
}

} // namespace

int main(int argc, char **argv) {
  try {
    if (argc != 3)
      throw std::runtime_error("verification_table PROGRAM FOLDER");
    print(argv[2], run_all(argv[1], argv[2]));
    return 0;
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
