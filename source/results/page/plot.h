// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// A two-dimensional chart.
struct Plot {
  struct Series {
    enum class Style { line, points, line_points };

    std::string label;        ///< in the key; empty: not there
    std::vector<double> x, y; ///< of equal length; a pair that is not finite breaks the line
    Style style = Style::line;
    bool dashed = false; ///< for a reference or a slope
    double line_width = 1.8;
    std::string colour;      ///< empty: that of its place among the series
    unsigned int marker = 0; ///< shape of its points, from 1 on; 0: that of its place
    double point_size = 0.6;
  };
  struct Label {
    double x, y;
    std::string text; ///< to the right of the point, above it
  };
  enum class Key { above, right };

  std::string title; ///< may be empty
  std::string x_label, y_label;
  bool log_x = false, log_y = false; ///< pairs that are not positive are left out
  std::string x_format;              ///< of the tics, as printf's; empty: %g, logarithmic 1e%T
  Key key = Key::above;
  unsigned int width = 560, height = 270; ///< [px]
  std::vector<Series> series;
  std::vector<Label> labels;
};

/// What draw_plots returns.
struct DrawnPlots {
  std::vector<std::string> svg; ///< one <svg> element for each plot, without XML prolog
  std::string problem;          ///< why there is none, in plain words; empty if all went well
};

/**
 * Draw all @p plots as SVG by one gnuplot process. The ids in the elements begin with @p prefix and
 * the plot's number, so that several fit into one page. A series is thinned to about 2000 points,
 * its peaks kept.
 *
 * Where gnuplot is missing or fails, each text is empty and @p problem says so: a chart is no
 * reason to lose a run.
 */
DrawnPlots draw_plots(const std::vector<Plot> &plots, const std::string &prefix = "plot");

/// Some of the plots drawn, side by side as HTML, or why there is none.
std::string html_charts(const DrawnPlots &drawn, const std::size_t first, const std::size_t n);
/// Draw plots, and all of them so.
std::string html_of_plots(const std::vector<Plot> &plots, const std::string &prefix);

/// Colour of the series number @p i, for readers with any kind of colour vision; six, then
/// repeated.
std::string series_colour(const unsigned int i);

} // namespace frictionbeam
