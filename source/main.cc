// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart_command.h"
#include "check_command.h"
#include "compare_command.h"
#include "contact_command.h"
#include "run_case.h"

#include <frictionbeam/analysis/interruption.h>
#include <frictionbeam/results/output_file.h>
#include <frictionbeam/results/summary.h>
#include <frictionbeam/scene/read_scene.h>
#include <frictionbeam/scene/user_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parallel.h>

#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>

namespace {

const char *const usage =
    "frictionbeam CASE.prm [options]     solve a piping line on friction supports\n"
    "  --set \"Section/Entry = value\"     change an entry of the file; may be repeated\n"
    "  --output-directory FOLDER         where results go (default: output/CASE)\n"
    "  --resume                          go on where a run into that folder was killed\n"
    "frictionbeam check CASE.prm          draw the model and say what was understood; solve "
    "nothing\n"
    "frictionbeam compare FOLDER FOLDER   what changes between the results of two runs, and where\n"
    "frictionbeam contact FILE.hdf5      solve a friction-contact problem in the format of FCLIB\n"
    "frictionbeam chart LIST.prm             run a list of configurations, draw error against "
    "time\n"
    "frictionbeam --print-parameters     every entry there is, with unit, bounds and meaning\n"
    "frictionbeam --version\n"
    "frictionbeam --help\n"
    "Exit status: 0 solved; 1 the input is wrong; 2 no convergence or no equilibrium;\n"
    "3 a mistake of the program's own; 4 results cannot be written, as on a full disk;\n"
    "130 and 143 ended by SIGINT and SIGTERM, with a checkpoint for --resume.\n";

bool started_by_mpirun() {
  for (const char *const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(variable) != nullptr)
      return true;
  return false;
}

/// Options as they stand on the command line. @return whether a case is to be run.
bool read_command_line(const int argc, char **argv, frictionbeam::RunOptions &options) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto value = [&]() -> std::string {
      if (++i == argc)
        throw frictionbeam::UserError("The option " + argument + " needs a value. See --help.");
      return argv[i];
    };
    if (argument == "--help" || argument == "-h") {
      std::cout << usage;
      return false;
    } else if (argument == "--version") {
      std::cout << "FrictionBeam " << frictionbeam::program_version() << ", deal.II "
                << frictionbeam::deal_ii_version() << '\n';
      return false;
    } else if (argument == "--print-parameters") {
      frictionbeam::LawLibrary laws;
      laws.load_builtin();
      frictionbeam::print_parameters(std::cout, laws);
      return false;
    } else if (argument == "--set")
      options.overrides.push_back(value());
    else if (argument == "--output-directory")
      options.output_directory = value();
    else if (argument == "--resume")
      options.resume = true;
    else if (argument[0] == '-')
      throw frictionbeam::UserError("There is no option '" + argument + "'. See --help.");
    else if (!options.parameter_file.empty())
      throw frictionbeam::UserError("One parameter file a run: read '" + options.parameter_file +
                                    "' and '" + argument + "'.");
    else
      options.parameter_file = argument;
  }
  if (options.parameter_file.empty())
    throw frictionbeam::UserError(std::string("Which case? Name a parameter file.\n") + usage);
  return true;
}

int solve_contact_command(const int argc, char **argv) {
  if (argc != 3 || argv[2][0] == '-')
    throw frictionbeam::UserError("'frictionbeam contact' takes one argument, the path of an FCLIB "
                                  "file: frictionbeam contact problem.hdf5");
  return frictionbeam::solve_contact_file(argv[2]);
}

/// What the command line asks for. @return exit status
int run(int argc, char **argv) {
  if (argc > 1 && std::string(argv[1]) == "contact")
    return solve_contact_command(argc, argv);
  if (argc > 1 && std::string(argv[1]) == "chart")
    return frictionbeam::chart_command(std::vector<std::string>(argv + 2, argv + argc));
  if (argc > 1 && std::string(argv[1]) == "compare") {
    if (argc != 4)
      throw frictionbeam::UserError("'frictionbeam compare' takes two folders with results: "
                                    "frictionbeam compare output/a output/b");
    return frictionbeam::compare_runs(argv[2], argv[3]);
  }
  const bool check = argc > 1 && std::string(argv[1]) == "check";
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
  frictionbeam::RunOptions options;
  if (!read_command_line(argc - (check ? 1 : 0), argv + (check ? 1 : 0), options))
    return 0;
  frictionbeam::interruption::listen();
  return check ? check_case_file(options) : run_case(options);
}

/// What was printed must have arrived: it may go to a file on a full disk.
void check_standard_output() {
  errno = 0;
  if (!std::cout.flush())
    throw frictionbeam::OutputError(
        std::string("The standard output cannot be written") +
        (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()) + ".");
}

} // namespace

int main(int argc, char **argv) {
  signal(SIGXFSZ, SIG_IGN); // a write beyond the limit fails with a reason then
  try {
    const int status = run(argc, argv);
    check_standard_output();
    return status;
  } catch (const frictionbeam::UserError &error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (const frictionbeam::OutputError &error) {
    std::cerr << error.what() << '\n';
    return 4;
  } catch (const frictionbeam::Interrupted &interrupted) {
    std::cerr << interrupted.what() << '\n';
    return 128 + interrupted.signal;
  } catch (const std::exception &error) { // our own mistake: say all there is
    std::cerr << error.what() << '\n';
    return 3;
  }
}
