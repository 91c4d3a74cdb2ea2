// SPDX-License-Identifier: LGPL-2.1-or-later
#include "documented_entries.h"

#include "../fuzz/parameter_text.h"
#include "../fuzz/trial.h"
#include "../text_pieces.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

/**
 * No entry of a parameter file may be ignored without a word.
 *
 *   silent_entries FRICTIONBEAM PROJECT [SCENE]
 *
 * Every entry of `FRICTIONBEAM --print-parameters`, and of the laws that it names, is set in every
 * scene of PROJECT/tests/entries/scenes, or of the one that is named, to a value other than the one
 * that it has there: those of settings in all scenes, those of a part in each part of its kind; of
 * a scene with a line `# tries: KIND, KIND` sections of these kinds alone. Then either a number of
 * the results changes, or a line is printed that names the entry, or the file is refused with a
 * message that names it. Values are made from the bounds that are documented, and read from
 * values.txt where they are words of the user's
 * (`Section/Entry = value | value ...`). exceptions.md says which entries may be silent, and why:
 * `| entry | scenes | reason |`, with a star for all. A row that nothing needs is a fault too, and
 * so is an entry that no scene has.
 */
namespace fs = std::filesystem;
using namespace entries;

namespace {

struct Exception {
  std::string entry, scene;
  bool is_needed = false;
};

/// Whether a text is a pattern's: the same, or with its beginning, where that ends with a star.
bool fits(const std::string &pattern, const std::string &text) {
  return pattern == text ||
         (pattern.back() == '*' && text.rfind(pattern.substr(0, pattern.size() - 1), 0) == 0);
}

std::vector<Exception> read_exceptions(const std::string &file) {
  std::vector<Exception> exceptions;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (const std::vector<std::string> cells = split(line, '|');
        cells.size() > 3 && cells[1] != "entry" && cells[1].rfind("---", 0) != 0)
      for (const std::string &scene : split(cells[2], ','))
        exceptions.push_back({cells[1], scene});
  return exceptions;
}

/// What a run has answered.
struct Answer {
  int status = 0;
  std::string numbers;         ///< of all tables and of the summary, but for what they cost
  std::string quantities;      ///< of the summary
  std::set<std::string> lines; ///< that were printed
};

/// What takes time takes another in each run.
void remove_times(nlohmann::json &in) {
  if (in.is_object())
    in.erase("seconds");
  if (in.is_structured())
    for (auto &one : in)
      remove_times(one);
}

class Scene {
public:
  /// @param file among what it names by relative paths
  /// @param folder where it runs
  Scene(const fs::path &file, const fs::path &folder)
      : name(file.stem().string()), text(fuzz::read_file(file.string())),
        file_of_trials((file.parent_path() / "trial").string()), folder(folder.string()) {
    base = run(text);
    if (base.status != 0)
      throw std::runtime_error(name + " ends with " + std::to_string(base.status));
    std::ifstream in(file);
    const std::string mark = "# tries: ";
    for (std::string line; std::getline(in, line);)
      if (line.rfind(mark, 0) == 0)
        kinds = split(line.substr(mark.size()), ',');
  }

  Answer run(const fuzz::ParameterText &changed) {
    const fuzz::Outcome outcome = fuzz::run_here(trial(changed.text()));
    Answer answer;
    answer.status = outcome.status;
    std::istringstream output(outcome.output);
    for (std::string line; std::getline(output, line);)
      answer.lines.insert(line);
    std::vector<fs::path> files;
    if (const fs::path results = folder + "/results"; fs::exists(results))
      for (const auto &entry : fs::recursive_directory_iterator(results))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path &file : files)
      if (file.extension() == ".csv" && file.filename() != "convergence.csv") // which has times
        answer.numbers += file.string() + '\n' + fuzz::read_file(file.string());
      else if (file.filename() == "summary.json") {
        nlohmann::json summary = nlohmann::json::parse(fuzz::read_file(file.string()));
        for (const char *const without : {"cost", "case", "remarks"})
          summary.erase(without);
        remove_times(summary);
        answer.quantities = summary["quantities"].dump();
        answer.numbers += summary.dump();
      }
    return answer;
  }

  bool tries(const std::string &kind) const {
    return kinds.empty() || std::count(kinds.begin(), kinds.end(), kind) > 0;
  }

  const std::string name;
  const fuzz::ParameterText text;
  Answer base;

private:
  fuzz::Trial trial(const std::string &changed) const {
    std::ofstream(file_of_trials) << changed;
    fuzz::Trial trial;
    trial.words = {"run",   file_of_trials,         "--set", "Output/VTU = false",
                   "--set", "Output/Report = false"};
    trial.folder = folder;
    trial.keep_after = true;
    return trial;
  }

  std::vector<std::string> kinds; ///< of sections that are tried; empty: all
  const std::string file_of_trials, folder;
};

/// The scene with an entry of one of its sections set to a value.
fuzz::ParameterText with(fuzz::ParameterText text, const std::string &heading,
                         const std::string &entry, const std::string &value) {
  auto section = std::find_if(text.sections.begin(), text.sections.end(),
                              [&](const auto &one) { return one.heading == heading; });
  if (section == text.sections.end())
    section = text.sections.insert(section, {heading, {}});
  auto &lines = section->lines;
  lines.erase(std::remove_if(lines.begin(), lines.end(),
                             [&](const auto &line) { return line.name == entry; }),
              lines.end());
  lines.push_back({entry, value, ""});
  return text;
}

/// What the section says for an entry; empty if it says nothing.
std::string value_in(const fuzz::ParameterText &text, const std::string &heading,
                     const std::string &entry) {
  for (const auto &section : text.sections)
    if (section.heading == heading)
      for (const auto &line : section.lines)
        if (line.name == entry)
          return line.value;
  return "";
}

class Search {
public:
  Search(const std::string &program, const std::string &values, const std::string &exceptions)
      : documented(documented_entries(program)), values(read_values(values)),
        exceptions(read_exceptions(exceptions)) {}

  void look_at(Scene &scene) {
    const auto start = std::chrono::steady_clock::now();
    const unsigned int n_before = n_runs;
    for (const Entry &entry : documented)
      for (const std::string &heading : headings(scene, entry)) {
        tried.insert(entry.name());
        std::string how;
        if (!is_silent(scene, heading, entry, how))
          continue;
        bool is_excepted = false;
        for (Exception &exception : exceptions)
          if (fits(exception.entry, entry.name()) && fits(exception.scene, scene.name))
            is_excepted = exception.is_needed = true;
        if (!is_excepted)
          fault(scene.name + ": " + (heading.empty() ? "" : heading + "/") + entry.word + ": " +
                how);
      }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << scene.name << ": " << n_runs - n_before << " runs, " << seconds.count() << " s"
              << std::endl;
  }

  int report() {
    for (const Entry &entry : documented)
      if (tried.count(entry.name()) == 0)
        fault(entry.name() + " is in no scene");
    for (const Exception &exception : exceptions)
      if (!exception.is_needed)
        fault(exception.entry + " is an exception of " + exception.scene + " that nothing needs");
    std::cout << documented.size() << " entries, " << n_runs << " runs, " << n_faults << " wrong\n";
    return n_faults > 0 ? 1 : 0;
  }

  /// Of the scenes so far, whatever the others need.
  int n_wrong() const { return n_faults > 0 ? 1 : 0; }

private:
  /// Sections of scenes that are made of them, and that no other scene may have.
  inline static const std::set<std::string> makers = {"Slab",   "Oscillator", "Rack",
                                                      "Random", "Long bar",   "Body"};

  /// The scene's sections in which an entry is tried.
  static std::vector<std::string> headings(const Scene &scene, const Entry &entry) {
    std::vector<std::string> result;
    if (!scene.tries(entry.kind))
      return result;
    const fuzz::ParameterText &text = scene.text;
    if (!entry.is_of_part && makers.count(entry.kind) == 0)
      result = {entry.kind};
    for (const auto &section : text.sections)
      if (entry.is_of_part
              ? section.heading.rfind(entry.kind + " ", 0) == 0 &&
                    (entry.law.empty() || value_in(text, section.heading, "Law") == entry.law)
              : section.heading == entry.kind && makers.count(entry.kind) > 0)
        result.push_back(section.heading);
    return result;
  }

  /// Whether texts differ by more than rounding of the numbers in them, beside the largest one.
  static bool differ(const std::string &one, const std::string &other) {
    constexpr double rounding = 1e-6, nothing = 1e-9;
    double largest = 0., difference = 0.;
    const char *a = one.c_str(), *b = other.c_str();
    while (*a != 0 && *b != 0) {
      char *end_of_a = nullptr, *end_of_b = nullptr;
      const double x = std::strtod(a, &end_of_a), y = std::strtod(b, &end_of_b);
      if (end_of_a == a || end_of_b == b) {
        if (*a++ != *b++)
          return true;
        continue;
      }
      largest = std::max(largest, std::abs(x));
      if (std::abs(x - y) > rounding * std::abs(x))
        difference = std::max(difference, std::abs(x - y));
      a = end_of_a;
      b = end_of_b;
    }
    return *a != *b || difference > nothing * largest;
  }

  static bool says_unused(const Answer &answer, const Answer &base, const std::string &entry) {
    return std::any_of(answer.lines.begin(), answer.lines.end(), [&](const std::string &line) {
      return base.lines.count(line) == 0 && line.find(entry + " is not used ") != std::string::npos;
    });
  }

  /// Whether none of the values that the scene takes for the entry is noticed.
  bool is_silent(Scene &scene, const std::string &heading, const Entry &entry, std::string &how) {
    const std::string here = value_in(scene.text, heading, entry.word);
    const auto given = values.find(entry.name());
    const std::vector<std::string> tries =
        given != values.end() ? given->second : other_values(entry, here);
    if (tries.empty())
      how = "there is no value for it";
    for (const std::string &value : tries) {
      if (value == here)
        continue;
      ++n_runs;
      const Answer answer = scene.run(with(scene.text, heading, entry.word, value));
      const bool is_named =
          std::any_of(answer.lines.begin(), answer.lines.end(), [&](const std::string &line) {
            return scene.base.lines.count(line) == 0 &&
                   (line.find(entry.word) != std::string::npos ||
                    line.find("ection " + heading + ' ') != std::string::npos);
          });
      const bool is_refused = answer.status == 1, is_changed = answer.numbers != scene.base.numbers;
      if (!is_refused && says_unused(answer, scene.base, entry.word) &&
          differ(answer.quantities, scene.base.quantities))
        fault(scene.name + ": " + heading + '/' + entry.word + ": '" + value +
              "' is said to be unused, and changes numbers");
      if (!is_refused && (is_named || answer.status != scene.base.status || is_changed))
        return false;
      const bool is_about_it =
          is_named || std::any_of(answer.lines.begin(), answer.lines.end(), [&](const auto &line) {
            return (!heading.empty() && line.find(heading) != std::string::npos) ||
                   line.find(value) != std::string::npos;
          });
      if (!is_refused || !is_about_it)
        how = "'" + value + "' is " +
              (is_refused ? "refused without naming it" : "ignored without a word");
    }
    return !how.empty();
  }

  void fault(const std::string &text) {
    ++n_faults;
    std::cout << text << std::endl;
  }

  const std::vector<Entry> documented;
  const std::map<std::string, std::vector<std::string>> values;
  std::vector<Exception> exceptions;
  std::set<std::string> tried;
  unsigned int n_runs = 0, n_faults = 0;
};

/// A copy of the scenes, which may be written to, beside the files of the project that they name.
class ProjectCopy {
public:
  explicit ProjectCopy(const fs::path &project)
      : root(fs::temp_directory_path() / ("silent_entries_" + std::to_string(getpid()))) {
    fs::create_directories(root / "tests/entries");
    fs::copy(project / "tests/entries/scenes", scenes());
    fs::create_directory_symlink(project / "tests/cases", root / "tests/cases");
    fs::create_directory_symlink(project / "prm", root / "prm");
  }
  ~ProjectCopy() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  ProjectCopy(const ProjectCopy &) = delete;
  ProjectCopy &operator=(const ProjectCopy &) = delete;

  fs::path scenes() const { return root / "tests/entries/scenes"; }

private:
  const fs::path root;
};

} // namespace

int main(int argc, char **argv) {
  try {
    if (argc < 3)
      throw std::runtime_error("silent_entries FRICTIONBEAM PROJECT [SCENE]");
    const fs::path project = fs::absolute(argv[2]);
    const ProjectCopy copy(project);
    Search search(argv[1], (project / "tests/entries/values.txt").string(),
                  (project / "tests/entries/exceptions.md").string());
    std::vector<fs::path> files;
    for (const auto &entry : fs::directory_iterator(copy.scenes()))
      if (entry.path().extension() == ".prm" && (argc == 3 || entry.path().stem() == argv[3]))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path &file : files) {
      Scene scene(file, copy.scenes());
      search.look_at(scene);
    }
    return argc == 3 ? search.report() : search.n_wrong();
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
