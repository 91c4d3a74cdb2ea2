// SPDX-License-Identifier: LGPL-2.1-or-later
// Every example of doc/quantities.md is asked of the file that stands above it and answered, and
// every quantity that there is has an example.
//   quantity_page PROGRAM ROOT
#include "../check.h"
#include "run_program.h"

#include <algorithm>
#include <set>

namespace {

/// The examples of one block.
struct Block {
  std::string file;
  std::vector<std::string> names, entries; ///< entries: NAME = TEXT
};

std::string trimmed(const std::string &text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first);
}

std::vector<Block> blocks_of(const std::string &page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    const std::string text = trimmed(line);
    if (text.rfind("```", 0) == 0)
      inside = !inside;
    else if (inside && text.rfind("file ", 0) == 0)
      blocks.push_back({text.substr(5), {}, {}});
    else if (inside && text.rfind("set ", 0) == 0) {
      CHECK(!blocks.empty());
      blocks.back().entries.push_back(text.substr(4));
      blocks.back().names.push_back(text.substr(4, text.find(" = ") - 4));
    }
  }
  return blocks;
}

/// Words of an example without signs around them.
std::set<std::string> words_of(const std::string &entry) {
  std::string text = entry;
  std::replace_if(
      text.begin(), text.end(), [](const char c) { return c == '|' || c == ',' || c == ';'; }, ' ');
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;)
    words.insert(word);
  return words;
}

/// The words that a message offers in place of one that there is not.
std::vector<std::string> known_words(const std::string &program, const std::string &file,
                                     const std::string &wrong) {
  const std::string output =
      program::run(program, file, {"--set", "Quantities/w = " + wrong}).output;
  const std::string begin = "the name of a quantity: ";
  const auto at = output.find(begin);
  CHECK(at != std::string::npos);
  std::string list = output.substr(at + begin.size());
  list = list.substr(0, list.find('\n'));
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream stream(list);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  CHECK(words.size() > 3);
  return words;
}

} // namespace

int main(int, char **argv) {
  const std::string program = argv[1], root = argv[2];
  const std::vector<Block> blocks = blocks_of(program::text_of(root + "/doc/quantities.md"));
  CHECK(blocks.size() >= 7);
  std::set<std::string> shown;
  for (const Block &block : blocks) {
    std::vector<std::string> options = {"--quiet"};
    for (const std::string &entry : block.entries) {
      options.insert(options.end(), {"--set", "Quantities/" + entry});
      const auto words = words_of(entry);
      shown.insert(words.begin(), words.end());
    }
    const program::Run run = program::run(program, root + "/" + block.file, options);
    if (run.exit_status != 0)
      std::cout << block.file << ": " << run.output << '\n';
    CHECK(run.exit_status == 0);
    for (const std::string &name : block.names)
      CHECK(std::isfinite(run.quantity(name).value)); // throws if it was not reached
  }
  const std::string line = root + "/" + blocks.front().file;
  for (const char *const wrong : {"nothing at P", "time_of nothing at P"})
    for (const std::string &word : known_words(program, line, wrong)) {
      if (shown.count(word) == 0)
        std::cout << "doc/quantities.md has no example of " << word << '\n';
      CHECK(shown.count(word) == 1);
    }
  return check::report();
}
