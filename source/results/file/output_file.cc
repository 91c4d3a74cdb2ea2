// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/output_file.h"
#include "base/user_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <filesystem>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>

namespace frictionbeam {

namespace {

std::string unwritable(const std::string &what, const std::string &path, const int error) {
  return "The " + what + " '" + path + "' cannot be written: " +
         (error != 0 ? std::strerror(error) : "the system gives no reason") +
         ". Choose another folder with --output-directory, or see to it that this one may be "
         "written to and that the disk is not full.";
}

bool is_full(const int error) {
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO;
}

} // namespace

void throw_unwritable(const std::string &what, const std::string &path, const int error) {
  throw OutputError(unwritable(what, path, error));
}

void prepare_output_folder(const std::string &folder) {
  namespace fs = std::filesystem;
  if (folder.empty())
    throw UserError("The name of the output folder is empty. Give one, for example 'results'.");
  const auto check = [&](const bool good, const int error) {
    if (!good && is_full(error))
      throw_unwritable("output folder", folder, error);
    if (!good) // a wrong name, or no right to write there
      throw UserError(unwritable("output folder", folder, error));
  };
  std::error_code error;
  fs::create_directories(folder, error);
  check(!error, error.value());

  // of one name, so that what a run leaves that is killed right here, the next one removes
  const fs::path probe = fs::path(folder) / ".write-test";
  errno = 0;
  std::ofstream file(probe);
  file << "test\n" << std::flush;
  const bool good = !file.fail();
  const int reason = errno;
  file.close();
  fs::remove(probe, error);
  check(good, reason);
}

namespace {

/// Have a file, or a folder's list of files, written to the disk.
void hand_to_disk(const std::string &path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY);
  if (descriptor < 0 || fsync(descriptor) != 0) {
    const int error = errno;
    if (descriptor >= 0)
      close(descriptor);
    throw_unwritable("file", path, error);
  }
  close(descriptor);
}

} // namespace

OutputFile::OutputFile(const std::string &path, const bool keep) : path(path) {
  errno = 0;
  file.imbue(std::locale::classic());
  file.open(path, std::ios::binary | (keep ? std::ios::app : std::ios::trunc));
  if (!file)
    throw_unwritable("file", path, errno);
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
  if (file) // else the reason is there since it failed
    errno = 0;
  file.flush();
  if (!file)
    throw_unwritable("file", path, errno);
}

namespace {

/// The blocks of a table, which threads take one after the other.
class RowBlocks {
public:
  RowBlocks(const std::size_t n_rows, const AddRow &add_row, OutputFile &file)
      : n_rows(n_rows), add_row(add_row), file(file) {}

  std::size_t size() const { return (n_rows + rows_at_once - 1) / rows_at_once; }

  /// Make and write blocks until none is left, or a thread has failed.
  void work() {
    const EndOfThread end{*this};
    std::string text;
    for (std::size_t block = take(); block < size(); block = take()) {
      text.clear();
      const std::size_t begin = block * rows_at_once;
      for (std::size_t row = begin; row < std::min(n_rows, begin + rows_at_once); ++row)
        add_row(row, text);
      std::unique_lock<std::mutex> lock(mutex);
      turn.wait(lock, [&]() { return n_written == block || has_failed; });
      if (has_failed)
        return;
      file.stream() << text;
      file.flush(); // here, for the reason of an error is its thread's
      ++n_written;
      turn.notify_all();
    }
  }

private:
  /// Lets the other thread wait no longer for what an exception has ended.
  struct EndOfThread {
    RowBlocks &blocks;
    ~EndOfThread() {
      if (std::uncaught_exceptions() == 0)
        return;
      const std::lock_guard<std::mutex> lock(blocks.mutex);
      blocks.has_failed = true;
      blocks.turn.notify_all();
    }
  };

  static constexpr std::size_t rows_at_once = 1000; // some 200 kB

  std::size_t take() {
    const std::lock_guard<std::mutex> lock(mutex);
    return n_taken++;
  }

  const std::size_t n_rows;
  const AddRow &add_row;
  OutputFile &file;
  std::mutex mutex;
  std::condition_variable turn;
  std::size_t n_taken = 0, n_written = 0;
  bool has_failed = false;
};

} // namespace

void write_rows(const std::size_t n_rows, const AddRow &add_row, OutputFile &file) {
  RowBlocks blocks(n_rows, add_row, file);
  std::future<void> other;
  if (blocks.size() > 1 && std::thread::hardware_concurrency() > 1)
    try {
      other = std::async(std::launch::async, [&]() { blocks.work(); });
    } catch (const std::system_error &) { // there is no thread to be had
    }
  blocks.work();
  if (other.valid())
    other.get();
}

void write_file(const std::string &path, const std::string &text) {
  OutputFile file(path);
  file.stream() << text;
  file.flush();
}

std::string file_beside(const std::string &path) { return path + ".new"; }

void replace_file(const std::string &path, const std::string &text) {
  replace_file(path, std::vector<std::string_view>{text});
}

void replace_file(const std::string &path, const std::vector<std::string_view> &texts) {
  const std::string beside = file_beside(path);
  std::error_code error;
  try {
    {
      OutputFile file(beside);
      for (const std::string_view &text : texts)
        file.stream() << text;
      file.flush();
    }
    hand_to_disk(beside);
  } catch (const OutputError &) {
    std::filesystem::remove(beside, error);
    throw;
  }
  std::filesystem::rename(beside, path, error);
  if (error)
    throw_unwritable("file", path, error.value());
  const std::string folder = std::filesystem::path(path).parent_path().string();
  hand_to_disk(folder.empty() ? "." : folder);
}

} // namespace frictionbeam
