// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/study/study_entries.h"

#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::parts {

namespace {

using Shape = Variation::Shape;

/// What the values of a section Vary stand for.
constexpr Word<bool> value_kinds[] = {{"value", false, "the entry's new value, in its unit"},
                                      {"factor", true, "times what the file says"}};

const std::string entry_form = "'Section/Entry' as of --set, several separated by semicolons";

double number_of(const ParameterReader &in, const std::string &entry) {
  double value = 0.;
  if (!to_number(in.text(entry), value))
    in.fail(entry, "a number, in the unit of the entry that varies", "'0.3'");
  return value;
}

void refuse(const ParameterReader &in, const std::vector<std::string> &entries,
            const std::string &beside, const std::string &otherwise) {
  for (const std::string &entry : entries)
    if (in.given(entry))
      in.fail(entry, "this entry " + beside, otherwise);
}

std::vector<std::string> entries_of(const ParameterReader &in) {
  std::vector<std::string> entries = split(in.text("Entry"), ';');
  entries.erase(std::remove(entries.begin(), entries.end(), ""), entries.end());
  if (entries.empty())
    in.fail("Entry", entry_form, "'Support rests/Friction coefficient'");
  for (const std::string &entry : entries)
    if (entry.find('=') != std::string::npos)
      in.fail("Entry", entry_form, "the entry alone; its values are Values or a Distribution");
  return entries;
}

void parse_list(const ParameterReader &in, Variation &variation) {
  refuse(in, {"Distribution", "From", "To", "Mean", "Deviation", "Levels"}, "without Values",
         "either a list of Values or a Distribution");
  variation.values = split(in.text("Values"), ',');
  if (variation.values.empty() || std::count(variation.values.begin(), variation.values.end(), ""))
    in.fail("Values", "values separated by single commas", "'0.1, 0.2, 0.3'");
}

void parse_bounds(const ParameterReader &in, Variation &variation) {
  if (in.given("From"))
    variation.from = number_of(in, "From");
  if (in.given("To"))
    variation.to = number_of(in, "To");
  if (!(variation.from < variation.to))
    in.fail("To", "a number above From, " + in.text("From"), "a larger To, or a smaller From");
}

void parse_distribution(const ParameterReader &in, Variation &variation) {
  variation.shape = in.choice("Distribution", variation_shapes);
  parse_bounds(in, variation);
  variation.levels = in.count("Levels");
  const bool is_uniform = variation.shape == Shape::uniform;
  if (is_uniform) {
    refuse(in, {"Mean", "Deviation"}, "with Distribution = normal or log-normal",
           "From and To alone");
    if (!in.given("From") || !in.given("To"))
      in.fail_section(
          "no 'Values', and not both 'From' and 'To'",
          "Values = a, b, ...; or From and To; or a Distribution with Mean and Deviation",
          "set From = 0.1, set To = 0.4");
    return;
  }
  variation.mean = number_of(in, "Mean");
  variation.deviation = number_of(in, "Deviation");
  if (!(variation.deviation > 0.))
    in.fail("Deviation", "a number > 0", "a tenth of Mean");
  if (variation.shape == Shape::log_normal && !(variation.mean > 0.))
    in.fail("Mean", "a number > 0, of what is log-normal", "Distribution = normal");
  if (variation.shape == Shape::log_normal && variation.to <= 0.)
    in.fail("To", "a number > 0, of what is log-normal", "Distribution = normal");
  // A tail far out has no probability left that could be told from rounding.
  constexpr double farthest = 6.;
  const double low = variation.mean - farthest * variation.deviation,
               high = variation.mean + farthest * variation.deviation;
  if (variation.from > high || (variation.to < low && variation.shape == Shape::normal))
    in.fail(variation.from > high ? "From" : "To",
            "a number within six deviations of Mean, " + rounded_number(low, 6) + " to " +
                rounded_number(high, 6),
            "another Mean, or a larger Deviation");
}

void declare_settings(ParameterReader &in) {
  in.declare_choice("Method", StudyMethod::latin_hypercube, study_methods,
                    "How the runs of 'frictionbeam study' are chosen.");
  in.declare_count("Runs", 100, 1,
                   "Number of runs; with 'sobol indices' and 'morris' that many times what Method "
                   "says. Not of factorial.",
                   10000000);
  in.declare_count("Seed", 1, 0, "Of the random numbers: another one, another choice of runs.");
  in.declare_count(
      "Threads", 0, 0,
      "Runs at the same time; 0: as many as the machine has processors, or with mpirun "
      "one for each process.",
      1024);
  in.declare_text(
      "Quantiles", "0.05 0.5 0.95", "rising numbers between 0 and 1",
      "Probabilities whose quantiles are reported, beside the least and largest value.");
}

void parse_settings(const ParameterReader &in, StudySettings &study) {
  study.method = in.choice("Method", study_methods);
  study.n_runs = in.count("Runs");
  if (study.method == StudyMethod::factorial && in.given("Runs"))
    in.fail("Runs", "no number of runs with Method = factorial, which runs all combinations",
            "Method = latin hypercube, or Levels and Values of the sections Vary");
  study.seed = in.count("Seed");
  study.n_threads = in.count("Threads");
  study.quantiles = in.numbers("Quantiles");
  double last = 0.;
  for (const double probability : study.quantiles) {
    if (!(probability > last && probability < 1.))
      in.fail("Quantiles", "rising numbers between 0 and 1, without them", "'0.05 0.5 0.95'");
    last = probability;
  }
}

void declare_variation(ParameterReader &in) {
  in.declare_text("Entry", "", entry_form,
                  "What varies. 'Support *' stands for all supports with friction, 'Support "
                  "rests.3' for the third place of a repeated one.");
  in.declare_text("Values", "", "values separated by commas",
                  "A list, each value as likely as the others; words where the entry takes words.");
  in.declare_choice("Distribution", Shape::uniform, variation_shapes, "Instead of Values.");
  const std::string unit = "a number, in the unit of the entry";
  in.declare_text("From", "", unit,
                  "Least value; a normal or log-normal distribution is cut there, if it is given.");
  in.declare_text("To", "", unit, "Largest value, likewise.");
  in.declare_text("Mean", "", unit, "Of the normal or log-normal distribution, before it is cut.");
  in.declare_text("Deviation", "", unit, "Its standard deviation.");
  in.declare_count("Levels", 3, 2,
                   "Of a distribution with Method = factorial: values at equal distances from From "
                   "to To, or of equal probability.",
                   1000);
  in.declare_flag("Independent", false,
                  "Every entry, and every place of a repeated support, varies on its own; "
                  "otherwise all of them have the same value.");
  in.declare_choice("Meaning", false, value_kinds, "What the numbers above are.");
}

void parse_variation(const ParameterReader &in, const std::string &name, StudySettings &study) {
  Variation variation;
  variation.name = name;
  variation.origin = in.where("Entry");
  variation.entries = entries_of(in);
  if (in.given("Values"))
    parse_list(in, variation);
  else
    parse_distribution(in, variation);
  variation.independent = in.flag("Independent");
  variation.is_factor = in.choice("Meaning", value_kinds);
  for (const std::string &value : variation.values)
    if (double number = 0.; variation.is_factor && !to_number(value, number))
      in.fail("Values", "numbers, with Meaning = factor", "Meaning = value");
  study.variations.push_back(variation);
}

} // namespace

void declare_study(ParameterReader &in) {
  in.enter("Study");
  declare_settings(in);
  in.enter(std::string(variation_kind) + " name");
  declare_variation(in);
}

void read_study(ParameterReader &in, StudySettings &study) {
  in.enter("Study");
  declare_settings(in);
  in.take();
  parse_settings(in, study);
  for (const ParameterFile::Section &section : in.file().sections())
    if (const auto words = split(section.heading, ' ');
        words.size() == 2 && words[0] == variation_kind) {
      in.enter(section.heading);
      declare_variation(in);
      in.take();
      parse_variation(in, words[1], study);
    }
}

} // namespace frictionbeam::parts
