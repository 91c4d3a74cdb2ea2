// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/study/run_queue.h"

#include "base/processes.h"

namespace frictionbeam::study {

RunQueue::RunQueue(std::vector<std::size_t> todo_here) : todo(std::move(todo_here)) {
  if (n_processes() == 1)
    return;
  const MPI_Aint size = this_process() == 0 ? sizeof(*counter) : 0;
  MPI_Win_allocate(size, sizeof(*counter), MPI_INFO_NULL, MPI_COMM_WORLD, &counter, &window);
  if (this_process() == 0) {
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
    *counter = 0;
    MPI_Win_unlock(0, window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

RunQueue::~RunQueue() {
  if (window != MPI_WIN_NULL)
    MPI_Win_free(&window);
}

std::optional<std::size_t> RunQueue::next() {
  unsigned long long place = 0;
  if (window == MPI_WIN_NULL)
    place = n_here++;
  else {
    const unsigned long long one = 1;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
    MPI_Fetch_and_op(&one, &place, MPI_UNSIGNED_LONG_LONG, 0, 0, MPI_SUM, window);
    MPI_Win_unlock(0, window);
    n_here = place + 1;
  }
  if (place >= todo.size())
    return {};
  return todo[place];
}

} // namespace frictionbeam::study
