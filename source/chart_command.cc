// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart_command.h"

#include "chart/chart_page.h"
#include "chart/work_precision.h"

#include <frictionbeam/results/output_file.h>
#include <frictionbeam/results/text.h>
#include <frictionbeam/scene/user_error.h>

#include <iostream>

namespace frictionbeam {

int chart_command(const std::vector<std::string> &arguments) {
  std::string file, folder;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--print-parameters") {
      chart::print_chart_parameters(std::cout);
      return 0;
    }
    if (arguments[i] == "--output-directory" && i + 1 < arguments.size())
      folder = arguments[++i];
    else if (arguments[i][0] == '-' || !file.empty())
      throw UserError("'frictionbeam chart' does not know '" + arguments[i] +
                      "'. It takes the path of one list and --output-directory FOLDER: "
                      "frictionbeam chart prm/chart/slab.prm");
    else
      file = arguments[i];
  }
  if (file.empty())
    throw UserError("'frictionbeam chart' takes the path of a list: frictionbeam chart "
                    "prm/chart/slab.prm; frictionbeam chart --print-parameters shows its entries.");
  const chart::ChartList list = chart::read_chart_list(file);
  if (folder.empty())
    folder = "output/chart_" + list.name;
  prepare_output_folder(folder);
  const std::vector<chart::Measurement> measurements = chart::measure(list);
  chart::write_chart(list, measurements, folder);
  for (const double accuracy : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
    if (const auto found = chart::cheapest(measurements, accuracy * (1. + 1e-12)))
      std::cout << "Error at most " << rounded_number(accuracy) << ": "
                << chart::name_of(list, measurements[*found]) << ", "
                << chart::readable_time(measurements[*found].median()) << '\n';
  std::cout << "The chart is " << folder << '/' << list.name
            << ".svg, with .csv and .md beside it\n";
  return 0;
}

} // namespace frictionbeam
