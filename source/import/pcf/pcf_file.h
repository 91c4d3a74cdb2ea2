// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam::import {

/// A line of a block: a word and what follows it.
struct PcfEntry {
  std::string key;  ///< in capitals, with - for _ and without angle brackets
  std::string text; ///< blanks in a row are one
  unsigned int line = 0;
};

/// A word at the beginning of a line and the indented lines below it.
struct PcfBlock {
  std::string keyword, text; ///< as of PcfEntry
  unsigned int line = 0;
  std::vector<PcfEntry> entries;
  bool in_materials = false; ///< below MATERIALS

  /// The first entry of that key; null if there is none.
  const PcfEntry *find(const std::string &key) const;
};

/**
 * A piping component file as text: blocks of lines, not yet understood. (The form is that of the
 * "Piping Component File" of ISOGEN, which plant design programs write.)
 *
 * Line ends of DOS and of old Macs are taken as such. A block begins at a word without indentation,
 * but for words that are known as entries (END-POINT, SKEY, ITEM-CODE before MATERIALS, ...), which
 * some programs do not indent; component words that stand alone begin one with indentation, too. A
 * word that is not known and has no points is an entry of the block before.
 */
class PcfFile {
public:
  /// @param encoding "utf-8" or "latin-1"
  /// @throws UserError for a file that cannot be read, NUL bytes, bytes that are no UTF-8
  PcfFile(const std::string &path, const std::string &encoding);

  const std::vector<PcfBlock> &blocks() const { return all; }
  const std::string &name() const { return path; }
  /// Whether @p block is the last one, after which a file that was cut off ends.
  bool is_last(const PcfBlock &block) const { return &block == &all.back(); }

  /// @throws UserError "FILE:LINE", what was read, what is allowed and what to try
  [[noreturn]] void fail(const unsigned int line, const std::string &read,
                         const std::string &allowed, const std::string &hint) const;

private:
  void add_line(const std::string &raw, const unsigned int number);
  void join_loose_words();

  std::string path;
  std::vector<PcfBlock> all;
  bool in_materials = false;
};

/// @p text in capitals.
std::string capitals(std::string text);

} // namespace frictionbeam::import
