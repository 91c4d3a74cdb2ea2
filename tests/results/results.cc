// SPDX-License-Identifier: LGPL-2.1-or-later
// The writers of results shall produce valid JSON, RFC 4180 csv, VTU and a report that stands
// alone, from names and numbers however awkward, shall hand each frame to the system at once, and
// shall say what is wrong where they cannot write. Expected texts follow from
// tests/results/sample.h.
#include "check.h"
#include "sample.h"

#include "base/user_error.h"
#include "results/file/csv_writer.h"
#include "results/file/summary.h"
#include "results/file/vtu_writer.h"
#include "results/page/plot.h"
#include "results/report/report.h"
#include "results/text.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <sstream>

using namespace frictionbeam;

namespace {

const std::string folder = "results-test/a/b";

std::string read(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  CHECK(file.good());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string &text, const std::string &part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++n;
  return n;
}

/// Rows and fields of a csv file after RFC 4180.
std::vector<std::vector<std::string>> parse_csv(const std::string &text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string &field = rows.back().back();
    if (quoted) {
      if (text[i] != '"')
        field += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else
        quoted = false;
    } else if (text[i] == '"')
      quoted = true;
    else if (text[i] == ',')
      rows.back().emplace_back();
    else if (text[i] == '\n')
      rows.push_back({""});
    else
      field += text[i];
  }
  CHECK(!quoted);
  CHECK(rows.back().size() == 1 && rows.back()[0].empty()); // the last line is complete
  rows.pop_back();
  for (const auto &row : rows)
    CHECK(row.size() == rows.front().size());
  return rows;
}

std::string message_of(const std::function<void()> &action) {
  try {
    action();
  } catch (const UserError &error) {
    return error.what();
  } catch (const OutputError &error) {
    return error.what();
  }
  return "";
}

void check_numbers() {
  CHECK(exact_number(0.1) == "0.1");
  CHECK(exact_number(-0.) == "0");
  CHECK(std::stod(exact_number(1. / 3.)) == 1. / 3.);
  CHECK(rounded_number(12345.6) == "12346");
  CHECK(fixed_number(-1e-9, 2) == "0.00");
  CHECK(decimals_for(12.3) == 2);
  CHECK(display_unit("N", 2e3).name == "kN");
  CHECK(csv_field("plain") == "plain");
  CHECK(csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"");
}

/// Numbers that tables repeat have the same text as when they came first.
void check_repeated_numbers() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-300., 300.);
  std::vector<double> numbers = {0., -0., 1., -1.7976931348623157e308, 5e-324, 1. / 0., -1. / 0.};
  for (unsigned int i = 0; i < 3000; ++i)
    numbers.push_back((i % 2 == 0 ? 1. : -1.) * std::pow(10., exponent(random)));
  for (const double number : numbers)
    for (unsigned int time = 0; time < 2; ++time) {
      char expected[100];
      *std::to_chars(expected, expected + sizeof(expected), number + 0.).ptr = '\0';
      CHECK(exact_number(number) == expected);
    }
  CHECK(exact_number(std::nan("")) == "nan" && exact_number(std::nan("")) == "nan");
}

/// A table made by two threads has the rows in their order, or says why it has not.
void check_rows() {
  const auto add_row = [](const std::size_t row, std::string &text) {
    text += std::to_string(row) + ',' + exact_number(row % 7 / 3.) + '\n';
  };
  for (const std::size_t n_rows : {0, 1, 999, 1000, 1001, 2000, 34567}) {
    std::string expected = "header\n";
    for (std::size_t row = 0; row < n_rows; ++row)
      add_row(row, expected);
    const std::string path = folder + "/rows.csv";
    OutputFile file(path);
    file.stream() << "header\n";
    file.flush();
    write_rows(n_rows, add_row, file);
    CHECK(read(path) == expected);
  }
  if (std::filesystem::exists("/dev/full")) {
    OutputFile full("/dev/full");
    const std::string message = message_of([&] { write_rows(34567, add_row, full); });
    CHECK(contains(message, "No space left on device"));
  }
  for (const std::size_t bad : {0, 5500, 34566}) {
    OutputFile file(folder + "/rows.csv");
    const auto fail = [&](const std::size_t row, std::string &text) {
      if (row == bad)
        throw UserError("row " + std::to_string(row));
      add_row(row, text);
    };
    const std::string message = message_of([&] { write_rows(34567, fail, file); });
    CHECK(message == "row " + std::to_string(bad));
  }
}

void check_folder() {
  std::filesystem::remove_all("results-test");
  prepare_output_folder(folder);
  CHECK(std::filesystem::is_empty(folder));

  // what an earlier run left stays until there is something to put in its place
  write_file(folder + "/summary.json", "old");
  prepare_output_folder(folder);
  CHECK(std::filesystem::exists(folder + "/summary.json"));
  std::filesystem::remove(folder + "/summary.json");

  write_file("results-test/file", "");
  std::string message = message_of([] { prepare_output_folder("results-test/file/sub"); });
  CHECK(contains(message, "results-test/file/sub") && contains(message, "Not a directory"));
  message = message_of([] { prepare_output_folder("results-test/file"); });
  CHECK(contains(message, "results-test/file") && contains(message, "Not a directory"));
  message = message_of([] { OutputFile("results-test/missing/x.csv"); });
  CHECK(contains(message, "x.csv") && contains(message, "No such file"));
  if (std::filesystem::exists("/dev/full")) {
    message = message_of([] { write_file("/dev/full", "text"); });
    CHECK(contains(message, "No space left on device"));
  }
}

void check_csv(Sample &sample) {
  CsvWriter csv(sample.scene, sample.results, folder);
  const auto supports = [&] { return parse_csv(read(folder + "/supports.csv")); };
  CHECK(supports().size() == 1);
  for (unsigned int i = 0; i < sample.results.frames.size(); ++i) {
    for (History &history : sample.results.histories) {
      history.time.push_back(sample.results.frames[i].time);
      history.displacement.push_back({{1e-3 * i, 0., 0., 0., 0., 0.}});
    }
    csv.append(sample.results.frames[i]);
    CHECK(supports().size() == 1 + 8 * (i + 1)); // on disk already
  }
  csv.finish();

  const auto rows = supports();
  CHECK(rows[0] ==
        (std::vector<std::string>{"support", "step", "increment", "time", "status", "fn", "ft1",
                                  "ft2", "gap", "slip1", "slip2", "work_friction", "mt"}));
  CHECK(rows[1] == (std::vector<std::string>{hard_name, "weight", "1", "0.5", "stick", "0.1",
                                             "-0.03", "0", "0", "0.001", "0", "2.5", "0"}));
  CHECK(rows[2][4] == "slip" && rows[3][4] == "open" && rows[4][4] == "closed");
  CHECK(rows.back()[1] == "heating, \"hot\" <1>");

  const auto line = parse_csv(read(folder + "/line.csv"));
  CHECK(line.size() == 1 + 2 * 50); // ends of steps only
  CHECK(line[0].size() == 20 && line[0][0] == "step" && line[0][12] == "N" && line[0][17] == "Mz" &&
        line[0][19] == "M_out");
  CHECK(line[1][1] == "pipe, 1");

  const auto reactions = parse_csv(read(folder + "/reactions.csv"));
  CHECK(reactions.size() == 1 + 4);
  CHECK(reactions[1] ==
        (std::vector<std::string>{"anchor", "weight", "1", "0.5", "1", "2", "3", "4", "5", "nan"}));
  CHECK(parse_csv(read(folder + "/history_tip.csv")).size() == 5);
  CHECK(parse_csv(read(folder + "/history_a_b.csv"))[2][1] == "0.001");
}

void check_summary(const Sample &sample) {
  write_summary(sample.scene, sample.results, folder);
  const auto summary = nlohmann::json::parse(read(folder + "/summary.json"));
  CHECK(summary.at("status") == "converged");
  const nlohmann::json &quantities = summary.at("quantities");
  CHECK(quantities.at(0).at("value") == 0.1 && quantities.at(0).at("reference") == 0.2 &&
        quantities.at(0).at("error").is_null());
  CHECK(std::any_of(quantities.begin(), quantities.end(),
                    [](const nlohmann::json &one) { return one.at("value").is_null(); }));
  CHECK(contains(summary.dump(), "displacement \\\"x\\\" \\\\ \\t\\u0001 \xc3\xa9 \xef\xbf\xbd"));
  for (const char *name : {"wall_seconds", "peak_memory_mb"})
    CHECK(summary.at("cost").contains(name));
  for (const char *name : {"certificate", "method", "steps"})
    CHECK(summary.contains(name));

  write_summary(Scene(), Results(), folder);
  CHECK(nlohmann::json::accept(read(folder + "/summary.json")));
}

void check_vtu(const Sample &sample) {
  const unsigned int n_steps = sample.results.frames.back().step + 1;
  VtuWriter vtu(sample.results, folder, n_steps);
  for (const Frame &frame : sample.results.frames)
    vtu.append(frame);
  Frame sizes = sample.results.frames.back(); // a case, whose time is that of a step
  sizes.step = n_steps + 1;
  sizes.is_amplitude = true;
  vtu.append(sizes);
  vtu.finish();
  CHECK(count(read(folder + "/results.pvd"), "vtu/line_") == 4);
  CHECK(count(read(folder + "/supports.pvd"), "vtu/supports_") == 4);
  CHECK(count(read(folder + "/cases.pvd"),
              "timestep=\"2\" group=\"\" part=\"0\" file=\"vtu/case_0002.vtu\"") == 1);
  CHECK(count(read(folder + "/case_supports.pvd"), "vtu/case_supports_0002.vtu") == 1);
  const std::string line = read(folder + "/vtu/line_0003.vtu");
  CHECK(contains(line, "NumberOfPoints=\"98\" NumberOfCells=\"49\""));
  CHECK(contains(line, "Name=\"displacement\" NumberOfComponents=\"3\""));
  const std::string supports = read(folder + "/vtu/supports_0000.vtu");
  CHECK(contains(supports, "NumberOfPoints=\"8\" NumberOfCells=\"8\""));
  CHECK(contains(supports, "Name=\"force\" NumberOfComponents=\"3\""));
}

/// Ids of the page, each once; no network; no markup from names.
void check_page(std::string page) {
  std::set<std::string> ids;
  for (const char quote : {'"', '\''})
    for (std::size_t at = 0;
         (at = page.find(std::string(" id=") + quote, at)) != std::string::npos;) {
      at += 5;
      CHECK(ids.insert(page.substr(at, page.find(quote, at) - at)).second);
    }
  CHECK(count(page, "<script>") == 1); // the page's own
  CHECK(!contains(page, "<b>&'1"));
  CHECK(count(page, "http://") + count(page, "https://") == count(page, "=\"http://www.w3.org/"));
  CHECK(!contains(page, "src=") && !contains(page, "@import") && !contains(page, "url(http"));
}

/// What the page's model is drawn from; null where the program was built without three.js.
nlohmann::json model_of(const std::string &page) {
  const std::string begin = "id=\"model-data\">";
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) {
    CHECK(contains(page, "three.js") && contains(page, "was missing"));
    return nullptr;
  }
  const std::size_t from = at + begin.size();
  const auto bytes =
      dealii::Utilities::decode_base64(page.substr(from, page.find('<', from) - from));
  return nlohmann::json::parse(
      dealii::Utilities::decompress(std::string(bytes.begin(), bytes.end())));
}

/// The number at a station, and how far it may be off.
std::pair<double, double> at_station(const nlohmann::json &packed, const std::size_t station) {
  long level = 0;
  for (std::size_t i = 0; i <= station; ++i)
    level += packed.at("d").at(i).get<long>();
  return {level * packed.at("f").get<double>(), 0.51 * packed.at("f").get<double>()};
}

void check_model(const nlohmann::json &model) {
  if (model.is_null())
    return;
  CHECK(model.at("steps").size() == 2 && model.at("supports").size() == 8);
  CHECK(model.at("left_out") == false && model.at("s").at("d").size() == 50);
  const nlohmann::json &last = model.at("steps").at(1);
  CHECK(last.at("kind") == "step" && model.at("supports").at(0).at("name") == hard_name);
  CHECK(last.at("supports").at(1).at(0) == "slip" && last.at("supports").at(1).at(1) == 1.1);
  CHECK(last.at("reactions").at(0) == nlohmann::json({1., 2., 3., 4., 5., nullptr}));
  for (const std::size_t station : {0, 17, 49}) {
    const double s = 120. * station / 49.;
    const auto [ux, ux_level] = at_station(last.at("u").at(0), station);
    CHECK(std::abs(ux - 1e-3 * s) <= ux_level && ux_level < 1e-5);
    const auto [uz, uz_level] = at_station(last.at("u").at(2), station);
    CHECK(std::abs(uz + 0.01 * std::sin(s)) <= uz_level);
    const auto [bending, level] = at_station(last.at("fields").at(3), station);
    CHECK(std::abs(bending - std::abs(3e3 * std::cos(s))) <= level);
  }
}

void check_report(const Sample &sample) {
  write_report(sample.scene, sample.results, folder);
  const std::string page = read(folder + "/report.html");
  check_page(page);
  check_model(model_of(page));
  CHECK(contains(page, "heating, &quot;hot&quot; &lt;1&gt;"));
  for (const char *id : {"quantities", "steps", "line", "forces", "histories", "supports",
                         "reactions", "solver", "input"})
    CHECK(contains(page, std::string("<section id=\"") + id + "\">"));
  const std::string picture = read(folder + "/line.svg");
  CHECK(contains(picture, "<?xml") && contains(picture, "times as large"));

  CHECK(contains(page, "<td>weight</td>") && contains(page, "&lt;1&gt; (not finished)</td>"));

  // nothing at all to show
  write_report(Scene(), Results(), folder);
  CHECK(contains(read(folder + "/report.html"), "Failed"));

  // a long line is thinned out
  const Sample large = make_sample(4000, 20000);
  write_report(large.scene, large.results, folder);
  const std::string large_page = read(folder + "/report.html");
  check_page(large_page);
  CHECK(large_page.size() < 5000000);
  CHECK(contains(large_page, "Shown are the 250 supports with the largest forces of 4000"));
  if (const nlohmann::json model = model_of(large_page); !model.is_null()) {
    const std::size_t n = model.at("s").at("d").size();
    CHECK(model.at("left_out") == true && n > 1500 && n < 5000);
    CHECK(model.at("supports").size() == 1500);
    double largest = 0.; // none is lost with the stations that are left out
    for (std::size_t i = 0; i < n; ++i)
      largest = std::max(largest, at_station(model.at("steps").at(0).at("fields").at(3), i).first);
    CHECK(std::abs(largest - 3e3) < 1.);
  }
}

void check_plot() {
  Plot plot;
  plot.x_label = "it's < & x";
  plot.log_y = true;
  plot.series = {{"a", {1., 2., 3.}, {1., 0., 10.}, Plot::Series::Style::line_points, false},
                 {"constant", {1., 2.}, {1., 1.}, Plot::Series::Style::line, true}};
  const DrawnPlots drawn = draw_plots({plot, Plot(), plot});
  CHECK(drawn.svg.size() == 3);
  if (drawn.problem.empty()) {
    for (const auto &svg : drawn.svg)
      CHECK(svg.substr(0, 4) == "<svg" && contains(svg, "</svg>"));
    CHECK(contains(drawn.svg[0], "it's &lt; &amp; x"));
  } else
    std::cout << drawn.problem << '\n';

  setenv("PATH", "/nowhere", 1);
  const DrawnPlots missing = draw_plots({plot});
  CHECK(contains(missing.problem, "gnuplot is not installed"));
  CHECK(missing.svg.size() == 1 && missing.svg[0].empty());
  const Sample sample = make_sample(8, 50);
  write_report(sample.scene, sample.results, folder);
  CHECK(contains(read(folder + "/report.html"), "gnuplot is not installed"));
}

} // namespace

int main() {
  Sample sample = make_sample(8, 50);
  check_numbers();
  check_repeated_numbers();
  check_folder();
  check_rows();
  check_csv(sample);
  check_summary(sample);
  check_vtu(sample);
  check_report(sample);
  check_plot();
  return check::report();
}
