// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/output_file.h>
#include <frictionbeam/scene/user_error.h>

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

  const fs::path probe = fs::path(folder) / (".write-test-" + std::to_string(getpid()));
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

OutputFile::OutputFile(const std::string &path) : path(path) {
  errno = 0;
  file.imbue(std::locale::classic());
  file.open(path, std::ios::binary | std::ios::trunc);
  if (!file)
    throw_unwritable("file", path, system_reason(errno));
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

} // namespace frictionbeam
