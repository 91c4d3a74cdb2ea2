// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/spectrum/spectrum_chart.h"

#include "results/page/plot.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Frequencies to draw: the ends of all curves and the modes between them [Hz].
std::pair<double, double> drawn_range(const Scene &scene, const Results &results) {
  double first = results.modes.front().frequency, last = results.modes.back().frequency;
  for (const Spectrum &spectrum : scene.spectra)
    for (const auto &[f, a] : spectrum.curve)
      if (f > 0. && std::isfinite(f)) {
        first = std::min(first, f);
        last = std::max(last, f);
      }
  return {first / 1.2, last * 1.2};
}

} // namespace

std::string spectrum_chart(const Scene &scene, const Results &results) {
  if (scene.spectra.empty() || results.modes.empty() || !(results.modes.front().frequency > 0.))
    return "";
  constexpr unsigned int n_points = 300;
  const auto [first, last] = drawn_range(scene, results);
  const double unit = scene.units.factor("m/s2");
  Plot plot;
  plot.title = "Spectra, and the modes on them";
  plot.x_label = "frequency [Hz]";
  plot.y_label = "pseudo-acceleration [" + scene.units.name("m/s2") + "]";
  plot.log_x = true;
  for (const Spectrum &spectrum : scene.spectra) {
    Plot::Series line, modes;
    line.label = spectrum.name;
    modes.style = Plot::Series::Style::points;
    line.colour = modes.colour = series_colour(plot.series.size() / 2);
    for (const double f : logarithmic_steps(first, last, n_points)) {
      line.x.push_back(f);
      line.y.push_back(spectrum.at(f, scene.response.interpolation) / unit);
    }
    for (const ModeResult &mode : results.modes) {
      modes.x.push_back(mode.frequency);
      modes.y.push_back(spectrum.at(mode.frequency, scene.response.interpolation) / unit);
    }
    plot.series.push_back(line);
    plot.series.push_back(modes);
  }
  return html_of_plots({plot}, "spectra");
}

} // namespace frictionbeam
