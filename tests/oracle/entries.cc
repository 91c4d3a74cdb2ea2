// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random_scene.h"
#include "write_scene.h"

#include "../text_pieces.h"

#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

/**
 * Which entries of a parameter file, and which values of entries with a choice, random scenes have.
 *
 *   oracle_entries FRICTIONBEAM LIST
 *
 * Every entry of `FRICTIONBEAM --print-parameters` shall stand in LIST, a table in Markdown, as
 * `drawn` or with the reason why not; what is called drawn shall be in a scene of the first seeds,
 * and what is not shall be in none. So an entry that is new is not forgotten. With a LIST that does
 * not exist the table is written to the terminal. Exit status 1 if something does not fit.
 */
using namespace oracle;

namespace {

/// "Pipe line3" and "Pipe name" are of kind Pipe, "Mesh" is itself.
std::string kind_of(const std::string &heading) {
  static const std::set<std::string> without_name = {"Long bar"};
  return without_name.count(heading) > 0 ? heading : heading.substr(0, heading.find(' '));
}

/// Call a function with the section's kind, the entry and its value for each line 'set'.
template <typename Function>
void each_entry(std::istream &in, const Function &function) {
  std::string section;
  for (std::string line; std::getline(in, line);) {
    const std::string text = trimmed(line);
    if (text.rfind("subsection ", 0) == 0)
      section = kind_of(text.substr(11)) + "/";
    else if (text == "end")
      section.clear();
    const auto equals = text.find('=');
    if (text.rfind("set ", 0) == 0 && equals != std::string::npos)
      function(section + trimmed(text.substr(4, equals - 4)), trimmed(text.substr(equals + 1)),
               line);
    else
      function("", "", line);
  }
}

/// Entries, and "entry = value" for each value of a choice, in the order of the output.
std::vector<std::string> entries_of(const std::string &program) {
  std::vector<std::string> result;
  std::string comment, of_law;
  std::istringstream in(output_of(program + " --print-parameters"));
  each_entry(in, [&](const std::string &entry, const std::string &value, const std::string &line) {
    if (entry.empty()) {
      const std::string words = trimmed(line);
      comment = words.empty() ? "" : comment + " " + trimmed(words.substr(words[0] == '#' ? 1 : 0));
      if (words.find("# Entries of a Support with Law") == 0)
        of_law = words.find("Law = coulomb") != std::string::npos ? "" : "Support/";
      else if (!of_law.empty() && words.rfind("#   ", 0) == 0)
        result.push_back(of_law + trimmed(words.substr(4, words.find('=') - 4)));
      return;
    }
    result.push_back(entry);
    if (const auto allowed = comment.rfind("Allowed: "); allowed != std::string::npos) {
      const std::vector<std::string> values =
          split(comment.substr(allowed + 9, comment.rfind('.') - allowed - 9), ',');
      bool has_default = false;
      for (const std::string &one : values)
        has_default = has_default || one == value;
      for (const std::string &one : values)
        if (has_default && values.size() > 1 && one.find("a number") == std::string::npos &&
            one.rfind("or ", 0) != 0)
          result.push_back(entry + " = " + one);
    }
    comment.clear();
  });
  return result;
}

/// Entries, and with their values, of scenes of all families.
std::set<std::string> drawn_entries(const std::uint64_t n_seeds) {
  std::set<std::string> drawn;
  for (const std::string family : {"", "more", "moving", "large", "response"})
    for (std::uint64_t seed = 1; seed <= n_seeds; ++seed) {
      Random random(seed + 77);
      Kinds kinds = kinds_of(family, random);
      kinds.transient = kinds.transient || (family.empty() && seed % 3 == 0);
      std::map<std::string, std::string> tables;
      std::istringstream in(parameter_file(random_scene(seed, kinds), tables));
      each_entry(in, [&](const std::string &entry, const std::string &value, const std::string &) {
        drawn.insert(entry);
        drawn.insert(entry + " = " + value);
      });
    }
  return drawn;
}

/// Rows '| entry | remark |' of a table.
std::map<std::string, std::string> read_list(const std::string &file) {
  std::map<std::string, std::string> list;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.rfind("| ", 0) == 0) {
      const std::vector<std::string> cells = split(line, '|');
      if (cells.size() < 3)
        throw std::runtime_error(file + ": '" + line + "' has not two columns");
      list[cells[1]] = cells[2];
    }
  return list;
}

} // namespace

int main(int argc, char **argv) {
  try {
    if (argc != 3)
      throw std::runtime_error("oracle_entries FRICTIONBEAM LIST");
    const std::vector<std::string> entries = entries_of(argv[1]);
    const std::set<std::string> drawn = drawn_entries(300);
    const std::map<std::string, std::string> list = read_list(argv[2]);
    if (list.empty()) {
      for (const std::string &entry : entries)
        std::cout << "| " << entry << " | " << (drawn.count(entry) > 0 ? "drawn" : "?") << " |\n";
      return 1;
    }
    int n_wrong = 0;
    const auto wrong = [&](const std::string &entry, const std::string &how) {
      std::cout << entry << ": " << how << '\n';
      ++n_wrong;
    };
    for (const std::string &entry : entries) {
      const auto row = list.find(entry);
      if (row == list.end())
        wrong(entry, "not in the list: is it drawn, or why not?");
      else if (row->second == "drawn" && drawn.count(entry) == 0)
        wrong(entry, "called drawn, but in no scene");
      else if (row->second != "drawn" && drawn.count(entry) > 0)
        wrong(entry, "called '" + row->second + "', but there are scenes with it");
      else if (row->second.empty() || row->second == "?")
        wrong(entry, "neither drawn nor a reason why not");
    }
    const std::set<std::string> known(entries.begin(), entries.end());
    for (const auto &[entry, remark] : list)
      if (known.count(entry) == 0 && entry != "entry" && entry != "---")
        wrong(entry, "in the list, but there is no such entry");
    std::cout << entries.size() << " entries and values, " << n_wrong << " wrong\n";
    return n_wrong > 0 ? 1 : 0;
  } catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
