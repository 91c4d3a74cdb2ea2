// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/folder_lock.h"

#include "base/user_error.h"
#include "results/file/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <sstream>

namespace frictionbeam {

namespace {

std::string this_computer() {
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

/// Process, computer and beginning, each a line.
struct Owner {
  long process = 0;
  std::string computer, since;

  std::string text() const {
    return std::to_string(process) + '\n' + computer + '\n' + since + '\n';
  }
  /// Of one on another computer, nothing is known.
  bool seems_alive() const {
    return process > 0 && (computer != this_computer() || kill(process, 0) == 0 || errno == EPERM);
  }
};

Owner this_owner() {
  const std::time_t now = std::time(nullptr);
  char since[64] = "";
  std::tm parts = {};
  if (localtime_r(&now, &parts) != nullptr)
    std::strftime(since, sizeof(since), "%Y-%m-%d %H:%M:%S", &parts);
  return {getpid(), this_computer(), since};
}

Owner read_owner(const int descriptor) {
  char bytes[512];
  const ssize_t n = pread(descriptor, bytes, sizeof(bytes), 0);
  std::istringstream in(std::string(bytes, n > 0 ? n : 0));
  Owner owner;
  in >> owner.process >> std::ws;
  std::getline(in, owner.computer);
  std::getline(in, owner.since);
  return owner;
}

/// Whether @p descriptor still is the file at @p path, which its last owner may have removed.
bool is_at(const int descriptor, const std::string &path) {
  struct stat open_file, file;
  return fstat(descriptor, &open_file) == 0 && stat(path.c_str(), &file) == 0 &&
         open_file.st_ino == file.st_ino && open_file.st_dev == file.st_dev;
}

[[noreturn]] void refuse(const std::string &folder, const Owner &owner) {
  throw UserError("Another run is writing into this folder.\n  read:    " + folder +
                  (owner.process > 0 ? ", where process " + std::to_string(owner.process) + " on " +
                                           owner.computer + " is at work since " + owner.since
                                     : "") +
                  "\n  allowed: one run at a time in a folder\n  try:     another "
                  "--output-directory, or this again when the other run has ended");
}

} // namespace

FolderLock::FolderLock(const std::string &folder) : path(folder + "/.lock") {
  while (true) {
    descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw_unwritable("file", path, errno);
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool unknown = !locked && errno != EWOULDBLOCK; // a file system without flock()
    const Owner owner = read_owner(descriptor);
    if (!locked && (!unknown || owner.seems_alive())) {
      close(descriptor);
      refuse(folder, owner);
    }
    if (is_at(descriptor, path))
      break;
    close(descriptor);
  }
  const std::string text = this_owner().text();
  if (ftruncate(descriptor, 0) != 0 ||
      pwrite(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    const int error = errno;
    unlink(path.c_str());
    close(descriptor);
    throw_unwritable("file", path, error);
  }
}

FolderLock::~FolderLock() {
  unlink(path.c_str());
  close(descriptor);
}

} // namespace frictionbeam
