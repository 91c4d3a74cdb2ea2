// SPDX-License-Identifier: LGPL-2.1-or-later
// Every column of every CSV file of a run stands in doc/results.md, in its order, and every
// summary.json fits doc/summary.schema.json; the tables of the model agree with line.csv,
// supports.csv and reactions.csv.
//   check_tables PROGRAM PROJECT TEST
#include "schema.h"
#include "tables.h"

#include <algorithm>
#include <cmath>
#include <iostream>

/// Forces of transient steps in the compliance table (transient.cc).
void check_transient_compliance();

namespace {

/// Runs that write every sort of table that a run writes, and every sort of summary.
struct Case {
  const char *file;
  std::vector<std::string> options;
};
const std::vector<Case> cases = {
    {"prm/example/plant.prm", {}},
    {"prm/example/catalogue_line.prm", {}},
    {"prm/example/earthquake.prm", {}},
    {"prm/example/yielding_rack.prm", {}},
    {"prm/example/spectrum.prm", {}},
    {"prm/example/load_cases.prm", {}},
    {"prm/example/pump_line.prm", {"--set", "Friction multipliers = 0.5, 1"}},
    {"prm/verification/nureg_1677_1_1.prm", {}},
    {"prm/verification/limit_loads.prm", {}},
    {"prm/verification/slab_continuum.prm", {}},
    {"prm/verification/rack_closed_form.prm", {"--set", "Accuracy = 0.05"}}};
/// Tables of other commands, of solid pipes and of every mode, which these runs do not write.
const std::vector<std::string> not_written = {"solid.csv",           "wall.csv",
                                              "models.csv",          "runs.csv",
                                              "failed.csv",          "spread.csv",
                                              "sensitivities.csv",   "record.csv",
                                              "record_motion.csv",   "record_spectrum.csv",
                                              "modal_line.csv",      "modal_supports.csv",
                                              "modal_reactions.csv", "spectrum_<damping>.csv",
                                              "<chart>.csv",         "governing.csv"};

program::Run run_case(const Case &one, const fs::path &folder) {
  std::vector<std::string> options = one.options;
  options.insert(options.end(),
                 {"--quiet", "--set", "Output/VTU = false", "--set", "Output/Report = false"});
  return program::run(program_path, project + "/" + one.file, options, folder);
}

/// Columns of each file of the glossary: the headings and first fields of the tables below them.
std::map<std::string, std::vector<std::string>> glossary() {
  std::map<std::string, std::vector<std::string>> result;
  std::ifstream page(project + "/doc/results.md");
  std::string file;
  for (std::string line; std::getline(page, line);)
    if (line.rfind("### ", 0) == 0)
      file = line.substr(4);
    else if (!file.empty() && line.rfind("| `", 0) == 0)
      result[file].push_back(line.substr(3, line.find("` |") - 3));
  return result;
}

bool is_open(const std::string &name) { return name.find('<') != std::string::npos; }

/// Whether @p text is @p pattern, in which <...> stands for anything.
bool fits(const std::string &pattern, const std::string &text) {
  const std::size_t begin = pattern.find('<'), end = pattern.find('>');
  if (begin == std::string::npos)
    return pattern == text;
  const std::string front = pattern.substr(0, begin), back = pattern.substr(end + 1);
  return text.size() >= front.size() + back.size() && text.rfind(front, 0) == 0 &&
         text.compare(text.size() - back.size(), back.size(), back) == 0;
}

/// Whether a header has the columns of a glossary in their order; an open one stands for any
/// number.
bool header_fits(const std::vector<std::string> &header, const std::vector<std::string> &columns) {
  std::size_t i = 0;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (is_open(columns[k]))
      while (i < header.size() && fits(columns[k], header[i]) &&
             (k + 1 == columns.size() || header[i] != columns[k + 1]))
        ++i;
    else if (i >= header.size() || header[i++] != columns[k])
      return false;
  return i == header.size();
}

/// Columns of the tables of a run against those of the page. @param seen files of the page
void check_columns(const Case &one, const fs::path &folder,
                   const std::map<std::string, std::vector<std::string>> &pages,
                   std::set<std::string> &seen) {
  // Units in headers are those of the case: the page has those of SI.
  const bool in_si =
      program::text_of(project + "/" + one.file).find("set Units") == std::string::npos;
  for (const auto &entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".csv")
      continue;
    const std::string name = entry.path().filename().string();
    auto page = pages.find(name);
    if (page == pages.end())
      page = std::find_if(pages.begin(), pages.end(), [&](const auto &p) {
        return is_open(p.first) && p.first[0] != '<' && fits(p.first, name);
      });
    expect(name + " of " + one.file + " is in doc/results.md", page != pages.end());
    if (page == pages.end())
      continue;
    seen.insert(page->first);
    std::ifstream in(entry.path());
    std::string header;
    std::getline(in, header);
    if (in_si || header.find('[') == std::string::npos)
      expect("doc/results.md has the columns of " + name + " in their order: " + header,
             header_fits(frictionbeam::csv_fields(header), page->second));
  }
}

void check_files_of_page(const std::map<std::string, std::vector<std::string>> &pages,
                         const std::set<std::string> &seen) {
  for (const auto &[file, columns] : pages) {
    const bool other = std::find(not_written.begin(), not_written.end(), file) != not_written.end();
    expect("doc/results.md has " + file + ", which no run writes", other || seen.count(file) == 1);
    expect(file + " has columns", !columns.empty());
  }
}

nlohmann::json json_of(const fs::path &file) {
  return nlohmann::json::parse(program::text_of(file));
}

/// A line that slides away, and one that the steps do not solve.
const char *const slides = R"(
set Free motions = ux, uz, ry
subsection Material steel
end
subsection Section pipe
  set Size = DN 100
end
subsection Pipe p
  set Route = A 0 0 0; B 6 0 0
end
subsection Support rests
  set Kind = rest
  set At = A, B
end
subsection Load weight
end
subsection Load push
  set Kind = force
  set Forces = A 1e6 0 0
end
subsection Step push
  set Loads = weight, push
end
)";

/// The page of columns and the schema of summaries, by the same runs.
void check_documents() {
  const auto pages = glossary();
  std::set<std::string> seen;
  const nlohmann::json text = json_of(project + "/doc/summary.schema.json");
  const Schema schema(text);
  std::set<std::string> words, parts;
  const auto check_folder = [&](const std::string &name, const fs::path &folder) {
    unsigned int n = 0;
    for (const auto &entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().filename() != "summary.json")
        continue;
      ++n;
      const nlohmann::json summary = json_of(entry.path());
      words.insert(summary.at("status").get<std::string>());
      for (const auto &[part, value] : summary.items())
        parts.insert(part);
      for (const std::string &fault : schema.faults(summary))
        expect(name + ": " + fault, false);
    }
    expect(name + " leaves a summary", n > 0);
  };
  for (const Case &one : cases) {
    const program::TemporaryFolder place;
    const program::Run run = run_case(one, place.path / "results");
    expect(std::string(one.file) + " ran\n" + run.output, run.exit_status == 0);
    check_folder(one.file, place.path / "results");
    check_columns(one, place.path / "results", pages, seen);
  }
  check_files_of_page(pages, seen);
  const program::TemporaryFolder place;
  const std::string file = (place.path / "slides.prm").string();
  std::ofstream(file) << slides;
  program::Run run = program::run(program_path, file, {}, place.path / "slides");
  expect("no equilibrium\n" + run.output, run.exit_status == 2 && run.status == "no_equilibrium");
  check_folder("no equilibrium", place.path / "slides");
  run = program::run(program_path, file,
                     {"--set", "Solver/Method = newton", "--set", "Solver/Max iterations = 1",
                      "--set", "Solver/Max halvings = 0"},
                     place.path / "failed");
  expect("failed\n" + run.output, run.exit_status == 2 && run.status == "failed");
  check_folder("failed", place.path / "failed");
  expect("every status is seen", words.size() == 3);
  // Each part of the schema is met.
  for (const auto &[part, value] : text["properties"].items())
    expect("a summary has '" + part + "'", parts.count(part) == 1);
  // The checker finds what is wrong.
  nlohmann::json bad = json_of(place.path / "slides" / "summary.json");
  bad["status"] = "fine";
  bad["steps"][0].erase("residual");
  bad["cost"]["cells"] = "many";
  bad["more"] = 1;
  expect("four faults are found", schema.faults(bad).size() == 4);
}

/// Whether a row of line.csv is at a node, and has all six forces of that end of an element.
bool is_same_place_and_force(const std::map<std::string, std::string> &station,
                             const std::map<std::string, std::string> &node,
                             const std::map<std::string, std::string> &forces,
                             const std::string &end) {
  for (const std::string axis : {"x", "y", "z"})
    if (!(std::abs(std::stod(station.at(axis)) - std::stod(node.at(axis + " [m]"))) < 1e-9))
      return false;
  for (const std::string force : {"N", "Vy", "Vz"})
    if (station.at(force) != forces.at(force + "_" + end + " [N]"))
      return false;
  for (const std::string moment : {"Mx", "My", "Mz"})
    if (station.at(moment) != forces.at(moment + "_" + end + " [N m]"))
      return false;
  return true;
}

/// Nodes, elements and forces against the older tables, which the same run writes by other code.
void check_tables() {
  const program::TemporaryFolder place;
  const fs::path folder = place.path / "results";
  run_case({"prm/example/plant.prm", {}}, folder);
  const auto nodes = rows_of(folder / "nodes.csv"), elements = rows_of(folder / "elements.csv"),
             forces = rows_of(folder / "element_forces.csv"), line = rows_of(folder / "line.csv"),
             supports = rows_of(folder / "supports.csv"),
             reactions = rows_of(folder / "reactions.csv"),
             restraints = rows_of(folder / "restraints.csv"),
             of_restraints = rows_of(folder / "restraint_forces.csv");
  std::map<std::string, std::vector<const std::map<std::string, std::string> *>> at; // line.csv
  const auto place_of = [](const std::string &step, const std::string &pipe, const std::string &s) {
    return step + "," + pipe + "," + std::to_string(std::lround(1e7 * std::stod(s)));
  };
  for (const auto &row : line)
    at[place_of(row.at("step"), row.at("pipe"), row.at("s"))].push_back(&row);
  unsigned int n = 0;
  for (const auto &row : forces) {
    const auto &element = elements.at(std::stoul(row.at("element")) - 1);
    CHECK(row.at("node_1") == element.at("node_1") && row.at("node_2") == element.at("node_2"));
    for (const std::string end : {"1", "2"}) {
      const auto &node = nodes.at(std::stoul(element.at("node_" + end)) - 1);
      bool found = false;
      for (const auto *const one :
           at[place_of(row.at("step"), element.at("pipe"), element.at("s_" + end + " [m]"))])
        found = found || is_same_place_and_force(*one, node, row, end);
      CHECK(found);
      n += found ? 1 : 0;
    }
  }
  CHECK(n > 0 && n % elements.size() == 0);
  // The weight that hangs in the elements is what the restraints carry.
  double mass = 0., up = 0.;
  for (const auto &row : elements)
    mass += std::stod(row.at("mass [kg/m]")) *
            (std::stod(row.at("s_2 [m]")) - std::stod(row.at("s_1 [m]")));
  for (const auto &row : of_restraints)
    if (row.at("step") == "operating_weight")
      up += std::stod(row.at("fz [N]"));
  CHECK_NEAR(up, 9.81 * mass, 1e-9);
  std::map<std::string, double> normal;
  for (const auto &row : supports)
    if (row.at("step") == "hot")
      normal[row.at("support")] = std::stod(row.at("fn")); // the last increment stays
  std::map<std::string, const std::map<std::string, std::string> *> reaction;
  for (const auto &row : reactions)
    if (row.at("step") == "hot")
      reaction[row.at("restraint")] = &row;
  for (const auto &row : of_restraints)
    if (row.at("step") == "hot" && normal.count(row.at("name")) == 1)
      CHECK_NEAR(std::stod(row.at("fz [N]")), normal[row.at("name")], 1e-12);
    else if (row.at("step") == "hot")
      for (const char *const number : {"fx", "fy", "fz", "mx", "my", "mz"})
        CHECK(row.at(number + std::string(number[0] == 'f' ? " [N]" : " [N m]")) ==
              reaction.at(row.at("name"))->at(number));
  CHECK(restraints.size() == normal.size() + reaction.size());
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 4)
    return 1;
  program_path = argv[1];
  project = argv[2];
  const std::map<std::string, void (*)()> tests = {{"documents", check_documents},
                                                   {"tables", check_tables},
                                                   {"transient", check_transient_compliance}};
  tests.at(argv[3])();
  return check::report();
}
