// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/quantity/quantity_grammar.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam::parts {

namespace {

using Of = QuantityKind::Of;
using Over = Quantity::Over;

/// Words of what may be asked of the first time, or else.
std::vector<std::string> words_of_kinds(const bool changes) {
  std::vector<std::string> words;
  for (const QuantityKind &kind : quantity_kinds)
    if ((kind.of == Of::change) == changes)
      words.emplace_back(kind.word);
  return words;
}

/// "max, min, ... or rate"
std::string words_of_intervals() {
  std::vector<std::string> words;
  for (const Word<Over> &interval : intervals)
    if (interval.value != Over::time_of)
      words.emplace_back(interval.word);
  const std::string last = words.back();
  words.pop_back();
  return join(words) + " or " + last;
}

} // namespace

void fail_form(const ParameterReader &in, const std::string &entry, const std::string &read) {
  in.fail(entry,
          "what at where, along X Y Z, pipe NAME, step NAME, time T; scale F; unit U; reference R; "
          "limit L; source TEXT (all but 'what' may be left out; |what| is its absolute value; "
          "'before P' or 'after P' in place of 'at P' is one side of a point, 'pipe NAME' one pipe "
          "of a branch, 'along' the direction of u, r, v, w, f, m, F or M), or " +
              words_of_intervals() +
              " and then what at where, from T, to T, or time_of max what at where, or time_of "
              "slip at SUPPORT, from T "
              "(doc/quantities.md)",
          "'ux at P1, step heat; reference 0.012; source hand calculation', or 'Mz after T1, pipe "
          "branch'",
          "'" + read + "'");
}

namespace {

double number_of(const ParameterReader &in, const std::string &entry, const std::string &text) {
  double value;
  if (!to_number(text, value))
    in.fail(entry, "a number", "a number in place of '" + text + "'");
  return value;
}

/// `[over] [|]what[|] [at where]`, in words
void parse_subject(const ParameterReader &in, std::vector<std::string> words,
                   const std::string &piece, Quantity &quantity) {
  const auto interval = find_word(intervals, words[0]);
  if (interval != std::end(intervals) && words.size() > 1) {
    quantity.over = interval->value;
    words.erase(words.begin());
    const auto extreme = find_word(intervals, words[0]); // time_of max what
    if (quantity.over == Over::time_of && words.size() > 1 && extreme != std::end(intervals) &&
        (extreme->value == Over::maximum || extreme->value == Over::minimum)) {
      quantity.wants_time = true;
      quantity.over = extreme->value;
      words.erase(words.begin());
    }
  }
  std::string what = words[0];
  quantity.absolute = what.size() > 2 && what.front() == '|' && what.back() == '|';
  if (quantity.absolute)
    what = what.substr(1, what.size() - 2);
  quantity.what = what;
  const std::vector<std::string> kinds = words_of_kinds(quantity.over == Over::time_of);
  if (std::count(kinds.begin(), kinds.end(), what) == 0) {
    const std::string like = nearest(what, kinds);
    in.fail(quantity.name, "the name of a quantity: " + join(kinds),
            like.empty() ? "'ux at A', 'fn at rest' or another of doc/quantities.md"
                         : "'" + like + "'",
            "'" + what + "'");
  }
  using Side = Quantity::Side;
  if (words.size() == 3 && words[1] == "at")
    quantity.where = words[2];
  else if (words.size() == 3 && quantity.has_pipe() &&
           (words[1] == "before" || words[1] == "after")) {
    quantity.where = words[2];
    quantity.side = words[1] == "before" ? Side::before : Side::after;
  } else if (words.size() == 2 && quantity.is(Of::mode))
    quantity.where = words[1];
  else if (words.size() != 1)
    fail_form(in, quantity.name, piece);
}

/// `along X Y Z`
void parse_direction(const ParameterReader &in, const std::vector<std::string> &words,
                     Quantity &quantity) {
  double size = 0.;
  for (unsigned int d = 0; d < 3; ++d) {
    quantity.direction[d] = number_of(in, quantity.name, words[1 + d]);
    size = std::hypot(size, quantity.direction[d]);
  }
  if (size == 0.)
    in.fail(quantity.name, "a direction that is not zero", "'along 1 1 0'");
  for (double &part : quantity.direction)
    part /= size;
  quantity.along = Quantity::Along::direction;
}

/// `along local x`, y or z: of the pipe at the point, for motions.
void parse_local(const ParameterReader &in, const std::string &axis, Quantity &quantity) {
  const auto component = std::string("xyz").find(axis);
  if (axis.size() != 1 || component == std::string::npos)
    in.fail(quantity.name,
            "along local x, y or z: the pipe's tangent, across and horizontal, and "
            "what completes them",
            "'along local y'", "'along local " + axis + "'");
  if (quantity.unit_is_force())
    in.fail(quantity.name, "a direction in numbers for " + quantity.what,
            "'along 1 1 0'; along the pipe's own axes there are N, Vy, Vz, Mx, My, Mz",
            "'along local " + axis + "'");
  quantity.direction[component] = 1.;
  quantity.along = Quantity::Along::local;
}

double time_of_run(const ParameterReader &in, const std::string &name, const std::string &word,
                   const std::string &piece) {
  const double time = number_of(in, name, word);
  if (!(time >= 0.))
    in.fail(name, "a time of the run, which begins at 0 s", "'time 0' for its beginning",
            "'" + piece + "'");
  return time;
}

/// An interval of the run from the beginning of a step to its end.
void take_interval_of_step(const ParameterReader &in, const std::string &text, const Scene &scene,
                           Quantity &quantity) {
  double begin = 0.;
  for (const LoadStep &step : scene.steps) {
    if (step.finds_limit) // which ends when nobody knows
      break;
    if (step.name == quantity.step) {
      quantity.from = begin;
      quantity.to = begin + step.duration;
      quantity.step.clear();
      return;
    }
    begin += step.duration;
  }
  in.fail(quantity.name, "an interval, 'from T, to T' [s of the run], or a step that has one",
          "the times at which the step begins and ends", "'" + text + "'");
}

} // namespace

void parse_definition(const ParameterReader &in, const std::string &text, const Scene &scene,
                      Quantity &quantity) {
  std::set<std::string> details;
  for (const std::string &piece : split(text, ',')) {
    const std::vector<std::string> words = split_names(piece);
    if (words.empty())
      fail_form(in, quantity.name, text);
    if (!quantity.what.empty())
      in.say_once(quantity.name, words[0], details);
    if (quantity.what.empty())
      parse_subject(in, words, piece, quantity);
    else if (words.size() == 2 && words[0] == "step") {
      quantity.step = words[1];
      in.find(quantity.name, words[1], case_names(scene), "step");
    } else if (words.size() == 4 && words[0] == "along" && quantity.is(Of::directed)) {
      parse_direction(in, words, quantity);
    } else if (words.size() == 3 && words[0] == "along" && words[1] == "local" &&
               quantity.is(Of::directed)) {
      parse_local(in, words[2], quantity);
    } else if (words.size() == 2 && words[0] == "pipe" && quantity.has_pipe()) {
      quantity.pipe = words[1];
      in.find(quantity.name, words[1], names(scene.pipes), "pipe");
    } else if (words.size() == 2 && words[0] == "time")
      quantity.time = time_of_run(in, quantity.name, words[1], piece);
    else if (words.size() == 2 && quantity.over != Over::end &&
             (words[0] == "from" || words[0] == "to"))
      (words[0] == "from" ? quantity.from : quantity.to) =
          time_of_run(in, quantity.name, words[1], piece);
    else
      fail_form(in, quantity.name, piece);
  }
  if (quantity.is(Of::directed) && quantity.along == Quantity::Along::none)
    in.fail(quantity.name, quantity.what + " at a point along a direction",
            "'" + quantity.what + " at P1, along 1 1 0'", "'" + text + "'");
  if (details.count("step") + details.count("time") +
              std::max(details.count("from"), details.count("to")) >
          1 ||
      (quantity.over != Over::end && quantity.time))
    in.fail(quantity.name, "a step, a time or an interval ('from T, to T', with max, min, ...)",
            "one of them", "'" + text + "'");
  if (!(quantity.from < quantity.to))
    in.fail(quantity.name, "an interval from an earlier time to a later one", "'from 1, to 2'",
            "'" + text + "'");
  if (quantity.over != Over::end && !quantity.step.empty())
    take_interval_of_step(in, text, scene, quantity);
}

void parse_attributes(const ParameterReader &in, const std::vector<std::string> &pieces,
                      const unsigned int first, Quantity &quantity) {
  std::set<std::string> keys;
  for (unsigned int i = first; i < pieces.size(); ++i) {
    const auto blank = pieces[i].find(' ');
    const std::string key = pieces[i].substr(0, blank),
                      value = blank == std::string::npos ? "" : pieces[i].substr(blank + 1);
    in.say_once(quantity.name, key, keys);
    if (key == "scale") {
      quantity.scale = number_of(in, quantity.name, value);
      if (quantity.scale == 0.)
        in.fail(quantity.name, "a scale that is not 0", "'scale 1000; unit mm'", pieces[i]);
      if (quantity.wants_time && quantity.scale < 0.)
        in.fail(quantity.name, "a scale > 0 of a time", "'scale 1000; unit ms'", pieces[i]);
    } else if (key == "reference")
      quantity.reference = number_of(in, quantity.name, value);
    else if (key == "limit") {
      quantity.limit = number_of(in, quantity.name, value);
      if (!(*quantity.limit >= 0.))
        in.fail(quantity.name, "a limit of its size, not below 0", "'limit 0.02'", pieces[i]);
    } else if (key == "unit")
      quantity.unit = value;
    else if (key == "source")
      quantity.source = value;
    else
      fail_form(in, quantity.name, pieces[i]);
  }
}

} // namespace frictionbeam::parts
