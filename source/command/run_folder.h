// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>

namespace frictionbeam {

class FolderLock;

/**
 * The folder that a run's results go to. While the run is at work it writes into the folder
 * `unfinished` in it; publish() puts what it wrote in the place of the earlier run's files. So, at
 * every moment, the files beside `unfinished` are all of one run or none, and where `summary.json`
 * is, they are all there: it is the first to go and the last to come. The file `.files` lists them,
 * since other files in the folder are the user's.
 */
class RunFolder {
public:
  /// Create the folder and keep it for this run. What an unfinished run left goes, unless @p
  /// resume.
  /// @throws UserError if another run is at work there
  RunFolder(const std::string &folder, const bool resume);
  ~RunFolder();

  /// Where the run writes.
  std::string work() const;
  static std::string work(const std::string &folder);

  /// Put what was written in the place of what was there. @throws OutputError
  void publish();
  /// Forget what was written.
  void discard();

  /// What a run leaves behind that ends here, in plain words.
  std::string what_is_whole(const bool may_be_resumed) const;

private:
  const std::string folder;
  std::unique_ptr<FolderLock> lock;
};

} // namespace frictionbeam
