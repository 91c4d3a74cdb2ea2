// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/**
 * Keeps a folder for this process: a file `.lock` in it, locked by flock(2), which the system takes
 * back when the process ends, however that happens. The file names the process, its computer and
 * when it began, for people, and for file systems without flock(): there a lock counts while its
 * process lives, as far as can be seen from here.
 */
class FolderLock {
public:
  /// @throws UserError if another process keeps the folder, OutputError if it cannot be written to
  explicit FolderLock(const std::string &folder);
  ~FolderLock();
  FolderLock(const FolderLock &) = delete;
  FolderLock &operator=(const FolderLock &) = delete;

private:
  std::string path;
  int descriptor = -1;
};

} // namespace frictionbeam
