// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk without room shall end a run, or 'frictionbeam contact', with exit status 4 and leave what
// was there as it was. The disk is a real one, in memory, where a test may mount it.
//   small_disk PROGRAM
#include "place.h"

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <cstring>

using namespace files;

namespace {

/// A disk of its own for this process and its children, of @p size bytes.
class SmallDisk {
public:
  SmallDisk(const fs::path &path, const std::size_t size) : path(path) {
    fs::create_directory(path);
    const std::string options = "size=" + std::to_string(size);
    is_there = unshare(CLONE_NEWNS) == 0 &&
               mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               mount("tmpfs", path.c_str(), "tmpfs", 0, options.c_str()) == 0;
    if (!is_there) // in a container without the right to mount
      std::cerr << "NOT TESTED: no disk of " << size
                << " bytes can be mounted here: " << std::strerror(errno) << '\n';
  }
  ~SmallDisk() {
    if (is_there)
      umount(path.c_str());
  }
  SmallDisk(const SmallDisk &) = delete;
  SmallDisk &operator=(const SmallDisk &) = delete;

  const fs::path path;
  bool is_there = false;
};

constexpr std::size_t page = 4096; // tmpfs counts them

/// Files of a run in a folder on a disk that is too small for them, and then on one that is not.
void check_run_on_small_disk() {
  for (const unsigned int n_pages : {2, 4, 8, 12, 16, 20, 1000}) {
    Place place;
    const SmallDisk disk(place.folder.path / "disk", n_pages * page);
    if (!disk.is_there)
      return;
    Child child({place.write("small.prm", bar).string(), "--output-directory",
                 (disk.path / "results").string()},
                place.folder.path / "log", [] {});
    const int status = child.wait();
    CHECK(status == (n_pages == 1000 ? 0 : 4));
    CHECK((status == 0) == fs::exists(disk.path / "results" / "summary.json"));
    CHECK((status == 0) == contains(child.output(), "Results are in"));
    CHECK(status == 0 || contains(child.output(), "No space left on device"));
  }
}

/// The same of a table that is so long that two threads make it.
void check_long_table_on_small_disk() {
  for (const unsigned int n_pages : {100, 300, 10000}) {
    Place place;
    const SmallDisk disk(place.folder.path / "disk", n_pages * page);
    if (!disk.is_there)
      return;
    Child child({place.write("small.prm", bar).string(), "--set", "Output/Stations = 1000", "--set",
                 "Mesh/Cell length = 0.2", "--output-directory", (disk.path / "results").string()},
                place.folder.path / "log", [] {});
    const int status = child.wait();
    CHECK(status == (n_pages == 10000 ? 0 : 4));
    CHECK(status == 0 || contains(child.output(), "No space left on device"));
  }
}

/// frictionbeam contact leaves the file as it was, and nothing else, if the solution has no room.
void check_contact_on_full_disk() {
  Place place;
  const std::string pad = "subsection Support pad\n  set Kind = rest\n  set At = B\nend\n";
  CHECK(place.run(place.write("pad.prm", bar + pad),
                  {"--set", "Output/Write contact problems = true"}) == 0);
  fs::path problem;
  for (const auto &entry : fs::directory_iterator(place.results / "contact_problems"))
    if (program::text_of(entry.path()).find("fclib_local") != std::string::npos)
      problem = entry.path();
  CHECK(!problem.empty());
  const std::string bytes = program::text_of(problem);
  unsigned int n_full = 0, n_solved = 0;
  const auto solve = [&](const fs::path &file) {
    Child child({"contact", file.string()}, place.folder.path / "log", [] {});
    const int status = child.wait();
    CHECK(status == 0 || status == 4);
    ++(status == 0 ? n_solved : n_full);
    CHECK(status == 0 || program::text_of(file) == bytes);
    CHECK(status == 0 || contains(child.output(), "cannot be written"));
    CHECK((status == 0) == contains(child.output(), "Written to the group"));
    const fs::path folder = file.parent_path();
    CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  };
  const std::size_t n_pages = bytes.size() / page + 1;
  // no room, for half of a copy, for a copy but not for what is added to it, for all
  // (of half of a copy, the system says "Input/output error")
  for (const std::size_t room : {n_pages, n_pages + n_pages / 2, 2 * n_pages, 4 * n_pages + 100}) {
    const SmallDisk disk(place.folder.path / "disk", room * page);
    if (!disk.is_there)
      break;
    std::ofstream(disk.path / "problem.hdf5", std::ios::binary) << bytes;
    solve(disk.path / "problem.hdf5");
  }
  CHECK(n_full + n_solved == 0 || (n_full >= 2 && n_solved >= 1));
  fs::create_directory(place.folder.path / "limited");
  const fs::path limited = place.folder.path / "limited" / "problem.hdf5";
  for (const rlim_t limit : {std::size_t(0), std::size_t(1000), bytes.size() - 1}) {
    std::ofstream(limited, std::ios::binary) << bytes;
    Child child({"contact", limited.string()}, place.folder.path / "log", [limit] {
      const rlimit limits = {limit, limit}; // of the log as well
      setrlimit(RLIMIT_FSIZE, &limits);
    });
    CHECK(child.wait() == 4);
    CHECK(program::text_of(limited) == bytes);
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 2)
    return 2;
  frictionbeam = argv[1];
  check_run_on_small_disk();
  check_long_table_on_small_disk();
  check_contact_on_full_disk();
  return check::report();
}
