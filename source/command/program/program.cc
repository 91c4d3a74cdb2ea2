// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/program/program.h"

#include "chart/chart_list.h"
#include "command/chart_command.h"
#include "command/check_command.h"
#include "command/compare_command.h"
#include "command/contact_command.h"
#include "command/import_command.h"
#include "command/program/command_line.h"
#include "command/run_case.h"
#include "command/spectrum_command.h"
#include "command/study/study_command.h"

#include "base/interruption.h"
#include "base/user_error.h"
#include "results/file/output_file.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parallel.h>

#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>
#include <streambuf>

namespace frictionbeam {

namespace {

bool started_by_mpirun() {
  for (const char *const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(variable) != nullptr)
      return true;
  return false;
}

/// Swallows what is printed, for --quiet.
class Silence : public std::streambuf {
public:
  Silence() : shown(std::cout.rdbuf(this)) {}
  ~Silence() override { std::cout.rdbuf(shown); }

private:
  int overflow(const int character) override { return traits_type::not_eof(character); }

  std::streambuf *const shown;
};

/// Of the commands that analyse a case.
int analyse(int argc, char **argv, const CommandLine &line) {
  // A process by itself needs no MPI, nor the daemon, network interface and common folder that
  // Open MPI wants: programs that start at the same time would get in each other's way there.
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  if (started_by_mpirun())
    mpi.emplace(argc, argv, 1);
  dealii::MultithreadInfo::set_thread_limit(1); // a line is too small to share out
  // TBB reads the map of all loaded libraries when it is first called, which takes some ms and is
  // part of starting the program.
  dealii::parallel::apply_to_subranges(
      0U, 1U, [](unsigned int, unsigned int) {}, 1U);
  interruption::listen();
  std::optional<Silence> silence;
  if (line.options.quiet)
    silence.emplace();
  switch (line.command) {
  case CommandLine::Command::check:
    return check_case_file(line.options);
  case CommandLine::Command::study:
    return study::study_command(line.options);
  default:
    return run_case(line.options);
  }
}

/// What the command line asks for. @return exit status
int run(int argc, char **argv) {
  const CommandLine line = read_command_line(argc, argv);
  switch (line.command) {
  case CommandLine::Command::nothing:
    return 0;
  case CommandLine::Command::compare:
    return compare_runs(line.folders[0], line.folders[1]);
  case CommandLine::Command::contact:
    return solve_contact_file(line.contact);
  case CommandLine::Command::spectrum:
    return spectrum_command(line.spectrum);
  case CommandLine::Command::record:
    return record_command(line.spectrum);
  case CommandLine::Command::import:
    return import_file(line.import);
  case CommandLine::Command::chart:
    return chart_command(line.chart_list, line.chart_folder);
  case CommandLine::Command::chart_parameters:
    chart::print_chart_parameters(std::cout);
    return 0;
  default:
    return analyse(argc, argv, line);
  }
}

/// What was printed must have arrived: it may go to a file on a full disk.
void check_standard_output() {
  errno = 0;
  if (!std::cout.flush())
    throw OutputError(std::string("The standard output cannot be written") +
                      (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()) +
                      ".");
}

} // namespace

int with_errors_told(const std::function<int()> &command) {
  try {
    return command();
  } catch (const UserError &error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (const OutputError &error) {
    std::cerr << error.what() << '\n';
    return 4;
  } catch (const Interrupted &interrupted) {
    std::cerr << interrupted.what() << '\n';
    return 128 + interrupted.signal;
  } catch (const std::exception &error) { // our own mistake: say all there is
    std::cerr << error.what() << '\n';
    return 3;
  }
}

int run_program(int argc, char **argv) {
  signal(SIGXFSZ, SIG_IGN); // a write beyond the limit fails with a reason then
  return with_errors_told([&]() {
    const int status = run(argc, argv);
    check_standard_output();
    return status;
  });
}

} // namespace frictionbeam
