// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/file/parameter_file.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace frictionbeam {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return text;
}

/// Number of insertions, deletions and replacements between two words (Levenshtein).
unsigned int distance(const std::string &a, const std::string &b) {
  std::vector<unsigned int> row(b.size() + 1);
  for (unsigned int j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (unsigned int i = 1; i <= a.size(); ++i) {
    unsigned int diagonal = row[0];
    row[0] = i;
    for (unsigned int j = 1; j <= b.size(); ++j) {
      const unsigned int replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/// The first word of a line in small letters, and what follows it.
std::pair<std::string, std::string> first_word(const std::string &line) {
  const auto blank = line.find(' ');
  return {lower(line.substr(0, blank)),
          blank == std::string::npos ? "" : tidy(line.substr(blank + 1))};
}

} // namespace

std::string tidy(const std::string &text) {
  std::istringstream words(text);
  std::string result, word;
  while (words >> word)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

std::vector<std::string> split(const std::string &text, const char separator) {
  std::vector<std::string> pieces;
  if (tidy(text).empty())
    return pieces;
  std::string::size_type begin = 0;
  while (true) {
    const auto end = text.find(separator, begin);
    pieces.push_back(tidy(text.substr(begin, end - begin)));
    if (end == std::string::npos)
      return pieces;
    begin = end + 1;
  }
}

std::vector<std::string> split_names(const std::string &text) {
  std::vector<std::string> names;
  for (const std::string &word : split(text, ' ')) {
    const bool is_cycle = word.size() > 2 && word.front() == '(' && word.back() == ')' &&
                          word.find_first_not_of("0123456789", 1) == word.size() - 1;
    if (is_cycle && !names.empty())
      names.back() += " " + word;
    else
      names.push_back(word);
  }
  return names;
}

bool to_number(const std::string &text, double &value) {
  if (text.empty())
    return false;
  char *end = nullptr;
  value = std::strtod(text.c_str(), &end);
  constexpr double largest = 1e30; // of what physics knows, in any unit
  return *end == '\0' && std::abs(value) <= largest;
}

std::string nearest(const std::string &name, const std::vector<std::string> &candidates) {
  std::string best;
  unsigned int smallest = 1 + std::max<unsigned int>(2, name.size() / 2);
  for (const std::string &candidate : candidates) {
    const unsigned int d = distance(lower(name), lower(candidate));
    if (d < smallest) {
      smallest = d;
      best = candidate;
    }
  }
  return best;
}

std::string join(const std::vector<std::string> &names) {
  std::string result;
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) == name)
      result += (result.empty() ? "" : ", ") + *name;
  return result;
}

const ParameterFile::Entry *ParameterFile::Section::find(const std::string &name) const {
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [&](const Entry &e) { return e.name == name; });
  return entry == entries.end() ? nullptr : &*entry;
}

ParameterFile::ParameterFile() : parts(1) {}

ParameterFile::ParameterFile(const std::string &file) : file_name(file), parts(1) {
  parts[0].origin = file;
  read(file, 0);
}

const ParameterFile::Section *ParameterFile::find(const std::string &heading) const {
  const auto place = places.find(heading);
  return place == places.end() ? nullptr : &parts[place->second];
}

ParameterFile::Section &ParameterFile::section(const std::string &heading,
                                               const std::string &origin) {
  const auto [place, is_new] = places.try_emplace(heading, parts.size());
  if (is_new)
    parts.push_back({heading, origin, {}});
  return parts[place->second];
}

void ParameterFile::set(Section &section, Entry entry) {
  for (Entry &present : section.entries)
    if (present.name == entry.name) {
      const auto file = [](const Entry &e) { return e.origin.substr(0, e.origin.rfind(':')); };
      if (!entry.is_override && file(present) == file(entry))
        throw UserError(entry.origin + ": entry '" + entry.name + "'\n  read:    a second value, " +
                        entry.value + "; the first one is at " + present.origin +
                        "\n  allowed: one value for each entry\n  try:     remove one of the two" +
                        (section.heading.empty() ? ""
                                                 : ", or give one of two parts called '" +
                                                       section.heading + "' another name"));
      if (entry.is_override) {
        entry.in_file = present.in_file;
        entry.file_value = present.is_override ? present.file_value : present.value;
      }
      present = entry;
      return;
    }
  section.entries.push_back(entry);
}

namespace {

std::string text_of(const std::string &file) {
  std::ifstream in(file);
  std::ostringstream text;
  if (!std::filesystem::is_directory(file))
    text << in.rdbuf();
  if (!in || std::filesystem::is_directory(file))
    throw UserError("The parameter file '" + file + "' cannot be read.\n  read:    nothing\n" +
                    "  allowed: the path of a text file, from the folder the program runs in\n"
                    "  try:     ls " +
                    std::filesystem::absolute(file).parent_path().string());
  return text.str();
}

/// A line without its comment, and the lines that it goes on with after a '\\' at its end.
/// @param number of the line, counted on
std::string statement_of(std::string line, std::istream &lines, unsigned int &number) {
  std::string statement = tidy(line.substr(0, line.find('#')));
  while (!statement.empty() && statement.back() == '\\') {
    statement.pop_back();
    if (!std::getline(lines, line))
      break;
    ++number;
    statement += ' ' + tidy(line.substr(0, line.find('#')));
  }
  return tidy(statement);
}

} // namespace

void ParameterFile::read(const std::string &file, const unsigned int depth) {
  const std::string bytes = text_of(file);
  if (depth > 0) // behind the text of the file that includes it
    content += "\n# " + std::filesystem::path(file).filename().string() + ":\n";
  content += bytes;
  std::istringstream lines(bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? bytes.substr(3) : bytes);
  std::string line;
  unsigned int number = 0;
  std::string heading;       // of the open subsection
  std::string opened;        // where it was opened
  std::set<std::string> own; // headings of this very file
  while (std::getline(lines, line)) {
    ++number;
    const std::string origin = file + ":" + std::to_string(number);
    const std::string statement = statement_of(line, lines, number);
    if (statement.empty())
      continue;

    const auto fail = [&](const std::string &allowed, const std::string &hint) {
      throw UserError(origin + ":\n  read:    " + statement + "\n  allowed: " + allowed +
                      "\n  try:     " + hint);
    };
    const auto [word, rest] = first_word(statement);
    const auto equal = rest.find('=');
    if (word == "subsection") {
      if (!opened.empty())
        fail("no subsection within another one",
             "'end' before this line; the open one, '" + heading + "', began at " + opened);
      if (rest.empty())
        fail("subsection <kind> <name>", "a heading such as 'subsection Pipe main'");
      if (!own.insert(rest).second)
        fail("every heading once", "another name for one of the two parts; the first '" + rest +
                                       "' is at " + section(rest, origin).origin);
      heading = rest;
      opened = origin;
      section(heading, origin);
    } else if (word == "end" && rest.empty()) {
      if (opened.empty())
        fail("'end' once for each subsection", "this line removed");
      heading = opened = "";
    } else if (word == "set" && equal != std::string::npos && equal > 0)
      set(section(heading, origin),
          {tidy(rest.substr(0, equal)), tidy(rest.substr(equal + 1)), origin});
    else if (word == "include" && opened.empty()) {
      const auto included = std::filesystem::path(file).parent_path() / rest;
      if (!std::filesystem::exists(included) || depth == 20)
        fail("a file that exists, from this file's folder, and does not include this one again",
             "the path from " + std::filesystem::absolute(file).parent_path().string());
      read(included.string(), depth + 1);
    } else
      fail("subsection <heading>, end, set <entry> = <value>, include <file>, # comment",
           equal != std::string::npos || statement.find('=') != std::string::npos
               ? "set " + statement
               : "a '#' in front if it is a comment");
  }
  if (!opened.empty())
    throw UserError(opened + ": section '" + heading +
                    "'\n  read:    the end of the file\n  allowed: an 'end' for each subsection\n"
                    "  try:     a line 'end' after its last entry");
}

void ParameterFile::apply(const std::string &option) {
  const auto equal = option.find('=');
  const auto slash = option.substr(0, equal).find('/');
  const std::string left = option.substr(0, equal);
  const std::string heading = slash == std::string::npos ? "" : tidy(left.substr(0, slash));
  const std::string name = tidy(slash == std::string::npos ? left : left.substr(slash + 1));
  if (equal == std::string::npos || name.empty())
    throw UserError("--set \"" + option +
                    "\":\n  read:    no entry and value\n  allowed: --set \"Section/Entry = "
                    "value\" or --set \"Entry = value\"\n"
                    "  try:     --set \"Time/Step = 0.01\"");
  const std::string origin = "--set \"" + option + "\"";
  Entry entry{name, tidy(option.substr(equal + 1)), origin, true, false, ""};
  set(section(heading, origin), entry);
}

} // namespace frictionbeam
