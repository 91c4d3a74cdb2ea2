// SPDX-License-Identifier: LGPL-2.1-or-later
/// Guides, line stops and stops that do not hold exactly: a pair of friction elements, one on
/// either side of the pipe, `NAME.plus` and `NAME.minus` of the section "Support NAME".
#pragma once

#include <initializer_list>
#include <string>

namespace frictionbeam {

/// What the two halves of a pair are called behind the name of their part.
inline constexpr const char *plus_half = ".plus", *minus_half = ".minus";

/// Whether a support of this kind may be half of a pair.
inline bool is_of_a_pair(const std::string &kind) {
  return kind == "guide" || kind == "line stop" || kind == "stop";
}

/// Whether a name is that of a part, or of one of the places where it stands (`rests.2`).
inline bool is_place_of(const std::string &instance, const std::string &part) {
  return instance == part ||
         (instance.size() > part.size() + 1 && instance.compare(0, part.size(), part) == 0 &&
          instance[part.size()] == '.' &&
          instance.find_first_not_of("0123456789", part.size() + 1) == std::string::npos);
}

/**
 * The name in the heading of the section that a friction support was read from: its own, or that of
 * the pair of which it is a half. Users may call a rest "a.plus"; so the kind counts.
 */
template <typename Support>
std::string part_name(const Support &support) {
  if (is_of_a_pair(support.kind))
    for (const std::string half : {plus_half, minus_half})
      if (const auto at = support.name.rfind(half);
          at != std::string::npos && at + half.size() == support.name.size())
        return support.name.substr(0, at);
  return support.name;
}

} // namespace frictionbeam
