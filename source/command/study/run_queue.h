// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <atomic>
#include <optional>
#include <vector>

namespace frictionbeam::study {

/**
 * Deals out the runs of a study, one at a time, to whoever asks: threads of this process and, under
 * mpirun, all processes, which count in the memory of the first one. To be made and destroyed by
 * all processes together.
 */
class RunQueue {
public:
  /// @param todo numbers of the runs, the same on all processes
  explicit RunQueue(std::vector<std::size_t> todo);
  ~RunQueue();
  RunQueue(const RunQueue &) = delete;
  RunQueue &operator=(const RunQueue &) = delete;

  /// The next one; none when all have been dealt out. By one thread of a process under mpirun.
  std::optional<std::size_t> next();
  std::size_t n_dealt() const { return n_here; } ///< as far as this process knows

private:
  const std::vector<std::size_t> todo;
  std::atomic<std::size_t> n_here{0};
  MPI_Win window = MPI_WIN_NULL;
  unsigned long long *counter = nullptr; ///< in the window
};

} // namespace frictionbeam::study
