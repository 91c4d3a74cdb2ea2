// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/child_process.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <new>

namespace frictionbeam {

namespace {

constexpr int good = 77, out_of_memory = 78; // exit statuses that no library uses

void limit(const int what, const double value) {
  const rlimit limits = {static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
  setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

void write_all(const int pipe, const std::string &text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(pipe, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR)
      return;
    done += n > 0 ? n : 0;
  }
}

std::string read_all(const int pipe) {
  std::string text;
  char bytes[4096];
  for (ssize_t n = 1; n > 0 || (n < 0 && errno == EINTR);) {
    n = read(pipe, bytes, sizeof(bytes));
    text.append(bytes, n > 0 ? n : 0);
  }
  return text;
}

/// What is thrown here, but bad_alloc, ends the child, not the program that it is a copy of.
[[noreturn]] void become_child(const std::function<std::string()> &task, const ChildLimits &limits,
                               const int pipe) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  signal(SIGTERM, SIG_DFL);
  signal(SIGINT, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
#if !defined(__SANITIZE_ADDRESS__) // which takes all addresses there are
  limit(RLIMIT_AS, limits.bytes);
#endif
  try {
    write_all(pipe, task());
  } catch (const std::bad_alloc &) {
    _exit(out_of_memory);
  }
  _exit(good);
}

std::string trouble_of(const int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return "takes very long";
  if (WIFSIGNALED(status))
    return std::string("was ended by the system (") + strsignal(WTERMSIG(status)) + ")";
  if (WEXITSTATUS(status) == out_of_memory)
    return "needs more memory than there is";
  return WEXITSTATUS(status) == good
             ? ""
             : "ended the program with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace

ChildEnd run_in_child(const std::function<std::string()> &task, const ChildLimits &limits) {
  std::cout.flush(); // else the child may write it once more
  int ends[2];
  if (pipe(ends) != 0)
    return {"", std::string("cannot be started: ") + std::strerror(errno)};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    become_child(task, limits, ends[1]);
  }
  close(ends[1]);
  ChildEnd end;
  int status = 0;
  if (child < 0)
    end.trouble = std::string("cannot be started: ") + std::strerror(errno);
  else {
    end.text = read_all(ends[0]);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    end.trouble = trouble_of(status);
  }
  close(ends[0]);
  return end;
}

} // namespace frictionbeam
