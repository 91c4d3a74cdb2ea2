// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/page/plot.h"
#include "results/page/html.h"
#include "results/text.h"

#include "base/file_bytes.h"
#include "base/numbers.h"
#include "base/process.h"
#include "base/temporary_folder.h"

#include <deal.II/base/exceptions.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace frictionbeam {

namespace {

/// In gnuplot's single quotes, which know no escapes but the doubled quote.
std::string quoted(const std::string &text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? "''" : static_cast<unsigned char>(c) < 0x20 ? " " : std::string(1, c);
  return result + "'";
}

/// Places of a series to draw: of each of some 500 stretches its first, lowest, highest and last.
std::vector<std::size_t> thinned(const std::vector<double> &y) {
  constexpr std::size_t n_stretches = 500;
  std::vector<std::size_t> places;
  if (y.size() <= 4 * n_stretches) {
    for (std::size_t i = 0; i < y.size(); ++i)
      places.push_back(i);
    return places;
  }
  for (std::size_t stretch = 0; stretch < n_stretches; ++stretch) {
    const std::size_t begin = stretch * y.size() / n_stretches;
    const std::size_t end = (stretch + 1) * y.size() / n_stretches;
    const auto [low, high] = std::minmax_element(y.begin() + begin, y.begin() + end);
    std::array<std::size_t, 4> found{{begin, static_cast<std::size_t>(low - y.begin()),
                                      static_cast<std::size_t>(high - y.begin()), end - 1}};
    std::sort(found.begin(), found.end());
    places.insert(places.end(), found.begin(), std::unique(found.begin(), found.end()));
  }
  return places;
}

/// Leave out points that lie within the pen of the line that remains (Douglas and Peucker 1973).
/// @param width, height of what the chart shows
std::vector<std::size_t> on_the_curve(const std::vector<std::size_t> &places,
                                      const Plot::Series &series, const double width,
                                      const double height) {
  constexpr double pen = 2.5e-4; // of the chart's height, 0.05 px
  const auto x = [&](const std::size_t k) { return series.x[places[k]] / width; };
  const auto y = [&](const std::size_t k) { return series.y[places[k]] / height; };
  std::vector<bool> stays(places.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> stretches{{0, places.size() - 1}};
  stays.front() = stays.back() = true;
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    const double dx = x(last) - x(first), dy = y(last) - y(first), length = std::hypot(dx, dy);
    double most = pen;
    std::size_t farthest = 0;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double ex = x(k) - x(first), ey = y(k) - y(first);
      const double along =
          length > 0. ? std::clamp((ex * dx + ey * dy) / (length * length), 0., 1.) : 0.;
      const double distance = std::hypot(ex - along * dx, ey - along * dy);
      if (!(distance <= most)) { // nan stays
        farthest = k;
        most = distance;
      }
    }
    if (farthest > 0) {
      stays[farthest] = true;
      stretches.emplace_back(first, farthest);
      stretches.emplace_back(farthest, last);
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (stays[k])
      result.push_back(places[k]);
  return result;
}

/// Least and largest of what a chart shows along an axis; the least is above if there is nothing.
std::pair<double, double> range_of(const Plot &plot, const char axis) {
  const bool log = axis == 'x' ? plot.log_x : plot.log_y;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const auto &series : plot.series)
    for (const double value : axis == 'x' ? series.x : series.y)
      if (std::isfinite(value) && (value > 0. || !log)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  return {low, high};
}

/// Places of a series to draw.
std::vector<std::size_t> places_to_draw(const Plot &plot, const Plot::Series &series) {
  std::vector<std::size_t> places = thinned(series.y);
  const auto [left, right] = range_of(plot, 'x');
  const auto [bottom, top] = range_of(plot, 'y');
  const auto is_finite = [](const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(),
                       [](const double v) { return std::isfinite(v); });
  };
  if (series.style != Plot::Series::Style::line || plot.log_x || plot.log_y || places.size() < 3 ||
      left >= right || bottom >= top || !is_finite(series.x) || !is_finite(series.y))
    return places;
  return on_the_curve(places, series, right - left, top - bottom);
}

/// Whether anything was written that can be drawn.
bool write_data(const Plot &plot, const Plot::Series &series, std::ostream &script) {
  AssertDimension(series.x.size(), series.y.size());
  bool some = false;
  for (const std::size_t i : places_to_draw(plot, series)) {
    const double x = series.x[i], y = series.y[i];
    if (std::isfinite(x) && std::isfinite(y) && (x > 0. || !plot.log_x) &&
        (y > 0. || !plot.log_y)) {
      script << rounded_number(x, 9) << ' ' << rounded_number(y, 9) << '\n';
      some = true;
    } else
      script << '\n';
  }
  return some;
}

/// How the numbers of an axis are written: powers of ten where they are far apart from 1.
std::string format_of(const Plot &plot, const char axis) {
  constexpr double small = 1e-3, large = 1e5; // written out as they are
  const auto [low, high] = range_of(plot, axis);
  const bool log = axis == 'x' ? plot.log_x : plot.log_y;
  return log && (low < small || high > large) ? "1e%T" : "%g";
}

/// A range that gnuplot does not complain about where all values are the same.
void write_range(const Plot &plot, const char axis, std::ostream &script) {
  const bool log = axis == 'x' ? plot.log_x : plot.log_y;
  const auto [low, high] = range_of(plot, axis);
  script << "set " << axis << "range [*:*]\n";
  if (axis == 'x')
    script << "set autoscale xfix\n";
  if (log && axis == 'x' && low < high) {
    script << "set xrange [" << rounded_number(low / 1.3, 9) << ':' << rounded_number(high * 1.3, 9)
           << "]\nset xtics autofreq\n";
    if (high < 30. * low) // less than two decades want more than one number
      for (int decade = std::floor(std::log10(low)) - 1; std::pow(10., decade) < high * 1.3;
           ++decade)
        for (const double digit : {1., 2., 5.})
          script << "set xtics add (" << rounded_number(digit * std::pow(10., decade)) << ")\n";
    return;
  }
  if (high < low || high - low > equal_numbers * std::max(std::abs(high), std::abs(low)))
    return;
  const double margin = high == 0. ? 1. : std::abs(high) * (log ? 0.5 : 0.1);
  script << "set " << axis << "range [" << rounded_number(low - margin, 12) << ':'
         << rounded_number(high + margin, 12) << "]\n";
}

/// Terminal, titles, axes, key and labels.
/// @param with_key whether any curve has a label
void write_settings(const Plot &plot, const std::string &name, const std::string &file,
                    const bool with_key, std::ostream &script) {
  script << "set terminal svg size " << plot.width << ',' << plot.height
         << " dynamic noenhanced font 'sans-serif,11' name '" << name << "' background 'white'\n"
         << "set output " << quoted(file) << '\n'
         << "set title " << quoted(plot.title) << " font 'sans-serif,13'"
         << "\nset xlabel " << quoted(plot.x_label) << " offset 0,0.3\nset ylabel "
         << quoted(plot.y_label) << '\n'
         << (plot.log_x ? "set logscale x 10\n" : "unset logscale x\n")
         << (plot.log_y ? "set logscale y 10\n" : "unset logscale y\n") << "set format x '"
         << (!plot.x_format.empty() ? plot.x_format : format_of(plot, 'x')) << "'\nset format y '"
         << format_of(plot, 'y') << "'\n";
  write_range(plot, 'x', script);
  write_range(plot, 'y', script);
  script << (!with_key ? "unset key\n"
             : plot.key == Plot::Key::right
                 ? "set key outside right top vertical Left reverse samplen 2 spacing 1.4 "
                   "noenhanced\n"
                 : "set key default\nset key outside top center horizontal samplen 2 noenhanced\n");
  script << "unset label\n";
  for (const Plot::Label &label : plot.labels)
    script << "set label " << quoted(label.text) << " at " << rounded_number(label.x, 9) << ','
           << rounded_number(label.y, 9)
           << " front offset 0.7,0.6 font 'sans-serif,9' textcolor rgb '#333333' noenhanced\n";
}

/// How curve @p i is drawn.
void write_style(const Plot::Series &series, const unsigned int i, std::ostream &script) {
  const bool line = series.style != Plot::Series::Style::points;
  const bool points = series.style != Plot::Series::Style::line;
  script << "$data" << i << " using 1:2 with "
         << (line ? (points ? "linespoints" : "lines") : "points") << " linecolor rgb '"
         << (series.colour.empty() ? series_colour(i) : series.colour) << "'";
  if (line)
    script << " linewidth " << rounded_number(series.line_width) << " dashtype "
           << (series.dashed ? "'--'" : "solid");
  if (points)
    script << " pointtype "
           << std::array<int, 7>{{7, 5, 9, 13, 11, 4,
                                  2}}[(series.marker > 0 ? series.marker - 1 : i % 6) % 7]
           << " pointsize " << rounded_number(series.point_size);
  script << ' ' << (series.label.empty() ? "notitle" : "title " + quoted(series.label));
}

void write_plot(const Plot &plot, const std::string &name, const std::string &file,
                std::ostream &script) {
  std::vector<unsigned int> drawn;
  std::string key;
  for (unsigned int i = 0; i < plot.series.size(); ++i) {
    script << "$data" << i << " << END_OF_DATA\n";
    if (write_data(plot, plot.series[i], script)) {
      drawn.push_back(i);
      key += plot.series[i].label;
    }
    script << "END_OF_DATA\n";
  }
  write_settings(plot, name, file, !key.empty(), script);
  if (drawn.empty()) {
    script << "set xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\nunset output\n";
    return;
  }
  for (const unsigned int i : drawn) {
    script << (i == drawn.front() ? "plot " : ", ");
    write_style(plot.series[i], i, script);
  }
  script << "\nunset output\nset print " << quoted(file + ".axes")
         << "\nprint sprintf('%.9g %.9g %.9g %.9g" << (plot.log_x ? " logx" : "")
         << (plot.log_y ? " logy" : "")
         << "', GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_Y_MIN, GPVAL_Y_MAX)\nunset print\n";
}

/// Run gnuplot on a script; what went wrong, or nothing.
std::string run_gnuplot(const std::string &folder) {
  constexpr double seconds = 600.;
  const ProcessResult process =
      run_process({"gnuplot", "--default-settings", folder + "/script"}, "", seconds);
  if (process.exit_status == 127)
    return "gnuplot is not installed (Debian: gnuplot-nox)";
  if (process.timed_out)
    return "gnuplot took more than " + rounded_number(seconds) + " s";
  return process.exit_status == 0 ? "" : "gnuplot failed: " + process.output.substr(0, 500);
}

/// Remove the groups that hold nothing, which gnuplot writes by the hundred.
std::string without_empty_groups(const std::string &svg) {
  std::string result;
  std::size_t at = 0;
  while (true) {
    const std::size_t group = svg.find("<g ", at);
    if (group == std::string::npos)
      return result + svg.substr(at);
    result += svg.substr(at, group - at);
    const std::size_t content = svg.find('>', group) + 1;
    const std::size_t next = svg.find_first_not_of(" \n\t", content);
    if (svg.compare(next, 4, "</g>") == 0)
      at = svg.find_first_not_of(" \n\t", next + 4);
    else {
      result += svg.substr(group, content - group);
      at = next;
    }
  }
}

/// Without prolog and description, and with ids that no other chart has; with what it shows in
/// words, and its axes for the page's script.
/// @param axes the ranges that gnuplot has chosen
std::string as_element(std::string svg, const std::string &name, const Plot &plot,
                       const std::string &axes) {
  const std::size_t begin = svg.find("<svg"), end = svg.rfind("</svg>");
  if (begin == std::string::npos || end == std::string::npos)
    return "";
  svg = "<svg role=\"img\" aria-label=\"" +
        escape_xml((plot.title.empty() ? "" : plot.title + ": ") + plot.y_label + " over " +
                   plot.x_label) +
        "\" data-axes=\"" + escape_xml(axes) + "\"" + svg.substr(begin + 4, end + 2 - begin);
  const auto erase = [&](const std::string &from, const std::string &to) {
    const std::size_t first = svg.find(from), last = svg.find(to);
    if (first != std::string::npos && last != std::string::npos && first < last)
      svg.erase(first, last + to.size() - first);
  };
  erase("<title>", "</desc>");
  if (svg.find("xlink:href", svg.find("</defs>")) == std::string::npos) // no marker is used
    erase("<defs>", "</defs>");
  for (const char *id : {"gpDot", "gpPt", "textbox", "greybox", "gnuplot_canvas"})
    boost::replace_all(svg, id, name + "_" + id);
  for (const auto &[wordy, plain] : std::initializer_list<std::pair<const char *, const char *>>{
           {" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", ""}, // as they are unless said
           {" color=\"black\" stroke=\"currentColor\"", " stroke=\"#000\""},
           {" class=\"gridline\"", ""},
           {"rgb(221, 221, 221)", "#ddd"},
           {"rgb(102, 102, 102)", "#666"},
           {"rgb(51,51,51)", "#333"},
           {"  '/>", "'/>"},
           {"\n\t\t", "\n"}})
    boost::replace_all(svg, wordy, plain);
  return without_empty_groups(svg);
}

} // namespace

std::string series_colour(const unsigned int i) {
  static const std::array<std::string, 6> colours{
      {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00"}}; // Okabe and Ito
  return colours[i % colours.size()];
}

DrawnPlots draw_plots(const std::vector<Plot> &plots, const std::string &prefix) {
  DrawnPlots drawn;
  drawn.svg.resize(plots.size());
  if (plots.empty())
    return drawn;
  const TemporaryFolder folder;
  if (folder.path.empty()) {
    drawn.problem = "no temporary folder can be made for gnuplot";
    return drawn;
  }

  const auto name = [&](const std::size_t i) { return prefix + std::to_string(i); };
  const auto file = [&](const std::size_t i) { return folder.path + "/" + name(i) + ".svg"; };
  {
    std::ofstream script(folder.path + "/script");
    script << "set encoding utf8\n"
              "set style line 10 linecolor rgb '#dddddd' linewidth 0.6\n"
              "set grid back linestyle 10\n"
              "set border 3 linecolor rgb '#666666'\n"
              "set tics nomirror out scale 0.5 textcolor rgb '#333333'\n"
              "set xzeroaxis linetype 1 linecolor rgb '#888888' linewidth 0.8\n"
              "set samples 2\n";
    for (std::size_t i = 0; i < plots.size(); ++i)
      write_plot(plots[i], name(i), file(i), script);
    if (!script.flush()) {
      drawn.problem = "the data for gnuplot cannot be written to " + folder.path;
      return drawn;
    }
  }
  drawn.problem = run_gnuplot(folder.path);
  for (std::size_t i = 0; drawn.problem.empty() && i < plots.size(); ++i)
    drawn.svg[i] =
        as_element(file_bytes(file(i)), name(i), plots[i], file_bytes(file(i) + ".axes"));
  return drawn;
}

std::string html_charts(const DrawnPlots &drawn, const std::size_t first, const std::size_t n) {
  if (!drawn.problem.empty())
    return html_note("There is no chart here, since " + drawn.problem + ".");
  std::string text = "<div class=\"charts\">\n";
  for (std::size_t i = first; i < first + n; ++i)
    text += "<div>" + drawn.svg[i] + "</div>\n";
  return text + "</div>\n";
}

std::string html_of_plots(const std::vector<Plot> &plots, const std::string &prefix) {
  return html_charts(draw_plots(plots, prefix), 0, plots.size());
}

} // namespace frictionbeam
