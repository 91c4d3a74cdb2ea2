// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace frictionbeam {

/**
 * The text of a parameter file, taken apart but not yet understood: the first of the two passes. It
 * finds which parts a file has, in their order, and remembers where each entry stands, so that the
 * second pass can declare what is allowed and say where something is wrong.
 *
 * The format is deal.II's (`subsection`, `end`, `set a = b`, `include file`, `#` comments, lines
 * continued with a backslash), with one level of subsections. Setting an entry twice is an error,
 * except that a file may set again what a file that it includes has set.
 */
class ParameterFile {
public:
  struct Entry {
    std::string name, value;
    std::string origin;       ///< "case.prm:12" or the --set option
    bool is_override = false; ///< by --set
    bool in_file = true;      ///< false: by --set alone
    std::string file_value{}; ///< before --set
  };

  /// Entries under one heading; the first section has none and holds the entries outside of any.
  struct Section {
    std::string heading, origin;
    std::vector<Entry> entries;

    const Entry *find(const std::string &name) const; ///< null if it is not set
  };

  /// A file without any entry.
  ParameterFile();

  /// @throws UserError if the file cannot be read or a line makes no sense.
  explicit ParameterFile(const std::string &file);

  /// Apply one `--set` option, "Section/Entry = value" or "Entry = value".
  /// @throws UserError if it has another form.
  void apply(const std::string &option);

  const std::vector<Section> &sections() const { return parts; }
  const Section *find(const std::string &heading) const; ///< null if there is none

  const std::string &name() const { return file_name; } ///< as given
  const std::string &text() const { return content; }

private:
  void read(const std::string &file, const unsigned int depth);
  void set(Section &section, Entry entry);
  Section &section(const std::string &heading, const std::string &origin);

  std::string file_name, content;
  std::vector<Section> parts;
  std::unordered_map<std::string, std::size_t> places{{"", 0}}; ///< of the parts, by heading
};

/// Without white space at either end, and with single blanks within.
std::string tidy(const std::string &text);

/// Pieces of a text between separators, tidied; none if the text is blank.
std::vector<std::string> split(const std::string &text, const char separator);

/// Words of a text, of which a number in brackets is the end of a name: `cool (2)`, a later cycle.
std::vector<std::string> split_names(const std::string &text);

/// The whole of @p text as a finite number. @return whether it is one.
bool to_number(const std::string &text, double &value);

/// The candidate that is most like @p name, or an empty text if none is alike.
std::string nearest(const std::string &name, const std::vector<std::string> &candidates);

/// "a, b, c"
std::string join(const std::vector<std::string> &names);

} // namespace frictionbeam
