// SPDX-License-Identifier: LGPL-2.1-or-later
// `frictionbeam study` shall find of two sliders (sliders.prm) what is known of them exactly, and
// the same numbers as runs that are made one by one with --set, whatever the number of threads and
// processes, and after it was killed.
//   check_study PROGRAM MPIRUN FOLDER TEST     MPIRUN may be empty; TEST: quantiles, ..., or a file
//   of bad input
#include "study.h"

#include "../check.h"

#include <signal.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace {

/// Rows of a csv file without quotes.
std::vector<std::vector<std::string>> rows_of(const std::string &text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');)
      rows.back().push_back(field);
  }
  return rows;
}

/// Runs of a study shall have the quantities of runs that --set makes, to rounding: what they share
/// is summed in another order.
/// @param named what varies under names that are no entries
void check_one_by_one(const std::string &file, const Options &settings,
                      const std::vector<std::pair<std::string, std::string>> &named = {}) {
  const program::TemporaryFolder into;
  const Study found = study(file, settings, into.path / "results");
  CHECK(found.exit_status == 0);
  const auto rows = rows_of(found.runs);
  const auto column = [&](const std::string &name) {
    const auto at = std::find(rows[0].begin(), rows[0].end(), name);
    CHECK(at != rows[0].end());
    return at - rows[0].begin();
  };
  auto entries = named;
  for (const std::string &name : rows[0])
    if (name.rfind("Support ", 0) == 0 && name.find('/') != std::string::npos)
      entries.push_back({name, name});
  CHECK(!entries.empty());
  for (const std::size_t run : {std::size_t(1), rows.size() / 2, rows.size() - 1}) {
    Options options;
    for (const auto &[variable, entry] : entries)
      options.insert(options.end(), {"--set", entry + " = " + rows[run][column(variable)]});
    const program::Run alone = program::run(program_path, file, options);
    CHECK(alone.exit_status == 0);
    for (const program::Quantity &quantity : alone.quantities)
      CHECK_NEAR(std::stod(rows[run][column("quantity " + quantity.name)]), quantity.value, 1e-9);
  }
}

/// A rest may be called as the half of a guide is; its places vary all the same.
void check_name_of_a_half() {
  const program::TemporaryFolder into;
  const auto renamed = [](std::string text) {
    for (auto at = text.find("Support slide"); at != std::string::npos;
         at = text.find("Support slide", at + 1))
      text.insert(at + 13, ".plus");
    return text;
  };
  const auto text_of = [](const std::string &file) {
    std::ifstream in(folder + "/" + file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  std::ofstream(into.path / "two_sliders.prm") << renamed(text_of("two_sliders.prm"));
  std::ofstream(into.path / "sliders.prm") << renamed(text_of("sliders.prm"));
  const std::string f = "/Friction coefficient";
  check_one_by_one((into.path / "sliders.prm").string(),
                   independent + Options{"Study/Method = latin hypercube", "Study/Runs = 20",
                                         "Vary friction/Entry = Support *" + f});
}

/// A star leaves out what has no friction, and says so.
void check_star() {
  const program::TemporaryFolder into;
  const Study found = study(folder + "/sliders_and_rod.prm", independent, into.path / "results");
  CHECK(found.exit_status == 0);
  CHECK(found.runs.find("Support slide.2/Friction coefficient") != std::string::npos);
  CHECK(found.runs.find("Support rod") == std::string::npos);
  CHECK(found.output.find("whose Friction coefficient is 0: rod.") != std::string::npos);
}

void check_one_by_one() {
  const std::string f = "/Friction coefficient";
  check_one_by_one(folder + "/sliders.prm",
                   independent + Options{"Study/Method = latin hypercube", "Study/Runs = 20"});
  // With bends, lift-off, heating and cooling, on a line that is shared from run to run; then one
  // entry of another kind, by which it is not.
  const std::string rack = folder + "/rack.prm";
  check_one_by_one(rack, {"Study/Runs = 12"},
                   {{"west", "Support west" + f}, {"gap", "Support stop/Gap"}});
  check_one_by_one(rack,
                   {"Study/Runs = 6", "Vary west/Entry = Load hot/Temperature",
                    "Vary west/From = 80", "Vary west/To = 120"},
                   {{"west", "Load hot/Temperature"}, {"gap", "Support stop/Gap"}});
  // Factors stand in runs.csv as the values that they make.
  const Options factors = {"Study/Method = latin hypercube", "Study/Runs = 6",
                           "Vary friction/Meaning = factor", "Vary friction/From = 0.5",
                           "Vary friction/To = 1.5"};
  check_one_by_one(folder + "/sliders.prm", factors, {{"friction", "Support slide" + f}});
  check_one_by_one(folder + "/sliders.prm", independent + factors);
  check_name_of_a_half();
  check_star();
}

/// Runs come to what a run of its own comes to: of a line in space; where one contact by itself may
/// jam, or several together have other equilibria.
void check_alone() {
  const std::string f = "/Friction coefficient";
  check_one_by_one(folder + "/plant_line.prm", {"Study/Runs = 12"},
                   {{"gap", "Support guides/Gap"}});
  check_one_by_one(folder + "/jamming.prm", {"Study/Runs = 12"});
  check_one_by_one(folder + "/together.prm", {}, {{"f", "Support rests" + f}});
}

/// Runs without an answer are counted and listed with their entries, and the others stand.
void check_failed() {
  // 250 N and 500 N are held by friction of 1000 N and 2000 N from f = 0.25 on.
  const program::TemporaryFolder into;
  const Study lost = study(folder + "/held.prm", {}, into.path / "results");
  CHECK(lost.exit_status == 2);
  CHECK(lost.json.at("outcomes").at("no_equilibrium") == 1);
  CHECK(lost.json.at("outcomes").at("converged") == 2);
  CHECK(lost.failed.find("1,no_equilibrium,") != std::string::npos);
  CHECK(lost.failed.find(",0.2\n") != std::string::npos);
  CHECK(lost.result("quantity friction").at("runs") == 2);
  CHECK_NEAR(lost.result("quantity friction").at("least").get<double>(), 750., 1e-9);
  // Each value for itself is allowed; a dynamic coefficient above the static one is not.
  const program::TemporaryFolder other;
  const Study refused = study(folder + "/dynamic.prm", {}, other.path / "results");
  CHECK(refused.exit_status == 2);
  CHECK(refused.json.at("outcomes").at("refused") == 1);
  CHECK(refused.json.at("outcomes").at("converged") == 3);
  CHECK(refused.failed.find("Dynamic friction coefficient") != std::string::npos);
}

/// Whether two studies have the same numbers, to the last bit.
void check_same(const Study &a, const Study &b) {
  CHECK(a.exit_status == b.exit_status);
  CHECK(!a.runs.empty() && a.runs == b.runs);
  CHECK(!a.spread.empty() && a.spread == b.spread);
  CHECK(a.json.at("results") == b.json.at("results"));
  CHECK(a.json.at("sensitivities") == b.json.at("sensitivities"));
}

/// One thread, three threads, two and three processes.
void check_processes() {
  const std::string file = folder + "/rack.prm";
  const program::TemporaryFolder into;
  const auto run = [&](const std::string &name, const Options &settings, const Options &start) {
    return study(file, Options{"Study/Runs = 30"} + settings, into.path / name, start);
  };
  const Study one = run("one", {"Study/Threads = 1"}, {});
  check_same(one, run("threads", {"Study/Threads = 3"}, {}));
  if (!mpirun.empty())
    for (const std::string n : {"2", "3"})
      check_same(one, run("processes" + n, {}, {mpirun, "--oversubscribe", "-np", n}));
}

/// Many threads that read a formula at once, whose errors are held back, end as one does.
void check_formula() {
  const program::TemporaryFolder into;
  CHECK(study(folder + "/formula.prm", {}, into.path / "results").exit_status == 0);
}

/// Killed and resumed, twice: the same numbers as from a study that was not. With another table its
/// runs are refused.
void check_resume() {
  const program::TemporaryFolder into;
  const std::string file = into.path / "rack.prm";
  std::ofstream(file) << "include " + folder +
                             "/rack.prm\n"
                             "subsection Load hot\n"
                             "  set History = file heat.csv\n"
                             "end\n";
  const auto write_table = [&](const std::string &end) {
    std::ofstream(into.path / "heat.csv") << "0, 1\n10, " + end + "\n";
  };
  write_table("1.1");
  const Options settings = {"Study/Runs = 300", "Study/Threads = 2"};
  const Study whole = study(file, settings, into.path / "whole");
  const fs::path cut = into.path / "cut";
  for (const int signal : {SIGKILL, SIGTERM}) {
    std::atomic<bool> ended{false};
    Study first;
    std::thread run([&]() {
      first = study(file, settings, cut, {}, signal == SIGKILL ? Options{} : Options{"--resume"});
      ended = true;
    });
    const fs::path journal = cut / "unfinished" / "runs.0.bin";
    std::error_code none_yet;
    const auto has_begun = [&]() { // the resumed one, when it has gathered what the first one left
      return signal == SIGKILL || fs::exists(cut / "unfinished" / "runs.done.bin");
    };
    while (!ended && !(has_begun() && fs::file_size(journal, none_yet) > 40000 && !none_yet))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    long process = 0;
    std::ifstream(cut / ".lock") >> process;
    if (!ended && process > 0)
      kill(process, signal);
    run.join();
    CHECK(first.exit_status != 0);
  }
  write_table("1.2");
  const Study refused = study(file, settings, cut, {}, {"--resume"});
  CHECK(refused.exit_status == 1);
  CHECK(refused.output.find("of tables or laws that have changed") != std::string::npos);
  write_table("1.1");
  const Study resumed = study(file, settings, cut, {}, {"--resume"});
  check_same(whole, resumed);
  CHECK(resumed.json.at("cost").at("resumed") > 0);
  CHECK(!fs::exists(cut / "unfinished"));
}

/// Bad input ends with exit status 1, and each line '# expect: TEXT' of the file is said.
void check_message(const std::string &file) {
  const program::TemporaryFolder into;
  const Study found = study(file, {}, into.path / "results");
  CHECK(found.exit_status == 1);
  std::istringstream lines(program::text_of(file));
  const std::string mark = "# expect: ";
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(mark, 0) == 0) {
      const bool is_said = found.output.find(line.substr(mark.size())) != std::string::npos;
      CHECK(is_said);
      if (!is_said)
        std::cerr << line << "\n" << found.output;
    }
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 5)
    return 2;
  program_path = argv[1];
  mpirun = argv[2];
  folder = argv[3];
  const std::string test = argv[4];
  if (test == "quantiles")
    check_quantiles();
  else if (test == "samples")
    check_samples();
  else if (test == "ranks")
    check_ranks_of_lists();
  else if (test == "units")
    check_units();
  else if (test == "sobol_indices")
    check_sobol_indices();
  else if (test == "morris")
    check_morris();
  else if (test == "places")
    check_places();
  else if (test == "one_by_one")
    check_one_by_one();
  else if (test == "alone")
    check_alone();
  else if (test == "failed")
    check_failed();
  else if (test == "formula")
    check_formula();
  else if (test == "processes")
    check_processes();
  else if (test == "resume")
    check_resume();
  else
    check_message(folder + "/" + test);
  return check::report();
}
