// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/file/output_file.h"
#include "study/study_results.h"

#include <memory>
#include <mutex>

namespace frictionbeam::study {

/**
 * Files `runs.N.bin` in the folder of a study's results, one of each process N, to which every run
 * is written as soon as it is done, so that a study that was killed goes on from there, with any
 * number of processes. They say which study they are of, and are of no use to another one.
 */
class RunJournal {
public:
  /// @param identity text that says which study it is, with all that its numbers depend on
  RunJournal(const std::string &folder, std::string identity);

  /// Fill in the runs of an earlier study, and put them into one file. By the first process, before
  /// any is written. @return how many there are
  /// @throws UserError if they are of another study
  std::size_t read(StudyResults &study) const;
  /// Remove what an earlier study left.
  void clear() const;

  /// May be called by several threads.
  void write(const std::size_t number, Run &run);

private:
  std::vector<std::string> files() const;

  const std::string folder, identity;
  std::unique_ptr<OutputFile> file; ///< null before the first run
  std::mutex mutex;
};

/// A run's place in a study and what it has, from or into bytes.
void transfer(Archive &archive, Run &run);

} // namespace frictionbeam::study
