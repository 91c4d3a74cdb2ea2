// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

/// Parameter files taken apart, changed by what others have in their places, and put together.
namespace fuzz {

using Random = std::mt19937_64;

inline std::size_t below(Random &random, const std::size_t n) { return n == 0 ? 0 : random() % n; }

std::string read_file(const std::string &path);

/// A line `set name = value`, or any other one.
struct Line {
  std::string name, value, other; ///< other: the text of one that sets nothing
  std::string text() const { return name.empty() ? other : "  set " + name + " = " + value; }
};

struct Section {
  std::string heading; ///< empty: outside of any
  std::vector<Line> lines;
};

struct ParameterText {
  std::vector<Section> sections;
  explicit ParameterText(const std::string &text);
  std::string text() const;
};

/// What all files together say may stand where.
class Dictionary {
public:
  void add(const ParameterText &file);
  /// One to three random changes.
  void change(ParameterText &file, Random &random) const;

private:
  void change_once(ParameterText &file, Random &random) const;
  std::string changed_value(const std::string &value, Random &random) const;

  std::map<std::string, std::vector<Line>> by_kind;        ///< of sections
  std::map<std::string, std::vector<std::string>> by_name; ///< values of entries
  std::vector<Section> sections;
  std::vector<std::string> words; ///< of all values
};

/// A number that is hard for programs.
std::string hard_number(Random &random);
/// Any text with a few bytes changed, cut or doubled; numbers in it may become hard ones.
std::string changed_text(const std::string &text, Random &random);

} // namespace fuzz
