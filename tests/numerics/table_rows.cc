// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables of users shall be read as editors, spreadsheets and measuring programs write them, and
// what is no table shall be refused with its line.
#include "scene/file/table_rows.h"
#include "base/user_error.h"
#include "scene/spectra/curve_file.h"

#include <cstdio>
#include <fstream>
#include <iostream>

using namespace frictionbeam;

namespace {

int faults = 0;
const char *const file = "table_rows.csv";

void expect(const bool holds, const std::string &what) {
  if (!holds) {
    std::cerr << "fails: " << what << '\n';
    ++faults;
  }
}

void write(const std::string &text) { std::ofstream(file, std::ios::binary) << text; }

std::string joined(const std::vector<std::string> &fields) {
  std::string text;
  for (const std::string &field : fields)
    text += '<' + field + '>';
  return text;
}

void fields() {
  expect(joined(fields_of_row("1, 2 , 3")) == "<1><2><3>", "commas");
  expect(joined(fields_of_row(" 1;2 ;3")) == "<1><2><3>", "semicolons");
  expect(joined(fields_of_row("1\t 2\t3 4")) == "<1><2><3 4>", "tabs");
  expect(joined(fields_of_row("  1   2 3 ")) == "<1><2><3>", "blanks");
  expect(joined(fields_of_row("1,2;3,4")) == "<1,2><3,4>", "decimal commas stay one field");
  expect(joined(fields_of_row("1,2,,")) == "<1><2>", "empty fields at the end");
  expect(joined(fields_of_row("1,,2")) == "<1><><2>", "an empty field within");
  expect(joined(fields_of_row(",,,")) == "", "a row of commas");
  expect(joined(fields_of_row(R"("a, b";"say ""x""", c)")) == R"(<a, b><say "x", c>)", "quotes");
  expect(joined(fields_of_row(R"(valve 6", 100)")) == R"(<valve 6"><100>)", "an inch mark");
  expect(joined(fields_of_row("a;b,c", ',')) == "<a;b><c>", "the header's separator");
  for (const std::string row : {"1, 2, 3\t", "\t1, 2, 3", "1,\t2,\t3", "1\t, 2\t, 3"})
    expect(joined(fields_of_row(row)) == "<1><2><3>", "commas with stray tabs");
  expect(joined(fields_of_row("a, b\tc")) == "<a, b><c>", "a comma in a field between tabs");
}

void rows() {
  write("\xef\xbb\xbf# comment\r\n\r\nitem,mass # of it\r\n\"no. #1\",2\r\n ,\r3 4\n\n5 6");
  std::string text;
  for (const TableRow &row : read_table_rows(file))
    text += std::to_string(row.line) + joined(fields_of_row(row.text));
  expect(text == "3<item><mass>4<no. #1><2>56<3><4>8<5><6>", "rows are " + text);
}

/// The same spectrum in every dress.
void curves() {
  for (const std::string text :
       {"frequency [Hz], acceleration [g]\n1,2\n3,4\n",
        "\xef\xbb\xbf\"frequency [Hz]\";\"acceleration [g]\";\r\n1;2;\r\n3;4;\r\n",
        "frequency [Hz]\tacceleration [g]\r1\t2\r3\t4\r", "1 2 # first\n\n3 4"}) {
    write(text);
    CurveForm form;
    form.unit = 9.80665;
    const auto curve = read_curve_file(file, form, "spectrum");
    expect(curve == std::vector<std::pair<double, double>>{{1., 2. * 9.80665}, {3., 4. * 9.80665}},
           "the curve of " + text);
  }
}

void refused(const std::string &text, const std::string &message) {
  write(text);
  for (const bool record : {false, true}) {
    std::string said;
    try {
      CurveForm form;
      if (record)
        read_record_file(file, form, "file");
      else
        read_curve_file(file, form, "file");
    } catch (const UserError &error) {
      said = error.what();
    }
    expect(said.find(message) != std::string::npos, "'" + text + "' says '" + said + "'");
  }
}

} // namespace

int table_rows(int, char **) {
  fields();
  rows();
  curves();
  refused(",,,\n1,2\n", "(table_rows.csv:1):\n  read:    ',,,'");
  refused("1,2\n;;\n", "(table_rows.csv:2):\n  read:    ';;'");
  refused("1,5;2,5\n", "'1,5;2,5'\n  allowed: two numbers");
  refused("1,2,3\n", "'1,2,3'");
  refused("", "no line with two numbers");
  std::remove(file);
  return faults == 0 ? 0 : 1;
}
