// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/run_folder.h"

#include "results/file/checkpoint.h"
#include "results/file/folder_lock.h"
#include "results/file/output_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

namespace frictionbeam {

namespace fs = std::filesystem;

namespace {

const char *const manifest = ".files", *const summary = "summary.json";

/// Of versions of the program that wrote no list; histories are not among them, since a user's own
/// tables may be called like that.
const std::set<std::string> without_list = {
    "summary.json",    "report.html", "line.svg",     "supports.csv",
    "line.csv",        "modes.csv",   "stresses.csv", "reactions.csv",
    "nozzles.csv",     "contact.csv", "results.pvd",  "friction_study.csv",
    "convergence.csv", "modes.pvd",   "supports.pvd", "continuum.pvd"};

/// Files of the earlier run, from its folder.
std::set<std::string> earlier_files(const fs::path &folder) {
  std::ifstream in(folder / manifest);
  if (!in)
    return without_list;
  std::set<std::string> files;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '/' && line.find("..") == std::string::npos)
      files.insert(line);
  return files;
}

std::set<std::string> files_in(const fs::path &folder) {
  std::set<std::string> files;
  for (const auto &entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.insert(entry.path().lexically_relative(folder).string());
  return files;
}

std::string lines(const std::set<std::string> &files) {
  std::string text;
  for (const std::string &file : files)
    text += file + '\n';
  return text;
}

void throw_if(const std::error_code &error, const fs::path &path) {
  if (error)
    throw_unwritable("file", path.string(), error.value());
}

void remove_files(const fs::path &folder, const std::set<std::string> &files) {
  std::error_code error;
  fs::remove(folder / summary, error);
  throw_if(error, folder / summary);
  std::set<fs::path> folders;
  for (const std::string &file : files) {
    fs::remove(folder / file, error);
    if (error != std::errc::not_a_directory)
      throw_if(error, folder / file);
    for (fs::path above = fs::path(file).parent_path(); !above.empty(); above = above.parent_path())
      folders.insert(above);
  }
  std::for_each(folders.rbegin(), folders.rend(), [&](const fs::path &empty) {
    fs::remove(folder / empty, error); // those that are empty, the inner ones first
  });
}

void move_files(const fs::path &from, const fs::path &to, const std::set<std::string> &files) {
  const auto move = [&](const std::string &file) {
    std::error_code error;
    fs::create_directories((to / file).parent_path(), error);
    throw_if(error, (to / file).parent_path());
    fs::rename(from / file, to / file, error);
    throw_if(error, to / file);
  };
  for (const std::string &file : files)
    if (file != summary)
      move(file);
  if (files.count(summary) > 0)
    move(summary);
}

} // namespace

std::string RunFolder::work(const std::string &folder) { return folder + "/unfinished"; }

std::string RunFolder::work() const { return work(folder); }

RunFolder::RunFolder(const std::string &folder, const bool resume) : folder(folder) {
  prepare_output_folder(folder);
  lock = std::make_unique<FolderLock>(folder);
  if (!resume)
    discard();
  prepare_output_folder(work());
}

RunFolder::~RunFolder() = default;

void RunFolder::discard() {
  std::error_code error;
  fs::remove_all(work(), error);
  throw_if(error, work());
}

void RunFolder::publish() {
  const std::set<std::string> written = files_in(work()), earlier = earlier_files(folder);
  std::set<std::string> both = written;
  both.insert(earlier.begin(), earlier.end());
  replace_file(folder + '/' + manifest, lines(both)); // if this is cut, the next run knows them all
  remove_files(folder, earlier);
  move_files(work(), folder, written);
  replace_file(folder + '/' + manifest, lines(written));
  discard();
}

std::string RunFolder::what_is_whole(const bool may_be_resumed) const {
  bool has_checkpoint = false;
  if (may_be_resumed && fs::exists(work()))
    for (const auto &entry : fs::recursive_directory_iterator(work()))
      has_checkpoint = has_checkpoint || Checkpoint::is_in(entry.path().parent_path().string());
  return (fs::exists(fs::path(folder) / summary)
              ? "The results in " + folder + ", of an earlier run, are as they were. "
              : "There are no results in " + folder + ". ") +
         (has_checkpoint ? "The checkpoint in " + work() +
                               " is whole: the same command with --resume goes on from it."
                         : "There is no checkpoint: the run is to be begun again.");
}

} // namespace frictionbeam
