// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/interruption.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

namespace frictionbeam::interruption {

namespace {

constexpr time_t patience = 3; // [s] for the increment at hand, after which there is a checkpoint

volatile sig_atomic_t flag = 0;
volatile time_t since = 0;

time_t now() { // may be called by a signal's handler
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

void handle(const int signal) {
  if (flag != 0)
    _exit(128 + signal);
  since = now();
  flag = signal;
}

} // namespace

void listen() {
  struct sigaction action = {};
  action.sa_handler = &handle;
  action.sa_flags = SA_RESTART; // what is being written is written to its end
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int received() { return flag; }

void end_if_overdue() {
  if (flag != 0 && now() - since > patience)
    throw Interrupted(flag, "Interrupted within an increment that takes long: what it did so far "
                            "is lost.");
}

} // namespace frictionbeam::interruption
