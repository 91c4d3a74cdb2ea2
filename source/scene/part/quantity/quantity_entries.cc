// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"
#include "scene/part/quantity/quantity_grammar.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::parts {

namespace {

using Of = QuantityKind::Of;
using Over = Quantity::Over;

bool contains(const std::vector<std::string> &list, const std::string &item) {
  return std::count(list.begin(), list.end(), item) > 0;
}

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string> &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Supports that stand at several places are called name.1, name.2, ...: is this one of them?
bool is_repeated(const std::string &where, const std::vector<std::string> &supports) {
  const auto dot = where.rfind('.');
  return dot != std::string::npos && dot + 1 < where.size() &&
         where.find_first_not_of("0123456789", dot + 1) == std::string::npos &&
         contains(supports, where.substr(0, dot));
}

/// Guides, line stops and stops that are a pair of friction elements.
std::vector<std::string> pairs_of(const std::vector<FrictionSupport> &supports) {
  std::vector<std::string> pairs;
  for (const FrictionSupport &support : supports)
    if (const std::string pair = part_name(support); pair != support.name && !contains(pairs, pair))
      pairs.push_back(pair);
  return pairs;
}

/// The number of a place stands behind the half that has it.
void check_half(const ParameterReader &in, const Quantity &quantity,
                const std::vector<std::string> &supports) {
  const std::string &where = quantity.where;
  const auto half = where.rfind('.'), place = half == 0 ? half : where.rfind('.', half - 1);
  if (half == std::string::npos || place == std::string::npos)
    return;
  const std::string right = where.substr(0, place) + where.substr(half);
  const std::string numbered = right + where.substr(place, half - place);
  if (contains(supports, right) && is_repeated(numbered, supports))
    in.fail(quantity.name, "the place behind the half of a support", "'" + numbered + "'",
            "'" + where + "'");
}

/// A point of the line, or what holds it: a support, also one that is a pair, a restraint, a
/// spring.
void check_holder(const ParameterReader &in, const Quantity &quantity, Scene &scene) {
  const std::vector<std::string> holders = names(scene.supports) + pairs_of(scene.supports) +
                                           names(scene.restraints) + names(scene.springs);
  if (contains(holders, quantity.where) || is_repeated(quantity.where, holders))
    return;
  check_half(in, quantity, holders);
  if (!scene.mesh.file.empty())
    check_point(in, quantity.name, quantity.where, scene);
  else
    in.find(quantity.name, quantity.where, point_names(scene) + holders,
            "point, support or spring");
}

/// A friction support. Those that are a pair answer for work and wear only.
void check_support(const ParameterReader &in, const Quantity &quantity, const Scene &scene) {
  const std::vector<std::string> supports = names(scene.supports), pairs = pairs_of(scene.supports);
  const std::string &what = quantity.what, &where = quantity.where;
  const bool is_one = contains(pairs, where), is_pair = is_one || is_repeated(where, pairs);
  if (is_pair && (what == "work" || what == "wear"))
    return;
  const auto number = is_one ? where.size() : where.rfind('.');
  if (is_pair)
    in.fail(quantity.name,
            "work, wear and fx to mz at a support whose two halves, .plus and .minus, are friction "
            "elements of their own; " +
                what + " of either half",
            "'" + what + " at " + where.substr(0, number) + ".plus" + where.substr(number) +
                "', or 'fx at " + where + "'",
            "'" + what + " at " + where + "'");
  if (is_repeated(where, supports))
    return;
  check_half(in, quantity, supports);
  in.find(quantity.name, where, supports, "friction support");
}

void check_where(const ParameterReader &in, const Quantity &quantity, Scene &scene) {
  const std::string &what = quantity.what, &where = quantity.where, &entry = quantity.name;
  switch (quantity.kind().of) {
  case Of::motion:
  case Of::velocity:
  case Of::section:
    check_point(in, entry, where, scene);
    return;
  case Of::directed:
    if (what == "f" || what == "m")
      check_holder(in, quantity, scene);
    else
      check_point(in, entry, where, scene);
    return;
  case Of::fibre:
    if (scene.time.is_exact() && quantity.over != Over::end && quantity.over != Over::time_of &&
        what != "M_in" && what != "M_out")
      in.fail(entry, what + " at an instant, with the integrator event",
              "another Integrator in section Time, or 'time T'",
              quantity.what + " over an interval");
    check_point(in, entry, where, scene);
    return;
  case Of::holder:
    check_holder(in, quantity, scene);
    return;
  case Of::support:
  case Of::change:
    check_support(in, quantity, scene);
    return;
  case Of::supports:
    if (!where.empty() && quantity.kind().measure == QuantityKind::Measure::place)
      in.fail(entry, what + " of all friction supports", "no place");
    if (const auto supports = names(scene.supports);
        !where.empty() && !is_repeated(where, supports)) {
      check_half(in, quantity, supports);
      in.find(entry, where, supports, "friction support");
    }
    return;
  case Of::mode:
    double number;
    if (!to_number(where, number) || number < 1. || number > scene.modal.n_modes)
      in.fail(entry, what + " N, with N from 1 to the Number of modes in section Modes",
              "'" + what + " 1'", "'" + where + "'");
    return;
  case Of::stress:
    if (scene.stress.code.empty())
      in.fail(entry, what + " where section Stress has a Code", "set Code = B31.3 there");
    if (!where.empty() || !quantity.kind().is_of_line_too)
      check_point(in, entry, where, scene);
    return;
  case Of::limit:
    if (!where.empty() ||
        std::none_of(scene.steps.begin(), scene.steps.end(), [&](const LoadStep &step) {
          return step.finds_limit && (quantity.step.empty() || step.name == quantity.step);
        }))
      in.fail(entry, what + " of a step with Find = limit", "'set Find = limit' in that step");
    return;
  case Of::cycle:
    if (!where.empty() ||
        std::none_of(scene.steps.begin(), scene.steps.end(), [&](const LoadStep &step) {
          return step.cycle.ends && (quantity.step.empty() || step.name == quantity.step);
        }))
      in.fail(entry, what + " of a step with Repeat, at the end of a cycle",
              "'set Repeat = 10' in that step");
    [[fallthrough]];
  case Of::wall:
    if (std::none_of(scene.sections.begin(), scene.sections.end(),
                     [](const Section &section) { return section.is_inelastic(); }))
      in.fail(entry, what + " of sections that yield or creep",
              "a Section with 'Law = fibre_pipe' or another such law");
    if (quantity.is(Of::wall) && (!where.empty() || !quantity.kind().is_of_line_too))
      check_point(in, entry, where, scene);
    return;
  case Of::line:
    if (scene.kinematics == Kinematics::linear || !where.empty())
      in.fail(entry, what + " of the whole line, with Kinematics = corotational",
              "set Kinematics = corotational, and no point");
    return;
  case Of::exact:
    if (!scene.exact)
      in.fail(entry, what + " in scenes with an exact solution",
              "a section Exact, Scene = oscillator, or slab with Sequence = cycle");
  }
}

/// What is known only at the end of a run has no course in time.
void check_when(const ParameterReader &in, const Quantity &quantity, const Scene &scene) {
  constexpr unsigned int first_of_status = 2; // after the sums of forces
  const bool is_case = !quantity.step.empty() &&
                       std::none_of(scene.steps.begin(), scene.steps.end(),
                                    [&](const auto &step) { return step.name == quantity.step; });
  if (is_case && (quantity.is(Of::directed) || quantity.is(Of::fibre)))
    in.fail(quantity.name,
            quantity.what + " of a step: a case made of others has its components alone, each by "
                            "itself",
            "a step in place of " + quantity.step);
  if (is_case && quantity.is(Of::supports) && quantity.kind().component >= first_of_status)
    in.fail(quantity.name,
            quantity.what + " of a step: a case made of others has no contact status",
            "a step in place of " + quantity.step);
  if (quantity.kind().is_of_the_end() && (quantity.over != Over::end || quantity.time))
    in.fail(quantity.name, quantity.what + " of a step, without an interval and a time",
            "'" + quantity.what +
                (quantity.where.empty()  ? ""
                 : quantity.is(Of::mode) ? " " + quantity.where
                                         : " at " + quantity.where) +
                "'");
}

/// The name of a unit converts nothing.
void check_unit(const ParameterReader &in, const std::vector<std::string> &pieces,
                const Quantity &quantity, const Scene &scene) {
  const auto begins = [&](const std::string &word) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const std::string &piece) { return piece.rfind(word + " ", 0) == 0; });
  };
  const std::string own = scene.units.name(quantity.wants_time ? "s" : quantity.kind().unit);
  if (begins("unit") && !begins("scale") && quantity.unit != own)
    in.fail(quantity.name, "a unit with the scale that makes it, or the quantity's own: " + own,
            "'scale 1000; unit mm' of metres", "unit " + quantity.unit);
}

bool is_of_continuum(const Scene &scene, const std::string &name) {
  if (!scene.continuum)
    return false;
  const auto &list = scene.continuum->quantities;
  return std::any_of(list.begin(), list.end(),
                     [&](const ContinuumQuantity &one) { return one.name == name; });
}

} // namespace

void declare_quantities(ParameterReader &in) {
  in.declare_text("Source", "", "any text",
                  "Where references come from, unless a quantity says so.");
  const ParameterFile::Section *const section = in.file().find("Quantities");
  if (section == nullptr)
    return;
  for (const ParameterFile::Entry &entry : section->entries)
    if (entry.name != "Source")
      in.declare_text(entry.name, "",
                      "what at where, along X Y Z, pipe NAME, step NAME, time T; scale F; "
                      "reference R; limit L; source TEXT",
                      "A number to compute.");
}

void parse_quantities(const ParameterReader &in, Scene &scene) {
  const ParameterFile::Section *const section = in.file().find("Quantities");
  if (section == nullptr)
    return;
  std::vector<std::string> dropped; // references
  for (const ParameterFile::Entry &entry : section->entries) {
    if (entry.name == "Source")
      continue;
    const std::vector<std::string> pieces = split(entry.value, ';');
    if (pieces.empty())
      fail_form(in, entry.name, "nothing");
    // A quantity of the generated scene is given a reference by its name alone.
    const bool is_reference = pieces[0].rfind("reference ", 0) == 0;
    const auto known =
        std::find_if(scene.quantities.begin(), scene.quantities.end(),
                     [&](const Quantity &other) { return other.name == entry.name; });
    if (is_reference && known == scene.quantities.end() && is_of_continuum(scene, entry.name))
      continue;
    Quantity quantity;
    quantity.name = entry.name;
    if (is_reference && known != scene.quantities.end())
      quantity = *known;
    else if (known != scene.quantities.end())
      in.fail(entry.name,
              "a name that the generated scene does not use itself: " +
                  join(names(scene.quantities)),
              "another name");
    if (!is_reference || known == scene.quantities.end()) {
      parse_definition(in, pieces[0], scene, quantity);
      check_where(in, quantity, scene);
      check_when(in, quantity, scene);
    }
    parse_attributes(in, pieces, is_reference ? 0 : 1, quantity);
    check_unit(in, pieces, quantity, scene);
    if (quantity.reference && in.scene_changed() && !entry.is_override) {
      quantity.reference.reset();
      dropped.push_back(quantity.name);
    }
    if (quantity.reference && quantity.source.empty())
      quantity.source = in.text("Source");
    if (is_reference)
      *known = quantity;
    else
      scene.quantities.push_back(quantity);
  }
  if (!dropped.empty())
    scene.remarks.push_back("No reference in this run for " + join(dropped) +
                            ": --set has changed the scene that the references in the file belong "
                            "to.");
}

} // namespace frictionbeam::parts
