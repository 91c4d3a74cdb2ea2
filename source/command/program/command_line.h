// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/run_options.h"
#include "command/contact_command.h"
#include "command/spectrum_command.h"
#include "import/import_pcf.h"

namespace frictionbeam {

/// What the command line asks for.
struct CommandLine {
  enum class Command {
    run,
    check,
    compare,
    contact,
    chart,
    chart_parameters,
    study,
    spectrum,
    record,
    import,
    nothing
  };
  Command command = Command::nothing;
  RunOptions options;     ///< of run, check and study
  std::string folders[2]; ///< of compare
  ContactOptions contact;
  SpectrumOptions spectrum; ///< of spectrum and record
  import::ImportOptions import;
  std::string chart_list;   ///< of chart
  std::string chart_folder; ///< where it goes; empty: output/chart_<its name>
};

/**
 * Read the command line. What only prints (help, version, parameters, man page, completion of
 * bash) is done here and leaves Command::nothing.
 * @throws UserError for what is not understood
 */
CommandLine read_command_line(const int argc, const char *const *argv);

} // namespace frictionbeam
