// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/unit_constants.h"
#include "scene/part/parts.h"
#include "scene/spectra/curve_file.h"
#include "scene/spectra/interpolations.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

double Spectrum::at(const double frequency, const Interpolation interpolation) const {
  if (record != nullptr)
    return frequency > 0. ? pseudo_acceleration(*record, frequency, damping) : 0.;
  if (frequency <= curve.front().first)
    return curve.front().second;
  if (frequency >= curve.back().first)
    return curve.back().second;
  const auto after = std::upper_bound(
      curve.begin(), curve.end(), frequency,
      [](const double f, const std::pair<double, double> &point) { return f < point.first; });
  const auto [f0, a0] = *(after - 1);
  const auto [f1, a1] = *after;
  if (interpolation == Interpolation::logarithmic && f0 > 0. && a0 > 0. && a1 > 0.)
    return a0 * std::pow(a1 / a0, std::log(frequency / f0) / std::log(f1 / f0));
  if (interpolation == Interpolation::in_period)
    return a0 + (a1 - a0) * (1. / frequency - 1. / f0) / (1. / f1 - 1. / f0);
  return a0 + (a1 - a0) * (frequency - f0) / (f1 - f0);
}

namespace parts {

namespace {

using ModeSum = SpectrumSettings::Modes;
constexpr Word<ModeSum> mode_sums[] = {
    {"srss", ModeSum::srss, "square root of the sum of squares"},
    {"cqc", ModeSum::cqc,
     "complete quadratic combination, which sees that close modes act together"},
    {"absolute", ModeSum::absolute, "sum of absolute values"},
    {"grouping", ModeSum::grouping,
     "sizes are added within groups of modes that lie within 10 % of the group's lowest frequency, "
     "then squares (RG 1.92 rev. 1)"},
    {"ten percent", ModeSum::ten_percent,
     "as srss, and twice the product of the sizes of each pair within 10 % (RG 1.92 rev. 1)"},
    {"double sum", ModeSum::double_sum, "Rosenblueth's, of sizes (RG 1.92 rev. 1)"},
    {"signed double sum", ModeSum::signed_double_sum,
     "Rosenblueth's, with the signs of the modes (RG 1.92 rev. 3)"}};
using SpectrumSum = SpectrumSettings::Sum;
constexpr Word<SpectrumSum> spectrum_sums[] = {{"srss", SpectrumSum::srss},
                                               {"absolute", SpectrumSum::absolute}};
using Interpolation = Spectrum::Interpolation;
constexpr Word<bool> orders[] = {{"modes", false, "in each direction, then the directions"},
                                 {"directions", true, "in each mode, by sizes, then the modes"}};
using Rigid = SpectrumSettings::Rigid;
constexpr Word<Rigid> rigid_parts[] = {
    {"none", Rigid::none},
    {"lindley-yow", Rigid::lindley_yow,
     "the spectrum's last acceleration over that of the mode, at most 1"},
    {"gupta", Rigid::gupta,
     "by the logarithm of the frequency, from 0 to 1 between the two Rigid "
     "frequencies"}};
constexpr Word<bool> axes[] = {{"frequency", false, "[Hz]"}, {"period", true, "[s]"}};
constexpr Word<bool> acceleration_words[] = {
    {"own", false, "that of the file, m/s2 unless Units says otherwise"},
    {"g", true, "9.80665 m/s2"}};

const std::string curve_form = "pairs separated by ';', each a frequency (or period) that rises "
                               "and an acceleration >= 0",
                  curve_example = "'1 2.5; 10 4; 33 1.5'";

void parse_directions(const ParameterReader &in, Spectrum &spectrum) {
  spectrum.factor = {{0., 0., 0.}};
  for (const std::string &item : in.list("Directions")) {
    const std::vector<std::string> words = split(item, ' ');
    double factor = 1.;
    const auto axis = std::string("xyz").find(words[0]);
    if (words[0].size() != 1 || axis == std::string::npos || words.size() > 2 ||
        (words.size() == 2 && !to_number(words[1], factor)))
      in.fail("Directions", "x, y, z, each with a factor if not 1", "'x, y, z 0.667'",
              "'" + item + "'");
    spectrum.factor[axis] = factor;
  }
}

WrittenCurve written_curve(const ParameterReader &in) {
  WrittenCurve written;
  for (const std::string &pair : split(in.text("Curve"), ';')) {
    if (pair.empty())
      continue;
    const std::vector<std::string> words = split(pair, ' ');
    double x, a;
    if (words.size() != 2 || !to_number(words[0], x) || !to_number(words[1], a))
      in.fail("Curve", curve_form, curve_example, "'" + pair + "'");
    written.points.emplace_back(x, a);
    written.places.push_back("'" + pair + "'");
  }
  if (written.points.empty())
    in.fail("Curve", curve_form, curve_example);
  return written;
}

/// Curve, File or Record, one of the three.
void parse_source(const ParameterReader &in, Spectrum &spectrum) {
  const std::vector<std::string> sources = {"Curve", "File", "Record"};
  std::string source;
  for (const std::string &entry : sources) {
    if (in.text(entry).empty())
      continue;
    if (!source.empty())
      in.fail(entry, "one of Curve, File and Record",
              "removing '" + entry + "' or '" + source + "'");
    source = entry;
  }
  if (source.empty())
    in.fail("Curve", curve_form + ", or a File, or a Record", curve_example);
  if (source != "Record" && in.given("Damping"))
    in.fail("Damping", "this entry beside a Record, whose oscillators have it",
            "removing it: a curve is of one damping, whatever that is");
  if (source == "Record" && in.given("Over"))
    in.fail("Over", "this entry beside Curve or File", "removing it");
  CurveForm form;
  form.over_period = in.choice("Over", axes);
  form.axis_given = in.given("Over");
  form.unit = in.choice("Unit", acceleration_words) ? standard_gravity : in.si("m/s2");
  form.unit_given = in.given("Unit");
  const std::string where = in.where(source);
  if (source == "Curve")
    spectrum.curve = to_curve(written_curve(in), form, where);
  else if (source == "File")
    spectrum.curve = read_curve_file(existing_file(in, "File"), form, where);
  else {
    auto record = std::make_shared<AccelerationRecord>(
        read_record_file(existing_file(in, "Record"), form, where));
    spectrum.damping = in.number("Damping");
    spectrum.curve = {{1., record->largest()}}; // of oscillators that are rigid
    spectrum.record = std::move(record);
  }
}

} // namespace

void declare_spectrum(ParameterReader &in) {
  in.declare_text("Curve", "", "f a; f a; ...: frequency [Hz] and acceleration [m/s2], rising f",
                  "Pseudo-acceleration of an oscillator of that frequency on the supports' motion, "
                  "level beyond the ends of the curve; its last point is the zero-period "
                  "acceleration.");
  in.declare_text("File", "", "file name",
                  "The same from a file with two columns, between commas; a first line such as "
                  "'period [s], acceleration [g]' says what they are.");
  in.declare_text("Record", "", "file name",
                  "Acceleration of the supports over time, of which the spectrum is computed at "
                  "each mode's frequency: two columns, with or without a first line 'time [s], "
                  "acceleration [g]'.");
  in.declare_number("Damping", 0.05, "-", 0., 0.99, "Ratio to critical, of the Record's spectrum.");
  in.declare_choice("Over", false, axes, "What the first column or number of a pair is.");
  in.declare_choice("Unit", false, acceleration_words, "Of the accelerations.");
  in.declare_text("Directions", "x, y, z", "x, y, z, each with a factor [-] if not 1",
                  "In which the supports move so, each by itself.");
  in.declare_text("Supports", "", "names of supports and springs, separated by commas",
                  "The group that moves so; the others stand still. Empty: all move together.");
}

void parse_spectrum(const ParameterReader &in, const std::string &name, Scene &scene) {
  Spectrum spectrum;
  spectrum.name = name;
  parse_source(in, spectrum);
  parse_directions(in, spectrum);
  spectrum.supports = in.list("Supports");
  std::vector<std::string> known = names(scene.supports);
  for (const Restraint &restraint : scene.restraints)
    known.push_back(restraint.name);
  for (const Spring &spring : scene.springs)
    known.push_back(spring.name);
  for (const std::string &support : spectrum.supports)
    in.find("Supports", support, known, "support");
  scene.spectra.push_back(spectrum);
}

void declare_response(ParameterReader &in) {
  in.declare_choice("Modes", ModeSum::srss, mode_sums, "How modes are combined.");
  in.declare_choice("Directions", SpectrumSum::srss, spectrum_sums, "How directions are combined.");
  in.declare_choice("First", false, orders, "What is combined first.");
  in.declare_choice(
      "Groups", SpectrumSum::absolute, spectrum_sums,
      "How groups of supports are combined, in each mode and direction. What comes of "
      "several has no signs: cqc and the signed double sum then take those of all "
      "modes as one.");
  in.declare_choice("Interpolation", Interpolation::logarithmic, spectrum_interpolations,
                    "Of spectra.");
  in.declare_number("Damping", 0.05, "-", positive, 1.,
                    "Ratio to critical, of cqc and double sums.");
  in.declare_number("Duration", 0., "s", 0., 1e6, "Of the earthquake, of double sums; > 0 there.");
  in.declare_flag("Missing mass", false,
                  "Add the static response to what the modes leave out, at the acceleration of the "
                  "spectrum's last point.");
  in.declare_choice("Rigid part", Rigid::none, rigid_parts,
                    "The part of each mode's response that follows the ground without delay, and "
                    "is added with its sign to those of the other modes and to the missing mass.");
  in.declare_text("Rigid frequencies", "", "f1 f2 [Hz]",
                  "Of gupta: where the rigid part begins and where it is all of the response.");
  in.declare_flag("Write modes", false,
                  "Write all numbers of each mode in each direction to modal_line.csv, "
                  "modal_supports.csv and modal_reactions.csv.");
}

void parse_response(const ParameterReader &in, Scene &scene) {
  SpectrumSettings &s = scene.response;
  s.modes = in.choice("Modes", mode_sums);
  s.directions = in.choice("Directions", spectrum_sums);
  s.directions_first = in.choice("First", orders);
  s.groups = in.choice("Groups", spectrum_sums);
  s.interpolation = in.choice("Interpolation", spectrum_interpolations);
  s.damping = in.number("Damping");
  s.duration = in.number("Duration");
  s.missing_mass = in.flag("Missing mass");
  s.rigid = in.choice("Rigid part", rigid_parts);
  s.write_modes = in.flag("Write modes");
  if (s.directions_first && s.needs_signs())
    in.fail("First",
            "modes, with Modes = " + in.text("Modes") +
                ": it needs the signs of the modes, which a combination of directions "
                "takes",
            "set First = modes, or Modes = grouping");
  if (s.is_double_sum() && s.duration == 0.)
    in.fail("Duration", "the strong motion's duration > 0, with Modes = " + in.text("Modes"),
            "set Duration = 10");
  if (!s.is_double_sum() && in.given("Duration"))
    in.fail("Duration", "this entry with a double sum", "removing it");
  if (s.rigid != Rigid::none && !s.missing_mass)
    in.fail("Rigid part",
            "with Missing mass = true: rigid parts of the modes alone leave out those "
            "of the others",
            "set Missing mass = true");
  const std::vector<double> frequencies = in.numbers("Rigid frequencies");
  if (s.rigid != Rigid::gupta && !frequencies.empty())
    in.fail("Rigid frequencies", "this entry with Rigid part = gupta", "removing it");
  if (s.rigid != Rigid::gupta)
    return;
  if (frequencies.size() != 2 || !(frequencies[0] > 0.) || !(frequencies[1] > frequencies[0]))
    in.fail("Rigid frequencies", "two frequencies > 0 that rise [Hz]", "'4 22'");
  s.rigid_frequencies = {{frequencies[0], frequencies[1]}};
}

namespace {

/// What moves in both of two groups: names, "all supports", or nothing.
std::string shared(const Spectrum &a, const Spectrum &b) {
  if (a.supports.empty() && b.supports.empty())
    return "all supports";
  if (a.supports.empty() || b.supports.empty())
    return join(a.supports.empty() ? b.supports : a.supports);
  std::vector<std::string> both;
  for (const std::string &support : a.supports)
    if (std::count(b.supports.begin(), b.supports.end(), support) > 0)
      both.push_back(support);
  return both.empty() ? "" : join(both);
}

/// Say where the groups of two spectra overlap in a direction.
void doubt_shared_supports(Scene &scene) {
  for (unsigned int k = 0; k < scene.spectra.size(); ++k)
    for (unsigned int i = 0; i < k; ++i) {
      const Spectrum &a = scene.spectra[i], &b = scene.spectra[k];
      std::string directions;
      for (unsigned int d = 0; d < 3; ++d)
        if (a.factor[d] != 0. && b.factor[d] != 0.)
          directions += (directions.empty() ? "" : ", ") + std::string(1, "xyz"[d]);
      if (const std::string both = shared(a, b); !both.empty() && !directions.empty())
        scene.doubts.push_back(
            "Spectra " + a.name + " and " + b.name + " both move " + both + " in " + directions +
            ", and what comes of either is combined as of two groups (Response/Groups). Give each "
            "support one spectrum of a direction.");
    }
}

} // namespace

void check_response(const ParameterReader &in, Scene &scene) {
  doubt_shared_supports(scene);
  const bool in_period = scene.response.interpolation == Interpolation::in_period;
  for (const Spectrum &spectrum : scene.spectra) {
    if (in_period && spectrum.curve.front().first == 0.)
      in.fail("Interpolation",
              "frequencies > 0 in all spectra: 0 has no period (Spectrum " + spectrum.name + ")",
              "a low frequency instead of 0, or another Interpolation", "linear in period");
    if (!in_period && std::isinf(spectrum.curve.back().first))
      in.fail("Interpolation",
              "periods > 0 in all spectra: 0 has no frequency (Spectrum " + spectrum.name + ")",
              "set Interpolation = linear in period, or a short period instead of 0",
              in.text("Interpolation"));
  }
}

} // namespace parts

} // namespace frictionbeam
