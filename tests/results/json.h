// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstring>
#include <string>

/// Whether a text is valid JSON (RFC 8259), byte by byte; UTF-8 is not checked.
class JsonChecker {
public:
  explicit JsonChecker(const std::string &text) : at(text.c_str()) {}

  bool valid() {
    const bool good = value();
    space();
    return good && *at == '\0';
  }

private:
  void space() { at += std::strspn(at, " \n\r\t"); }

  bool take(const char *word) {
    space();
    const std::size_t length = std::strlen(word);
    if (std::strncmp(at, word, length) != 0)
      return false;
    at += length;
    return true;
  }

  bool digits() {
    const std::size_t n = std::strspn(at, "0123456789");
    at += n;
    return n > 0;
  }

  bool number() {
    at += *at == '-' ? 1 : 0;
    if (at[0] == '0' && at[1] >= '0' && at[1] <= '9')
      return false;
    if (!digits() || (*at == '.' && (++at, !digits())))
      return false;
    if (*at != 'e' && *at != 'E')
      return true;
    ++at;
    at += *at == '+' || *at == '-' ? 1 : 0;
    return digits();
  }

  bool string() {
    if (!take("\""))
      return false;
    for (; *at != '"'; ++at) {
      if (static_cast<unsigned char>(*at) < 0x20)
        return false;
      if (*at == '\\') {
        ++at;
        if (*at == 'u') {
          if (std::strspn(at + 1, "0123456789abcdefABCDEF") < 4)
            return false;
          at += 4;
        } else if (*at == '\0' || std::strchr("\"\\/bfnrt", *at) == nullptr)
          return false;
      }
    }
    ++at;
    return true;
  }

  template <typename Member>
  bool list(const char *close, const Member &member) {
    if (take(close))
      return true;
    do
      if (!member())
        return false;
    while (take(","));
    return take(close);
  }

  bool value() {
    space();
    if (take("{"))
      return list("}", [&]() { return string() && take(":") && value(); });
    if (take("["))
      return list("]", [&]() { return value(); });
    if (*at == '"')
      return string();
    return take("true") || take("false") || take("null") || number();
  }

  const char *at;
};
