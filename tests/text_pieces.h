// SPDX-License-Identifier: LGPL-2.1-or-later
/// @file Pieces of text, and what a command prints.
#pragma once

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Without blanks at its ends.
inline std::string trimmed(const std::string &text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos
             ? ""
             : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// What stands between separators, trimmed.
inline std::vector<std::string> split(const std::string &text, const char separator) {
  std::vector<std::string> pieces;
  std::istringstream in(text);
  for (std::string piece; std::getline(in, piece, separator);)
    pieces.push_back(trimmed(piece));
  return pieces;
}

/// What a command prints. @throws std::runtime_error if it fails
inline std::string output_of(const std::string &command) {
  std::string text;
  FILE *const pipe = popen(command.c_str(), "r");
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof(buffer), pipe))
    text.append(buffer, n);
  if (pclose(pipe) != 0)
    throw std::runtime_error(command + " fails");
  return text;
}
