// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run leaves behind shall be all of one run or nothing, whatever ends it: a scene that is
// refused, a second run into the same folder, kill -9, SIGINT, SIGTERM, a disk that is full. What
// is expected are the files of runs that nothing disturbed, byte by byte.
//   files PROGRAM
#include "place.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <thread>

using namespace files;

namespace {

/// A vibration of some seconds of computing time.
const std::string long_run = bar + R"(
subsection Step swing
  set Analysis = transient
  set Duration = 4
end
subsection Mesh
  set Cell length = 0.1
end
subsection Time
  set Step = 1e-4
  set Output interval = 0.1
end
subsection Output
  set VTU = false
  set Report = false
end
)";

/// An increment that never ends: rigid friction by the elastic stiffness alone.
const std::string endless = R"(
set Scene = slab
subsection Slab
  set GS = 1e9
end
subsection Solver
  set Method = elastic
  set Max elastic iterations = 1000000000
end
)";

void wait_until(const std::function<bool()> &condition) {
  for (unsigned int i = 0; i < 5000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  CHECK(condition());
}

void check_replacement() {
  Place place;
  const fs::path small = place.write("small.prm", bar), other = place.write("other.prm", R"(
set Monitors = B, A
set Friction multipliers = 0.5, 2
)" + bar.substr(bar.find("subsection")));
  CHECK(place.run(small) == 0);
  const Files fresh = files_in(place.results);
  CHECK(fresh.count("summary.json") == 1 && fresh.count("history_B.csv") == 1 &&
        fresh.count(".files") == 1 && fresh.count(".lock") == 0);
  for (const auto &[name, text] : fresh)
    CHECK(!contains(name, "unfinished"));

  // refused in its file, in its mesh, in its analysis; looked at by 'check'
  CHECK(place.run(place.write("typo.prm", "set Titel = x\n" + bar)) == 1);
  CHECK(place.run(place.write("twice.prm", bar + "subsection Support far\n  set Kind = rest\n"
                                                 "  set Pipe = bar\n  set Every = 100\nend\n")) ==
        1);
  CHECK(place.run(small, {"--set", "Step pull/Analysis = transient", "--set", "Time/Step = 1e-11",
                          "--set", "Step pull/Duration = 1000"}) == 1);
  check_same(files_in(place.results), fresh);
  std::vector<std::string> words = {"check", small.string(), "--output-directory",
                                    place.results.string()};
  CHECK(Child(words, place.folder.path / "log", [] {}).wait() == 0);
  CHECK(fs::remove(place.results / "model.svg")); // the only file it writes
  check_same(files_in(place.results), fresh);

  // another run puts its own files in their place, and leaves the user's
  std::ofstream(place.results / "history_mine.csv") << "0 0\n1 1\n";
  CHECK(place.run(other) == 0);
  CHECK(fs::exists(place.results / "friction_2" / "summary.json"));
  CHECK(place.run(small) == 0);
  CHECK(fs::remove(place.results / "history_mine.csv"));
  check_same(files_in(place.results), fresh);
  CHECK(!fs::exists(place.results / "friction_2"));
}

void check_lock() {
  Place place;
  const fs::path file = place.write("long.prm", long_run), small = place.write("small.prm", bar);
  Child first = place.start(file, {"--set", "Step swing/Duration = 1000"});
  wait_until([&] { return fs::exists(place.results / "unfinished" / "history_B.csv"); });
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{}, std::vector<std::string>{"--resume"}}) {
    Place second; // for its log
    std::vector<std::string> words = {small.string(), "--output-directory", place.results.string()};
    words.insert(words.end(), options.begin(), options.end());
    Child child(words, second.folder.path / "log", [] {});
    CHECK(child.wait() == 1);
    CHECK(contains(child.output(), "Another run is writing into this folder"));
    CHECK(contains(child.output(), "process "));
  }
  CHECK(fs::exists(place.results / "unfinished" / "history_B.csv"));
  first.send(SIGKILL);
  CHECK(first.wait() == -SIGKILL);
  CHECK(fs::exists(place.results / ".lock")); // stale, and known to be
  CHECK(place.run(small) == 0);
  CHECK(!fs::exists(place.results / ".lock") && !fs::exists(place.results / "unfinished"));
}

void check_signals() {
  Place whole, cut;
  const std::vector<std::string> options = {"--set", "Output/Checkpoint interval = 0"};
  CHECK(whole.run(whole.write("long.prm", long_run), options) == 0);
  const fs::path file = cut.write("long.prm", long_run);
  std::vector<std::string> resumed = options;
  resumed.push_back("--resume");
  const fs::path history = cut.results / "unfinished" / "history_B.csv";
  for (const int signal : {SIGINT, SIGTERM}) {
    std::uintmax_t before = signal == SIGINT ? 0 : fs::file_size(history);
    Child child = cut.start(file, signal == SIGINT ? options : resumed);
    wait_until([&] { return fs::exists(history) && fs::file_size(history) > before + 20000; });
    child.send(signal);
    CHECK(child.wait() == 128 + signal);
    CHECK(contains(child.output(), "Interrupted at time"));
    CHECK(contains(child.output(), "--resume goes on from it"));
    CHECK(fs::exists(cut.results / "unfinished" / "checkpoint.bin"));
    CHECK(!fs::exists(cut.results / "summary.json"));
    const std::string text = program::text_of(history);
    CHECK(!text.empty() && text.back() == '\n'); // whole lines
  }
  CHECK(cut.run(file, resumed) == 0);
  check_same(files_in(cut.results), files_in(whole.results));

  // within an increment: the second signal ends it at once, one alone after a while
  const fs::path stuck = cut.write("endless.prm", endless);
  for (const unsigned int n_signals : {2, 1}) {
    const Files before = files_in(cut.results);
    Child child = cut.start(stuck);
    wait_until([&] { return fs::exists(cut.results / "unfinished" / "supports.csv"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    for (unsigned int i = 0; i < n_signals; ++i) {
      child.send(SIGTERM);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    CHECK(child.wait() == 143);
    CHECK(n_signals == 2 || contains(child.output(), "within an increment that takes long"));
    fs::remove_all(cut.results / "unfinished");
    fs::remove(cut.results / ".lock");
    check_same(files_in(cut.results), before);
  }
}

/// What a file includes is part of the case that a checkpoint is of.
void check_included() {
  Place place;
  place.write("part.prm", long_run);
  const fs::path file = place.write("whole.prm", "include part.prm\n");
  Child child = place.start(file);
  const fs::path history = place.results / "unfinished" / "history_B.csv";
  wait_until([&] { return fs::exists(history) && fs::file_size(history) > 10000; });
  child.send(SIGTERM);
  CHECK(child.wait() == 143);
  place.write("part.prm", long_run + "subsection Solver\n  set Tolerance = 1e-9\nend\n");
  CHECK(place.run(file, {"--resume"}) == 1);
  CHECK(contains(place.output, "is of another case: its parameter file"));
}

void check_full_disk() {
  Place place;
  const fs::path file = place.write("small.prm", bar);
  CHECK(place.run(file) == 0);
  const Files fresh = files_in(place.results);
  std::uintmax_t largest = 0;
  for (const auto &entry : fs::recursive_directory_iterator(place.results))
    if (entry.is_regular_file())
      largest = std::max(largest, entry.file_size());
  for (const rlim_t limit : {0, 10, 300, 2000, 5000, 20000}) { // the largest file is the report
    CHECK(limit < largest);
    Child child = place.start(file, {}, [limit] {
      // of the log, which is the disk's as well, there is more than that
      const int log = open("/dev/full", O_WRONLY);
      dup2(log, 1);
      const rlimit limits = {limit, limit};
      setrlimit(RLIMIT_FSIZE, &limits);
    });
    const int status = child.wait();
    CHECK(status == 4);
    Files left = files_in(place.results);
    for (auto f = left.begin(); f != left.end();) // as many as there was room for
      f = contains(f->first, "unfinished/") || f->first == ".lock" ? left.erase(f) : std::next(f);
    check_same(left, fresh);
    CHECK(!fs::exists(place.results / "unfinished" / "summary.json"));
  }
  Child child = place.start(file, {}, [] {
    const rlimit limits = {3000, 3000};
    setrlimit(RLIMIT_FSIZE, &limits);
  });
  CHECK(child.wait() == 4);
  CHECK(contains(child.output(), "File too large"));
  CHECK(contains(child.output(), "unfinished/"));
  CHECK(contains(child.output(), "of an earlier run, are as they were"));
  CHECK(place.run(file) == 0);
  check_same(files_in(place.results), fresh);

  Child silent = place.start(file, {}, [] { dup2(open("/dev/full", O_WRONLY), 1); });
  CHECK(silent.wait() == 4);
  CHECK(contains(silent.output(), "standard output cannot be written: No space left on device"));
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 2)
    return 2;
  frictionbeam = argv[1];
  check_replacement();
  check_lock();
  check_signals();
  check_included();
  check_full_disk();
  return check::report();
}
