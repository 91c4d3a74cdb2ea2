// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/run_journal.h"

#include "base/file_bytes.h"
#include "base/processes.h"
#include "base/user_error.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace frictionbeam::study {

namespace {

namespace fs = std::filesystem;

/// A piece of the file: its length in front, so that one that was cut is known.
std::string piece(const std::string &bytes) {
  const std::uint64_t size = bytes.size();
  std::string result(sizeof(size), '\0');
  std::memcpy(result.data(), &size, sizeof(size));
  return result + bytes;
}

/// The pieces of a file that are whole.
std::vector<std::string> pieces_of(const std::string &file) {
  const std::string bytes = file_bytes(file);
  std::vector<std::string> pieces;
  std::uint64_t size = 0;
  for (std::size_t at = 0; bytes.size() - at >= sizeof(size); at += sizeof(size) + size) {
    std::memcpy(&size, bytes.data() + at, sizeof(size));
    if (size > bytes.size() - at - sizeof(size))
      break;
    pieces.push_back(bytes.substr(at + sizeof(size), size));
  }
  return pieces;
}

std::string bytes_of(std::uint64_t number, Run &run) {
  Archive archive;
  archive(number, run);
  return archive.bytes();
}

} // namespace

void transfer(Archive &archive, Run &run) { archive(run.outcome, run.reason, run.numbers); }

RunJournal::RunJournal(const std::string &folder, std::string identity)
    : folder(folder), identity(std::move(identity)) {}

std::vector<std::string> RunJournal::files() const {
  std::vector<std::string> found;
  for (const auto &entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        name.rfind("runs.", 0) == 0 && entry.path().extension() == ".bin")
      found.push_back(entry.path().string());
  return found;
}

std::size_t RunJournal::read(StudyResults &study) const {
  std::string merged = piece(identity);
  std::size_t n = 0;
  for (const std::string &file : files()) {
    const std::vector<std::string> pieces = pieces_of(file);
    if (pieces.empty())
      continue;
    if (pieces.front() != identity)
      throw UserError(
          "The study cannot be resumed.\n  read:    " + file +
          ", runs of another study, of another file, of tables or laws that have changed, or by "
          "another build of the program\n"
          "  allowed: --resume with the files and options that the study began with\n"
          "  try:     the study without --resume, from its beginning");
    for (auto bytes = pieces.begin() + 1; bytes != pieces.end(); ++bytes) {
      std::uint64_t number = 0;
      Run run;
      Archive archive(*bytes);
      archive(number, run);
      if (number >= study.runs.size() || study.runs[number].outcome != Outcome::pending)
        continue;
      merged += piece(*bytes);
      study.runs[number] = run;
      ++n;
    }
  }
  const std::vector<std::string> old = files();
  replace_file(folder + "/runs.done.bin", merged);
  for (const std::string &file : old)
    if (file != folder + "/runs.done.bin")
      fs::remove(file);
  return n;
}

void RunJournal::clear() const {
  for (const std::string &file : files())
    fs::remove(file);
}

void RunJournal::write(const std::size_t number, Run &run) {
  const std::string bytes = piece(bytes_of(number, run));
  const std::lock_guard<std::mutex> lock(mutex);
  if (!file) {
    file =
        std::make_unique<OutputFile>(folder + "/runs." + std::to_string(this_process()) + ".bin");
    file->stream() << piece(identity);
  }
  file->stream() << bytes;
  file->flush();
}

} // namespace frictionbeam::study
