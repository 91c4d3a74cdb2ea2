// SPDX-License-Identifier: LGPL-2.1-or-later
// A run of a body that is ended by SIGKILL, SIGTERM and SIGINT, each on a finer mesh or in a later
// step, and resumed each time shall leave the same files as one that was not, to the last byte, and
// the same summary but for its cost. By one process, or by two under mpirun, of which the first one
// gets the signal.
//   resume_body "PROGRAM" | "MPIRUN --options PROGRAM" CASE.prm [--set "Section/Entry = value"]...
#include "cut_runs.h"

#include <signal.h>

#include <chrono>
#include <thread>

namespace fs = std::filesystem;

namespace {

/// End the run that is at work in @p folder by @p signal, some increments after its checkpoint has
/// grown: on a finer mesh than the one where it was begun, or in a later step.
/// @return whether that was done before the run had @p ended
bool end_on_finer_mesh(const fs::path &folder, const int signal, const bool &ended) {
  const fs::path checkpoint = folder / "unfinished" / "checkpoint.bin";
  const auto size = [&]() -> std::uintmax_t {
    std::error_code none_yet;
    const std::uintmax_t bytes = fs::file_size(checkpoint, none_yet);
    return none_yet ? 0 : bytes;
  };
  const std::uintmax_t first = size();
  std::string last;
  for (int n_changes = 0; !ended; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    const std::string now = size() > first + first / 4 ? program::text_of(checkpoint) : last;
    n_changes += now != last;
    last = now;
    if (n_changes < 2)
      continue;
    long process = 0;
    std::ifstream(folder / ".lock") >> process;
    return process > 0 && kill(process, signal) == 0;
  }
  return false;
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 3)
    return 2;
  const program::TemporaryFolder work;
  const fs::path whole = work.path / "whole", cut = work.path / "cut";
  std::istringstream start(argv[1]);
  std::vector<std::string> words{std::istream_iterator<std::string>(start), {}};
  words.insert(words.end(), argv + 2, argv + argc);
  const auto run = [&](const std::vector<std::string> &options, const fs::path &folder) {
    std::vector<std::string> all = words;
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"--output-directory", folder.string()});
    return program::execute(all);
  };
  CHECK(run({"--set", "Output/Checkpoint interval = 0"}, whole).exit_status == 0);
  CHECK(!fs::exists(whole / "checkpoint.bin"));

  std::vector<std::string> often{"--set", "Output/Checkpoint interval = 1e-9"};
  for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
    bool ended = false, cut_in_time = false;
    std::thread killer([&]() { cut_in_time = end_on_finer_mesh(cut, signal, ended); });
    const program::Run part = run(often, cut);
    ended = true;
    killer.join();
    CHECK(cut_in_time);
    CHECK(!fs::exists(cut / "summary.json"));
    CHECK(fs::exists(cut / "unfinished" / "checkpoint.bin"));
    if (signal != SIGKILL) {
      CHECK(part.exit_status == 128 + signal);
      CHECK(part.output.find("Interrupted at time") != std::string::npos);
      CHECK(part.output.find("--resume goes on from it") != std::string::npos);
    }
    often = {"--set", "Output/Checkpoint interval = 1e-9", "--resume"};
  }
  const program::Run last = run(often, cut);
  CHECK(last.exit_status == 0);
  CHECK(last.output.find("There is no checkpoint") == std::string::npos);
  cut_runs::check_same(cut, whole);
  return check::report();
}
