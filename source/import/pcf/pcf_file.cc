// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/pcf/pcf_file.h"

#include "base/user_error.h"
#include "import/pcf/component_kinds.h"
#include "scene/file/parameter_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace frictionbeam::import {

namespace {

/// Of a file of text; a line's length and a file's that no plant design program writes.
constexpr std::size_t longest_line = 10000, largest_file = 200000000;

/// Keys that are entries wherever they stand, each with the form that is used here.
const std::pair<const char *, const char *> entry_words[] = {
    {"END-POINT", "END-POINT"},
    {"ENDPOINT", "END-POINT"},
    {"CENTRE-POINT", "CENTRE-POINT"},
    {"CENTER-POINT", "CENTRE-POINT"},
    {"BRANCH1-POINT", "BRANCH1-POINT"},
    {"BRANCH2-POINT", "BRANCH2-POINT"},
    {"BRANCH-POINT", "BRANCH1-POINT"},
    {"CO-ORDS", "CO-ORDS"},
    {"SKEY", "SKEY"},
    {"WEIGHT", "WEIGHT"},
    {"ANGLE", "ANGLE"},
    {"BEND-RADIUS", "BEND-RADIUS"},
    {"NAME", "NAME"},
    {"DESCRIPTION", "DESCRIPTION"},
    {"MATERIAL", "MATERIAL"},
    {"FABRICATION-ITEM", "FABRICATION-ITEM"},
    {"ERECTION-ITEM", "ERECTION-ITEM"},
    {"OFFSHORE-ITEM", "OFFSHORE-ITEM"},
    {"PIPING-SPEC", "PIPING-SPEC"},
    {"PIPELINE-TEMP", "PIPELINE-TEMP"},
    {"CONNECTION-REFERENCE", "CONNECTION-REFERENCE"},
    {"ITEM-DESCRIPTION", "ITEM-DESCRIPTION"}};

/// The form of @p key that is used here; empty if it may begin a block.
std::string entry_word(const std::string &key) {
  for (const auto &[word, form] : entry_words)
    if (key == word)
      return form;
  for (const char *const prefix : {"COMPONENT-ATTRIBUTE", "ITEM-ATTRIBUTE", "ATTRIBUTE"})
    if (key.rfind(prefix, 0) == 0)
      return key;
  return "";
}

/// How many bytes the character at @p at of UTF-8 has; 0 if it is none.
std::size_t bytes_of_character(const std::string &text, const std::size_t at) {
  const unsigned char first = text[at];
  const std::size_t n = first < 0x80                     ? 1
                        : first >= 0xc2 && first <= 0xdf ? 2
                        : first >= 0xe0 && first <= 0xef ? 3
                        : first >= 0xf0 && first <= 0xf4 ? 4
                                                         : 0;
  if (n == 0 || at + n > text.size())
    return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80)
      return 0;
  return n;
}

bool is_component(const std::string &word) { return find_component_kind(word) != nullptr; }

std::string from_latin_1(const std::string &text) {
  std::string result;
  for (const char byte : text) {
    const unsigned char c = byte;
    if (c < 0x80)
      result += byte;
    else {
      result += static_cast<char>(0xc0 | (c >> 6));
      result += static_cast<char>(0x80 | (c & 0x3f));
    }
  }
  return result;
}

std::string bytes_of(const std::string &path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (in)
    bytes << in.rdbuf();
  if (!in || in.bad())
    throw UserError("The file '" + path +
                    "' cannot be read.\n  try:     the path of a piping component file (.pcf)");
  return bytes.str();
}

} // namespace

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return std::toupper(c); });
  return text;
}

const PcfEntry *PcfBlock::find(const std::string &key) const {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const PcfEntry &one) { return one.key == key; });
  return entry == entries.end() ? nullptr : &*entry;
}

void PcfFile::fail(const unsigned int line, const std::string &read, const std::string &allowed,
                   const std::string &hint) const {
  throw UserError(path + (line > 0 ? ":" + std::to_string(line) : "") + "\n  read:    " + read +
                  "\n  allowed: " + allowed + "\n  try:     " + hint);
}

PcfFile::PcfFile(const std::string &path, const std::string &encoding) : path(path) {
  std::string bytes = bytes_of(path);
  if (bytes.size() > largest_file)
    fail(0, std::to_string(bytes.size()) + " bytes", "at most 200 million", "a file for each line");
  if (bytes.rfind("\xff\xfe", 0) == 0 || bytes.rfind("\xfe\xff", 0) == 0)
    fail(1, "a file in UTF-16", "text in UTF-8, or in Latin-1 with --encoding latin-1",
         "iconv -f utf-16 -t utf-8");
  if (bytes.rfind("\xef\xbb\xbf", 0) == 0)
    bytes.erase(0, 3);
  const bool latin = encoding == "latin-1";
  unsigned int number = 1;
  std::string line;
  for (std::size_t i = 0; i < bytes.size();) {
    const char c = bytes[i];
    if (c == '\0')
      fail(number, "a NUL byte", "text without NUL bytes",
           "the file as its program wrote it: this one is no text, or was damaged");
    if (c == '\n' || c == '\r') {
      add_line(line, number++);
      line.clear();
      i += c == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n' ? 2 : 1;
      continue;
    }
    const std::size_t n = latin ? 1 : bytes_of_character(bytes, i);
    if (n == 0)
      fail(number,
           "byte " + std::to_string(static_cast<unsigned int>(static_cast<unsigned char>(c))) +
               " after '" + line + "', which is no UTF-8",
           "text in UTF-8, or in Latin-1 (Windows) with --encoding latin-1",
           "--encoding latin-1, or iconv -f latin1 -t utf-8");
    line += latin ? from_latin_1(std::string(1, c)) : bytes.substr(i, n);
    i += n;
    if (line.size() > longest_line)
      fail(number, "a line of more than " + std::to_string(longest_line) + " bytes",
           "lines of a piping component file, one word with its values each",
           "the file as its program wrote it");
  }
  add_line(line, number);
  join_loose_words();
  if (all.empty())
    fail(0, "an empty file", "a piping component file", "the file as its program wrote it");
}

void PcfFile::add_line(const std::string &raw, const unsigned int number) {
  const std::string line = tidy(raw);
  if (line.empty())
    return;
  const std::size_t blank = line.find(' ');
  std::string key = capitals(line.substr(0, blank));
  if (key.size() > 2 && key.front() == '<' && key.back() == '>')
    key = key.substr(1, key.size() - 2);
  std::replace(key.begin(), key.end(), '_', '-');
  const std::string text = blank == std::string::npos ? "" : line.substr(blank + 1);
  const bool indented = raw[0] == ' ' || raw[0] == '\t';
  const std::string entry = entry_word(key);
  const bool begins = key == "ITEM-CODE" ? in_materials && !indented
                      : !entry.empty()   ? false
                      : indented         ? text.empty() && find_component_kind(key) != nullptr
                                         : true;
  if (begins || all.empty()) {
    if (is_component(key) || key == "PIPELINE-REFERENCE" || key == "ISOGEN-FILES")
      in_materials = false; // of another pipeline
    all.push_back({key, text, number, {}, in_materials});
    in_materials = in_materials || key == "MATERIALS";
  } else
    all.back().entries.push_back({entry.empty() ? key : entry, text, number});
}

void PcfFile::join_loose_words() {
  std::vector<PcfBlock> joined;
  for (PcfBlock &block : all) {
    const bool known = is_component(block.keyword) || block.keyword.rfind("UNITS-", 0) == 0 ||
                       block.keyword == "ISOGEN-FILES" || block.keyword == "PIPELINE-REFERENCE" ||
                       block.keyword == "MATERIALS" || block.keyword == "ITEM-CODE";
    if (joined.empty() || known || block.find("END-POINT") != nullptr ||
        block.find("CO-ORDS") != nullptr) {
      joined.push_back(std::move(block));
      continue;
    }
    std::vector<PcfEntry> &entries = joined.back().entries;
    entries.push_back({block.keyword, block.text, block.line});
    entries.insert(entries.end(), block.entries.begin(), block.entries.end());
  }
  all = std::move(joined);
}

} // namespace frictionbeam::import
