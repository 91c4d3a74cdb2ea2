// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/section_law.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <iterator>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr char bend_radius[] = "Bend radius", place_in_bend[] = "Place in bend",
               bending_rigidity[] = "Bending rigidity";

/// What a parameter is taken from.
struct Known {
  const Section &section;
  const Profile &profile;
  const BendPart &bend;
};
struct KnownFigure {
  const char *parameter;
  double (*value)(const Known &);
  bool needs_diameter = false;
};
constexpr KnownFigure known_figures[] = {
    {"Young's modulus", [](const Known &of) { return of.profile.material.youngs_modulus; }},
    {"Poisson ratio", [](const Known &of) { return of.profile.material.poissons_ratio; }},
    {"Outside diameter", [](const Known &of) { return 2. * of.section.outer_radius; }, true},
    {"Wall thickness", [](const Known &of) { return of.section.wall; }, true},
    {"Axial rigidity", [](const Known &of) { return of.profile.EA; }},
    {"Shear rigidity", [](const Known &of) { return of.profile.GA; }},
    {"Torsional rigidity", [](const Known &of) { return of.profile.GJ; }},
    {bending_rigidity, [](const Known &of) { return of.profile.EI; }},
    {bend_radius, [](const Known &of) { return of.bend.radius; }},
    {"Bend length", [](const Known &of) { return of.bend.length; }},
    {place_in_bend, [](const Known &of) { return (of.bend.begin + of.bend.end) / 2.; }}};

const KnownFigure *known_figure(const std::string &parameter) {
  const auto found =
      std::find_if(std::begin(known_figures), std::end(known_figures),
                   [&](const KnownFigure &figure) { return figure.parameter == parameter; });
  return found == std::end(known_figures) ? nullptr : found;
}

/// Place of a parameter in a law's list; -1 if it has none of this name.
int place_of(const LawDescription &law, const std::string &name) {
  for (int i = 0; i < law.n_parameters; ++i)
    if (law.parameters[i].name == name)
      return i;
  return -1;
}

bool has_own_flexibility(const LawDescription &law) {
  return place_of(law, bend_radius) >= 0 && place_of(law, bending_rigidity) < 0;
}

/// What the file has for a parameter; a rigid part of the pipe has another law than its section.
std::optional<double> given(const LawDescription &law, const Section &section,
                            const std::string &name) {
  const int place = place_of(law, name);
  return place < 0 || section.law != law.name || section.law_parameters.empty()
             ? std::nullopt
             : section.law_parameters[place];
}

double value_of(const LawDescription &law, const int i, const Known &known) {
  const LawParameter &parameter = law.parameters[i];
  if (const auto of_file = given(law, known.section, parameter.name))
    return *of_file;
  const KnownFigure *const figure = known_figure(parameter.name);
  if (figure == nullptr)
    return parameter.default_value;
  if (figure->needs_diameter && known.section.wall == 0.)
    throw UserError("Section " + known.section.name + ": its law '" + law.name + "' needs '" +
                    parameter.name +
                    "'.\n  read:    a section by its area and inertia\n  allowed: 'Outer "
                    "diameter' and 'Wall', or a 'Size'\n  try:     these, or '" +
                    parameter.name + "' itself");
  return figure->value(known);
}

/// A law that knows nothing of bends stands in none that is more flexible than a straight pipe.
void check_flexibility(const LawDescription &law, const Pipe &pipe, const Section &section,
                       const Profile &profile) {
  const double straight = profile.material.youngs_modulus * section.inertia;
  constexpr double rounding = 1e-9;
  if (place_of(law, bend_radius) < 0 && place_of(law, bending_rigidity) < 0 &&
      profile.EI < (1. - rounding) * straight)
    throw UserError("Pipe " + pipe.name + ": its bends are " +
                    rounded_number(straight / profile.EI, 3) +
                    " times as flexible as a straight pipe, which the law '" + law.name +
                    "' of section " + section.name +
                    " knows nothing of.\n  read:    a law of straight pipes\n  allowed: bends with "
                    "a law that has 'Bend radius' or 'Bending rigidity'\n  try:     a section of "
                    "its own with Law = ovalising_pipe or global_plastic for the bend, or 'Bend "
                    "flexibility = none'");
}

/// Of a law that has the flexibility of bends in itself.
void check_bend(const LawDescription &law, const Pipe &pipe, const Section &section,
                const BendPart &bend) {
  if (given(law, section, bend_radius))
    throw UserError("Section " + section.name + ": its law '" + law.name +
                    "' takes the bends of the route.\n  read:    'Bend radius'\n  allowed: none, "
                    "for the law has to know where the bend's centre is\n  try:     leaving it "
                    "out, and a route with 'bend RADIUS'");
  if (bend.radius == 0.)
    return;
  const BendFlexibility &flexibility = pipe.bend_flexibility;
  if (flexibility.rule != BendFlexibility::Rule::code || flexibility.pressure != 0.)
    throw UserError("Pipe " + pipe.name + ": the flexibility of its bends comes from the law '" +
                    law.name + "' of section " + section.name +
                    ".\n  read:    another 'Bend flexibility', or a 'Stiffening pressure'\n  "
                    "allowed: neither of them; the law is stiffened by the pressure of the loads\n"
                    "  try:     leaving them out, or Law = global_plastic");
  if (!bend.arc_centre)
    throw UserError("Pipe " + pipe.name + ": the law '" + law.name + "' of section " +
                    section.name +
                    " stands in a bend of straight pieces, and has to know its plane.\n  read:    "
                    "a bend cut into straight cells, or one of a mesh of your own\n  allowed: "
                    "bends of routes that are arcs\n  try:     'Bends = arcs' in subsection Mesh, "
                    "or Law = global_plastic");
}

/// Of a cell whose law is another along it.
double mean_bending_rigidity(const Profile &profile) {
  const QGauss<1> points(8);
  double flexibility = 0.;
  for (unsigned int q = 0; q < points.size(); ++q)
    flexibility += points.weight(q) / elastic_tangent(law_at(profile, points.point(q)[0]))(5, 5);
  return 1. / flexibility;
}

} // namespace

BoundLaw bind_section_law(const LawDescription &law, const Section &section, const Pipe &pipe,
                          const BendPart &bend, Profile &profile) {
  check_flexibility(law, pipe, section, profile);
  if (has_own_flexibility(law))
    check_bend(law, pipe, section, bend);
  std::vector<double> values;
  for (int i = 0; i < law.n_parameters; ++i)
    values.push_back(value_of(law, i, {section, profile, bend}));
  if (law.interface_version >= 2 && law.fault != nullptr)
    if (const char *const fault = law.fault(values.data()))
      throw UserError("Section " + section.name + ": its law '" + law.name +
                      "' cannot take these parameters.\n  allowed: " + fault);
  const BoundLaw bound(law, values);
  profile.tangent = elastic_tangent(bound);
  if (bend.radius > 0. && has_own_flexibility(law)) {
    profile.law = bound;
    profile.bend = bend;
    if (place_of(law, place_in_bend) < 0 || given(law, section, place_in_bend))
      profile.bend.begin = profile.bend.end;
    profile.EI = mean_bending_rigidity(profile);
    profile.tangent(4, 4) = profile.tangent(5, 5) = profile.EI;
  }
  return bound;
}

BoundLaw law_at(const Profile &profile, const double part) {
  if (!profile.bend.changes_along())
    return profile.law;
  const LawDescription &law = profile.law.description();
  std::vector<double> values = profile.law.parameters();
  values[place_of(law, place_in_bend)] =
      profile.bend.begin + part * (profile.bend.end - profile.bend.begin);
  return {law, values};
}

Table<2, double> elastic_tangent(const BoundLaw &law) {
  const BoundLaw::Answer answer =
      law.answer_at_rest(std::vector<double>(n_section_strains, 0.), 1., LawTangent::elastic,
                         LawIncrement().temperature);
  Table<2, double> result(n_section_strains, n_section_strains);
  result.fill(answer.tangent.begin(), true);
  return result;
}

} // namespace frictionbeam
