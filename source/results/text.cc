// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace frictionbeam {

std::string escape_xml(const std::string &text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text)
    switch (c) {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    case '\'':
      escaped += "&#39;";
      break;
    case '\n':
    case '\t':
      escaped += c;
      break;
    default:
      escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return escaped;
}

std::string file_name_part(const std::string &text) {
  std::string name = text;
  for (char &c : name)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
          c == '-'))
      c = '_';
  return name;
}

std::string status_word(const ContactStatus status) {
  switch (status) {
  case ContactStatus::stick:
    return "stick";
  case ContactStatus::slip:
    return "slip";
  case ContactStatus::open:
    return "open";
  case ContactStatus::closed:
    return "closed";
  case ContactStatus::none:
    break;
  }
  return "none";
}

std::string status_word(const RunStatus status) {
  switch (status) {
  case RunStatus::converged:
    return "converged";
  case RunStatus::no_equilibrium:
    return "no_equilibrium";
  case RunStatus::failed:
    break;
  }
  return "failed";
}

bool is_finished(const Results &results, const Frame &frame) {
  return frame.end_of_step &&
         (frame.step >= results.steps.size() || results.steps[frame.step].converged);
}

double friction_force(const SupportState &state) { return std::hypot(state.ft1, state.ft2); }

DisplayUnit display_unit(const std::string &si_unit, const double largest) {
  if (largest == 0.)
    return {1., si_unit};
  if (si_unit == "N" || si_unit == "N m" || si_unit == "J") {
    if (largest >= 1e7)
      return {1e-6, "M" + si_unit};
    if (largest >= 1e3)
      return {1e-3, "k" + si_unit};
  }
  if (si_unit == "Pa" && largest >= 1e5)
    return {1e-6, "MPa"};
  if (si_unit == "m" || si_unit == "rad") {
    if (largest < 1e-4)
      return {1e6, "\u00b5" + si_unit};
    if (largest < (si_unit == "m" ? 10. : 1.))
      return {1e3, "m" + si_unit};
  }
  return {1., si_unit};
}

DisplayUnit display_unit(const UnitSystem &units, const std::string &si_unit,
                         const double largest) {
  if (units.is_si())
    return display_unit(si_unit, largest);
  return {1. / units.factor(si_unit), units.name(si_unit)};
}

const Frame &in_units(const UnitSystem &units, const Frame &frame, Frame &converted) {
  if (units.is_si())
    return frame;
  converted = frame;
  const double length = 1. / units.factor("m"), force = 1. / units.factor("N");
  const auto scale = [](Motion &motion, const double first, const double second) {
    for (unsigned int c = 0; c < 6; ++c)
      motion[c] *= c < 3 ? first : second;
  };
  for (Station &station : converted.line) {
    station.s *= length;
    station.position = length * station.position;
    scale(station.displacement, length, 1.);
    scale(station.force, force, force * length);
  }
  for (SupportState &support : converted.supports) {
    for (double *value : {&support.fn, &support.ft1, &support.ft2})
      *value *= force;
    for (double *value : {&support.gap, &support.slip1, &support.slip2})
      *value *= length;
    support.work_friction *= force * length;
    support.mt *= force * length;
    scale(support.on_pipe, force, force * length);
  }
  for (Motion &reaction : converted.reactions)
    scale(reaction, force, force * length);
  for (SectionState &section : converted.sections)
    section = in_units(units, section);
  return converted;
}

SectionState in_units(const UnitSystem &units, const SectionState &section) {
  SectionState shown = section;
  const double metre = units.factor("m"), newton = units.factor("N");
  shown.s /= metre;
  shown.length /= metre;
  for (unsigned int c = 0; c < 6; ++c) {
    shown.strain[c] *= c < 3 ? 1. : metre;
    shown.force[c] /= c < 3 ? newton : newton * metre;
  }
  shown.dissipated /= newton;
  return shown;
}

void Largest::operator()(const double value) {
  if (std::isfinite(value))
    largest = std::max(largest, std::abs(value));
}

} // namespace frictionbeam
