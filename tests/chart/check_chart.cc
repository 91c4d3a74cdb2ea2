// SPDX-License-Identifier: LGPL-2.1-or-later
// `frictionbeam chart` shall measure each configuration in a process of its own, show failures,
// mark the efficient front and name the cheapest configurations; bad lists shall be refused with a
// message. Errors are those of the runs by themselves.
//   check_chart PROGRAM FOLDER_OF_LISTS
#include "../cases/run_program.h"
#include "../check.h"
#include "base/csv_row.h"

#include <cmath>
#include <iostream>
#include <map>

namespace {

namespace fs = std::filesystem;
using Row = std::map<std::string, std::string>;

std::vector<Row> read_csv(const fs::path &path) {
  std::istringstream lines(program::text_of(path));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = frictionbeam::csv_fields(line);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = frictionbeam::csv_fields(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i)
      rows.back()[names[i]] = values[i];
  }
  return rows;
}

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

void check_list(const std::string &binary, const fs::path &lists) {
  const program::TemporaryFolder folder;
  const program::Run run = program::execute(
      {binary, "chart", (lists / "list.prm").string(), "--output-directory", folder.path.string()});
  CHECK(run.exit_status == 0);
  std::cout << run.output;
  const std::vector<Row> rows = read_csv(folder.path / "list.csv");
  CHECK(rows.size() == 7);
  if (rows.size() != 7)
    return;

  const std::vector<std::string> steps = {"0.1", "0.05", "0.025"};
  for (std::size_t i = 0; i < 3; ++i) {
    const program::Run alone =
        program::run(binary, (lists / "../../prm/verification/oscillator.prm").string(),
                     {"--set", "Time/Integrator = newmark", "--set", "Time/Step = " + steps[i]});
    CHECK(rows[i].at("problem").empty());
    CHECK(std::abs(std::stod(rows[i].at("error")) - alone["max_error"]) <= 1e-12);
    CHECK(std::stod(rows[i].at("seconds_median")) > 0.);
    CHECK(std::stod(rows[i].at("process_seconds")) > std::stod(rows[i].at("seconds_median")));
    CHECK(std::stod(rows[i].at("peak_memory_mb")) > 1.);
  }
  CHECK(rows[3].at("problem") == "not converged");
  CHECK(rows[3].at("error").empty());
  CHECK(rows[4].at("error") == "0.5" && rows[4].at("seconds_median") == "0.25");
  CHECK(contains(rows[6].at("problem"), "exit status 127"));

  // Nothing on the front is beaten in both, and everything else is.
  for (const Row &one : rows) {
    if (!one.at("problem").empty()) {
      CHECK(one.at("efficient") == "0");
      continue;
    }
    bool beaten = false;
    for (const Row &other : rows)
      beaten =
          beaten || (&other != &one && other.at("problem").empty() &&
                     std::stod(other.at("error")) <= std::stod(one.at("error")) &&
                     std::stod(other.at("seconds_median")) < std::stod(one.at("seconds_median")));
    CHECK((one.at("efficient") == "1") == !beaten);
  }

  const std::string page = program::text_of(folder.path / "list.md");
  CHECK(contains(page, "A small chart for a test."));
  CHECK(contains(page, "![Three time steps, and what else there may be](list.svg)"));
  CHECK(contains(page, "steps reach 0.0026, 1 times."));
  CHECK(contains(page, "| 1e-3 | none of these"));
  CHECK(contains(page, "not converged"));
  const std::string svg = program::text_of(folder.path / "list.svg");
  CHECK(contains(svg, "<svg") && contains(svg, "efficient front") && contains(svg, "no answer"));
}

void check_reference_run(const std::string &binary, const fs::path &lists) {
  const program::TemporaryFolder folder;
  const program::Run run =
      program::execute({binary, "chart", (lists / "reference_run.prm").string(),
                        "--output-directory", folder.path.string()});
  CHECK(run.exit_status == 0);
  const std::vector<Row> rows = read_csv(folder.path / "reference_run.csv");
  CHECK(rows.size() == 3);
  if (rows.size() != 3)
    return;
  const double ratio = std::stod(rows[0].at("error")) / std::stod(rows[1].at("error"));
  CHECK(ratio > 3.5 && ratio < 4.5); // straight cells on an arc: order 2
  CHECK(std::stod(rows[2].at("error")) == 0.);
}

/// Cases in other units, and the list's references in SI units.
void check_units(const std::string &binary, const fs::path &lists) {
  const program::TemporaryFolder folder;
  const program::Run run = program::execute({binary, "chart", (lists / "units/units.prm").string(),
                                             "--output-directory", folder.path.string()});
  CHECK(run.exit_status == 0);
  const std::vector<Row> rows = read_csv(folder.path / "units.csv");
  CHECK(rows.size() == 2);
  for (const Row &row : rows)
    CHECK(row.at("problem").empty() && std::stod(row.at("error")) < 1e-9);
}

void check_message(const std::string &binary, const fs::path &list) {
  const program::Run run = program::execute({binary, "chart", list.string()});
  CHECK(run.exit_status == 1);
  std::istringstream lines(program::text_of(list));
  const std::string prefix = "# expect: ";
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, prefix.size(), prefix) == 0 &&
        !contains(run.output, line.substr(prefix.size()))) {
      CHECK(!"an expected text is missing");
      std::cerr << list << ": expected '" << line.substr(prefix.size()) << "', read\n"
                << run.output;
    }
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3)
    return 1;
  const std::string binary = argv[1];
  const fs::path lists = argv[2];
  try {
    check_list(binary, lists);
    check_reference_run(binary, lists);
    check_units(binary, lists);
    for (const char *name : {"misspelt_entry", "no_curve", "values_without_entry", "missing_case"})
      check_message(binary, lists / (std::string(name) + ".prm"));
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return check::report();
}
