// SPDX-License-Identifier: LGPL-2.1-or-later
#include "documented_entries.h"

#include "../text_pieces.h"
#include "scene/file/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace entries {

using frictionbeam::to_number;
using frictionbeam::to_text;

namespace {

/// What stands between two marks, from the end of the last @p before on; empty if they are not
/// there.
std::string between(const std::string &text, const std::string &before, const std::string &after) {
  const auto begin = text.rfind(before);
  const auto end = begin == std::string::npos ? begin : text.find(after, begin + before.size());
  return end == std::string::npos
             ? ""
             : trimmed(text.substr(begin + before.size(), end - begin - before.size()));
}

/// Something that is neither nothing nor much, of a number that is 0.
double usual_size(const std::string &unit) {
  static const std::map<std::string, double> sizes = {
      {"m", 0.01},  {"N", 100.},    {"Pa", 1e6},   {"s", 1e-3},  {"kg", 10.},  {"kg/m", 10.},
      {"K", 20.},   {"kg/m3", 100}, {"-", 0.5},    {"m2", 1e-3}, {"m4", 1e-5}, {"N/m", 1e4},
      {"degC", 50}, {"N m2", 1e5},  {"Pa/m", 1e9}, {"1/s", 1.}};
  const auto found = sizes.find(unit);
  return found == sizes.end() ? 1. : found->second;
}

std::vector<std::string> other_numbers(const Entry &entry, const double value) {
  const bool is_whole = entry.allowed.rfind("a whole number", 0) == 0;
  double least = 0., most = 0.;
  const bool has_least = to_number(between(entry.allowed + " ", ">= ", " "), least) ||
                         to_number(between(entry.allowed + " ", "> ", " "), least);
  const bool has_most = to_number(between(entry.allowed + " ", "<= ", " "), most);
  const double size = usual_size(entry.unit);
  std::vector<double> numbers;
  if (is_whole)
    numbers = {value + 1., value - 1., value + 2.};
  else if (value == 0. || value == -1.)
    numbers = {size};
  else
    numbers = {1.1 * value, 0.9 * value};
  std::vector<std::string> result;
  for (const double number : numbers)
    if ((!has_least || number >= least) && (!has_most || number <= most))
      result.push_back(to_text(number));
  return result;
}

} // namespace

std::vector<Entry> documented_entries(const std::string &frictionbeam) {
  std::vector<Entry> entries;
  Entry section; // what the entries of a section have in common
  std::string comment;
  std::istringstream in(output_of(frictionbeam + " --print-parameters"));
  for (std::string line; std::getline(in, line);) {
    const std::string text = trimmed(line);
    const auto equals = text.find('=');
    if (text.rfind("subsection ", 0) == 0) {
      section.kind = text.substr(11);
      const auto blank = section.kind.find(" name");
      section.is_of_part = blank != std::string::npos;
      section.kind = section.kind.substr(0, blank);
    } else if (text == "end")
      section = Entry();
    else if (text.rfind("# Entries of a ", 0) == 0 && text.find(" with Law = ") != text.npos) {
      section.kind = between(text, "# Entries of a ", " with");
      section.law = between(text, "Law = ", " (");
      section.is_of_part = true;
    } else if (!section.law.empty() && text.rfind("#   ", 0) == 0) {
      Entry entry = section;
      entry.word = trimmed(text.substr(1, equals - 1));
      entry.unit = between(text, "[", "]");
      entry.default_value = between(text, "= ", " [");
      if (section.law != "coulomb") // whose entries stand in the section Support
        entries.push_back(entry);
    } else if (!text.empty() && text[0] == '#')
      comment += " " + trimmed(text.substr(1));
    else if (text.rfind("set ", 0) == 0) {
      Entry entry = section;
      entry.word = trimmed(text.substr(4, equals - 4));
      entry.default_value = trimmed(text.substr(equals + 1));
      if (comment.rfind(" [", 0) == 0)
        entry.unit = comment.substr(2, comment.find(']') - 2);
      if (const auto allowed = comment.rfind("Allowed: "); allowed != std::string::npos)
        entry.allowed = comment.substr(allowed + 9, comment.rfind('.') - allowed - 9);
      entries.push_back(entry);
    }
    if (text.empty() || text[0] != '#')
      comment.clear();
  }
  return entries;
}

std::vector<std::string> other_values(const Entry &entry, const std::string &value) {
  const std::string now = value.empty() ? entry.default_value : value;
  if (entry.allowed == "true or false")
    return {now == "true" ? "false" : "true"};
  double number = 0.;
  if (to_number(now, number) && entry.allowed.find(',') == std::string::npos)
    return other_numbers(entry, number);
  std::vector<std::string> words = split(entry.allowed, ',');
  if (std::count(words.begin(), words.end(), entry.default_value) == 0)
    return {};
  const auto is_no_word = [&](const std::string &word) {
    return word == now || word.rfind("or ", 0) == 0 || word.find("a number") != std::string::npos;
  };
  words.erase(std::remove_if(words.begin(), words.end(), is_no_word), words.end());
  return words;
}

std::map<std::string, std::vector<std::string>> read_values(const std::string &file) {
  std::map<std::string, std::vector<std::string>> values;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (const auto equals = line.find(" = "); equals != std::string::npos && line[0] != '#')
      values[trimmed(line.substr(0, equals))] = split(line.substr(equals + 3), '|');
  return values;
}

} // namespace entries
