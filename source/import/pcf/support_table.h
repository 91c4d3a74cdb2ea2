// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace frictionbeam::import {

/// One support that a word stands for.
struct MappedSupport {
  std::string kind; ///< as of Support/Kind; "hanger", "none" beside
  std::vector<std::pair<std::string, std::string>> entries; ///< of the section
};

/**
 * Which words of a piping component file stand for which kinds of support: rows
 * `WORD : kind, Entry = value, ... : kind ...`, the first that fits; # begins a comment. A word is
 * compared with SKEY, name, ITEM-CODE, its description, SUPPORT-... attributes and the component's
 * own word, whatever the case; * stands for any characters. A shoe that is guided is both:
 * `GS* : rest, Pad = steel : guide`.
 */
class SupportTable {
public:
  /// @param path of the user's table; empty: only the rows that hold where no table says other
  /// @throws UserError for a file that cannot be read or a row that is not understood
  explicit SupportTable(const std::string &path);

  /// What the first row says that fits one of @p words; null if none does.
  const std::vector<MappedSupport> *find(const std::vector<std::string> &words) const;

private:
  struct Row {
    std::string pattern;
    std::vector<MappedSupport> supports;
  };
  void add(const std::string &line, const std::string &place);

  std::vector<Row> rows;
};

} // namespace frictionbeam::import
