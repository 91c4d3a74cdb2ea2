// SPDX-License-Identifier: LGPL-2.1-or-later
// Piping component files with traps, each by its geometry, weights and supports.
#include "import_run.h"

#include <chrono>
#include <functional>

namespace {

const std::string head = "ISOGEN-FILES ISOGEN.FLS\nUNITS-BORE MM\nUNITS-CO-ORDS MM\n"
                         "UNITS-WEIGHT KGS\nPIPELINE-REFERENCE T-1\n";
const std::vector<std::string> schedule = {"--schedule", "40"};

std::string point(const std::string &key, const std::string &place, const std::string &bore = "") {
  return "    " + key + " " + place + (bore.empty() ? "" : " " + bore) + "\n";
}

std::string run_of(const std::string &word, const std::string &from, const std::string &to,
                   const std::string &more = "", const std::string &bore = "100") {
  return word + "\n" + point("END-POINT", from, bore) + point("END-POINT", to, bore) + more;
}

std::string anchor(const std::string &place) {
  return "SUPPORT\n" + point("CO-ORDS", place) + "    SKEY ANCH\n    NAME A" +
         std::to_string(std::hash<std::string>()(place) % 1000) + "\n";
}

void expect_part(const std::string &what, const std::string &text, const std::string &part) {
  expect(what + ": '" + part + "'", text.find(part) != std::string::npos, text);
}

std::size_t count(const std::string &text, const std::string &part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

/// Imported, with nothing refused.
Imported taken(const std::string &what, const std::string &text,
               std::vector<std::string> options = schedule) {
  const Imported line = import_text(head + text, options);
  expect(what + " is taken", line.run.exit_status == 0, line.run.output);
  return line;
}

/// The weight that the supports of a line carry in its first step [N], by a run of it.
double weight_of(const std::string &text) {
  const program::TemporaryFolder place;
  const Imported line = import_text(head + text, schedule, place.path);
  expect("the line is taken", line.run.exit_status == 0, line.run.output);
  double sum = 0.;
  for (const auto &[name, numbers] : forces_of((place.path / "line.prm").string()))
    if (name.find(", weight") != std::string::npos)
      sum += numbers.at(2);
  return sum;
}

constexpr double gravity = 9.81, steel = 7850., pi = 3.14159265358979323846;
/// Metal of DN 100, schedule 40 [kg/m].
const double metal = steel * pi * (0.1143 - 0.00602) * 0.00602;

void check_near(const std::string &what, const double value, const double wanted,
                const double tolerance) {
  expect(what + ": " + std::to_string(value) + ", expected " + std::to_string(wanted),
         std::abs(value - wanted) <= tolerance * std::abs(wanted));
}

/// Two elbows that meet: a step aside, and the same elbow twice.
void double_elbows() {
  const std::string elbow =
      run_of("ELBOW", "1000 0 0", "1152 152 0", point("CENTRE-POINT", "1152 0 0"));
  const std::string text =
      run_of("PIPE", "0 0 0", "1000 0 0") + elbow +
      run_of("ELBOW", "1152 152 0", "1304 304 0", point("CENTRE-POINT", "1152 304 0")) +
      run_of("PIPE", "1304 304 0", "2000 304 0") + anchor("0 0 0") + anchor("2000 304 0");
  const Imported line = taken("two elbows back to back", text);
  expect_part("two elbows", line.parameters, "1.152 0 0 bend 0.152; 1.152 0.304 0 bend 0.152;");
  const double length = 1. + pi * 0.152 + 0.696;
  check_near("weight of two elbows", weight_of(text), gravity * metal * length, 1e-6);
  const Imported twice = import_text(head + text + elbow, schedule);
  expect("an elbow twice is refused", twice.run.exit_status == 1, twice.run.output);
  expect_part("an elbow twice", twice.run.output, "lies already");
}

/// What a valve with three or four ways weighs, whatever its ways, and with what stands on it.
void valves() {
  const std::string run = run_of("PIPE", "0 0 0", "1000 0 0") +
                          run_of("PIPE", "1400 0 0", "2400 0 0") +
                          run_of("PIPE", "1200 300 0", "1200 1000 0") + anchor("0 0 0") +
                          anchor("2400 0 0") + anchor("1200 1000 0");
  const std::string body =
      run_of("VALVE-3WAY", "1000 0 0", "1400 0 0",
             point("CENTRE-POINT", "1200 0 0") + point("BRANCH1-POINT", "1200 300 0", "100") +
                 "    WEIGHT 70\n");
  check_near("a valve with three ways", weight_of(run + body), gravity * (2.7 * metal + 70.), 1e-6);
  const std::string rest = "SUPPORT\n" + point("CO-ORDS", "1100 0 0") + "    SKEY REST\n";
  check_near("with a rest on it", weight_of(run + body + rest), gravity * (2.7 * metal + 70.),
             1e-6);
  const std::string cross =
      replaced(body, "VALVE-3WAY", "VALVE-4WAY") + point("BRANCH2-POINT", "1200 -300 0", "100");
  check_near("with four ways", weight_of(run + cross), gravity * (2.7 * metal + 70.), 1e-6);
  // In pounds, by WEIGHT and by an attribute without a unit.
  const std::string pounds = replaced(head, "UNITS-WEIGHT KGS", "UNITS-WEIGHT LBS") + run +
                             replaced(body, "WEIGHT 70", "COMPONENT-ATTRIBUTE8 100");
  const Imported line = import_text(pounds, {"--schedule", "40", "--attributes", "caesar"});
  double mass = 0.;
  std::istringstream lines(line.parameters);
  for (std::string text; std::getline(lines, text);)
    if (text.find("set Mass = ") != std::string::npos)
      mass += std::stod(text.substr(text.find('=') + 1));
  check_near("UNITS-WEIGHT LBS of an attribute", mass, 45.359237, 1e-8);
}

/// Tees without a centre, and reducers with a branch.
void branches() {
  const std::string ends = run_of("PIPE", "0 0 0", "1000 0 0") + anchor("0 0 0");
  const Imported lateral = taken("a tee without a centre",
                                 ends + "TEE\n" + point("END-POINT", "1000 0 0", "100") +
                                     point("END-POINT", "1400 0 0", "100") +
                                     point("BRANCH1-POINT", "1341.4 141.4 0", "100") +
                                     run_of("PIPE", "1400 0 0", "2000 0 0") + anchor("2000 0 0"));
  expect_part("its centre is said", lateral.run.output,
              "TEE has no CENTRE-POINT: taken where its branch is square to its run, at (1.3414, "
              "0, 0) m");
  const std::string reducer =
      run_of("PIPE", "0 0 0", "1000 0 0", "", "150") + "REDUCER-CONCENTRIC-TEED\n" +
      point("END-POINT", "1000 0 0", "150") + point("END-POINT", "1140 0 0", "100") +
      point("CENTRE-POINT", "1070 0 0") + point("BRANCH1-POINT", "1070 100 0", "50") +
      run_of("PIPE", "1140 0 0", "2000 0 0") +
      run_of("PIPE", "1070 100 0", "1070 800 0", "", "50") + anchor("0 0 0") + anchor("2000 0 0");
  const Imported teed = taken("a reducer with a branch", reducer);
  expect("there is one reducer", count(teed.parameters, "set End section") == 1, teed.parameters);
  expect_part("there is a tee", teed.parameters, "subsection Tee ");
  expect_part("the branch is whole", teed.parameters, " 1.07 0.8 0\n");
}

/// A support in the middle of a reducer leaves it one cone.
void reducers() {
  const std::string text =
      run_of("PIPE", "0 0 0", "1000 0 0", "", "150") + "REDUCER-CONCENTRIC\n" +
      point("END-POINT", "1000 0 0", "150") + point("END-POINT", "1140 0 0", "100") +
      run_of("PIPE", "1140 0 0", "2000 0 0") + anchor("0 0 0") + anchor("2000 0 0");
  const std::string rest =
      "SUPPORT\n" + point("CO-ORDS", "1070 0 0") + "    SKEY REST\n    NAME R1\n";
  const Imported line = taken("a support on a reducer", text + rest);
  expect("there is one reducer", count(line.parameters, "set End section") == 1, line.parameters);
  expect_part("the support stands in it", line.parameters, "1.07 0 0;");
  // The metal of the cone, by Simpson's rule; a run has steps in its place.
  const auto area = [](const double part) {
    const double wall = 0.00711 + part * (0.00602 - 0.00711),
                 diameter = 0.1683 + part * (0.1143 - 0.1683);
    return steel * pi * (diameter - wall) * wall;
  };
  const double cone = 0.14 * (area(0.) + 4. * area(0.5) + area(1.)) / 6.;
  check_near("its weight", weight_of(text + rest), gravity * (area(0.) + cone + 0.86 * metal),
             2e-6);
  // Reversed, the small end first.
  const Imported reversed = taken(
      "a reducer from its small end",
      run_of("PIPE", "0 0 0", "1000 0 0") + "REDUCER-CONCENTRIC\n" +
          point("END-POINT", "1140 0 0", "150") + point("END-POINT", "1000 0 0", "100") +
          run_of("PIPE", "2000 0 0", "1140 0 0", "", "150") + anchor("0 0 0") + anchor("2000 0 0"));
  expect_part(
      "its sections go with its ends", reversed.parameters,
      "set Section = dn_150\n  set End section = dn_100\n  set Route = n30 1.14 0 0; n20\n");
}

/// Schedules of descriptions; what is not known is said.
void schedules() {
  const auto described = [](const std::string &description, const std::string &bores = "100") {
    return run_of("PIPE", "0 0 0", "1000 0 0", "    ITEM-CODE I\n", bores) + anchor("0 0 0") +
           "MATERIALS\nITEM-CODE I\n    DESCRIPTION " + description + "\n";
  };
  for (const auto &[description, wanted] :
       {std::make_pair("PIPE SMLS SCH 80 A106", "80"), std::make_pair("PIPE S80", "40"),
        std::make_pair("PIPE SCH.80, A106", "80"), std::make_pair("PIPE A106 XS", "XS"),
        std::make_pair("PIPE, STD WT", "STD"), std::make_pair("PIPE SCH S80", "80"),
        std::make_pair("PIPE SCHEDULE 160", "160")})
    expect_part(description, taken(description, described(description)).parameters,
                std::string("set Schedule = ") + wanted + "\n");
  const Imported unknown = taken("SCH 10S", described("PIPE SMLS SCH 10S A312 TP304"));
  expect_part("a schedule that is not known is said", unknown.run.output,
              "schedule 10S of bore 100 is not known");
  for (const auto &[description, wanted] : {std::make_pair("PIPE ASTM A106 STD SCH 160", "160"),
                                            std::make_pair("PIPE EN STD 10216 SCH 80", "80")})
    expect_part(description, taken(description, described(description)).parameters,
                std::string("set Schedule = ") + wanted + "\n");
  const auto reducer = [](const std::string &description, const std::vector<std::string> &options) {
    return taken("a reducer, " + description,
                 "REDUCER-CONCENTRIC\n" + point("END-POINT", "0 0 0", "150") +
                     point("END-POINT", "140 0 0", "100") + "    ITEM-CODE I\n" + anchor("0 0 0") +
                     anchor("140 0 0") + "MATERIALS\nITEM-CODE I\n    DESCRIPTION " + description +
                     "\n",
                 options);
  };
  const Imported two = reducer("RED CONC SCH 80 X SCH 160 A234", {});
  expect_part("its first end", two.parameters, "set Size = DN 150\n  set Schedule = 80\n");
  expect_part("its second end", two.parameters, "set Size = DN 100\n  set Schedule = 160\n");
  const Imported one = reducer("RED CONC SCH 10S X SCH 40", {"--schedule", "80"});
  expect_part("the first is not known", one.run.output, "schedule 10S of bore 150 is not known");
  expect_part("the first is the option's", one.parameters,
              "set Size = DN 150\n  set Schedule = 80\n");
  expect_part("the second is its own", one.parameters, "set Size = DN 100\n  set Schedule = 40\n");
  // A diameter by an attribute beside a schedule.
  const Imported diameter =
      import_text(head + replaced(described("PIPE SCH 80"), "    ITEM-CODE I\n",
                                  "    ITEM-CODE I\n    COMPONENT-ATTRIBUTE1 114.5\n"),
                  {"--attributes", "caepipe"});
  expect_part("an outer diameter and a schedule", diameter.parameters,
              "set Outer diameter = 0.1145\n");
  expect_part("an outer diameter and a schedule", diameter.parameters, "set Wall = 0.00856\n");
}

/// Bends that turn back, and branches that begin on bends.
void bends() {
  const std::string ends = run_of("PIPE", "0 0 0", "1000 0 0") +
                           run_of("PIPE", "1000 304 0", "0 304 0") + anchor("0 0 0") +
                           anchor("0 304 0");
  for (const std::string centre : {"1000 152 0", "1152 152 0"}) {
    const std::string back = run_of("BEND", "1000 0 0", "1000 304 0",
                                    point("CENTRE-POINT", centre) + "    ANGLE 18000\n");
    const Imported line = taken("a bend of 180 degrees", ends + back);
    expect_part("its two halves", line.parameters,
                "1.152 0 0 bend 0.152; 1.152 0.304 0 bend 0.152;");
    expect_part("it is said", line.run.output, "turns by 180 degrees");
    check_near("its weight", weight_of(ends + back), gravity * metal * (2. + pi * 0.152), 1e-6);
  }
  // An ANGLE that is wrong bends nothing.
  const Imported wrong =
      taken("a wrong ANGLE", run_of("PIPE", "0 0 0", "1000 0 0") +
                                 run_of("BEND", "1000 0 0", "1152 152 0",
                                        point("CENTRE-POINT", "1152 0 0") + "    ANGLE 18000\n") +
                                 run_of("PIPE", "1152 152 0", "1152 900 0") + anchor("0 0 0"));
  expect_part("a wrong ANGLE", wrong.parameters, "1.152 0 0 bend 0.152;");
  expect_part("it is said", wrong.run.output, "ANGLE is 180 degrees, its points turn by 90");
  const Imported lost = import_text(
      head + run_of("BEND", "1000 0 0", "1000 304 0", point("CENTRE-POINT", "1000 152 0")) +
          anchor("1000 0 0"),
      schedule);
  expect("without pipe beside it, it is refused", lost.run.exit_status == 1, lost.run.output);
  expect_part("it is refused", lost.run.output, "no pipe comes in square");

  const std::string elbow = run_of("PIPE", "0 0 0", "1000 0 0") +
                            run_of("PIPE", "1152 152 0", "1152 1000 0") + anchor("0 0 0") +
                            anchor("1152 1000 0");
  const std::string on_it = point("CENTRE-POINT", "1152 0 0") +
                            point("BRANCH1-POINT", "1222 -70 0", "50"),
                    stub = run_of("PIPE", "1222 -70 0", "1422 -270 0", "", "50");
  for (const std::string &text :
       {elbow + run_of("ELBOW-TEED", "1000 0 0", "1152 152 0", on_it) + stub,
        elbow + run_of("ELBOW", "1000 0 0", "1152 152 0", point("CENTRE-POINT", "1152 0 0")) +
            "OLET\n" + on_it + stub}) {
    const Imported line = taken("a branch on an elbow", text);
    expect_part("the elbow is cut where it leaves", line.parameters, "1.107480231 0.044519769 0;");
    expect_part("there is a tee", line.parameters, "subsection Tee ");
    const double small = steel * pi * (0.0603 - 0.00391) * 0.00391,
                 branch = std::hypot(1.422 - 1.107480231, 0.27 + 0.044519769);
    check_near("all of it weighs", weight_of(text),
               gravity * (metal * (1. + 0.848 + pi / 2. * 0.152) + small * branch), 1e-6);
  }
  const Imported mitred =
      taken("a mitred bend", elbow + run_of("BEND", "1000 0 0", "1152 152 0",
                                            point("CENTRE-POINT", "1152 0 0") +
                                                "    ITEM-DESCRIPTION MITRE BEND 90\n"));
  expect_part("it is said", mitred.run.output, "is mitred: taken as a smooth bend");
}

/// Springs: their data goes to the hanger, and is never dropped in silence.
void springs() {
  const program::TemporaryFolder place;
  const std::string map = (place.path / "map.txt").string(),
                    attributes = (place.path / "attributes.txt").string();
  std::ofstream(map)
      << "\xef\xbb\xbfSPR* : hanger\r\nCON* : hanger, Kind = constant\r\nGDE* : guide\r\n";
  std::ofstream(attributes)
      << "SPRING-RATE;spring_rate;N/mm\r\nCOLD-LOAD\tcold_load\tkN\r\nHOT-LOAD,hot_load,N\r\n";
  const auto support = [](const std::string &skey, const std::string &more) {
    return "SUPPORT\n" + point("CO-ORDS", "1000 0 0") + "    SKEY " + skey + "\n    NAME S-1\n" +
           more;
  };
  const std::string line = run_of("PIPE", "0 0 0", "2000 0 0") + anchor("0 0 0");
  const std::vector<std::string> options = {"--schedule", "40",           "--support-map",
                                            map,          "--attributes", attributes};
  const Imported spring =
      taken("a spring",
            line + support("SPR1", "    SPRING-RATE 50\n    COLD-LOAD 1.5\n    HOT-LOAD 1400\n"),
            options);
  expect_part("its rate", spring.parameters, "set Stiffness = 50000\n");
  expect_part("its load", spring.parameters, "set Cold load = 1500\n");
  expect_part("its hot load is said", spring.run.output, "its hot load of 1400 N is not taken");
  const Imported constant =
      taken("a constant hanger",
            line + support("CON1", "    COLD-LOAD 1500 N\n    SPRING-RATE 50\n"), options);
  expect_part("its load", constant.parameters, "set Cold load = 1500\n");
  expect("it has no stiffness", constant.parameters.find("set Stiffness") == std::string::npos,
         constant.parameters);
  expect_part("its rate is said", constant.run.output, "its spring rate is not taken");
  const Imported none =
      taken("a cold load of nothing",
            line + support("SPR1", "    SPRING-RATE 50\n    COLD-LOAD 0\n"), options);
  expect_part("its rate alone", none.run.output, "a spring rate without a cold load");
  const Imported guide =
      taken("a spring that is a guide", line + support("GDE1", "    COLD-LOAD 1.5\n"), options);
  expect_part("it is said", guide.run.output,
              "its spring's data is not taken: --support-map makes no hanger of it, but guide");
  const Imported rate =
      taken("a rate alone", line + support("SPR1", "    SPRING-RATE 50 N/mm\n"), options);
  expect_part("it is said", rate.run.output, "a spring rate without a cold load");
  const Imported words =
      taken("words of their own", line + support("SPR1", "    SPRING-SIZE 12\n    WEIGHT 5\n"),
            {"--schedule", "40", "--support-map", map});
  expect_part("they are said", words.run.output,
              "SPRING-SIZE 12, whose meaning --attributes can say");
  expect_part("its weight is said", words.run.output, "the weight that 1 SUPPORT say is not taken");
}

/// Millimetres and inches mixed, reversed runs, branches first, supports at one place.
void mixed() {
  const std::string text =
      "UNITS-BORE INCH\nUNITS-CO-ORDS MM\nUNITS-WEIGHT LBS\nPIPELINE-REFERENCE M-1\n    WEIGHT "
      "900\nTEE\n" +
      point("BRANCH1-POINT", "1105 105 0", "4") + point("CENTRE-POINT", "1105 0 0") +
      point("END-POINT", "1210 0 0", "4") + point("END-POINT", "1000 0 0", "4") +
      run_of("PIPE", "1000 0 0", "0 0 0", "    WEIGHT 35\n", "4") +
      run_of("PIPE", "2000 0 0", "1210 0 0", "", "4") +
      run_of("PIPE", "1105 1000 0", "1105 105 0", "", "4") + anchor("0 0 0") + anchor("2000 0 0") +
      "SUPPORT\n" + point("CO-ORDS", "1105 1000 0") + "    SKEY REST\n    NAME SAME\nSUPPORT\n" +
      point("CO-ORDS", "1105 1000 0") + "    SKEY GUIDE\n    NAME SAME\n";
  const Imported line = import_text(text, schedule);
  expect("inches and millimetres are taken", line.run.exit_status == 0, line.run.output);
  expect_part("bore in inches", line.parameters, "set Size = NPS 4\n");
  expect_part("the tee in the middle of the run", line.parameters, "1.105 0 0");
  expect("both supports of one place are there",
         line.parameters.find("subsection Support same\n") != std::string::npos &&
             line.parameters.find("subsection Support same_2\n") != std::string::npos,
         line.parameters);
  expect_part("the weight of a pipeline is not that of each component", line.run.output,
              "the weight of a whole pipeline; not taken");
  expect_part("weights of pipes are said", line.run.output,
              "the weight that 1 PIPE say is not taken");
  expect("no mass stands in the file", line.parameters.find("set Mass") == std::string::npos,
         line.parameters);
  const Imported corner =
      taken("a word that is not known, with a corner",
            run_of("PIPE", "0 0 0", "1000 0 0") +
                run_of("SWEEP", "1000 0 0", "1152 152 0", point("CENTRE-POINT", "1152 0 0")) +
                anchor("0 0 0"));
  expect_part("it is a bend", corner.parameters, "1.152 0 0 bend 0.152");
  expect_part("it is said", corner.run.output,
              "SWEEP, no component that is known: taken as a bend");
}

/// Thousands of pipes that do not meet, or lie in one row, take no more than their share of time.
void long_files() {
  std::string apart, row;
  constexpr unsigned int n = 6000;
  for (unsigned int i = 0; i < n; ++i) {
    apart += run_of("PIPE", std::to_string(1000 * i) + " 0 0",
                    std::to_string(1000 * i + 900 - i % 50) + " 0 0");
    row += run_of("PIPE", std::to_string(100 * i) + " 0 0", std::to_string(100 * i + 100) + " 0 0");
  }
  const auto start = std::chrono::steady_clock::now();
  const Imported gaps = import_text(head + apart, schedule);
  expect("pipes that do not meet are refused", gaps.run.exit_status == 1, gaps.run.output);
  expect_part("with their number", gaps.run.output, "in 6000 parts that do not meet");
  expect_part("and the shortest gaps", gaps.run.output, "100 mm apart");
  expect_part("not all of them", gaps.run.output, "and 5989 more");
  expect("the message is short", gaps.run.output.size() < 3000);
  const Imported line = taken("a long row", row + anchor("0 0 0"));
  expect_part("of two points", line.parameters, "n10 0 0 0; n20 600 0 0\n");
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  constexpr double patient = 60.; // a cube would take hours
  expect("in good time: " + std::to_string(seconds) + " s", seconds < patient);
}

} // namespace

void traps(const std::string &name) {
  const std::map<std::string, void (*)()> tests = {{"double_elbows", double_elbows},
                                                   {"valves", valves},
                                                   {"branches", branches},
                                                   {"reducers", reducers},
                                                   {"schedules", schedules},
                                                   {"bends", bends},
                                                   {"springs", springs},
                                                   {"mixed", mixed},
                                                   {"long_files", long_files}};
  tests.at(name)();
}
