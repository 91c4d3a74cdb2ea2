// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/output_file.h>
#include <frictionbeam/scene/user_error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace frictionbeam {

namespace {

[[noreturn]] void throw_unwritable(const std::string &what, const std::string &path,
                                   const std::string &reason) {
  throw UserError("The " + what + " '" + path + "' cannot be written: " + reason +
                  ". Choose another folder with --output-directory, or see to it that this one may "
                  "be written to and "
                  "that the disk is not full.");
}

std::string system_reason(const int error) {
  return error != 0 ? std::strerror(error) : "the system gives no reason";
}

} // namespace

void prepare_output_folder(const std::string &folder) {
  namespace fs = std::filesystem;
  if (folder.empty())
    throw UserError("The name of the output folder is empty. Give one, for example 'results'.");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw_unwritable("output folder", folder, error.message());

  // of one name, so that what a run leaves that is killed right here, the next one removes
  const fs::path probe = fs::path(folder) / ".write-test";
  errno = 0;
  std::ofstream file(probe);
  file << "test\n" << std::flush;
  if (!file)
    throw_unwritable("output folder", folder, system_reason(errno));
  file.close();
  fs::remove(probe, error);

  for (const char *name : {"summary.json", "report.html", "line.svg"}) {
    fs::remove(fs::path(folder) / name, error);
    if (error)
      throw_unwritable("file", (fs::path(folder) / name).string(), error.message());
  }
}

namespace {

/// Have a file, or a folder's list of files, written to the disk.
void hand_to_disk(const std::string &path) {
  const int descriptor = open(path.c_str(), O_RDONLY);
  if (descriptor < 0 || fsync(descriptor) != 0) {
    const int error = errno;
    if (descriptor >= 0)
      close(descriptor);
    throw_unwritable("file", path, system_reason(error));
  }
  close(descriptor);
}

} // namespace

OutputFile::OutputFile(const std::string &path, const bool keep) : path(path) {
  errno = 0;
  file.imbue(std::locale::classic());
  file.open(path, std::ios::binary | (keep ? std::ios::app : std::ios::trunc));
  if (!file)
    throw_unwritable("file", path, system_reason(errno));
}

void OutputFile::transfer(Archive &archive) {
  namespace fs = std::filesystem;
  std::uintmax_t size = 0;
  if (!archive.reads()) {
    flush();
    hand_to_disk(path);
    size = fs::file_size(path);
  }
  archive(size);
  if (!archive.reads())
    return;
  const std::uintmax_t found = fs::file_size(path);
  if (found < size)
    throw UserError("The run cannot be resumed.\n  read:    " + path + " with " +
                    std::to_string(found) + " bytes\n  allowed: at least the " +
                    std::to_string(size) +
                    " bytes that it had at the checkpoint\n  try:     the "
                    "run without --resume, from its beginning");
  fs::resize_file(path, size);
}

void OutputFile::flush() {
  errno = 0;
  file.flush();
  if (!file)
    throw_unwritable("file", path, system_reason(errno));
}

void write_file(const std::string &path, const std::string &text) {
  OutputFile file(path);
  file.stream() << text;
  file.flush();
}

std::string file_beside(const std::string &path) { return path + ".new"; }

void replace_file(const std::string &path, const std::string &text) {
  const std::string beside = file_beside(path);
  write_file(beside, text);
  hand_to_disk(beside);
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error)
    throw_unwritable("file", path, error.message());
  const std::string folder = std::filesystem::path(path).parent_path().string();
  hand_to_disk(folder.empty() ? "." : folder);
}

} // namespace frictionbeam
