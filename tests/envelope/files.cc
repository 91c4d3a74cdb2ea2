// SPDX-License-Identifier: LGPL-2.1-or-later
// Code checks, nozzles and tables of a transient step shall be those of its worst instants and not
// of its last one, whatever the output interval, on few unknowns too. References: reactions.csv
// with a row for every time step; the run ended at the instant of the largest stress, with B31.3's
// formula written out here for straight pipe; the run on few unknowns with every time step put out.
// A rigid stop that is struck shall show its impulse and say that it has no peak force.
// With event they are those of the motion between its instants: the same whatever Time/Step.
//   test_envelope_files quake|reduced|struck|between PROGRAM CASE.prm
#include "../cases/run_program.h"
#include "../check.h"

#include <algorithm>

namespace {

namespace fs = std::filesystem;
using Row = std::map<std::string, std::string>;

/// Rows of a csv file without quoted fields.
std::vector<Row> rows_of(const fs::path &file) {
  std::istringstream lines(program::text_of(file));
  const auto fields = [](const std::string &line) {
    std::vector<std::string> result(1);
    for (const char c : line)
      if (c == ',')
        result.emplace_back();
      else
        result.back() += c;
    return result;
  };
  std::vector<Row> rows;
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = fields(line);
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = fields(line);
    Row row;
    for (std::size_t i = 0; i < std::min(header.size(), values.size()); ++i)
      row[header[i]] = values[i];
    rows.push_back(row);
  }
  CHECK(!rows.empty());
  return rows;
}

double number(const Row &row, const std::string &name) {
  return row.count(name) > 0 && !row.at(name).empty() ? std::stod(row.at(name)) : std::nan("");
}

/// The first row in which all these columns are so.
Row find(const std::vector<Row> &rows, const Row &wanted) {
  for (const Row &row : rows)
    if (std::all_of(wanted.begin(), wanted.end(), [&](const auto &column) {
          return row.count(column.first) > 0 && row.at(column.first) == column.second;
        }))
      return row;
  throw std::runtime_error("A row is missing.");
}

/// SL of NPS 8, schedule 40, by B31.3, 320.2, without pressure, at a station of line.csv.
double longitudinal_stress(const Row &station) {
  const double pi = 3.14159265358979323846, D = 0.2191, t = 0.00818, d = D - 2. * t,
               A = pi * (D - t) * t, Z = pi / 32. * (std::pow(D, 4) - std::pow(d, 4)) / D,
               Sa = std::abs(number(station, "N")) / A,
               Sb = std::hypot(number(station, "My"), number(station, "Mz")) / Z,
               St = number(station, "Mx") / (2. * Z);
  return std::hypot(Sa + Sb, 2. * St);
}

void check_quake(const std::string &binary, const std::string &file) {
  const program::TemporaryFolder work;
  const auto run = [&](const std::string &name, std::vector<std::string> options) {
    options.insert(options.end(),
                   {"--set", "Output/VTU = false", "--set", "Output/Report = false"});
    const program::Run result = program::run(binary, file, options, work.path / name);
    CHECK(result.exit_status == 0);
    return result;
  };
  const program::Run whole = run("whole", {});
  const auto uses = rows_of(work.path / "whole/nozzles.csv");
  const Row use = find(uses, {{"step", "quake"}});
  // The limit of moments is exceeded, of mz before all, as the quantity has it.
  CHECK(number(use, "utilization") > 1.);
  CHECK_NEAR(number(use, "utilization"), whole["m"] / 3000., 1e-9);
  CHECK_NEAR(std::abs(number(use, "mz")), whole["m"], 1e-9);

  // Every time step put out: nothing but the output changes.
  run("every", {"--set", "Time/Output interval = 0"});
  for (const char *const file : {"nozzles.csv", "stresses.csv", "envelope.csv"})
    CHECK(program::text_of(work.path / "whole" / file) ==
          program::text_of(work.path / "every" / file));
  double ratio = 0., most = 0.;
  for (const Row &row : rows_of(work.path / "every/reactions.csv")) {
    if (row.at("restraint") != "anc.1")
      continue;
    for (const char *const force : {"fx", "fy", "fz"})
      ratio = std::max(ratio, std::abs(number(row, force)) / 5000.);
    for (const char *const moment : {"mx", "my", "mz"})
      ratio = std::max(ratio, std::abs(number(row, moment)) / 3000.);
    most = std::max(most, number(row, "mz"));
  }
  CHECK_NEAR(number(use, "utilization"), ratio, 1e-9);
  const Row mz = find(rows_of(work.path / "whole/envelope.csv"),
                      {{"step", "quake"}, {"name", "anc.1"}, {"what", "mz"}});
  CHECK_NEAR(number(mz, "largest"), most, 1e-9);

  // The largest stress at A, and the run that ends then.
  const Row stress =
      find(rows_of(work.path / "whole/stresses.csv"), {{"case", "quake"}, {"s", "0"}});
  const double duration = number(stress, "time") - 1.;
  CHECK(duration > 0. && duration < 7.999);
  std::ostringstream entry;
  entry << std::setprecision(15) << "Step quake/Duration = " << duration;
  run("until", {"--set", entry.str()});
  const Row then = find(rows_of(work.path / "until/line.csv"), {{"step", "quake"}, {"s", "0"}}),
            last = find(rows_of(work.path / "whole/line.csv"), {{"step", "quake"}, {"s", "0"}});
  CHECK_NEAR(number(stress, "stress"), longitudinal_stress(then), 1e-6);
  CHECK(number(stress, "stress") > 1.5 * longitudinal_stress(last));
  std::cout << "utilization " << number(use, "utilization") << ", SL at A "
            << number(stress, "stress") << " Pa\n";
}

/// Numbers of envelope.csv by what they are, of some parts.
std::map<std::string, std::array<double, 2>> extremes_of(const fs::path &file, const bool of_line) {
  std::map<std::string, std::array<double, 2>> result;
  for (const Row &row : rows_of(file))
    if (of_line || row.at("part") == "support" || row.at("part") == "restraint")
      result[row.at("what") + ' ' + row.at("part") + ' ' + row.at("name") + ' ' + row.at("s")] = {
          {number(row, "least"), number(row, "largest")}};
  return result;
}

void compare(const fs::path &one, const fs::path &other, const bool of_line) {
  const auto found = extremes_of(one, of_line), wanted = extremes_of(other, of_line);
  CHECK(found.size() == wanted.size() && found.size() > 20);
  std::map<std::string, double> size; // of what is alike
  const auto kind = [](const std::string &what) { return what.substr(0, what.find(' ')); };
  for (const auto &[what, values] : wanted)
    for (const double value : values)
      size[kind(what)] = std::max(size[kind(what)], std::abs(value));
  for (const auto &[what, values] : wanted)
    for (const unsigned int i : {0u, 1u})
      CHECK(std::abs(found.at(what)[i] - values[i]) <= 1e-8 * size[kind(what)]);
}

void check_reduced(const std::string &binary, const std::string &file) {
  const program::TemporaryFolder work;
  const auto run = [&](const std::string &name, const std::string &interval,
                       const std::string &code) {
    const program::Run result =
        program::run(binary, file,
                     {"--set", "Time/Modes = 20", "--set", "Time/Output interval = " + interval,
                      "--set", "Stress/Code = " + code},
                     work.path / name);
    CHECK(result.exit_status == 0);
    CHECK(result.output.find("reduced from") != std::string::npos);
    const bool says_so =
        result.output.find("supports and reactions are looked at in all") != std::string::npos;
    CHECK(says_so == (interval != "0" && code == "none"));
    return work.path / name / "envelope.csv";
  };
  const fs::path every = run("every", "0", "none");
  compare(run("some", "0.1", "none"), every, false); // supports and restraints
  compare(run("checked", "0.1", "B31.3"), every, true);
}

void check_struck(const std::string &binary, const std::string &file) {
  const program::TemporaryFolder work;
  const program::Run run =
      program::run(binary, file, {"--set", "Output/VTU = false"}, work.path / "whip");
  CHECK(run.exit_status == 0);
  boost::property_tree::ptree tree;
  boost::property_tree::read_json((work.path / "whip/summary.json").string(), tree);
  const auto support =
      tree.get_child("envelopes").front().second.get_child("supports").front().second;
  CHECK(support.get<unsigned int>("impacts") > 0);
  CHECK_NEAR(support.get<double>("impulse"), run["impulse"], 1e-9); // as the quantity has it
  const std::string report = program::text_of(work.path / "whip/report.html");
  CHECK(report.find("rigid, impact: no peak force") != std::string::npos);
  const Row impact =
      find(rows_of(work.path / "whip/envelope.csv"), {{"name", "stop"}, {"what", "impact"}});
  CHECK(number(impact, "largest") > 0. && number(impact, "largest") < run["impulse"]);
}

void check_between(const std::string &binary, const std::string &file) {
  const program::TemporaryFolder work;
  const auto run = [&](const std::string &step) {
    const program::Run result =
        program::run(binary, file,
                     {"--set", "Time/Integrator = event", "--set", "Time/Step = " + step, "--set",
                      "Time/Stiffness damping = 0", "--set", "Mesh/Cell length = 9", "--set",
                      "Step shake/Duration = 0.004", "--set", "Output/VTU = false"},
                     work.path / step);
    CHECK(result.exit_status == 0);
    return work.path / step;
  };
  const fs::path one = run("0.004"), many = run("2e-4");
  compare(one / "envelope.csv", many / "envelope.csv", true);
  for (const auto &[table, number_of] :
       {std::pair<const char *, const char *>{"stresses.csv", "stress"},
        {"nozzles.csv", "utilization"}}) {
    const auto found = rows_of(one / table), wanted = rows_of(many / table);
    CHECK(found.size() == wanted.size());
    double largest = 0.;
    for (const Row &row : wanted)
      largest = std::max(largest, number(row, number_of));
    CHECK(largest > 0.);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      CHECK(std::abs(number(found[i], number_of) - number(wanted[i], number_of)) <= 1e-8 * largest);
  }
}

} // namespace

int main(int, char **argv) {
  try {
    if (std::string(argv[1]) == "quake")
      check_quake(argv[2], argv[3]);
    else if (std::string(argv[1]) == "reduced")
      check_reduced(argv[2], argv[3]);
    else if (std::string(argv[1]) == "between")
      check_between(argv[2], argv[3]);
    else
      check_struck(argv[2], argv[3]);
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return check::report();
}
