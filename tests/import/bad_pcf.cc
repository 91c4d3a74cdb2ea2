// SPDX-License-Identifier: LGPL-2.1-or-later
// Bad piping component files: exit status 1, and a message with the line, what was read, what is
// allowed and what to try.
#include "import_run.h"

namespace {

struct Bad {
  const char *what;
  std::string text;
  std::vector<std::string> options, expected;
};

} // namespace

void bad_input() {
  const std::string mm = line_in("mm");
  const std::vector<std::string> usual = usual_options();
  const auto with = [&](const std::vector<std::string> &more) {
    std::vector<std::string> options = usual;
    options.insert(options.end(), more.begin(), more.end());
    return options;
  };
  const auto cut = [&](const std::string &at) { return mm.substr(0, mm.find(at)); };
  const std::vector<Bad> list = {
      {"ends in the middle of a component",
       cut("    END-POINT 6096.0000 0.0000 2819.4000"),
       usual,
       {":70", "PIPE with 1 END-POINT; the file ends here: was it cut off?", "two END-POINTs"}},
      {"ends in the middle of a point",
       cut(" 0.0000 2819.4000"),
       usual,
       {":72", "END-POINT 6096.0000; the file ends here: was it cut off?", "x y z"}},
      {"unknown units",
       replaced(mm, "UNITS-CO-ORDS MM", "UNITS-CO-ORDS FURLONG"),
       usual,
       {":3", "UNITS-CO-ORDS FURLONG", "MM or INCH", "'UNITS-CO-ORDS MM'"}},
      {"unknown units of bolts",
       replaced(mm, "UNITS-BOLT-DIA MM", "UNITS-BOLT-DIA ELL"),
       usual,
       {":5", "UNITS-BOLT-DIA ELL"}},
      {"unknown units of weight",
       replaced(mm, "UNITS-WEIGHT KGS", "UNITS-WEIGHT STONE"),
       usual,
       {":4", "UNITS-WEIGHT STONE", "KGS or LBS"}},
      {"no units", replaced(mm, "UNITS-BORE MM\n", ""), usual, {"a file without UNITS-BORE"}},
      {"disconnected ends",
       replaced(mm, "END-POINT 6464.3000 457.2000 3048.0000 100",
                "END-POINT 6460.3000 457.2000 3048.0000 100"),
       usual,
       {"parts that do not meet", "(6.4603, 0.4572, 3.048) m", "(6.4643, 0.4572, 3.048) m",
        "4 mm apart", "--tolerance"}},
      {"no end points",
       replaced(mm, "    END-POINT 2032.0000 0.0000 0.0000 150 BW\n    END-POINT 2317.7500",
                "    X 2317.7500"),
       usual,
       {":37", "TEE with 0 END-POINTs", "two END-POINTs"}},
      {"zero length",
       replaced(mm, "END-POINT 2032.0000 0.0000 0.0000", "END-POINT 88.9000 0.0000 0.0000"),
       usual,
       {":24", "PIPE of zero length", "--tolerance"}},
      {"centre that does not fit",
       replaced(mm, "CENTRE-POINT 6096.0000 0.0000 0.0000", "CENTRE-POINT 6090.0000 0.0000 0.0000"),
       usual,
       {":58", "whose CENTRE-POINT (6.09, 0, 0) m", "from one END-POINT and"}},
      {"centre of the arc",
       replaced(mm, "CENTRE-POINT 6096.0000 0.0000 0.0000",
                "CENTRE-POINT 5867.4000 0.0000 228.6000"),
       usual,
       {":58", "it is the centre of the arc", "CENTRE-POINT (6.096, 0, 0) m"}},
      {"no wall",
       mm,
       {"--support-map", folder + "/supports.txt"},
       {":24",
        "pipes without a wall thickness, of bore 80 (line 194), 100 (line 111), 150 (line 24)",
        "--wall", "--schedule"}},
      {"wall that is no wall",
       mm,
       with({"--wall", "thick"}),
       {"--wall", "read:    thick", "7.11 mm"}},
      {"NUL bytes",
       replaced(mm, "PIPING-SPEC", std::string("PIP\0NG", 6)),
       usual,
       {":8", "a NUL byte"}},
      {"UTF-16", "\xff\xfe" + mm, usual, {"UTF-16", "iconv"}},
      {"no UTF-8",
       replaced(mm, "PIPING-SPEC", "PIPING\xd8SPEC"),
       usual,
       {":8", "byte 216", "no UTF-8", "--encoding latin-1"}},
      {"the same pipe twice",
       replaced(mm, "WELD\n",
                "PIPE\n    END-POINT 88.9 0 0 150\n    END-POINT 1016 0 0 150\nPIPE\n    "
                "END-POINT 88.9 0 0 150\n    END-POINT 1016 0 0 150\nWELD\n"),
       usual,
       {"lies already", "each component once"}},
      {"an olet on no pipe",
       replaced(mm, "CENTRE-POINT 2174.8750 1524.0000 0.0000",
                "CENTRE-POINT 2174.8750 1524.0000 9.0000"),
       usual,
       {":185", "is on no pipe: the nearest is 9 mm away"}},
      {"empty", "", usual, {"an empty file"}},
      {"no component", cut("END-CONNECTION"), usual, {"no component with a length"}},
      {"a table that is not there", mm, {"--attributes", "nowhere.txt"}, {"nowhere.txt", "caesar"}},
      {"no such units", mm, with({"--units", "ell"}), {"--units", "ell"}},
  };
  for (const Bad &bad : list) {
    const Imported line = import_text(bad.text, bad.options);
    expect(std::string(bad.what) + ": exit status 1", line.run.exit_status == 1, line.run.output);
    for (const std::string &part : bad.expected)
      expect(std::string(bad.what) + ": the message has '" + part + "'",
             line.run.output.find(part) != std::string::npos, line.run.output);
    expect(std::string(bad.what) + ": the message says what to try",
           line.run.output.find("try:") != std::string::npos, line.run.output);
  }
  // What was changed by hand is not written over.
  const program::TemporaryFolder place;
  import_text(mm, usual, place.path);
  const program::Run again =
      program::execute({program_path, "import", (place.path / "line.pcf").string(), "-o",
                        (place.path / "line.prm").string()});
  expect("a parameter file that is there stays",
         again.exit_status == 1 && again.output.find("--overwrite") != std::string::npos,
         again.output);
}
