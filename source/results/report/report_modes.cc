// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report_modes.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/picture/coloured_line.h"
#include "results/picture/displacement_scale.h"
#include "results/report/limits.h"
#include "results/spectrum/modal_csv.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

double part_of_mass(const Results &results, const ModeResult &mode, const unsigned int d) {
  return results.total_mass[d] > 0. ? mode.effective_mass[d] / results.total_mass[d] : 0.;
}

std::string picture(const Scene &scene, const Results &results, const unsigned int number) {
  const ModeResult &mode = results.modes[number - 1];
  ColouredLine what;
  what.title = "Mode " + std::to_string(number) + ", " + rounded_number(mode.frequency, 5) + " Hz";
  what.legend = "displacement of the shape, from none to the largest";
  for (const Station &station : mode.shape.line)
    what.values.push_back(
        std::hypot(station.displacement[0], station.displacement[1], station.displacement[2]));
  what.scale = displacement_scale({&mode.shape});
  return "<div class=\"picture\">" + draw_coloured_line(scene, results, mode.shape, what) +
         "</div>\n";
}

} // namespace

std::string mode_section(const Scene &scene, const Results &results) {
  if (results.modes.empty())
    return "";
  std::vector<std::string> number, frequency, period, residual;
  std::array<std::vector<std::string>, 3> mass, sum;
  std::array<double, 3> so_far{};
  for (const ModeResult &mode : results.modes) {
    number.push_back(std::to_string(number.size() + 1));
    frequency.push_back(rounded_number(mode.frequency, 6));
    period.push_back(mode.frequency > 0. ? rounded_number(1. / mode.frequency, 4) : "\u2013");
    residual.push_back(rounded_number(mode.residual, 2));
    for (unsigned int d = 0; d < 3; ++d) {
      const double part = part_of_mass(results, mode, d);
      mass[d].push_back(fixed_number(100. * part, 2));
      sum[d].push_back(fixed_number(100. * (so_far[d] += part), 2));
    }
  }
  HtmlTable table;
  table.right("mode", number).right("frequency [Hz]", frequency).right("period [s]", period);
  const char *const axes[] = {"x", "y", "z"};
  for (unsigned int d = 0; d < 3; ++d)
    table.right(std::string("mass ") + axes[d] + " [%]", mass[d]).right("\u03a3 [%]", sum[d]);
  std::vector<std::pair<std::string, std::string>> panels;
  for (std::size_t i = 0; i < std::min(n_pictures_at_most, results.modes.size()); ++i)
    panels.emplace_back("mode " + std::to_string(i + 1), picture(scene, results, i + 1));
  return table.right("residual", residual).str() +
         html_note(
             "Effective modal masses as parts of the mass that can move, those at supports "
             "included, and their sums. Found by: " +
             results.modal_method +
             ". The residual is |K q - w\u00b2 M q| / |w\u00b2 M q|. Shapes are in modes.pvd.") +
         html_tabs("modes-of", panels) + excitation_table(results);
}

void write_modes(const Results &results, const std::string &folder) {
  if (results.modes.empty())
    return;
  std::string text = "mode,frequency,period,participation_x,participation_y,participation_z,"
                     "mass_x,mass_y,mass_z,residual\n";
  unsigned int number = 0;
  for (const ModeResult &mode : results.modes) {
    text += std::to_string(++number) + ',' + exact_number(mode.frequency) + ',' +
            exact_number(1. / mode.frequency);
    for (const double value : mode.participation)
      text += ',' + exact_number(value);
    for (unsigned int d = 0; d < 3; ++d)
      text += ',' + exact_number(part_of_mass(results, mode, d));
    text += ',' + exact_number(mode.residual) + '\n';
  }
  write_file(folder + "/modes.csv", text);
}

} // namespace frictionbeam
