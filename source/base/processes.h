// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

/**
 * @file
 * Number of this process and of all, also where MPI has not been started, in which case deal.II's
 * own functions may not be called.
 */
namespace frictionbeam {

inline unsigned int this_process(const MPI_Comm communicator = MPI_COMM_WORLD) {
  namespace MPI = dealii::Utilities::MPI;
  return MPI::job_supports_mpi() ? MPI::this_mpi_process(communicator) : 0;
}

inline unsigned int n_processes(const MPI_Comm communicator = MPI_COMM_WORLD) {
  namespace MPI = dealii::Utilities::MPI;
  return MPI::job_supports_mpi() ? MPI::n_mpi_processes(communicator) : 1;
}

} // namespace frictionbeam
