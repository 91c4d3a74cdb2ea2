// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace frictionbeam {

/**
 * @file
 * The words of an entry with a choice: one table, a row for each word with what it stands for and
 * what it means, by which the entry is declared, documented and read, and a value is written. A
 * table is an array of Word, or of any rows that have these three members and more of their own.
 */

/// A row of such a table.
template <typename Value>
struct Word {
  const char *word;
  Value value;
  const char *meaning = ""; ///< in a few words, without a full stop; empty: the entry's text has it
};

/// The words of a table, in its order.
template <typename Table>
std::vector<std::string> words_of(const Table &table) {
  std::vector<std::string> words;
  for (const auto &row : table)
    words.emplace_back(row.word);
  return words;
}

/// The row of a word, or the end of the table.
template <typename Table>
auto find_word(const Table &table, const std::string &word) {
  return std::find_if(std::begin(table), std::end(table),
                      [&](const auto &row) { return word == row.word; });
}

/// The first row of a value, which has one.
template <typename Table, typename Value>
const auto &row_of(const Table &table, const Value &value) {
  const auto row = std::find_if(std::begin(table), std::end(table),
                                [&](const auto &one) { return one.value == value; });
  Assert(row != std::end(table), dealii::ExcInternalError());
  return *row;
}

/// "word: meaning; other word: meaning", of the rows that say one.
template <typename Table>
std::string meanings_of(const Table &table) {
  std::string text;
  for (const auto &row : table)
    if (const std::string meaning = row.meaning; !meaning.empty())
      text += (text.empty() ? "" : "; ") + std::string(row.word) + ": " + meaning;
  return text;
}

} // namespace frictionbeam
