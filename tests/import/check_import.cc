// SPDX-License-Identifier: LGPL-2.1-or-later
// frictionbeam import: the same line from files in mm, in inches and by hand has the same
// reactions; dialects are understood; ends are snapped and said; supports become what the table
// says; bad input is refused with place and hint.
//   check_import PROGRAM FOLDER TEST
#include "import_run.h"

/// Bad input (bad_pcf.cc).
void bad_input();
/// Files with traps, by name (traps.cc).
void traps(const std::string &name);

namespace {

/// Weight and heat of the line from mm, from inches, and as written by hand.
void same_line() {
  const program::TemporaryFolder mm, inch;
  for (const auto &[unit, place] : {std::make_pair("mm", &mm), std::make_pair("inch", &inch)}) {
    const Imported line = import_text(line_in(unit), usual_options(), place->path);
    expect(std::string("import of the line in ") + unit, line.run.exit_status == 0,
           line.run.output);
    expect("nothing is left over", line.run.output.find("not understood 0") != std::string::npos,
           line.run.output);
  }
  const auto from_mm = forces_of((mm.path / "line.prm").string()),
             from_inches = forces_of((inch.path / "line.prm").string()),
             by_hand = forces_of(folder + "/line_by_hand.prm");
  expect("mm and inches", difference(from_mm, from_inches) < 1e-9,
         std::to_string(1e9 * difference(from_mm, from_inches)) + "e-9");
  expect("mm and by hand", difference(from_mm, by_hand) < 1e-9,
         std::to_string(1e9 * difference(from_mm, by_hand)) + "e-9");
}

/// The parameter file in other units.
void units() {
  const program::TemporaryFolder si, mm;
  import_text(line_in("mm"), usual_options(), si.path);
  std::vector<std::string> options = usual_options();
  options.insert(options.end(), {"--units", "mm kN MPa F"});
  const Imported other = import_text(line_in("mm"), options, mm.path);
  expect("units are written",
         other.parameters.find("set Units = mm kN MPa F\n") != std::string::npos, other.run.output);
  expect("temperature in F", other.parameters.find("set Temperature = 302\n") != std::string::npos);
  const double error = difference(forces_of((si.path / "line.prm").string()),
                                  forces_of((mm.path / "line.prm").string()), 1e3, 1.);
  expect("si and mm kN MPa F", error < 1e-8, std::to_string(1e9 * error) + "e-9");
  options.back() = "in lb psi F";
  const Imported us = import_text(line_in("inch"), options);
  expect("6 inches are 6.625 in",
         us.parameters.find("set Outer diameter = 6.625\n") != std::string::npos, us.run.output);
}

std::string without_blanks_in_front(const std::string &text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += line.substr(std::min(line.size(), line.find_first_not_of(' '))) + "\n";
  return result;
}

/// The parameter file without the name of the file that it came from.
std::string body(const std::string &parameters) {
  return parameters.substr(std::min(parameters.size(), parameters.find("set Title")));
}

/// Line ends, indentation, spelling, attributes by other numbers, walls in descriptions.
void dialects() {
  const std::string mm = line_in("mm");
  const Imported plain = import_text(mm, usual_options());
  std::string dos, mac;
  for (const char c : mm) {
    dos += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  for (const auto &[name, text] :
       {std::make_pair("DOS", dos), std::make_pair("old Mac", mac),
        std::make_pair("byte order mark", "\xef\xbb\xbf" + mm),
        std::make_pair("no indentation", without_blanks_in_front(mm)),
        std::make_pair("CENTER-POINT", replaced(mm, "CENTRE-POINT", "CENTER-POINT")),
        std::make_pair("<SKEY>", replaced(mm, "SKEY WTBW", "<SKEY> WTBW"))}) {
    const Imported line = import_text(text, usual_options());
    expect(name, line.run.exit_status == 0 && body(line.parameters) == body(plain.parameters),
           line.run.output);
  }
  std::vector<std::string> options = usual_options();
  options.insert(options.end(), {"--encoding", "latin-1"});
  const Imported latin = import_text(
      replaced(mm, "SUPPORT-NAME ANC-1", "SUPPORT-NAME ANC-1\n    NOTE \xd8 100"), options);
  expect("Latin-1", latin.run.exit_status == 0, latin.run.output);

  const Imported caepipe =
      import_text(program::text_of(folder + "/caepipe.pcf"), {"--attributes", "caepipe"});
  for (const char *const part : {"set Outer diameter = 0.2191\n", "set Wall = 0.00818\n",
                                 "set Corrosion allowance = 0.001\n", "set Insulation = 0.05\n",
                                 "set Insulation density = 180\n", "set Temperature = 200\n",
                                 "set Pressure = 1e+06\n", "set Kind = anchor\n", "bend 0.3048"})
    expect(std::string("CAEPIPE: ") + part, caepipe.parameters.find(part) != std::string::npos,
           caepipe.run.output);
  const Imported plant = import_text(program::text_of(folder + "/descriptions.pcf"),
                                     {"--support-map", folder + "/supports.txt"});
  for (const char *const part :
       {"set Size = NPS 8\n", "set Schedule = 40\n", "set Size = NPS 1-1/2\n",
        "set Schedule = 80\n", "set Grade = austenitic steel\n", "set Kind = unreinforced\n",
        "set Mass = 45.359237"})
    expect(std::string("descriptions: ") + part, plant.parameters.find(part) != std::string::npos,
           plant.run.output + plant.parameters);
  expect("a word that is not known is said",
         plant.run.output.find("FLOW-METER, no component that is known: taken as a pipe") !=
             std::string::npos,
         plant.run.output);
  expect("and stands in the file",
         plant.parameters.find("FLOW-METER, no component that is known") != std::string::npos);
  expect("attributes without a meaning are said",
         plant.run.output.find("COMPONENT-ATTRIBUTE1 A-1, whose meaning --attributes can say") !=
             std::string::npos,
         plant.run.output);
}

/// Ends within the tolerance are the same, and it is said.
void snapped() {
  const std::string mm = replaced(line_in("mm"), "END-POINT 6096.0000 0.0000 228.6000",
                                  "END-POINT 6096.4000 0.0000 228.6000");
  const Imported plain = import_text(line_in("mm"), usual_options()),
                 moved = import_text(mm, usual_options());
  expect("an end that is 0.4 mm off is snapped", moved.run.exit_status == 0, moved.run.output);
  expect("which is said",
         moved.run.output.find("an end was moved by 0.4 mm to (6.0964, 0, 0.2286)") !=
             std::string::npos,
         moved.run.output);
  std::vector<std::string> options = usual_options();
  options.insert(options.end(), {"--tolerance", "0.2"});
  const Imported apart = import_text(mm, options);
  expect("beyond the tolerance it is not", apart.run.exit_status == 1, apart.run.output);
  for (const char *const part :
       {"parts that do not meet", "line 58: ELBOW at (6.0964, 0, 0.2286) m",
        "at (6.096, 0, 0.2286) m", "0.4 mm apart", "--tolerance"})
    expect(std::string("the message has ") + part, apart.run.output.find(part) != std::string::npos,
           apart.run.output);
}

/// What the table makes of supports.
void supports() {
  const program::TemporaryFolder place;
  const std::string map = (place.path / "map.txt").string();
  std::ofstream(map)
      << "*/RST : stop, Gap = 0.003\n01HG : hanger, Stiffness = 5e4, Cold load = 800\n"
         "*/GDE : none\nEND-CONNECTION-EQUIPMENT : restraint, Fixed = ux, uy\n";
  const std::string mm = line_in("mm");
  Imported line = import_text(mm, {"--attributes", "caesar", "--support-map", map});
  expect("the table is taken", line.run.exit_status == 0, line.run.output);
  for (const char *const part : {"set Fixed = ux, uy\n", "subsection Hanger ps-102_rod\n",
                                 "set Cold load = 800\n", "set Gap = 0.003\n"})
    expect(part, line.parameters.find(part) != std::string::npos, line.parameters);
  expect("none leaves it out",
         line.parameters.find("subsection Support ps-101") == std::string::npos);

  line = import_text(mm, {"--attributes", "caesar"});
  expect("without a table the line is taken", line.run.exit_status == 0, line.run.output);
  expect("what has no row is said",
         line.run.output.find("SUPPORT PS-102/ROD, SKEY 01HG: no row of --support-map fits") !=
             std::string::npos,
         line.run.output);
  expect("and stands in the file to be completed",
         line.parameters.find("# subsection Support ps-102_rod\n") != std::string::npos);
  std::ofstream(map) << "* : guide, Gapp = 0.003\n";
  line = import_text(mm, {"--attributes", "caesar", "--support-map", map});
  expect("an entry that there is not",
         line.run.exit_status == 1 && line.run.output.find("Gapp") != std::string::npos,
         line.run.output);
  // A support below the pipe, and on the arc of an elbow.
  const Imported below = import_text(
      replaced(mm, "CO-ORDS 1016.0000 0.0000 0.0000", "CO-ORDS 1016.0000 0.0000 -84.1500"),
      usual_options());
  expect("a support at the bottom of the pipe is moved to its axis",
         below.run.output.find("moved by 84.15 mm onto the axis, to (1.016, 0, 0)") !=
             std::string::npos,
         below.run.output);
  const Imported on_bend = import_text(
      replaced(mm, "CO-ORDS 1016.0000 0.0000 0.0000", "CO-ORDS 6029.0445 0.0000 66.9555"),
      usual_options());
  expect("in the middle of an elbow it has the corner's name",
         on_bend.run.exit_status == 0 &&
             on_bend.parameters.find("n10 6.096 0 0 bend 0.2286") != std::string::npos,
         on_bend.run.output + on_bend.parameters);
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 4)
    return 1;
  program_path = argv[1];
  folder = argv[2];
  const std::map<std::string, void (*)()> tests = {
      {"same_line", same_line}, {"units", units},       {"dialects", dialects},
      {"snapped", snapped},     {"supports", supports}, {"bad_input", bad_input}};
  const auto test = tests.find(argv[3]);
  if (test != tests.end())
    test->second();
  else
    traps(argv[3]);
  return check::report();
}
