// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trial.h"

#include "parameter_text.h"

#include "command/check_command.h"
#include "command/contact_command.h"
#include "command/program/program.h"
#include "command/run_case.h"

#include "base/interruption.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace fs = std::filesystem;

namespace fuzz {

namespace {

void limit(const int what, const rlim_t value) {
  const rlimit limits = {value, value};
  setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

int command(const std::vector<std::string> &words, const bool interrupted) {
  using namespace frictionbeam;
  return with_errors_told([&]() {
    if (words[0] == "contact")
      return solve_contact_file({words[1]});
    RunOptions options;
    options.output_directory = "results";
    for (std::size_t i = 1; i < words.size(); ++i)
      if (words[i] == "--resume")
        options.resume = true;
      else if (words[i] == "--set")
        options.overrides.push_back(words[++i]);
      else
        options.parameter_file = words[i];
    interruption::listen();
    if (interrupted)
      raise(SIGTERM);
    return words[0] == "check" ? check_case_file(options) : run_case(options);
  });
}

[[noreturn]] void become(const Trial &trial) {
  const int log = open((trial.folder + "/log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (log < 0 || dup2(log, 1) != 1 || dup2(log, 2) != 2 || chdir(trial.folder.c_str()) != 0)
    _exit(99);
  setsid();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 200000000);
#if !defined(__SANITIZE_ADDRESS__)
  limit(RLIMIT_AS, 6000000000u);
#endif
  limit(RLIMIT_CPU, trial.seconds + 20);
  const int status = command(trial.words, trial.interrupted);
  std::cout.flush();
  _exit(status);
}

/// Whether a field of a table, or a value of a summary, is no number.
bool has_no_number(const std::string &text, const bool is_table) {
  if (!is_table)
    return text.find("\"value\": null") != std::string::npos;
  for (const std::string word : {"nan", "inf", "-nan", "-inf"})
    for (std::size_t at = 0; (at = text.find(',' + word, at)) != std::string::npos; ++at) {
      const std::size_t end = at + 1 + word.size();
      if (end == text.size() || text[end] == ',' || text[end] == '\n')
        return true;
    }
  return false;
}

std::string fault_of_files(const std::string &folder, const bool converged) {
  std::error_code error;
  for (const auto &entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".csv" || (ending == ".json" && converged))
      if (has_no_number(read_file(entry.path().string()), ending == ".csv"))
        return "not finite: " + entry.path().filename().string();
  }
  return "";
}

std::string fault_of(const Outcome &outcome, const std::string &folder) {
  if (outcome.status < 0)
    return "crash by signal " + std::to_string(-outcome.status);
  if (outcome.status == 143) // it was asked to end
    return "";
  if (outcome.status == 3 && outcome.output.find("bad_alloc") != std::string::npos)
    return "out of memory";
  if (outcome.status == 3) {
    const auto condition = outcome.output.find("The violated condition was");
    return "internal error: " + without_numbers(condition == std::string::npos
                                                    ? outcome.output
                                                    : outcome.output.substr(condition));
  }
  if (outcome.status < 0 || outcome.status > 4)
    return "exit status " + std::to_string(outcome.status);
  if (outcome.output.find("An error occurred in line") != std::string::npos)
    return "an internal error in the message of another";
  return fault_of_files(folder + "/results", outcome.status == 0);
}

} // namespace

std::string without_numbers(const std::string &text) {
  std::string result;
  bool quoted = false;
  for (const char c : text) {
    if (c == '\'' || c == '"')
      quoted = !quoted;
    else if (!quoted && std::isdigit(static_cast<unsigned char>(c)) == 0)
      result += c;
  }
  return result.substr(0, 160);
}

namespace {

/// Of computing by a process [s].
double computing_time(const pid_t process) {
  clockid_t clock;
  timespec time;
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0)
    return 0.;
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

/// Of computing after it was asked to end [s].
constexpr double time_to_end = 8.;
/// Without computing, until a process counts as one that hangs: others may have the machine [s].
constexpr double most_waiting = 60.;

/// @return status of waitpid(); a hang is ended, and noted.
int wait_for(const pid_t child, const Trial &trial, Outcome &outcome) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point moved = Clock::now(); // when it was last seen to have computed
  double computed = 0.;
  int status = 0;
  pollfd ended = {static_cast<int>(syscall(SYS_pidfd_open, child, 0)), POLLIN, 0};
  while (waitpid(child, &status, WNOHANG) != child) {
    const double now = computing_time(child);
    if (now > computed)
      moved = Clock::now();
    computed = std::max(computed, now);
    const bool waits = std::chrono::duration<double>(Clock::now() - moved).count() > most_waiting;
    if (!outcome.slow && (computed > trial.seconds || waits)) {
      outcome.slow = true;
      moved = Clock::now();
      kill(child, SIGTERM);
    } else if (outcome.slow && (computed > trial.seconds + time_to_end || waits)) {
      outcome.fault = "hang";
      kill(child, SIGKILL);
    }
    poll(&ended, 1, 20); // [ms]
  }
  close(ended.fd);
  return status;
}

} // namespace

Outcome run(const Trial &trial) {
  std::error_code ignored;
  const std::string results = trial.folder + "/results";
  if (!trial.keep_before)
    fs::remove_all(results, ignored);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0)
    become(trial);
  Outcome outcome;
  const int status = wait_for(child, trial, outcome);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.output = read_file(trial.folder + "/log");
  if (outcome.fault.empty() && outcome.status == -SIGXCPU)
    outcome.fault = "hang";
  if (outcome.fault.empty())
    outcome.fault = fault_of(outcome, trial.folder);
  if (!trial.keep_after)
    fs::remove_all(results, ignored);
  return outcome;
}

Outcome run_here(const Trial &trial) {
  const fs::path here = fs::current_path();
  fs::current_path(trial.folder);
  fs::remove_all("results");
  std::ostringstream text;
  std::streambuf *const out = std::cout.rdbuf(text.rdbuf()), *const err =
                                                                 std::cerr.rdbuf(text.rdbuf());
  Outcome outcome;
  outcome.status = command(trial.words, false);
  std::cout.rdbuf(out);
  std::cerr.rdbuf(err);
  fs::current_path(here);
  outcome.output = text.str();
  if (!trial.keep_after)
    fs::remove_all(trial.folder + "/results");
  signal(SIGINT, SIG_DFL); // the program's own handlers are for processes that are its own
  signal(SIGTERM, SIG_DFL);
  return outcome;
}

void warm_up(const Trial &trial) {
  if (const int status = run_here(trial).status; status != 0)
    throw std::runtime_error("What is run first ends with " + std::to_string(status) + ".");
}

} // namespace fuzz
