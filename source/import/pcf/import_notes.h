// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace frictionbeam::import {

/// What the user should know of a file that was taken over. Nothing of it is dropped in silence.
struct Notes {
  struct Note {
    unsigned int line; ///< of the file; 0: of no line
    std::string text;
  };
  std::vector<Note> not_understood; ///< what has no place in the model, or not yet
  std::vector<Note> assumed;        ///< what the file does not say, and what was taken instead
  std::vector<Note> moved;          ///< ends and supports that were moved onto the line

  struct Count {
    unsigned int first_line = 0, n = 0;
  };
  /// Words of the file that say nothing of the line's mechanics, as welds and drawing numbers.
  std::map<std::string, Count> without_effect;

  void count_without_effect(const std::string &word, const unsigned int line) {
    Count &count = without_effect[word];
    if (count.n++ == 0)
      count.first_line = line;
  }
};

} // namespace frictionbeam::import
