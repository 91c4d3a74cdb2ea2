// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace frictionbeam {

namespace {

/// A file that has no name any more, for the output of a process.
class OutputCatcher {
public:
  OutputCatcher() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "frictionbeam-XXXXXX");
    descriptor = error ? -1 : mkstemp(name.data());
    if (descriptor >= 0)
      unlink(name.c_str());
  }
  ~OutputCatcher() {
    if (descriptor >= 0)
      close(descriptor);
  }
  OutputCatcher(const OutputCatcher &) = delete;
  OutputCatcher &operator=(const OutputCatcher &) = delete;

  std::string text() const {
    std::string result;
    char buffer[4096];
    lseek(descriptor, 0, SEEK_SET);
    for (ssize_t n; (n = read(descriptor, buffer, sizeof buffer)) > 0;)
      result.append(buffer, n);
    return result;
  }

  int descriptor = -1;
};

[[noreturn]] void become(const std::vector<std::string> &words, const std::string &folder,
                         const int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::vector<char *> arguments;
  for (const std::string &word : words)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0 && dup2(nothing, 0) == 0 && dup2(output, 1) == 1 && dup2(output, 2) == 2 &&
      (folder.empty() || chdir(folder.c_str()) == 0))
    execvp(arguments[0], arguments.data());
  _exit(127);
}

} // namespace

ProcessResult run_process(const std::vector<std::string> &words, const std::string &folder,
                          const double time_limit) {
  using Clock = std::chrono::steady_clock;
  ProcessResult result;
  const OutputCatcher output;
  const Clock::time_point start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const pid_t child = output.descriptor < 0 ? -1 : fork();
  if (child == 0)
    become(words, folder, output.descriptor);
  if (child < 0) {
    result.output = std::string("the process cannot be started: ") + std::strerror(errno);
    return result;
  }

  int status = 0;
  rusage usage{};
  pid_t ended;
  while ((ended = wait4(child, &status, result.timed_out ? 0 : WNOHANG, &usage)) != child) {
    if (ended < 0 && errno != EINTR)
      return result;
    if (passed() > time_limit) {
      result.timed_out = true;
      kill(child, SIGKILL);
    } else // looked at often enough for a process of milliseconds, seldom for one of minutes
      std::this_thread::sleep_for(
          std::chrono::duration<double>(std::clamp(0.01 * passed(), 2e-4, 0.05)));
  }
  result.seconds = passed();
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  const auto seconds_of = [](const timeval &time) { return time.tv_sec + 1e-6 * time.tv_usec; };
  result.processor_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  result.peak_memory_mb = usage.ru_maxrss / 1024.;
  result.output = output.text();
  return result;
}

std::string own_path() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

} // namespace frictionbeam
