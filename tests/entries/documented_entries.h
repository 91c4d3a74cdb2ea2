// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

/// What `--print-parameters` says of the entries of a parameter file.
namespace entries {

struct Entry {
  std::string kind; ///< of its section; empty: outside of any
  std::string word, default_value;
  std::string unit;        ///< "-" for none; empty where the entry has several
  std::string allowed;     ///< what is said of that
  std::string law;         ///< of whose parts it is; empty: of all
  bool is_of_part = false; ///< sections of its kind have names

  std::string name() const { return kind.empty() ? word : kind + "/" + word; }
};

/// Of the program @p frictionbeam, in their order.
std::vector<Entry> documented_entries(const std::string &frictionbeam);

/// Values other than @p value, or than the default if that is empty: the other words of a choice,
/// the other flag, a number somewhat larger or smaller. None where any text is allowed.
std::vector<std::string> other_values(const Entry &entry, const std::string &value);

/// Lines `Section/Entry = value | value ...`; `#` begins a comment.
std::map<std::string, std::vector<std::string>> read_values(const std::string &file);

} // namespace entries
