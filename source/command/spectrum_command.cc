// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/spectrum_command.h"

#include "analysis/vibration/matched_record.h"
#include "base/user_error.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/text.h"
#include "scene/spectra/curve_file.h"
#include "scene/spectra/interpolations.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace frictionbeam {

namespace {

CurveForm form_of(const SpectrumOptions &options) {
  CurveForm form;
  form.unit_name = options.unit.empty() ? "m/s2" : options.unit;
  form.unit = acceleration_unit(form.unit_name);
  if (form.unit == 0.)
    throw UserError("--unit:\n  read:    '" + options.unit +
                    "'\n  allowed: " + acceleration_units() + "\n  try:     --unit g");
  form.unit_given = !options.unit.empty();
  form.over_period = options.over_period;
  form.axis_given = options.over_period;
  return form;
}

std::string folder_of(const SpectrumOptions &options, const std::string &what) {
  return options.folder.empty()
             ? "output/" + what + '_' + std::filesystem::path(options.file).stem().string()
             : options.folder;
}

void check_frequencies(const double first, const double last) {
  if (!(first > 0.) || !(last > first))
    throw UserError("--from, --to:\n  read:    " + rounded_number(first) + " and " +
                    rounded_number(last) +
                    " Hz\n  allowed: two frequencies > 0, the second one higher\n  try:     --from "
                    "0.2 --to 50");
}

Plot::Series line_of(const std::string &label, const std::vector<double> &x, std::vector<double> y,
                     const double unit, const bool dashed = false) {
  for (double &value : y)
    value /= unit;
  Plot::Series series;
  series.label = label;
  series.x = x;
  series.y = std::move(y);
  series.dashed = dashed;
  return series;
}

Plot plot_of(const std::string &title, const std::string &x, const std::string &y) {
  Plot plot;
  plot.title = title;
  plot.x_label = x;
  plot.y_label = y;
  return plot;
}

Plot spectrum_plot(const std::string &title, const CurveForm &form) {
  Plot plot = plot_of(title, "frequency [Hz]", "pseudo-acceleration [" + form.unit_name + "]");
  plot.log_x = plot.log_y = true;
  return plot;
}

Plot history_plot(const std::string &title, const AccelerationRecord &record,
                  const std::vector<double> &values, const double unit, const std::string &name) {
  Plot plot = plot_of(title, "time [s]", name);
  plot.series = {line_of("", record.time, values, unit)};
  return plot;
}

std::string number_rows(const std::string &header,
                        const std::vector<const std::vector<double> *> &columns,
                        const std::vector<double> &units) {
  std::string text = header + '\n';
  for (std::size_t i = 0; i < columns.front()->size(); ++i)
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += exact_number((*columns[c])[i] / units[c]) + (c + 1 < columns.size() ? ',' : '\n');
  return text;
}

} // namespace

int spectrum_command(const SpectrumOptions &options) {
  CurveForm form = form_of(options);
  const AccelerationRecord record = read_record_file(options.file, form, options.file);
  const double first = options.first == 0. ? 0.1 : options.first,
               last = options.last == 0. ? 100. : options.last;
  check_frequencies(first, last);
  const std::vector<double> frequencies = logarithmic_steps(first, last, options.n_frequencies);
  const std::string folder = folder_of(options, "spectrum");
  prepare_output_folder(folder);
  Plot plot = spectrum_plot("Response spectra", form);
  std::vector<double> dampings = options.damping;
  if (dampings.empty())
    dampings = {0.05};
  for (const double damping : dampings) {
    std::vector<double> accelerations;
    for (const double f : frequencies)
      accelerations.push_back(pseudo_acceleration(record, f, damping));
    const std::string file = folder + "/spectrum_" + rounded_number(damping) + ".csv";
    write_file(file, "# " + options.file + ", damping " + rounded_number(damping) +
                         ", pseudo-acceleration; zero-period " +
                         exact_number(record.largest() / form.unit) + "\n" +
                         number_rows("frequency [Hz],acceleration [" + form.unit_name + "]",
                                     {&frequencies, &accelerations}, {1., form.unit}));
    plot.series.push_back(
        line_of("damping " + rounded_number(damping), frequencies, accelerations, form.unit));
    std::cout << file << ": largest "
              << rounded_number(
                     *std::max_element(accelerations.begin(), accelerations.end()) / form.unit, 4)
              << ' ' << form.unit_name << '\n';
  }
  write_file(
      folder + "/spectrum.html",
      html_page("Spectra of " + options.file,
                "<h1>Spectra of " + escape_xml(options.file) + "</h1>\n" +
                    html_of_plots({history_plot("The record", record, record.acceleration,
                                                form.unit, "acceleration [" + form.unit_name + "]"),
                                   plot},
                                  "spectrum") +
                    html_note("Pseudo-acceleration \u03c9\u00b2|u| of oscillators, exact for a "
                              "record that is straight between its instants. Largest "
                              "acceleration of the record, which is that of zero period: " +
                              rounded_number(record.largest() / form.unit, 5) + " " +
                              form.unit_name + ".")));
  std::cout << "The charts are in " << folder << "/spectrum.html\n";
  return 0;
}

namespace {

/// Its numbers, and how well it fits.
std::string record_page(const SpectrumOptions &options, const CurveForm &form,
                        const MatchedRecordSettings &settings, const MatchedRecord &match,
                        const GroundMotion &motion) {
  Plot spectra = spectrum_plot("Its spectrum and the target", form);
  spectra.series = {line_of("target", match.frequency, match.target, form.unit, true),
                    line_of("of the record", match.frequency, match.response, form.unit)};
  const std::vector<Plot> plots = {
      history_plot("Acceleration", match.record, match.record.acceleration, form.unit,
                   "[" + form.unit_name + "]"),
      spectra, history_plot("Velocity", match.record, motion.velocity, 1., "[m/s]"),
      history_plot("Displacement", match.record, motion.displacement, 1., "[m]")};
  return html_page(
      "A record for " + options.file,
      "<h1>A record for " + escape_xml(options.file) + "</h1>\n<p>" +
          (match.fits() ? "It fits: " : "<b>It does not fit:</b> ") + "its spectrum is " +
          rounded_number(match.least, 4) + " to " + rounded_number(match.largest, 4) +
          " times the target at " + std::to_string(match.frequency.size()) + " frequencies from " +
          rounded_number(settings.first, 4) + " to " + rounded_number(settings.last, 4) +
          " Hz, damping " + rounded_number(settings.damping) + ". Largest acceleration " +
          rounded_number(match.record.largest() / form.unit, 4) + " " + form.unit_name + ", " +
          std::to_string(match.record.time.size()) + " instants, seed " +
          std::to_string(match.seed) + ".</p>\n" + html_of_plots(plots, "record") +
          html_note(
              "Asked for is a spectrum nowhere more than 10 % below and 30 % above the target "
              "(NUREG-0800, section 3.7.1, option 1, approach 2, asks for the same, and for "
              "more: duration, power spectral density). A record made so has random phases, "
              "and is no earthquake that was measured: take several seeds."));
}

} // namespace

int record_command(const SpectrumOptions &options) {
  CurveForm form = form_of(options);
  Spectrum spectrum;
  spectrum.curve = read_curve_file(options.file, form, options.file);
  MatchedRecordSettings settings;
  settings.duration = options.duration;
  settings.rise = options.rise;
  settings.fall = options.fall;
  settings.step = options.step;
  settings.damping = options.damping.empty() ? 0.05 : options.damping.front();
  settings.first = options.first;
  settings.last = options.last;
  settings.seed = options.seed;
  settings.n_frequencies = options.n_frequencies;
  settings.interpolation = find_word(spectrum_interpolations, options.interpolation)->value;
  if (options.rise + options.fall >= options.duration)
    throw UserError("--rise, --fall:\n  read:    " + rounded_number(options.rise) + " and " +
                    rounded_number(options.fall) + " s of " + rounded_number(options.duration) +
                    "\n  allowed: together less than the duration\n  try:     a longer --duration");
  choose_free(spectrum, settings);
  check_frequencies(settings.first, settings.last);
  constexpr double most_waves = 1e5, most_instants = 1e6;
  if (settings.last * settings.duration > most_waves ||
      settings.duration / settings.step > most_instants || settings.step * settings.last > 0.2)
    throw UserError(
        "--step, --duration, --to:\n  read:    " + rounded_number(settings.step) + " s, " +
        rounded_number(settings.duration) + " s, " + rounded_number(settings.last) +
        " Hz\n  allowed: at least five instants in the shortest period, a million "
        "instants, and 100,000 periods\n  try:     leaving out --step, or another --to");
  if (std::isinf(spectrum.curve.back().first) &&
      settings.interpolation != Spectrum::Interpolation::in_period)
    throw UserError(options.file + ":\n  read:    period 0\n  allowed: periods > 0\n  try:     "
                                   "--interpolation 'linear in period'");
  for (const double f : {settings.first, settings.last})
    if (!(spectrum.at(f, settings.interpolation) > 0.))
      throw UserError(options.file + ":\n  read:    acceleration 0 at " + rounded_number(f) +
                      " Hz\n  allowed: a spectrum > 0 where the record shall fit it\n  try:     "
                      "other frequencies by --from and --to");
  const MatchedRecord match = match_record(spectrum, settings);
  const GroundMotion motion = integrate(match.record);
  const std::string folder = folder_of(options, "record"), unit = form.unit_name;
  prepare_output_folder(folder);
  const auto &time = match.record.time, &acceleration = match.record.acceleration;
  write_file(folder + "/record.csv", number_rows("time [s],acceleration [" + unit + "]",
                                                 {&time, &acceleration}, {1., form.unit}));
  write_file(folder + "/record_motion.csv",
             number_rows("time [s],acceleration [m/s2],velocity [m/s],displacement [m]",
                         {&time, &acceleration, &motion.velocity, &motion.displacement},
                         {1., 1., 1., 1.}));
  std::vector<double> ratio;
  for (std::size_t i = 0; i < match.target.size(); ++i)
    ratio.push_back(match.response[i] / match.target[i]);
  write_file(folder + "/record_spectrum.csv",
             number_rows("frequency [Hz],target [" + unit + "],record [" + unit + "],ratio",
                         {&match.frequency, &match.target, &match.response, &ratio},
                         {1., form.unit, form.unit, 1.}));
  write_file(folder + "/record.html", record_page(options, form, settings, match, motion));
  std::cout << folder << "/record.csv: " << time.size() << " instants, largest "
            << rounded_number(match.record.largest() / form.unit, 4) << ' ' << unit << ", seed "
            << match.seed << ". Its spectrum is " << rounded_number(match.least, 3) << " to "
            << rounded_number(match.largest, 3) << " times the target from "
            << rounded_number(settings.first) << " to " << rounded_number(settings.last)
            << " Hz.\n";
  if (!match.fits())
    std::cerr << "It does not fit: 0.9 to 1.3 is asked for. Try another --seed, a longer "
                 "--duration, or fewer frequencies (--from, --to).\n";
  return match.fits() ? 0 : 2;
}

} // namespace frictionbeam
