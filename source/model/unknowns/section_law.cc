// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/section_law.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <frictionbeam/law_closed_form.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr char bend_radius[] = "Bend radius", place_in_bend[] = "Place in bend",
               bending_rigidity[] = "Bending rigidity";

/// How a section has to be given for a figure to be known.
enum class By { any, diameter, area };
/// What figures are taken from.
struct Known {
  const Section &section;
  const Profile &profile;
  const BendPart &bend;

  /// Of the rectangle with this area and inertia.
  double height() const { return std::sqrt(12. * section.inertia / section.area); }
};
struct KnownFigure {
  const char *parameter;
  double (*value)(const Known &);
  By by = By::any;
};
constexpr KnownFigure known_figures[] = {
    {"Young's modulus", [](const Known &of) { return of.profile.material.youngs_modulus; }},
    {"Poisson ratio", [](const Known &of) { return of.profile.material.poissons_ratio; }},
    {"Shear modulus",
     [](const Known &of) {
       return of.profile.material.youngs_modulus / (2. * (1. + of.profile.material.poissons_ratio));
     }},
    {"Outside diameter", [](const Known &of) { return 2. * of.section.outer_radius; },
     By::diameter},
    {"Wall thickness", [](const Known &of) { return of.section.wall; }, By::diameter},
    {"Height", [](const Known &of) { return of.height(); }, By::area},
    {"Width", [](const Known &of) { return of.section.area / of.height(); }, By::area},
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

void check_figure(const KnownFigure &figure, const Section &section, const std::string &law) {
  const bool is_pipe = section.wall > 0.;
  if (figure.by == By::any || is_pipe == (figure.by == By::diameter))
    return;
  const std::string by_diameter = "'Outer diameter' and 'Wall', or a 'Size'",
                    by_area = "'Area' and 'Inertia'", own = figure.parameter;
  throw UserError("Section " + section.name + ": its law '" + law + "' needs '" + own +
                  "'.\n  read:    a section by its " +
                  (is_pipe ? "diameter and wall\n  allowed: " + by_area +
                                 "\n  try:     " + by_area + ", or Law = fibre_pipe"
                           : "area and inertia\n  allowed: " + by_diameter +
                                 "\n  try:     these, or '" + own + "' itself"));
}

/// @throws UserError if the law is not made for it.
double known_value(const KnownFigure &figure, const LawParameter &parameter, const Known &known) {
  const double value = figure.value(known);
  if (!(value >= parameter.minimum && value <= parameter.maximum))
    throw UserError(
        "Section " + known.section.name + ": '" + parameter.name +
        "' of its law is taken from section and material.\n  read:    " + rounded_number(value, 6) +
        "\n  allowed: " + rounded_number(parameter.minimum, 6) + " to " +
        rounded_number(parameter.maximum, 6) +
        "\n  try:     another material or "
        "section, or '" +
        parameter.name + "' itself");
  return value;
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

BoundLaw bind_section_law(const LawDescription &law, const Pipe &pipe, const Section &section,
                          const BendPart &bend, const Profile &profile) {
  check_flexibility(law, pipe, section, profile);
  if (has_own_flexibility(law))
    check_bend(law, pipe, section, bend);
  std::vector<double> values;
  for (int i = 0; i < law.n_parameters; ++i) {
    const LawParameter &parameter = law.parameters[i];
    const std::optional<double> of_file = given(law, section, parameter.name);
    const KnownFigure *const figure = known_figure(parameter.name);
    if (figure != nullptr && (!of_file || figure->by == By::area))
      check_figure(*figure, section, law.name);
    values.push_back(of_file ? *of_file
                     : figure == nullptr
                         ? parameter.default_value
                         : known_value(*figure, parameter, {section, profile, bend}));
  }
  if (const auto fault = fault_of(law, values))
    throw UserError("Section " + section.name + ": its law '" + law.name +
                    "' cannot take these parameters together.\n  allowed: " + fault->allowed +
                    "\n  try:     " + fault->attempt);
  return {law, values};
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

Table<2, double> elastic_tangent(const BoundLaw &law, const double temperature) {
  const BoundLaw::Answer answer = law.answer_at_rest(std::vector<double>(n_section_strains, 0.), 1.,
                                                     LawTangent::elastic, temperature);
  Table<2, double> result(n_section_strains, n_section_strains);
  result.fill(answer.tangent.begin(), true);
  return result;
}

void take_section_law(const BoundLaw &law, const Pipe &pipe, const Section &section,
                      const BendPart &bend, Profile &profile) {
  profile.tangent = elastic_tangent(law);
  profile.law = law;
  if (bend.radius > 0. && has_own_flexibility(law.description())) {
    profile.bend = bend;
    if (place_of(law.description(), place_in_bend) < 0 ||
        given(law.description(), section, place_in_bend))
      profile.bend.begin = profile.bend.end;
    profile.tangent(4, 4) = profile.tangent(5, 5) = mean_bending_rigidity(profile);
  }
  const Table<2, double> &D = profile.tangent;
  constexpr double rounding = 1e-9;
  if (profile.arc_centre && std::abs(D(4, 4) - D(5, 5)) > rounding * D(4, 4))
    throw UserError(
        "Pipe " + pipe.name +
        ": its section bends differently about its two axes, by its "
        "law '" +
        law.name() +
        "', and stands in a bend.\n  read:    a bend of such a section\n  "
        "allowed: straight pipes of it\n  try:     'Bends = straight pieces' in section "
        "Mesh, or a pipe of its own for the bend");
  const auto take = [&](double &rigidity, const unsigned int component) {
    if (D(component, component) > 0.)
      rigidity = D(component, component);
  };
  const double EA = profile.EA;
  take(profile.EA, 0);
  take(profile.GA, 1);
  take(profile.GJ, 3);
  take(profile.EI, 4);
  profile.pressure_strain *= EA / profile.EA;
}

} // namespace frictionbeam
