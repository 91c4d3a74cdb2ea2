// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameter_text.h"

#include "../text_pieces.h"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fuzz {

namespace {

std::string kind_of(const std::string &heading) { return heading.substr(0, heading.find(' ')); }

std::vector<std::string> words_of(const std::string &text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;)
    words.push_back(word);
  return words;
}

template <typename Item>
const Item &any(const std::vector<Item> &items, Random &random) {
  return items[below(random, items.size())];
}

bool is_number(const std::string &word) {
  char *end = nullptr;
  std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0';
}

} // namespace

std::string read_file(const std::string &path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

ParameterText::ParameterText(const std::string &text) : sections(1) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::string statement = trimmed(line.substr(0, line.find('#')));
    while (!statement.empty() && statement.back() == '\\' && std::getline(in, line))
      statement =
          statement.substr(0, statement.size() - 1) + " " + trimmed(line.substr(0, line.find('#')));
    const auto equal = statement.find('=');
    if (statement.empty())
      continue;
    if (statement.rfind("subsection ", 0) == 0)
      sections.push_back({trimmed(statement.substr(11)), {}});
    else if (statement == "end")
      sections.push_back({"", {}});
    else if (statement.rfind("set ", 0) == 0 && equal != std::string::npos)
      sections.back().lines.push_back(
          {trimmed(statement.substr(4, equal - 4)), trimmed(statement.substr(equal + 1)), ""});
    else
      sections.back().lines.push_back({"", "", statement});
  }
}

std::string ParameterText::text() const {
  std::string result;
  for (const Section &section : sections) {
    if (!section.heading.empty())
      result += "subsection " + section.heading + '\n';
    for (const Line &line : section.lines)
      result += line.text() + '\n';
    if (!section.heading.empty())
      result += "end\n";
  }
  return result;
}

std::string hard_number(Random &random) {
  static const std::vector<std::string> numbers = {
      "0",      "-0",     "1",     "-1",    "0.5",    "2",         "3",     "1e-300", "1e300",
      "-1e300", "1e-12",  "1e12",  "1e7",   "1e-7",   "-1e-3",     "1e3",   "1e20",   "1e-20",
      "nan",    "inf",    "-inf",  "1e400", "1e-400", "4e-320",    "1e16",  "0.1",    "-0.5",
      "1e5",    "2e9",    "3e9",   "-2e9",  "0x10",   "1,5",       "1e",    "--1",    "1e-9",
      "1e9",    "90",     "180",   "360",   "0.3",    "0.9999999", "1e-15", "1e15",   "7850",
      "1e18",   "9.99e6", "1e-10", "1e6",   "1e4",    "10",        "100",   "1e2"};
  return any(numbers, random);
}

std::string changed_text(const std::string &text, Random &random) {
  std::string result = text;
  const std::size_t n = 1 + below(random, 3);
  for (std::size_t i = 0; i < n && !result.empty(); ++i) {
    const std::size_t at = below(random, result.size());
    switch (below(random, 7)) {
    case 0:
      result[at] = static_cast<char>(random());
      break;
    case 1:
      result.erase(at, 1 + below(random, 20));
      break;
    case 2:
      result.insert(at, result.substr(below(random, result.size()), below(random, 40)));
      break;
    case 3:
      result.resize(at);
      break;
    default: { // a number
      auto begin = result.find_first_of("0123456789", at);
      if (begin == std::string::npos)
        break;
      while (begin > 0 && (std::isdigit(static_cast<unsigned char>(result[begin - 1])) != 0 ||
                           result[begin - 1] == '.'))
        --begin;
      const auto end = result.find_first_not_of("0123456789.eE+-", begin);
      result.replace(begin, end == std::string::npos ? end : end - begin, hard_number(random));
    }
    }
  }
  return result;
}

void Dictionary::add(const ParameterText &file) {
  for (const Section &section : file.sections) {
    if (!section.lines.empty())
      sections.push_back(section);
    for (const Line &line : section.lines) {
      if (line.name.empty())
        continue;
      by_kind[kind_of(section.heading)].push_back(line);
      by_name[line.name].push_back(line.value);
      for (const std::string &word : words_of(line.value))
        words.push_back(word);
    }
  }
}

std::string Dictionary::changed_value(const std::string &value, Random &random) const {
  std::vector<std::string> pieces = words_of(value);
  if (pieces.empty())
    return hard_number(random);
  std::string &piece = pieces[below(random, pieces.size())];
  const bool number = is_number(piece);
  switch (below(random, number ? 8 : 6)) {
  case 0:
    piece = any(words, random);
    break;
  case 1:
    piece = "";
    break;
  case 2:
    piece += " " + any(words, random);
    break;
  case 3:
    return changed_text(value, random);
  case 4:
    if (number) {
      std::ostringstream text;
      text << std::strtod(piece.c_str(), nullptr) *
                  std::vector<double>{
                      -1., 0.1, 10., 1e-3, 1e3, 0.999999999, 1e-6, 1e6}[below(random, 8)];
      piece = text.str();
      break;
    }
    [[fallthrough]];
  default:
    piece = hard_number(random);
  }
  std::string result;
  for (const std::string &word : pieces)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

void Dictionary::change_once(ParameterText &file, Random &random) const {
  Section &section = file.sections[below(random, file.sections.size())];
  const std::size_t at = below(random, section.lines.size());
  const std::size_t what = below(random, 20);
  if (what == 0 && file.sections.size() > 1)
    file.sections.erase(file.sections.begin() + below(random, file.sections.size()));
  else if (what == 1) {
    file.sections.push_back(any(sections, random));
    if (below(random, 2) == 0)
      file.sections.back().heading += "_more";
  } else if (what == 2)
    std::swap(section, file.sections[below(random, file.sections.size())]);
  else if (what <= 6) { // an entry that such sections have elsewhere
    const auto known = by_kind.find(kind_of(section.heading));
    if (known == by_kind.end())
      return;
    const Line line = any(known->second, random);
    for (Line &present : section.lines)
      if (present.name == line.name) {
        present = line;
        return;
      }
    section.lines.push_back(line);
  } else if (section.lines.empty())
    return;
  else if (what == 7)
    section.lines.erase(section.lines.begin() + at);
  else if (what == 8)
    section.lines.push_back(section.lines[at]);
  else if (what <= 11 && by_name.count(section.lines[at].name) > 0)
    section.lines[at].value = any(by_name.at(section.lines[at].name), random);
  else
    section.lines[at].value = changed_value(section.lines[at].value, random);
}

void Dictionary::change(ParameterText &file, Random &random) const {
  const std::size_t n = 1 + below(random, 3) * below(random, 2);
  for (std::size_t i = 0; i < n; ++i)
    change_once(file, random);
}

} // namespace fuzz
