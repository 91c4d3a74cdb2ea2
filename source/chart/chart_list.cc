// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart/chart_list.h"

#include "base/user_error.h"
#include "scene/file/parameter_reader.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <sstream>

namespace frictionbeam::chart {

namespace {

namespace fs = std::filesystem;

using Time = ChartList::Time;
constexpr Word<Time> times[] = {
    {"solution", Time::solution, "mesh, set-up and solution"},
    {"process", Time::process,
     "from the start of the program to its end, with all that it reads and writes"},
    {"processor", Time::processor,
     "what the whole process takes of the processor, which a busy machine changes little"}};

const std::string settings_form = "'Section/Entry = value', separated by semicolons";

void declare_list(ParameterReader &in) {
  in.declare_text("Title", "", "any text", "Of the chart.");
  in.declare_text("Case", "", "path of a parameter file, from the list's folder",
                  "The scene, unless a curve has one of its own.");
  in.declare_text("Settings", "", settings_form, "Of every run, as of --set.");
  in.declare_text("Quantities", "", "names of the case's quantities, separated by commas",
                  "The error of a run is the largest of these; empty: of all with a reference.");
  in.declare_text("Reference run", "", settings_form,
                  "A fine run of the case whose quantities are the references, instead of those "
                  "that the case has itself; 'none': not made.");
  in.declare_number("Floor", 0.01, "-", 0., 1.,
                    "The error of a quantity is relative to its reference, or to this part of the "
                    "largest reference with the same unit if that is more; absolute if both are "
                    "0.");
  in.declare_choice("Time", Time::solution, times, "");
  in.declare_count("Runs", 3, 1, "Of each configuration; the median of their times counts.");
  in.declare_number("Time limit", 60., "s", positive, 1e300,
                    "A run that takes longer is ended and shown as failed, and finer ones of its "
                    "curve are not begun; a configuration is not repeated beyond it.");
  in.declare_text("Advice", "",
                  "any text with {best 1e-3}, {error CURVE}, {time CURVE 1e-3}, "
                  "{ratio CURVE OTHER 1e-3}",
                  "What a user should choose and why. Figures come from the run: the cheapest "
                  "configuration with an error of at most 1e-3; the smallest error of a curve; the "
                  "least time in which it reaches 1e-3; how many times longer it takes for that "
                  "than another curve.");
}

void declare_curve(ParameterReader &in) {
  in.declare_text("Label", "", "any text", "In the key; empty: the curve's name.");
  in.declare_text("Case", "", "path of a parameter file, from the list's folder",
                  "Instead of the list's.");
  in.declare_text("Settings", "", settings_form, "Of the curve's runs.");
  in.declare_text("Vary", "", "'Section/Entry', several separated by semicolons",
                  "What changes along the curve.");
  in.declare_text("Values", "", "values separated by commas, coarsest first",
                  "One for each run; where several entries vary, one for each of them, between "
                  "blanks.");
  in.declare_text(
      "Command", "", "a command with {value}, {program}",
      "Another program instead, started in the list's folder. It prints lines "
      "'name = value': the quantities, or 'error', and 'seconds', without which the "
      "whole process counts. {value} stands for the value, {program} for frictionbeam.");
}

void declare_references(ParameterReader &in) {
  const ParameterFile::Section *const section = in.file().find("References");
  if (section == nullptr)
    return;
  for (const ParameterFile::Entry &entry : section->entries)
    in.declare_number(entry.name, 0., "", -1e300, 1e300, "Reference of a quantity.");
}

std::vector<std::string> settings_of(const ParameterReader &in, const std::string &entry) {
  std::vector<std::string> settings = split(in.text(entry), ';');
  settings.erase(std::remove(settings.begin(), settings.end(), ""), settings.end());
  for (const std::string &setting : settings)
    if (setting.find('=') == std::string::npos)
      in.fail(entry, settings_form, "'Slab/Elements = 64; Solver/Method = exact'",
              "'" + setting + "'");
  return settings;
}

std::string case_of(const ParameterReader &in, const std::string &folder,
                    const std::string &otherwise) {
  const std::string path = in.text("Case");
  if (path.empty())
    return otherwise;
  const fs::path beside = fs::path(folder) / path;
  if (!fs::exists(beside))
    in.fail("Case", "a file that exists, from the list's folder",
            "the path from " + fs::absolute(folder).string());
  return beside.string();
}

Curve read_curve(const ParameterReader &in, const std::string &name, const ChartList &list,
                 const std::string &common_case) {
  Curve curve;
  curve.name = name;
  curve.label = in.text("Label").empty() ? name : in.text("Label");
  curve.case_file = case_of(in, list.folder, common_case);
  curve.settings = settings_of(in, "Settings");
  curve.command = in.text("Command");
  if (curve.command.empty() && curve.case_file.empty())
    in.fail("Case", "a parameter file, for the curve or for the list",
            "set Case = ../verification/slab.prm");
  curve.varied = split(in.text("Vary"), ';');
  for (const std::string &value : split(in.text("Values"), ','))
    curve.values.push_back(split(value, ' '));
  const std::size_t n_words = std::max<std::size_t>(1, curve.varied.size());
  for (const auto &words : curve.values)
    if (words.size() != n_words)
      in.fail("Values",
              n_words == 1 ? "single words separated by commas"
                           : std::to_string(n_words) + " words a run, as many as Vary has entries",
              "another number of words in each");
  if (curve.values.empty() != curve.varied.empty() && curve.command.empty())
    in.fail("Values", "values and, in Vary, the entry that takes them, or neither",
            "set Vary = Slab/Elements, set Values = 16, 32, 64");
  if (curve.values.empty())
    curve.values.emplace_back();
  return curve;
}

/// The comment at the top of a file.
std::string prose_of(const std::string &text) {
  std::istringstream lines(text);
  std::string prose;
  for (std::string line; std::getline(lines, line) && line.rfind("#", 0) == 0;) {
    line.erase(0, line.rfind("# ", 0) == 0 ? 2 : 1);
    prose += line + "\n";
  }
  return prose;
}

} // namespace

ChartList read_chart_list(const std::string &file) {
  ParameterReader in{ParameterFile(file)};
  ChartList list;
  list.name = fs::path(file).stem().string();
  list.folder = fs::absolute(file).parent_path().string();
  list.prose = prose_of(in.file().text());
  declare_list(in);
  in.take();
  list.title = in.text("Title").empty() ? list.name : in.text("Title");
  const std::string common_case = case_of(in, list.folder, "");
  list.settings = settings_of(in, "Settings");
  list.quantities = in.list("Quantities");
  list.has_reference_run = in.given("Reference run") && in.text("Reference run") != "none";
  if (list.has_reference_run) {
    list.reference_run = settings_of(in, "Reference run");
    if (common_case.empty())
      in.fail("Reference run", "a reference run where the list has a Case", "set Case");
  }
  list.floor = in.number("Floor");
  list.time = in.choice("Time", times);
  list.n_runs = in.count("Runs");
  list.time_limit = in.number("Time limit");
  list.advice = in.text("Advice");

  for (const ParameterFile::Section &section : in.file().sections()) {
    const std::vector<std::string> words = split(section.heading, ' ');
    if (words.empty())
      continue;
    in.enter(section.heading);
    if (section.heading == "References") {
      declare_references(in);
      in.take();
      for (const ParameterFile::Entry &entry : section.entries)
        list.references[entry.name] = in.number(entry.name);
    } else if (words.size() == 2 && words[0] == "Curve") {
      declare_curve(in);
      in.take();
      list.curves.push_back(read_curve(in, words[1], list, common_case));
    } else
      in.fail_section("subsection " + section.heading,
                      "'Curve <name>', a name of one word, and 'References'",
                      "subsection Curve exact");
  }
  in.enter("");
  if (list.curves.empty())
    in.fail_section("no curve", "at least one part 'Curve <name>'", "subsection Curve exact");
  if (list.has_reference_run)
    for (Curve &curve : list.curves)
      if (curve.case_file.empty())
        curve.case_file = common_case;
  return list;
}

void print_chart_parameters(std::ostream &out) {
  out << "# All entries of a list for 'frictionbeam chart', with their defaults. A list has any\n"
         "# number of parts 'Curve <name>'. In the section 'References' stand 'set <quantity> = "
         "value',\n"
         "# in SI units: references that come before those of the case. A comment at the top of "
         "the\n"
         "# list is printed above its chart.\n";
  const ParameterFile empty;
  ParameterReader in(empty);
  declare_list(in);
  in.enter("Curve name");
  declare_curve(in);
  in.print(out);
}

} // namespace frictionbeam::chart
