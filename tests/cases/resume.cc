// SPDX-License-Identifier: LGPL-2.1-or-later
// A run that is killed (kill -9) at several moments and resumed each time shall leave the same
// files as one that was not, to the last byte, and the same summary but for its cost; a checkpoint
// of another case, or of a build with another layout, shall be refused.
//   resume PROGRAM CASE.prm [--set "Section/Entry = value"]...
#include "cut_runs.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace fs = std::filesystem;

namespace {

const char *const history = "history_M.csv";

std::size_t n_lines(const fs::path &file) {
  const std::string text = program::text_of(file);
  return std::count(text.begin(), text.end(), '\n');
}

/// Start the program and kill it when its history has @p n_rows.
/// @return whether it was running then.
bool run_until(std::vector<std::string> words, const fs::path &folder, const std::size_t n_rows) {
  std::vector<char *> arguments;
  for (std::string &word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (freopen("/dev/null", "w", stdout) != nullptr)
      execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (fs::exists(folder / history) && n_lines(folder / history) >= n_rows)
      kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

} // namespace

int main(int argc, char **argv) {
  const program::TemporaryFolder work;
  const fs::path whole = work.path / "whole", cut = work.path / "cut", at_work = cut / "unfinished";
  const std::vector<std::string> options(argv + 3, argv + argc);
  std::vector<std::string> never = options, always = options;
  never.insert(never.end(), {"--set", "Output/Checkpoint interval = 0"});
  always.insert(always.end(), {"--set", "Output/Checkpoint interval = 1e-9"});
  CHECK(program::run(argv[1], argv[2], never, whole).exit_status == 0);
  CHECK(!fs::exists(whole / "checkpoint.bin"));

  const std::size_t n_rows = n_lines(whole / history);
  CHECK(n_rows > 50);
  std::vector<std::string> words{argv[1], argv[2], "--output-directory", cut.string()};
  words.insert(words.end(), always.begin(), always.end());
  for (const double part : {0.01, 0.3, 0.62, 0.9}) {
    CHECK(run_until(words, at_work, static_cast<std::size_t>(part * n_rows)));
    CHECK(!fs::exists(cut / "summary.json"));
    if (part == 0.01)
      words.push_back("--resume");
    else
      CHECK(fs::exists(at_work / "checkpoint.bin"));
  }

  const std::string written = program::text_of(at_work / "checkpoint.bin");
  std::vector<std::string> other = always;
  other.insert(other.end(), {"--resume", "--set", "Solver/Tolerance = 1e-9"});
  const program::Run refused = program::run(argv[1], argv[2], other, cut);
  CHECK(refused.exit_status == 1);
  CHECK(refused.output.find("is of another case: its options --set") != std::string::npos);
  std::vector<std::string> resumed = always;
  resumed.push_back("--resume");
  const std::size_t end_of_line = written.find('\n');
  const int layout = std::stoi(written.substr(written.find_last_of(' ', end_of_line)));
  std::ofstream(at_work / "checkpoint.bin", std::ios::binary)
      << "FrictionBeam checkpoint " << layout - 1 << written.substr(end_of_line);
  const program::Run older = program::run(argv[1], argv[2], resumed, cut);
  CHECK(older.exit_status == 1);
  CHECK(older.output.find("read:    layout " + std::to_string(layout - 1) + "\n  allowed: layout " +
                          std::to_string(layout)) != std::string::npos);
  std::ofstream(at_work / "checkpoint.bin", std::ios::binary)
      << written.substr(0, written.size() / 2);
  const program::Run damaged = program::run(argv[1], argv[2], resumed, cut);
  CHECK(damaged.exit_status == 1);
  CHECK(damaged.output.find("cannot be used") != std::string::npos);
  std::ofstream(at_work / "checkpoint.bin", std::ios::binary) << written;

  for (const fs::path &folder :
       {cut, at_work, at_work / "vtu"}) // as a run killed right at its start leaves them
    std::ofstream(folder / ".write-test") << "test\n";
  const program::Run last = program::run(argv[1], argv[2], resumed, cut);
  CHECK(last.exit_status == 0);
  CHECK(last.output.find("There is no checkpoint") == std::string::npos);
  cut_runs::check_same(cut, whole);
  return check::report();
}
