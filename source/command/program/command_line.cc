// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/program/command_line.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "results/file/summary.h"
#include "scene/read_scene.h"
#include "scene/spectra/interpolations.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace frictionbeam {

namespace {

using Command = CommandLine::Command;

const char *const exit_status =
    "Exit status: 0 solved; 1 the input is wrong; 2 no convergence or no equilibrium; "
    "3 a mistake of the program's own; 4 results cannot be written, as on a full disk; "
    "5 solved, but a check of the report fails ('Fail on = checks' in section Output); "
    "130 and 143 ended by SIGINT and SIGTERM, with a checkpoint for --resume.";

/// As CLI::Range, which shows small bounds as 0.
CLI::Validator between(const double least, const double most) {
  const auto fault = [=](const std::string &text) -> std::string {
    double value = 0.;
    if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most)
      return "";
    return "Value " + text + " not in range " + exact_number(least) + " to " + exact_number(most);
  };
  return CLI::Validator(fault, "", "");
}

/// Options of `spectrum` and `record`.
void declare_spectra(CLI::App &spectrum, CLI::App &record, SpectrumOptions &options) {
  spectrum
      .add_option("file", options.file,
                  "The record: two columns, 'time [s], acceleration [g]' or without a first line")
      ->type_name("RECORD.csv")
      ->required();
  spectrum.add_option("--damping", options.damping, "Ratios to critical (0.05 if not given)")
      ->type_name("NUMBERS")
      ->check(CLI::Range(0., 0.99));
  record
      .add_option("file", options.file,
                  "The spectrum: two columns, 'frequency [Hz], acceleration [g]' or 'period [s], "
                  "...' or without a first line")
      ->type_name("SPECTRUM.csv")
      ->required();
  record.add_option("--damping", options.damping, "Ratio to critical (0.05 if not given)")
      ->type_name("NUMBER")
      ->expected(1)
      ->check(CLI::Range(0.001, 0.99));
  const auto seconds = [&](const std::string &name, double &value, const std::string &meaning) {
    record.add_option(name, value, meaning)->type_name("SECONDS")->check(CLI::Range(1e-4, 1e3));
  };
  seconds("--duration", options.duration, "Of the record (20 if not given)");
  seconds("--rise", options.rise, "Of its beginning, until it is strong (3 if not given)");
  seconds("--fall", options.fall, "Of its end (7 if not given)");
  seconds("--step", options.step,
          "Between instants (a tenth of the shortest period if not given, at most 0.01)");
  record.add_option("--seed", options.seed, "Of the random phases (1 if not given)")
      ->type_name("NUMBER");
  record.add_flag("--over-period", options.over_period,
                  "The first column has periods, where no first line says so");
  record.add_option("--interpolation", options.interpolation, "Of the spectrum")
      ->type_name("WORDS")
      ->check(CLI::IsMember(words_of(spectrum_interpolations)));
  for (CLI::App *const one : {&spectrum, &record}) {
    const bool is_record = one == &record;
    one->add_option("--from", options.first,
                    is_record
                        ? "Lowest frequency that shall fit (that of the spectrum if not given)"
                        : "Lowest frequency (0.1 if not given)")
        ->type_name("HERTZ")
        ->check(CLI::Range(1e-3, 1e4));
    one->add_option("--to", options.last,
                    is_record ? "Highest frequency that shall fit (that of the spectrum if not "
                                "given, at most 50)"
                              : "Highest frequency (100 if not given)")
        ->type_name("HERTZ")
        ->check(CLI::Range(1e-3, 1e4));
    one->add_option("--points", options.n_frequencies, "Frequencies between (200 if not given)")
        ->type_name("NUMBER")
        ->check(CLI::Range(2, 10000));
    one->add_option("--unit", options.unit,
                    "Of accelerations, where no first line says it: g, m/s2, cm/s2, mm/s2, in/s2, "
                    "ft/s2 (m/s2 if not given)")
        ->type_name("UNIT");
    one->add_option("--output-directory", options.folder, "Where the results go")
        ->type_name("FOLDER");
  }
}

void declare_import(CLI::App &app, import::ImportOptions &options) {
  app.add_option("file", options.file, "The piping component file")
      ->type_name("LINE.pcf")
      ->required();
  app.add_option("-o,--output", options.output,
                 "The parameter file (LINE.prm, in the folder one is in, if not given)")
      ->type_name("FILE.prm");
  app.add_flag("--overwrite", options.overwrite, "Replace a parameter file that is there");
  app.add_option("--support-map", options.support_map,
                 "Kinds of supports by their names and SKEYs: rows \"WORD : kind, Entry = value\" "
                 "(doc/import.md)")
      ->type_name("FILE");
  app.add_option("--attributes", options.attributes,
                 "What COMPONENT-ATTRIBUTEs say: none, caesar, caepipe, or a file of rows \"KEY "
                 "property unit\"")
      ->type_name("WORD");
  app.add_option("--tolerance", options.tolerance,
                 "Within which ends are the same, in mm (1 if not given)")
      ->type_name("MM")
      ->check(CLI::Range(0., 1000.));
  app.add_option("--wall", options.sections.wall,
                 "Wall thickness where the file says none: \"7.11 mm\", or by bore \"150 7.11 mm, "
                 "80 5.49 mm\"")
      ->type_name("WALL");
  app.add_option("--schedule", options.sections.schedule,
                 "The same by a schedule of ASME B36.10M: 5 to 160, STD, XS, XXS")
      ->type_name("WORD")
      ->check(CLI::IsMember({"5", "10", "20", "30", "40", "60", "80", "100", "120", "140", "160",
                             "STD", "XS", "XXS"}));
  app.add_option("--material", options.sections.material,
                 "Of what has no name that is known: carbon steel or austenitic steel")
      ->type_name("GRADE")
      ->check(CLI::IsMember({"carbon steel", "austenitic steel"}));
  app.add_option("--units", options.units,
                 "Of the parameter file, as of its entry Units (si if not given)")
      ->type_name("UNITS");
  app.add_option("--encoding", options.encoding, "Of the file: utf-8 or latin-1")
      ->type_name("WORD")
      ->check(CLI::IsMember({"utf-8", "latin-1"}));
}

/// All options and sub-commands; what is read goes into @p line.
void declare(CLI::App &app, CommandLine &line) {
  const auto add_case = [&line](CLI::App &to) {
    to.add_option("case", line.options.parameter_file, "Parameter file")->type_name("CASE.prm");
    to.add_option("--set", line.options.overrides,
                  "Change an entry of the file, \"Section/Entry = value\"; may be repeated")
        ->type_name("ENTRY")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
    to.add_option("--output-directory", line.options.output_directory,
                  "Where results go (output/CASE if not given)")
        ->type_name("FOLDER");
    to.add_flag("-q,--quiet", line.options.quiet, "Print errors only; results are written as ever");
  };
  const auto add_strict = [&line](CLI::App &to) {
    to.add_flag("--strict", line.options.strict,
                "Take for errors what is hardly meant: moduli far from any metal's, displacements "
                "as large as the line, spans that sag, ... (else they are remarks)");
  };
  const auto add_command = [&](const std::string &word, const std::string &meaning,
                               const Command command) {
    CLI::App *const added = app.add_subcommand(word, meaning);
    added->callback([&line, command]() { line.command = command; });
    added->footer(exit_status);
    return added;
  };

  app.set_help_flag("-h,--help", "Print this and end");
  app.add_flag("-V,--version", "Print the version of the program and of deal.II");
  app.add_flag("--print-parameters", "Print every entry there is, with unit, bounds and meaning");
  app.add_flag("--print-man-page", "Print the man page");
  app.add_flag("--print-completion", "Print completion for bash; source it");
  add_case(app);
  add_strict(app);
  const auto add_resume = [&line](CLI::App &to) {
    to.add_flag("--resume", line.options.resume, "Go on where a run into that folder was killed");
  };
  add_resume(app);
  app.footer(exit_status);

  CLI::App *const check = add_command(
      "check", "Draw the model and say what was understood; solve nothing", Command::check);
  add_case(*check);
  add_strict(*check);
  CLI::App *const study = add_command(
      "study", "Run a case many times with other values, and say what becomes of its results",
      Command::study);
  add_case(*study);
  add_resume(*study);
  CLI::App *const compare = add_command(
      "compare", "What changes between the results of two runs, and where", Command::compare);
  for (std::string &folder : line.folders)
    compare->add_option(&folder == line.folders ? "first" : "second", folder, "Folder of results")
        ->type_name("FOLDER")
        ->required();
  CLI::App *const contact = add_command(
      "contact", "Solve a friction-contact problem in the format of FCLIB", Command::contact);
  contact->add_option("file", line.contact.file, "The problem; its solution is written into it")
      ->type_name("FILE.hdf5")
      ->required();
  contact
      ->add_option("--tolerance", line.contact.tolerance,
                   "Of both residuals, from 1e-15 to 1e-2 (1e-8 if not given)")
      ->type_name("NUMBER")
      ->check(between(1e-15, 1e-2));
  contact
      ->add_option("--time-limit", line.contact.time_limit,
                   "Seconds after which the best so far is written, with exit status 2 (none if "
                   "not given)")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  declare_import(*add_command("import",
                              "Make a parameter file of a piping component file (.pcf) that a "
                              "plant design program has written",
                              Command::import),
                 line.import);
  CLI::App *const chart = add_command(
      "chart", "Run a list of configurations and draw error against time", Command::chart);
  chart->add_option("list", line.chart_list, "List of configurations")->type_name("LIST.prm");
  chart
      ->add_option("--output-directory", line.chart_folder,
                   "Where the chart goes (output/chart_LIST if not given)")
      ->type_name("FOLDER");
  chart->add_flag("--print-parameters", "Print the entries of a list");
  CLI::App *const spectrum =
      add_command("spectrum", "Response spectra of a record of accelerations", Command::spectrum);
  CLI::App *const record = add_command(
      "record", "Make a record of accelerations that fits a response spectrum", Command::record);
  declare_spectra(*spectrum, *record, line.spectrum);
}

/// Text as roff takes it literally.
std::string roff(const std::string &text) {
  std::string result;
  for (const char c : text)
    result += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
  return result;
}

void list_options(const CLI::App &app, std::ostream &out) {
  for (const CLI::Option *const option : app.get_options()) {
    const std::string type = option->get_type_name();
    out << ".TP\n\\fB" << roff(option->get_positional() ? type : option->get_name(false, true))
        << "\\fR" << (option->get_positional() || type.empty() ? "" : " \\fI" + type + "\\fR")
        << '\n'
        << roff(option->get_description()) << ".\n";
  }
}

void print_man_page(const CLI::App &app, std::ostream &out) {
  out << ".TH FRICTIONBEAM 1 \"\" \"FrictionBeam " << program_version() << "\"\n.SH NAME\n"
      << "frictionbeam \\- " << roff(app.get_description())
      << "\n.SH SYNOPSIS\n.B frictionbeam\n[\\fICASE.prm\\fR | \\fICOMMAND\\fR] "
         "[\\fIOPTION\\fR ...]\n.SH OPTIONS\n";
  list_options(app, out);
  for (const CLI::App *const command : app.get_subcommands({})) {
    out << ".SH \"frictionbeam " << command->get_name() << "\"\n"
        << roff(command->get_description()) << ".\n";
    list_options(*command, out);
  }
  out << ".SH EXIT STATUS\n" << roff(exit_status) << '\n';
}

/// Long names of an app's options, each behind a space.
std::string long_names(const CLI::App &app) {
  std::string result;
  for (const CLI::Option *const option : app.get_options())
    for (const std::string &name : option->get_lnames())
      result += " --" + name;
  return result;
}

void print_completion(const CLI::App &app, std::ostream &out) {
  std::string commands;
  out << "_frictionbeam() {\n  local words\n  case \"${COMP_WORDS[1]}\" in\n";
  for (const CLI::App *const command : app.get_subcommands({})) {
    commands += " " + command->get_name();
    out << "  " << command->get_name() << ") words=\"" << long_names(*command).substr(1)
        << "\" ;;\n";
  }
  out << "  *) words=\"" << long_names(app).substr(1) << "\"; ((COMP_CWORD == 1)) && words+=\""
      << commands << "\" ;;\n  esac\n"
      << "  COMPREPLY=($(compgen -W \"$words\" -- \"$2\"))\n}\n"
      << "complete -o default -F _frictionbeam frictionbeam\n";
}

} // namespace

CommandLine read_command_line(const int argc, const char *const *argv) {
  CommandLine line;
  CLI::App app("solves piping lines and bodies on friction supports", "frictionbeam");
  declare(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp &) {
    const auto parsed = app.get_subcommands();
    std::cout << (parsed.empty() ? app : *parsed.front()).help();
    return {};
  } catch (const CLI::ParseError &error) {
    const auto parsed = app.get_subcommands();
    throw UserError(std::string("The command line is not understood: ") + error.what() +
                    "\n  try:     frictionbeam " +
                    (parsed.empty() ? "" : parsed.front()->get_name() + " ") + "--help");
  }
  if (app.count("--version") > 0)
    std::cout << "FrictionBeam " << program_version() << ", deal.II " << deal_ii_version() << '\n';
  else if (app.count("--print-parameters") > 0) {
    LawLibrary laws;
    laws.load_builtin();
    print_parameters(std::cout, laws);
  } else if (app.count("--print-man-page") > 0)
    print_man_page(app, std::cout);
  else if (app.count("--print-completion") > 0)
    print_completion(app, std::cout);
  else if (line.command == Command::nothing) {
    line.command = Command::run;
    if (line.options.parameter_file.empty())
      throw UserError("Which case? Name a parameter file.\n\n" + app.help());
  } else if (line.command == Command::check && line.options.parameter_file.empty())
    throw UserError("Which case? Name a parameter file: frictionbeam check CASE.prm");
  else if (line.command == Command::study && line.options.parameter_file.empty())
    throw UserError("Which case? Name a parameter file with sections Vary: frictionbeam study "
                    "CASE.prm");
  else if (line.command == Command::chart &&
           app.get_subcommand("chart")->count("--print-parameters") > 0)
    line.command = Command::chart_parameters;
  else if (line.command == Command::chart && line.chart_list.empty())
    throw UserError("Which list? frictionbeam chart prm/chart/slab.prm; "
                    "frictionbeam chart --print-parameters shows the entries of one.");
  return line;
}

} // namespace frictionbeam
