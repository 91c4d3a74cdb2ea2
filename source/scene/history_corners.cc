// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/history_corners.h"

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int first_samples = 1u << 10, last_samples = 1u << 18;
constexpr std::size_t most_corners = 100000;

bool is_word(const char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The pieces of @p text between commas outside of parentheses.
std::vector<std::string> arguments(const std::string &text) {
  std::vector<std::string> result(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}

/// End of the operand that begins at @p place, going forwards or backwards: a parenthesis that is
/// not its own, a comma, or an operator that binds less than a comparison.
std::size_t end_of_operand(const std::string &text, std::size_t place, const int direction) {
  int depth = 0;
  const char own = direction > 0 ? '(' : ')', other = direction > 0 ? ')' : '(';
  for (; place < text.size(); place += direction) { // an index below 0 is larger than any
    const char c = text[place];
    if (c == own)
      ++depth;
    else if (c == other && depth-- == 0)
      break;
    else if (depth == 0 && std::string(",?:&|<>=!").find(c) != std::string::npos)
      break;
  }
  return place;
}

/// Expressions that are constant but for jumps, where @p text may jump or bend.
std::vector<std::string> conditions(const std::string &text) {
  std::vector<std::string> result;
  const auto side_of = [&](const std::string &a, const std::string &b) {
    result.push_back("if((" + a + ")>(" + b + "),1,0)");
    result.push_back("if((" + a + ")<(" + b + "),1,0)");
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '<' || c == '>' ||
        ((c == '=' || c == '!') && i + 1 < text.size() && text[i + 1] == '=')) {
      const std::size_t after = i + 1 < text.size() && text[i + 1] == '=' ? i + 2 : i + 1,
                        first = end_of_operand(text, i - 1, -1) + 1,
                        last = end_of_operand(text, after, 1);
      side_of(text.substr(first, i - first), text.substr(after, last - after));
      i = after - 1;
    } else if (c == '(' && i > 0 && is_word(text[i - 1])) {
      std::size_t first = i;
      while (first > 0 && is_word(text[first - 1]))
        --first;
      const std::string name = text.substr(first, i - first);
      std::size_t end = i + 1;
      for (int depth = 1; end < text.size() && depth > 0; ++end)
        depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
      const std::vector<std::string> list = arguments(text.substr(i + 1, end - i - 2));
      if (name == "abs" || name == "sign")
        side_of(list[0], "0");
      else if (name == "floor" || name == "ceil" || name == "rint" || name == "int")
        result.push_back(name + "(" + list[0] + ")");
      else if (name == "if")
        result.push_back("if(" + list[0] + ",1,0)");
      else if (name == "min" || name == "max")
        for (std::size_t a = 0; a < list.size(); ++a)
          for (std::size_t b = 0; b < a; ++b)
            side_of(list[a], list[b]);
    }
  }
  return result;
}

/// First instant of [a, b] at which the value is no longer that at a.
double locate(const std::function<double(const double)> &value, double a, double b) {
  const double before = value(a);
  for (;;) {
    const double middle = a + (b - a) / 2.;
    if (!(middle > a && middle < b))
      return b;
    (value(middle) == before ? a : b) = middle;
  }
}

/// Instants at which a piecewise constant value changes.
std::vector<double> changes(const std::function<double(const double)> &value, const double end) {
  std::vector<double> found;
  unsigned int as_before = 0;
  for (unsigned int n = first_samples; n <= last_samples && as_before < 2; n *= 2) {
    std::vector<double> now;
    double previous = 0., previous_value = value(0.);
    for (unsigned int i = 1; i <= n; ++i) {
      const double time = end * i / n, here = value(time);
      if (here != previous_value)
        now.push_back(previous);
      previous = time;
      previous_value = here;
    }
    as_before = now.size() == found.size() ? as_before + 1 : 0;
    found = now;
    if (as_before == 2 || 2 * n > last_samples)
      for (double &instant : found)
        instant = locate(value, instant, instant + end / n);
  }
  return found;
}

} // namespace

void find_corners(TimeFunction &function, const double end) {
  if (!function.is_given() || !function.breaks.empty() || !(end > 0.))
    return;
  for (const std::string &condition : conditions(function.text)) {
    dealii::FunctionParser<1> parser(1);
    parser.initialize("t", condition, {{"pi", 3.14159265358979323846}});
    const std::vector<double> instants =
        changes([&](const double time) { return parser.value(dealii::Point<1>(time)); }, end);
    function.breaks.insert(function.breaks.end(), instants.begin(), instants.end());
  }
  const double least = 1e-12 * end; // what begins at 0 has no corner there
  function.breaks.erase(std::remove_if(function.breaks.begin(), function.breaks.end(),
                                       [&](const double instant) { return instant < least; }),
                        function.breaks.end());
  std::sort(function.breaks.begin(), function.breaks.end());
  function.breaks.erase(std::unique(function.breaks.begin(), function.breaks.end()),
                        function.breaks.end());
  if (function.breaks.size() > most_corners)
    function.breaks.clear(); // as good as noise
}

void find_corners(Scene &scene) {
  double end = 0.;
  for (const LoadStep &step : scene.steps)
    end += step.duration;
  for (Load &load : scene.loads)
    find_corners(load.history, end);
  for (FrictionSupport &support : scene.supports)
    for (TimeFunction &motion : support.ground_motion)
      find_corners(motion, end);
}

} // namespace frictionbeam
