// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/study_runs.h"

#include "base/interruption.h"
#include "base/processes.h"
#include "command/study/run_queue.h"

#include <unistd.h>

#include <exception>
#include <iostream>
#include <thread>

namespace frictionbeam::study {

namespace {

namespace MPI = dealii::Utilities::MPI;

/// Numbers of the runs that nobody has done: the first process knows.
std::vector<std::size_t> pending_runs(const StudyResults &study) {
  std::vector<std::size_t> todo;
  for (std::size_t run = 0; run < study.runs.size(); ++run)
    if (study.runs[run].outcome == Outcome::pending)
      todo.push_back(run);
  return n_processes() == 1 ? todo : MPI::broadcast(MPI_COMM_WORLD, todo);
}

/// How far the study is, on a terminal.
class ProgressOfRuns {
public:
  explicit ProgressOfRuns(const std::size_t n_runs)
      : n_runs(n_runs), is_shown(this_process() == 0 && isatty(STDERR_FILENO) != 0) {}
  ~ProgressOfRuns() {
    if (is_shown)
      std::cerr << "\r\033[K";
  }
  void show(const std::size_t n_dealt) const {
    if (is_shown)
      std::cerr << "\r\033[Krun " << std::min(n_dealt, n_runs) << " of " << n_runs << std::flush;
  }

private:
  const std::size_t n_runs;
  const bool is_shown;
};

/// What one thread does.
void work(const StudyCase &of, const Variables &variables, RunQueue &queue, RunJournal &journal,
          const ProgressOfRuns &progress, const bool shows, StudyResults &study) {
  StudySolver solver(of);
  while (interruption::received() == 0) {
    const std::optional<std::size_t> number = queue.next();
    if (!number)
      return;
    if (shows)
      progress.show(queue.n_dealt());
    study.runs[*number] =
        solver.solve(variables.settings(study.values[*number], study.texts[*number]));
    journal.write(*number, study.runs[*number]);
  }
}

/// All threads of this process; the first exception of any of them comes out.
void work_in_threads(const StudyCase &of, const Variables &variables, RunQueue &queue,
                     RunJournal &journal, StudyResults &study) {
  const ProgressOfRuns progress(study.runs.size());
  std::vector<std::exception_ptr> failures(study.n_threads);
  const auto guarded = [&](const unsigned int thread) {
    try {
      work(of, variables, queue, journal, progress, thread == 0, study);
    } catch (const Interrupted &) { // within a run, which is not done then
    } catch (const std::exception &) {
      failures[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (unsigned int thread = 1; thread < study.n_threads; ++thread)
    others.emplace_back(guarded, thread);
  guarded(0);
  for (std::thread &other : others)
    other.join();
  for (const std::exception_ptr &failure : failures)
    if (failure)
      std::rethrow_exception(failure);
}

/// Bring all runs to the first process, in parts of a size that MPI's counts hold.
void gather(const std::vector<std::size_t> &todo, StudyResults &study) {
  constexpr std::size_t runs_at_once = 10000;
  for (std::size_t begin = 0; begin < todo.size(); begin += runs_at_once) {
    Archive mine;
    for (std::size_t k = begin; k < std::min(todo.size(), begin + runs_at_once); ++k)
      if (Run &run = study.runs[todo[k]]; run.outcome != Outcome::pending)
        mine(k, run);
    for (const std::string &bytes : MPI::gather(MPI_COMM_WORLD, mine.bytes())) {
      Archive theirs(bytes);
      while (!theirs.at_end()) {
        std::size_t k = 0;
        theirs(k);
        theirs(study.runs[todo[k]]);
      }
    }
  }
}

} // namespace

void solve_runs(const StudyCase &of, const Variables &variables, RunJournal &journal,
                StudyResults &study) {
  const std::vector<std::size_t> todo = pending_runs(study);
  {
    RunQueue queue(todo);
    work_in_threads(of, variables, queue, journal, study);
  }
  int signal = interruption::received();
  if (n_processes() > 1) {
    signal = MPI::max(signal, MPI_COMM_WORLD);
    gather(todo, study);
  }
  if (signal != 0)
    throw Interrupted(signal,
                      "Interrupted when " +
                          std::to_string(study.runs.size() - study.count(Outcome::pending)) +
                          " of " + std::to_string(study.runs.size()) + " runs were done.");
}

} // namespace frictionbeam::study
