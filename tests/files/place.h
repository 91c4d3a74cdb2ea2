// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../cases/run_program.h"
#include "../check.h"
#include "../small_bar.h"

#include <fcntl.h>
#include <signal.h>

#include <functional>

namespace fs = std::filesystem;

/// Runs of the program, and the files that they leave behind.
namespace files {

inline std::string frictionbeam; ///< the program

inline const std::string bar = "\nset Monitors = B" + small_bar + R"(subsection Load pull
  set Kind = force
  set Forces = B 0 0 -100
end
subsection Step pull
  set Loads = pull
  set Increments = 3
end
)";

using Files = std::map<std::string, std::string>; ///< name and content

/// Without the dates and times that differ from run to run.
inline Files files_in(const fs::path &folder) {
  Files files;
  for (const auto &entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file())
      continue;
    std::string text = program::text_of(entry.path());
    const auto cut = [&](const std::string &from, const char to) {
      const auto begin = text.find(from);
      if (begin != std::string::npos)
        text.erase(begin, text.find(to, begin) - begin);
    };
    cut("\"cost\"", '}');
    if (entry.path().extension() == ".pvd")
      cut("on 20", '\n');
    if (entry.path().extension() == ".html")
      text = "";
    files[fs::relative(entry.path(), folder).string()] = text;
  }
  return files;
}

inline void check_same(const Files &found, const Files &expected) {
  CHECK(found == expected);
  for (const auto &[name, text] : found)
    if (expected.count(name) == 0 || expected.at(name) != text)
      std::cerr << name << (expected.count(name) == 0 ? " should not be there\n" : " differs\n");
  for (const auto &[name, text] : expected)
    if (found.count(name) == 0)
      std::cerr << name << " is missing\n";
}

/// The program at work, until it is waited for.
class Child {
public:
  Child(std::vector<std::string> words, const fs::path &log, const std::function<void()> &prepare)
      : log(log) {
    words.insert(words.begin(), frictionbeam);
    std::vector<char *> arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process = fork();
    if (process == 0) {
      const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
      if (out >= 0 && dup2(out, 1) == 1 && dup2(out, 2) == 2) {
        prepare();
        execv(arguments[0], arguments.data());
      }
      _exit(127);
    }
  }

  /// @return exit status, or -signal
  int wait() {
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  void send(const int signal) const { kill(process, signal); }
  std::string output() const { return program::text_of(log); }

private:
  fs::path log;
  pid_t process = -1;
};

class Place {
public:
  Place() : results(folder.path / "results") {}

  fs::path write(const std::string &name, const std::string &text) const {
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
  }
  Child start(
      const fs::path &file, std::vector<std::string> options = {},
      const std::function<void()> &prepare = [] {}) const {
    options.insert(options.begin(), {file.string(), "--output-directory", results.string()});
    return Child(options, folder.path / "log", prepare);
  }
  /// @return exit status; the output is in @p output.
  int run(const fs::path &file, const std::vector<std::string> &options = {}) {
    Child child = start(file, options);
    const int status = child.wait();
    output = child.output();
    return status;
  }

  const program::TemporaryFolder folder;
  const fs::path results;
  std::string output;
};

inline bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace files
