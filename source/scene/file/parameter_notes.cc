// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/file/parameter_notes.h"

#include "scene/file/parameter_file.h"
#include "scene/quantity.h"

namespace frictionbeam {

namespace {

constexpr std::size_t longest_line = 96;

/// Where quantities of one sort are asked.
constexpr Word<QuantityKind::Of> places[] = {
    {"at a point", QuantityKind::Of::motion},
    {"at a point", QuantityKind::Of::velocity},
    {"of the pipe at a point, local axes, N > 0 in tension ('before P' or 'after P' where they "
     "jump, 'pipe NAME' at a branch)",
     QuantityKind::Of::section},
    {"at a support, spring or point: the force of what holds the pipe there on the pipe",
     QuantityKind::Of::holder},
    {"at a point, 'along X Y Z' (f and m at a support, spring or point; u, r, v, w also 'along "
     "local x', y or z, the pipe's axes there)",
     QuantityKind::Of::directed},
    {"of the pipe at a point ('before', 'after', 'pipe NAME' as above)", QuantityKind::Of::fibre},
    {"at a friction support (name.1, name.2, ... of a repeated one)", QuantityKind::Of::support},
    {"of all friction supports or of one part", QuantityKind::Of::supports},
    {"of a mode, by its number: 'frequency 1'", QuantityKind::Of::mode},
    {"at a point, by the stress code", QuantityKind::Of::stress},
    {"of a step with Find = limit", QuantityKind::Of::limit},
    {"of steps with Repeat, pipes that yield or creep", QuantityKind::Of::cycle},
    {"of pipes whose section yields or creeps", QuantityKind::Of::wall},
    {"of the whole line, with Kinematics = corotational", QuantityKind::Of::line},
    {"in scenes with an exact solution", QuantityKind::Of::exact}};

/// "ux uy uz [m] rx ry rz [rad]" of the kinds that belong to it.
template <typename Kinds, typename Property>
std::string words_and_units(const Kinds &kinds, const Property &belongs) {
  std::string text, unit;
  for (const auto &kind : kinds) {
    if (!belongs(kind))
      continue;
    if (!unit.empty() && unit != kind.unit)
      text += "[" + unit + "] ";
    unit = kind.unit;
    text += std::string(kind.word) + " ";
  }
  return text + "[" + unit + "]";
}

/// "ux uy uz [m] rx ry rz [rad] at a point", and what the words mean that do not say it.
std::string quantities_of(const Word<QuantityKind::Of> &place) {
  const auto belongs = [&](const QuantityKind &kind) { return kind.of == place.value; };
  std::string meanings;
  for (const QuantityKind &kind : quantity_kinds)
    if (belongs(kind) && *kind.meaning != '\0')
      meanings += std::string("; ") + kind.word + ": " + kind.meaning;
  return words_and_units(quantity_kinds, belongs) + " " + place.word + meanings + ".";
}

/// The same of a continuum: "Of a continuum: ux uy uz [m] at a point; ..."
std::string quantities_of_bodies() {
  using At = BodyQuantityKind::At;
  constexpr Word<At> body_places[] = {
      {"a point", At::point}, {"a part of its boundary", At::part}, {"a coordinate x [m]", At::x}};
  std::string text = "Of a continuum:";
  for (const Word<At> &place : body_places)
    text += " " +
            words_and_units(body_quantity_kinds,
                            [&](const BodyQuantityKind &kind) { return kind.at == place.value; }) +
            " at " + place.word + (place.value == At::x ? "." : ";");
  return text;
}

/// As lines of comment.
std::string comment(const std::string &text) {
  std::string lines, line = "#";
  for (const std::string &word : split(text, ' ')) {
    if (line.size() + 1 + word.size() > longest_line) {
      lines += line + "\n";
      line = "#  ";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

} // namespace

std::string parameter_notes() {
  std::string text =
      R"(# All entries of a parameter file, with their defaults. A file holds any number of parts
# '<Kind> <name>': here stands one of each kind, called 'name'. Steps are taken in the
# order of the file. Units are SI unless an entry says otherwise; angles are in degrees.
# Entries of a support's law stand in the support: those of 'coulomb' are shown.
# Files may be included: include <file>. In 'Quantities', entries have names of your own:
#   set <name> = what at where, step NAME, time T; scale F; unit U; reference R; source TEXT
# |what| is the absolute value. Without a step, the last one is meant; without a time, the end of
# the step. Over an interval:
#   set <name> = max what at where, from T1, to T2        or min, mean, integral, change, rate
#   set <name> = time_of max what at where, from T1, to T2  or min: when it is reached first
#   set <name> = time_of slip at SUPPORT, from T1, to T2  or stick, open, closed
# What there is to ask for:
)";
  for (const Word<QuantityKind::Of> &place : places)
    text += comment(quantities_of(place));
  return text + comment(quantities_of_bodies());
}

} // namespace frictionbeam
