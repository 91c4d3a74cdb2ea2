// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/chart_command.h"

#include "chart/chart_page.h"
#include "chart/work_precision.h"

#include "results/file/output_file.h"
#include "results/text.h"

#include <iostream>

namespace frictionbeam {

int chart_command(const std::string &file, std::string folder) {
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
