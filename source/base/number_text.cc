// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/number_text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace frictionbeam {

namespace {

template <typename... Format>
void append_number(std::string &text, const double value, const Format... format) {
  if (std::isnan(value)) {
    text += "nan";
    return;
  }
  char buffer[400]; // a double in fixed notation has at most 309 digits before the point
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value, format...);
  Assert(result.ec == std::errc(), dealii::ExcInternalError());
  text.append(buffer, result.ptr - buffer);
}

template <typename... Format>
std::string number_text(const double value, const Format... format) {
  std::string text;
  append_number(text, value, format...);
  return text;
}

} // namespace

void append_exact_number(const double value, std::string &text) {
  // Tables repeat numbers from row to row, and to look one up takes a tenth of making its text.
  struct Known {
    std::uint64_t bits = 0;
    std::uint8_t length = 0; ///< 0: nothing is known here
    std::array<char, 24> text{};
  };
  constexpr unsigned int log_n_known = 8;
  thread_local std::array<Known, 1u << log_n_known> all_known;
  const double number = value + 0.; // no negative zero
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof(bits));
  Known &known = all_known[(bits * 0x9e3779b97f4a7c15u) >> (64 - log_n_known)]; // of Fibonacci
  if (known.length == 0 || known.bits != bits) {
    const std::size_t begin = text.size();
    append_number(text, number);
    known.bits = bits;
    known.length = text.copy(known.text.data(), known.text.size(), begin);
    Assert(begin + known.length == text.size(), dealii::ExcInternalError());
    return;
  }
  text.append(known.text.data(), known.length);
}

std::string exact_number(const double value) {
  std::string text;
  append_exact_number(value, text);
  return text;
}

std::string rounded_number(const double value, const unsigned int digits) {
  if (std::abs(value) >= std::pow(10., digits) && std::abs(value) < 1e7)
    return fixed_number(value, 0);
  const double number = value + 0.; // no negative zero
  return number_text(number, std::chars_format::general, static_cast<int>(digits));
}

std::string fixed_number(const double value, const unsigned int decimals) {
  if (!std::isfinite(value) || std::abs(value) >= 1e12)
    return rounded_number(value);
  const std::string text =
      number_text(value, std::chars_format::fixed, static_cast<int>(std::min(decimals, 30u)));
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string first_of(const std::vector<std::string> &names) {
  constexpr std::size_t most_named = 5;
  std::string text;
  for (std::size_t n = 0; n < std::min(most_named, names.size()); ++n)
    text += (n == 0 ? "" : ", ") + names[n];
  if (names.size() > most_named)
    text += " and " + std::to_string(names.size() - most_named) + " more";
  return text;
}

unsigned int decimals_for(const double largest) {
  if (!std::isfinite(largest) || largest <= 0.)
    return 0;
  return static_cast<unsigned int>(std::clamp(3. - std::floor(std::log10(largest)), 0., 12.));
}

} // namespace frictionbeam
