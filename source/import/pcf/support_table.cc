// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/pcf/support_table.h"

#include "base/user_error.h"
#include "import/pcf/pcf_file.h"
#include "scene/file/parameter_file.h"
#include "scene/file/table_rows.h"

#include <algorithm>
#include <fstream>

namespace frictionbeam::import {

namespace {

/// Behind the user's rows. SKEYs of programs' manuals (ANCH: CAEPIPE), and plain words.
const char *const own_rows[] = {"ANCH : anchor", "ANCHOR : anchor", "GUIDE : guide", "REST : rest",
                                "END-CONNECTION-EQUIPMENT : anchor"};

const std::vector<std::string> kinds_of_table = {"anchor",  "restraint", "guide", "line stop",
                                                 "stop",    "rest",      "rod",   "friction",
                                                 "snubber", "hanger",    "none"};

/// Whether @p text is @p pattern, in which * stands for any characters.
bool fits(const std::string &pattern, const std::string &text) {
  std::size_t p = 0, t = 0, star = std::string::npos, behind = 0;
  while (t < text.size())
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      behind = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string::npos) {
      p = star + 1;
      t = ++behind;
    } else
      return false;
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

} // namespace

SupportTable::SupportTable(const std::string &path) {
  if (!path.empty()) {
    if (!std::ifstream(path))
      throw UserError("--support-map: the file '" + path +
                      "' cannot be read.\n  try:     the path of a text file with rows 'WORD : "
                      "kind, Entry = value'");
    for (const TableRow &row : read_table_rows(path))
      add(row.text, path + ":" + std::to_string(row.line));
  }
  for (const char *const row : own_rows)
    add(row, "");
}

void SupportTable::add(const std::string &line, const std::string &place) {
  const std::vector<std::string> fields = split(line, ':');
  const auto refuse = [&](const std::string &read, const std::string &allowed) {
    throw UserError(place + "\n  read:    " + read + "\n  allowed: " + allowed +
                    "\n  try:     GS* : rest, Pad = steel : guide, Gap = 0.003");
  };
  if (fields.size() < 2 || fields[0].empty())
    refuse(tidy(line), "rows 'WORD : kind, Entry = value, ...'");
  Row row{capitals(fields[0]), {}};
  for (auto field = fields.begin() + 1; field != fields.end(); ++field) {
    const std::vector<std::string> words = split(*field, ',');
    MappedSupport support;
    support.kind = words.empty() ? "" : words[0];
    if (std::count(kinds_of_table.begin(), kinds_of_table.end(), support.kind) == 0)
      refuse("kind '" + support.kind + "'", join(kinds_of_table));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t equal = words[i].find('=');
      if (equal == std::string::npos && !support.entries.empty()) { // of a list of values
        support.entries.back().second += ", " + words[i];
        continue;
      }
      if (equal == std::string::npos || equal == 0)
        refuse(words[i], "entries 'Entry = value' behind the kind, between commas");
      support.entries.emplace_back(tidy(words[i].substr(0, equal)),
                                   tidy(words[i].substr(equal + 1)));
    }
    row.supports.push_back(support);
  }
  rows.push_back(row);
}

const std::vector<MappedSupport> *SupportTable::find(const std::vector<std::string> &words) const {
  for (const Row &row : rows)
    for (const std::string &word : words)
      if (!word.empty() && fits(row.pattern, capitals(word)))
        return &row.supports;
  return nullptr;
}

} // namespace frictionbeam::import
